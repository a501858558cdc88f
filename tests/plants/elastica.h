// The bend of an even stalk under drag that turns with it, solved numerically: the reference for
// shaders/numerics/plant_drag.glsl.
//
//   theta'' = -Ca (cos(theta) H + sin(theta) V),   H' = -cos^3(theta),   V' = -cos^2(theta) sin(theta)
//   theta(0) = 0,   theta'(1) = H(1) = V(1) = 0
//
// Measured from the tip in lengths of (2 E I / (rho C_d w U^2))^(1/3), Ca drops out: one solution from a tip angle down to theta
// = 0 is the stalk whose length there is Ca^(1/3). No shooting. Fourth order in the step (Runge and Kutta).
#pragma once

#include <array>
#include <cmath>
#include <glm/vec2.hpp>
#include <vector>

namespace windrow::test {

struct Elastica {
    double cauchy = 0.0;
    double tip = 0.0;              ///< [rad]
    double root_slope = 0.0;       ///< theta'(0), lengths of 1
    double drag = 0.0;             ///< horizontal force over that of an upright stalk in the same wind
    std::vector<double> s;         ///< along the stalk, 0 at the root to 1
    std::vector<double> theta;     ///< [rad] there
    std::vector<glm::dvec2> place; ///< downwind and up, lengths of 1

    /// Place at s, linear between nodes.
    [[nodiscard]] glm::dvec2 at(double where) const {
        std::size_t n = 1;
        while (n + 1 < s.size() && s[n] < where)
            ++n;
        const double t = (where - s[n - 1]) / (s[n] - s[n - 1]);
        return place[n - 1] + t * (place[n] - place[n - 1]);
    }
};

/// The stalk whose tip leans by `tip` [rad], above 0 and below pi/2. A stiff stalk is short in these lengths: a step is at most
/// `longest` of the length that a cantilever would have.
inline Elastica elastica_of_tip(double tip, double step = 1e-3, double longest = 0.01) {
    using State = std::array<double, 6>; // theta, its slope from the tip, H, V, downwind and up from the tip
    const auto slope = [](const State& y) -> State {
        const double c = std::cos(y[0]), s = std::sin(y[0]);
        return {y[1], -(c * y[2] + s * y[3]), c * c * c, c * c * s, -s, -c};
    };
    const auto moved = [](const State& y, const State& k, double h) {
        State sum;
        for (std::size_t i = 0; i < y.size(); ++i)
            sum[i] = y[i] + h * k[i];
        return sum;
    };
    const auto advanced = [&](const State& y, double h) {
        const State a = slope(y), b = slope(moved(y, a, 0.5 * h)), c = slope(moved(y, b, 0.5 * h)), d = slope(moved(y, c, h));
        State sum;
        for (std::size_t i = 0; i < y.size(); ++i)
            sum[i] = y[i] + h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]);
        return sum;
    };
    std::vector<State> states{State{tip, 0.0, 0.0, 0.0, 0.0, 0.0}};
    std::vector<double> from_tip{0.0};
    step = std::min(step, longest * std::cbrt(6.0 * tip));
    while (states.back()[0] > 0.0) {
        State next = advanced(states.back(), step);
        double taken = step;
        if (next[0] <= 0.0) { // the root lies within this step
            double low = 0.0, high = step;
            for (int i = 0; i < 60; ++i) {
                taken = 0.5 * (low + high);
                next = advanced(states.back(), taken);
                (next[0] > 0.0 ? low : high) = taken;
            }
            next[0] = 0.0;
        }
        states.push_back(next);
        from_tip.push_back(from_tip.back() + taken);
    }
    const double length = from_tip.back();
    Elastica solved;
    solved.cauchy = length * length * length;
    solved.tip = tip;
    solved.root_slope = -states.back()[1] * length;
    solved.drag = states.back()[2] / length;
    for (std::size_t n = states.size(); n-- > 0;) {
        solved.s.push_back(1.0 - from_tip[n] / length);
        solved.theta.push_back(states[n][0]);
        solved.place.emplace_back((states[n][4] - states.back()[4]) / length, (states[n][5] - states.back()[5]) / length);
    }
    return solved;
}

/// The stalk of a Cauchy number, by bisection for the tip.
inline Elastica elastica(double cauchy, double step = 1e-3) {
    double low = 0.0, high = 1.57079632;
    for (int i = 0; i < 50; ++i) {
        const double middle = 0.5 * (low + high);
        if (middle <= 1e-9 || elastica_of_tip(middle, step).cauchy < cauchy)
            low = middle;
        else
            high = middle;
    }
    return elastica_of_tip(0.5 * (low + high), step);
}

} // namespace windrow::test
