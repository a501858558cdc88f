#include "cases/jets.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace windrow::cases {
namespace {

struct Jet {
    glm::vec3 centre, direction; ///< centre as a share of the box
};

constexpr Jet k_jets[] = {
    {{0.25f, 0.30f, 0.30f}, {1.0f, 0.0f, 0.0f}},   {{0.70f, 0.55f, 0.25f}, {0.0f, 0.3f, 1.0f}},
    {{0.45f, 0.75f, 0.70f}, {-0.7f, -0.5f, 0.3f}}, {{0.80f, 0.20f, 0.75f}, {-0.2f, 1.0f, 0.0f}},
    {{0.15f, 0.65f, 0.85f}, {0.5f, -0.2f, -1.0f}}, {{0.55f, 0.40f, 0.50f}, {0.6f, 0.6f, -0.4f}},
};
constexpr float k_speed = 24.0f;       // [m/s]
constexpr float k_width_share = 0.08f; // of the box along x

} // namespace

Box bench_box(glm::ivec3 cells) {
    return {.cells = cells, .cell_size = 1.0f, .sides = Sides::open_over_floor()};
}

std::vector<glm::vec4> jets(const Box& box) {
    std::vector<glm::vec4> velocity(box.cell_count());
    const float width = k_width_share * static_cast<float>(box.cells.x);
    for (int k = 0; k < box.cells.z; ++k)
        for (int j = 0; j < box.cells.y; ++j)
            for (int i = 0; i < box.cells.x; ++i) {
                glm::vec3 sum = k_bench_ambient;
                for (const Jet& jet : k_jets) {
                    const glm::vec3 away = glm::vec3(i, j, k) + 0.5f - jet.centre * glm::vec3(box.cells);
                    sum += k_speed * std::exp(-0.5f * glm::dot(away, away) / (width * width)) * jet.direction;
                }
                velocity[box.index(i, j, k)] = glm::vec4(sum, 0.0f);
            }
    return velocity;
}

} // namespace windrow::cases
