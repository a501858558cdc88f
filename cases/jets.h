// The flow of all measurements: a mean wind over a floor with six jets in it, strong enough that nothing is still and slow enough
// that a step needs no sub-steps.
#pragma once

#include "fluid/box.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

namespace windrow::cases {

/// [s]
inline constexpr double k_bench_dt = 1.0 / 60.0;
/// After these the flow is laid in anew: until then the jets have not left the box.
inline constexpr int k_steps_of_flow = 60;
/// [m/s]
inline constexpr glm::vec3 k_bench_ambient{6.0f, 0.0f, 2.0f};

/// The box of `cells` cells of 1 m with open sides over a floor.
[[nodiscard]] Box bench_box(glm::ivec3 cells);
/// [m/s] Jets of Gaussian cross-section on the mean wind: CFL number about 0.5 at k_bench_dt.
[[nodiscard]] std::vector<glm::vec4> jets(const Box& box);

} // namespace windrow::cases
