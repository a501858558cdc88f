#include "scene/carried.h"

#include <algorithm>
#include <cmath>

namespace windrow::scene {
namespace {

/// f(a) of the header, for a up to 5: the terms are then below 26 before they fall.
double pulled(double a) {
    double term = -1.0, sum = 0.0;
    for (int n = 1; n <= 40; ++n) {
        term *= -a / n;
        sum += term / (2.5 * n + 1.0);
    }
    return sum;
}

} // namespace

WakeMotor wake_of(glm::vec2 front, float cell_size) {
    const double thin = 0.25 * std::max(static_cast<double>(front.x) * static_cast<double>(front.y), 1e-4); // A / pi
    const double radius = std::max(std::sqrt(thin), 1.5 * static_cast<double>(cell_size));
    const double wanted = 0.5 * thin / (radius * radius);
    double low = 0.0, high = 5.0; // pulled() is 0 to 0.52 there
    for (int n = 0; n < 50; ++n) {
        const double middle = 0.5 * (low + high);
        (pulled(middle) < wanted ? low : high) = middle;
    }
    return {.radius = static_cast<float>(radius), .law = WakeDrive{.per_metre = static_cast<float>(0.9375 * low / radius)}};
}

} // namespace windrow::scene
