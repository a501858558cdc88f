#include "vegetation/trees/crown_light.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace windrow::vegetation::trees {

CrownLight::CrownLight(std::span<const Absorber> leaves) : density_(static_cast<std::size_t>(k_cells) * k_cells * k_cells, 0.0f) {
    if (leaves.empty())
        return;
    glm::vec3 low(leaves.front()), high(leaves.front());
    for (const Absorber& leaf : leaves) {
        low = glm::min(low, glm::vec3(leaf));
        high = glm::max(high, glm::vec3(leaf));
    }
    const glm::vec3 size = glm::max(high - low, glm::vec3(1e-3f));
    low_ = low;
    cell_ = 1.0001f * size / static_cast<float>(k_cells);
    const float volume = cell_.x * cell_.y * cell_.z;
    for (const Absorber& leaf : leaves) {
        const glm::ivec3 at((glm::vec3(leaf) - low_) / cell_);
        density_[static_cast<std::size_t>((at.z * k_cells + at.y) * k_cells + at.x)] += leaf.w / volume;
    }
}

float CrownLight::density(glm::vec3 p) const {
    const glm::vec3 local = (p - low_) / cell_;
    for (int axis = 0; axis < 3; ++axis)
        if (!(local[axis] >= 0.0f && local[axis] < static_cast<float>(k_cells)))
            return 0.0f;
    const glm::ivec3 at(local);
    return density_[static_cast<std::size_t>((at.z * k_cells + at.y) * k_cells + at.x)];
}

float CrownLight::transmittance(glm::vec3 p, glm::vec3 direction) const {
    const float step = glm::min(cell_.x, glm::min(cell_.y, cell_.z));
    const float reach = glm::length(cell_) * static_cast<float>(k_cells);
    float depth = 0.0f;
    const int steps = glm::min(static_cast<int>(reach / step), 200);
    for (int n = 0; n < steps; ++n) // the first half step is the leaf's own neighbourhood
        depth += density(p + (static_cast<float>(n) + 0.75f) * step * direction) * step;
    return std::exp(-0.5f * depth);
}

glm::vec4 CrownLight::fit(glm::vec3 p) const {
    float mean = 0.0f, weights = 0.0f;
    glm::vec3 slope(0.0f);
    for (int z = -1; z <= 1; ++z)
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x) {
                const glm::vec3 way(x, y, z);
                if (x == 0 && y == 0 && z == 0)
                    continue;
                // Corners of a cube stand closer together than its faces' middles: weights of about their share of the sphere.
                const float square = glm::dot(way, way);
                const float weight = square == 1.0f ? 1.0f / 21.0f : square == 2.0f ? 4.0f / 105.0f : 9.0f / 280.0f;
                const glm::vec3 direction = way / std::sqrt(square);
                const float through = transmittance(p, direction);
                mean += weight * through;
                slope += 3.0f * weight * through * direction;
                weights += weight;
            }
    return glm::vec4(slope / weights, mean / weights);
}

} // namespace windrow::vegetation::trees
