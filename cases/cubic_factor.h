// What a step of cubic advection makes of a wave in a uniform wind: its closed form.
//
// A wave of angle theta = k h a cell that is carried by `carried_cells` = a comes out of a step times
//     G(a, theta) = sum_j w_j(t) exp(i (floor(-a) + j) theta),  t = -a - floor(-a),  w the cubic Lagrange weights on -1, 0, 1, 2;
// |G| is its damping, arg G + a theta the error of its phase. Expanded, 1 - |G| = theta^4 t (1 - t) (1 + t) (2 - t) / 24 + ...
// and the phase is off by theta^5: a wave that has crossed a fixed distance is off to order 3 at a fixed CFL number. Based on:
// Staniforth & Cote 1991, Monthly Weather Review 119 (stability and dispersion of semi-Lagrangian schemes).
#pragma once

#include <array>
#include <cmath>
#include <complex>

namespace windrow::cases {

/// Lagrange's weights of the values at -1, 0, 1, 2 for a point t between 0 and 1.
[[nodiscard]] inline std::array<double, 4> cubic_weights(double t) {
    return {-t * (t - 1) * (t - 2) / 6, (t + 1) * (t - 1) * (t - 2) / 2, -(t + 1) * t * (t - 2) / 2, (t + 1) * t * (t - 1) / 6};
}

[[nodiscard]] inline std::complex<double> cubic_factor(double carried_cells, double theta) {
    const double low = std::floor(-carried_cells);
    const std::array<double, 4> weights = cubic_weights(-carried_cells - low);
    std::complex<double> sum = 0.0;
    for (int j = 0; j < 4; ++j)
        sum += weights[static_cast<std::size_t>(j)] * std::polar(1.0, (low + j - 1) * theta);
    return sum;
}

} // namespace windrow::cases
