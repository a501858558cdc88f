// The flow of all measurements: a mean wind over a floor with six jets in it, strong enough that nothing is still and slow enough
// that a step needs no sub-steps.
#pragma once

#include "cases/cell_values.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace windrow::cases {

/// [s]
inline constexpr double k_bench_dt = 1.0 / 60.0;
/// After these the flow is laid in again: until then the jets have not left the box.
inline constexpr int k_steps_of_flow = 60;
/// [m/s]
inline constexpr glm::vec3 k_bench_ambient{6.0f, 0.0f, 2.0f};

/// The box of `cells` cells of 1 m with open boundaries over a floor.
[[nodiscard]] inline Box bench_box(glm::ivec3 cells) {
    return {.cells = cells, .cell_size = 1.0f, .boundaries = Boundaries::open_over_floor()};
}

/// [m/s] Jets of Gaussian cross-section on the mean wind: CFL number about 0.5 at k_bench_dt.
[[nodiscard]] inline CellVelocities jets(const Box& box) {
    struct Jet {
        glm::vec3 centre, direction; ///< centre as a share of the box
    };
    constexpr Jet k_jets[] = {
        {{0.25f, 0.30f, 0.30f}, {1.0f, 0.0f, 0.0f}},   {{0.70f, 0.55f, 0.25f}, {0.0f, 0.3f, 1.0f}},
        {{0.45f, 0.75f, 0.70f}, {-0.7f, -0.5f, 0.3f}}, {{0.80f, 0.20f, 0.75f}, {-0.2f, 1.0f, 0.0f}},
        {{0.15f, 0.65f, 0.85f}, {0.5f, -0.2f, -1.0f}}, {{0.55f, 0.40f, 0.50f}, {0.6f, 0.6f, -0.4f}},
    };
    constexpr float k_speed = 24.0f; // [m/s]
    const float width = 0.08f * static_cast<float>(box.cells.x);
    return velocities_of(box, [&](glm::dvec3 x) {
        glm::vec3 sum = k_bench_ambient;
        for (const Jet& jet : k_jets) {
            const glm::vec3 away = glm::vec3(x) - jet.centre * glm::vec3(box.cells);
            sum += k_speed * std::exp(-0.5f * glm::dot(away, away) / (width * width)) * jet.direction;
        }
        return sum;
    });
}

} // namespace windrow::cases
