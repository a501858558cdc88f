#include "fluid/core/validation.h"
#include "vegetation/fur/mesh_grid.h"
#include "vegetation/fur/shapes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace windrow::vegetation::fur {

void check_rules(windrow::detail::Reasons& reasons, const windrow::detail::FieldPath& path, const Sheet& sheet) {
    const float most = 0.1f * std::min(sheet.size.x, sheet.size.y);
    if (sheet.wave > most)
        reasons.add(windrow::detail::FieldPath{&path, "wave"}, " is ", sheet.wave,
                    " m: give at most a tenth of the shorter side, ", most, " m.");
}

Result<Mesh> sheet(const Sheet& settings) {
    if (const auto valid = windrow::detail::validate_settings(settings, "sheet"); !valid)
        return valid.failure();

    // y = wave sin(a) cos(b), with one wave and a half along x and one along z: two slopes that a hanging cloth has.
    const float along_x = 3.0f * std::numbers::pi_v<float>, along_z = 2.0f * std::numbers::pi_v<float>;
    Mesh mesh;
    mesh.has_uv = true;
    for (int row = 0; row <= settings.rows; ++row)
        for (int column = 0; column <= settings.columns; ++column) {
            const glm::vec2 uv{static_cast<float>(column) / static_cast<float>(settings.columns),
                               static_cast<float>(row) / static_cast<float>(settings.rows)};
            const float a = along_x * uv.x, b = along_z * uv.y;
            const float dx = settings.wave * along_x / settings.size.x * std::cos(a) * std::cos(b);
            const float dz = -settings.wave * along_z / settings.size.y * std::sin(a) * std::sin(b);
            const glm::vec2 at = (uv - 0.5f) * settings.size;
            mesh.vertices.push_back({.position = {at.x, settings.wave * std::sin(a) * std::cos(b), at.y},
                                     .normal = glm::normalize(glm::vec3(-dx, 1.0f, -dz)),
                                     .uv = uv});
        }
    const auto columns = static_cast<std::uint32_t>(settings.columns) + 1;
    for (std::uint32_t row = 0; row < static_cast<std::uint32_t>(settings.rows); ++row)
        for (std::uint32_t column = 0; column + 1 < columns; ++column) {
            const std::uint32_t a = row * columns + column;
            add_cell(mesh, a, a + columns, a + columns + 1, a + 1);
        }
    finish(mesh, "sheet");
    return mesh;
}

} // namespace windrow::vegetation::fur
