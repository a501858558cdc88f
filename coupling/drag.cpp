#include "coupling/drag.h"

#include "coupling/plant_numerics.h"
#include "fluid/core/validation.h"

#include <algorithm>
#include <cmath>

namespace windrow {
namespace {

constexpr double k_pi = 3.14159265358979323846;

} // namespace

Result<void> validate(const Drag& drag, const char* name) {
    return detail::validate_settings(drag, name);
}

DragBlock block(const Drag& drag) {
    const double k =
        0.5 * drag.air_density * drag.drag_coefficient * drag.width * numerics::power(drag.length, 3) / drag.rigidity;
    // A load beyond the range of a float flattens the stalk in any wind, as the largest float does.
    return {{static_cast<float>(std::fmin(k, 1e30)), drag.vogel_exponent, drag.vogel_speed, drag.max_bend}};
}

double cauchy_number(const Drag& drag, double speed) {
    const numerics::WindrowDrag shared{block(drag).load};
    return static_cast<double>(numerics::windrow_load_at(shared, static_cast<float>(speed), 1.0f)) * speed * speed;
}

float bend_angle(const Drag& drag, float speed) {
    constexpr float k_fastest = 1e6f; // [m/s] as Sampling::limit; the square of more is no float
    const numerics::WindrowDrag shared{block(drag).load};
    const float across = std::clamp(speed, -k_fastest, k_fastest);
    return glm::length(numerics::windrow_drag_bend(shared, {0.0f, 1.0f, 0.0f}, {across, 0.0f, 0.0f}, 1.0f));
}

float rectangle_rigidity(float young, float width, float thickness) {
    return static_cast<float>(young * width * numerics::power(thickness, 3) / 12.0);
}

float folded_rigidity(float young, float width, float thickness, float depth) {
    return static_cast<float>(young * width * thickness * numerics::power(depth, 2) / 12.0);
}

float rod_rigidity(float young, float diameter) {
    return static_cast<float>(young * k_pi / 64.0 * numerics::power(diameter, 4));
}

float tube_rigidity(float young, float outer_diameter, float inner_diameter) {
    return static_cast<float>(young * k_pi / 64.0 * (numerics::power(outer_diameter, 4) - numerics::power(inner_diameter, 4)));
}

} // namespace windrow
