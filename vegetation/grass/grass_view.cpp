#include "vegetation/grass/grass_view.h"

#include <glm/geometric.hpp>

namespace windrow::vegetation::grass {

Planes frustum_planes(const glm::mat4& view_projection, const glm::dvec3& corner) {
    const glm::dmat4 m(view_projection);
    const auto row = [&](int n) { return glm::dvec4(m[0][n], m[1][n], m[2][n], m[3][n]); };
    const glm::dvec4 x = row(0), y = row(1), z = row(2), w = row(3);
    const glm::dvec4 found[] = {w + x, w - x, w + y, w - y, z, w - z};
    Planes planes{};
    for (std::size_t n = 0; n < planes.size(); ++n) {
        const glm::dvec3 across(found[n]);
        const double size = glm::length(across);
        planes[n] = size > 1e-12 ? glm::vec4(across / size, (found[n].w + glm::dot(across, corner)) / size)
                                 : glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
    }
    return planes;
}

} // namespace windrow::vegetation::grass
