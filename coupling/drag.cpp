#include "coupling/drag.h"

#include "coupling/checks.h"
#include "coupling/plant_numerics.h"

#include <cmath>

namespace windrow {
namespace {

constexpr double k_pi = 3.14159265358979323846;

} // namespace

Result<void> validate(const Drag& drag, const char* name) {
    detail::Checks checks(name);
    checks.between(".length", drag.length, 1e-4f, 200.0f, "m");
    checks.between(".width", drag.width, 1e-6f, 100.0f, "m");
    checks.between(".rigidity", drag.rigidity, 1e-12f, 1e12f, "N m2");
    checks.between(".drag_coefficient", drag.drag_coefficient, 0.0f, 10.0f, "");
    checks.between(".air_density", drag.air_density, 0.0f, 2000.0f, "kg/m3");
    checks.between(".vogel_exponent", drag.vogel_exponent, -2.0f, 0.0f, "");
    checks.between(".vogel_speed", drag.vogel_speed, 1e-3f, 1e3f, "m/s");
    checks.between(".most_bend", drag.most_bend, 0.0f, 2.5f, "rad");
    return checks.outcome();
}

DragBlock block(const Drag& drag) {
    const double k = 0.5 * drag.air_density * drag.drag_coefficient * drag.width * std::pow(drag.length, 3.0) / drag.rigidity;
    // A load beyond what a float holds lays the stalk flat in any wind, as the largest does.
    return {{static_cast<float>(std::fmin(k, 1e30)), drag.vogel_exponent, drag.vogel_speed, drag.most_bend}};
}

double cauchy_number(const Drag& drag, double speed) {
    const numerics::WindrowDrag shared{block(drag).load};
    return static_cast<double>(numerics::windrow_load_at(shared, static_cast<float>(speed), 1.0f)) * speed * speed;
}

float bend_angle(const Drag& drag, float speed) {
    const numerics::WindrowDrag shared{block(drag).load};
    return glm::length(numerics::windrow_drag_bend(shared, {0.0f, 1.0f, 0.0f}, {speed, 0.0f, 0.0f}, 1.0f));
}

float rectangle_rigidity(float young, float width, float thickness) {
    return static_cast<float>(young * width * std::pow(thickness, 3.0) / 12.0);
}

float folded_rigidity(float young, float width, float thickness, float depth) {
    return static_cast<float>(young * width * thickness * std::pow(depth, 2.0) / 12.0);
}

float rod_rigidity(float young, float diameter) {
    return static_cast<float>(young * k_pi / 64.0 * std::pow(diameter, 4.0));
}

float tube_rigidity(float young, float outer_diameter, float inner_diameter) {
    return static_cast<float>(young * k_pi / 64.0 * (std::pow(outer_diameter, 4.0) - std::pow(inner_diameter, 4.0)));
}

} // namespace windrow
