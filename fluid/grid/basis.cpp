#include "fluid/grid/basis.h"

#include "fluid/portable_math.h"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace windrow {
namespace {

struct AxisMode {
    double theta;
    bool sine;
};

// Mirror point of an end, in cells from the first centre.
double mirror_point(EndRule rule, bool low, int count) {
    const double reach = rule == EndRule::zero_at_ghost ? 1.0 : 0.5;
    return low ? -reach : count - 1 + reach;
}

std::vector<AxisMode> modes_of(int count, EndRule low, EndRule high) {
    const double pi = std::numbers::pi;
    std::vector<AxisMode> modes;
    if (low == EndRule::periodic) {
        modes.push_back({0.0, false});
        for (int k = 1; static_cast<int>(modes.size()) < count; ++k) {
            const double theta = 2.0 * pi * k / count;
            // At the shortest wave of an even axis one of the two vectors vanishes on the centres;
            // the sine about the middle remains.
            if (2 * k != count)
                modes.push_back({theta, false});
            modes.push_back({theta, true});
        }
        return modes;
    }
    const double length = mirror_point(high, false, count) - mirror_point(low, true, count);
    const bool low_even = low == EndRule::even_at_face;
    const bool high_even = high == EndRule::even_at_face;
    const double shift = low_even != high_even ? 0.5 : low_even ? 0.0 : 1.0;
    for (int k = 0; k < count; ++k)
        modes.push_back({pi * (k + shift) / length, !low_even});
    return modes;
}

} // namespace

AxisBasis::AxisBasis(int n, EndRule low, EndRule high) : count(n), folded(low == high), even_size(n), odd_size(0), zero_mode(-1) {
    const bool periodic = low == EndRule::periodic;
    // A periodic axis is measured from its middle, so that its cosines are even and its sines odd about it.
    const double origin = periodic ? 0.5 * (n - 1) : mirror_point(low, true, n);
    if (folded) {
        even_size = (n + 1) / 2;
        odd_size = n / 2;
    }
    std::vector<double> even_values, odd_values;
    for (const AxisMode& mode : modes_of(n, low, high)) {
        std::vector<double> vector(static_cast<std::size_t>(n));
        double norm = 0.0;
        for (int i = 0; i < n; ++i) {
            const double phase = mode.theta * (i - origin);
            vector[i] = mode.sine ? numerics::sin(phase) : numerics::cos(phase);
            norm += vector[i] * vector[i];
        }
        const double scale = 1.0 / std::sqrt(norm);
        const double half_sine = numerics::sin(0.5 * mode.theta);
        const double eigenvalue = -4.0 * half_sine * half_sine;
        double symmetric = 0.0, antisymmetric = 0.0;
        for (int i = 0; i < n; ++i) {
            symmetric += std::abs(vector[i] + vector[n - 1 - i]);
            antisymmetric += std::abs(vector[i] - vector[n - 1 - i]);
        }
        const bool to_even = !folded || symmetric > antisymmetric;
        std::vector<double>& part = to_even ? even : odd;
        for (int i = 0; i < (to_even ? even_size : odd_size); ++i)
            part.push_back(scale * vector[i]);
        (to_even ? even_values : odd_values).push_back(mode.theta == 0.0 ? 0.0 : eigenvalue);
    }
    eigenvalues = even_values;
    eigenvalues.insert(eigenvalues.end(), odd_values.begin(), odd_values.end());
    for (int mode = 0; mode < n; ++mode)
        if (eigenvalues[mode] == 0.0)
            zero_mode = mode;
}

} // namespace windrow
