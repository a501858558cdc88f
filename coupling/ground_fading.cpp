#include "coupling/ground_fading.h"

#include "fluid/portable_math.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace windrow::detail {
namespace {

// After this time the slowest spring is at rest and the slowest fading has ended.
constexpr double k_longest = 1e9;

// The system's components: place, velocity / omega, the ramp's f, e^(-t / tau) - 1, t / h, and 1.
enum Part : std::size_t { place, speed, ramp, faded, share, one, parts };
using Matrix = std::array<std::array<double, parts>, parts>;

Matrix product(const Matrix& a, const Matrix& b) {
    Matrix c{};
    for (std::size_t i = 0; i < parts; ++i)
        for (std::size_t k = 0; k < parts; ++k)
            for (std::size_t j = 0; j < parts; ++j)
                c[i][j] += a[i][k] * b[k][j];
    return c;
}

// e^m - 1, computed without the 1, which would cost a short step's digits.
Matrix grown(Matrix m) {
    double most = 0.0;
    for (const auto& row : m) {
        double sum = 0.0;
        for (const double value : row)
            sum += std::abs(value);
        most = std::max(most, sum);
    }
    const int squarings = most > 0.25 ? numerics::ceil_log2(4.0 * most) : 0;
    for (auto& row : m)
        for (double& value : row)
            value = std::ldexp(value, -squarings);
    Matrix sum = m, term = m;
    for (int n = 2; n < 12; ++n) { // 0.25^12 / 12! is below a double's last digit
        term = product(term, m);
        for (std::size_t i = 0; i < parts; ++i)
            for (std::size_t j = 0; j < parts; ++j) {
                term[i][j] /= n;
                sum[i][j] += term[i][j];
            }
    }
    for (int n = 0; n < squarings; ++n) { // (1 + E)^2 - 1 = 2 E + E^2
        const Matrix square = product(sum, sum);
        for (std::size_t i = 0; i < parts; ++i)
            for (std::size_t j = 0; j < parts; ++j)
                sum[i][j] = 2.0 * sum[i][j] + square[i][j];
    }
    return sum;
}

FadingResponse response(const SpringClass& spring, double duration, double time, Part target) {
    const double h = std::min(duration, k_longest);
    const double omega = 2.0 * std::numbers::pi * spring.frequency_hz;
    Matrix m{};
    m[place][speed] = omega * h;
    m[speed][place] = -omega * h;
    m[speed][speed] = -2.0 * spring.damping * omega * h;
    m[speed][target] = omega * h;
    m[ramp][ramp] = -h / time;
    m[ramp][faded] = 1.0;
    m[ramp][share] = -h / time;
    m[faded][faded] = -h / time;
    m[faded][one] = -h / time;
    m[share][one] = 1.0;
    if (!(h > 0.0))
        return {};
    const Matrix found = grown(m);
    return {.place = found[place][one], .velocity = omega * found[speed][one]};
}

} // namespace

FadingResponse fading_response(const SpringClass& spring, double duration, double time) {
    return response(spring, duration, time, faded);
}
FadingResponse fading_ramp_response(const SpringClass& spring, double duration, double time) {
    return response(spring, duration, time, ramp);
}

} // namespace windrow::detail
