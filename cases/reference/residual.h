// How wrong a pressure is, evaluated in double: the figure that belongs beside a solver's time.
#pragma once

#include "fluid/box.h"

#include <functional>
#include <span>

namespace windrow::reference {

/// phi of a cell; a solver may keep it in rows of its own.
using PressureAt = std::function<double(int i, int j, int k)>;

/// |L phi - rhs| / |rhs|, L the 7-point Laplacian with h = 1, open sides over a floor. 0 where rhs is 0.
[[nodiscard]] double relative_residual(const Box& box, std::span<const float> rhs, const PressureAt& phi);
/// |d(phi - exact)/dx| / |d exact/dx|. What an iteration leaves is smooth, so its residual flatters it; the wind feels the slope.
[[nodiscard]] double relative_gradient_error(const Box& box, const PressureAt& phi, const PressureAt& exact);

} // namespace windrow::reference
