// The wind at one point, as a host would write it with GLM from fluid/view.h and fluid/ambient.h: what the queries of the library
// are compared with, in speed and in bits.
//
// This is the text that the library itself used before its queries became kernels (fluid/cpu/kernels/box_points.inl).
#pragma once

#include "fluid/view.h"

namespace windrow::reference {

/// [m/s] What WindView::velocity returns, to rounding.
[[nodiscard]] glm::vec3 plain_velocity(const WindView& view, glm::dvec3 position);
/// [m/s] The ambient wind there, by the text of shaders/numerics/ambient.glsl.
[[nodiscard]] glm::vec3 plain_ambient(const AmbientWind& wind, glm::dvec3 position);
/// [m/s] What a plant feels of a wind there, by the same text.
[[nodiscard]] glm::vec3 plain_felt(const AmbientWind& wind, glm::vec3 velocity, glm::dvec3 position, const Sampling& sampling);

} // namespace windrow::reference
