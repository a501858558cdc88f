// Bend of a plant in a wind: drag against stiffness.
//
//     windrow::Drag stem{.length = 0.8f, .width = 0.008f, .rigidity = windrow::tube_rigidity(4.8e9f, 0.004f, 0.003f)};
//     float lean = windrow::bend_angle(stem, 5.0f);     // [rad] of the tip in 5 m/s
//
// The Cauchy number Ca = rho C_d w L^3 U^2 / (2 E I) alone decides the shape (shaders/numerics/plant_drag.glsl has the equation
// and its sources): Ca = 1 leans the tip by 9 degrees, 10 by 47, 100 by 77.
#pragma once

#include "../fluid/api.h"
#include "../fluid/result.h"
#include "../fluid/setting.h"

#include <glm/vec4.hpp>

namespace windrow {
namespace detail {
class Reasons;
struct FieldPath;
} // namespace detail

/// Mechanical properties of a stalk, uniform along its length.
struct Drag {
    /// [m] 1e-4 to 200, default 0.3. Length of the stalk; 0.3 is meadow grass. In a scene it is that of the class. The bend grows
    /// with its cube.
    float length = 0.3f;
    /// [m] 1e-6 to 100, default 0.004. Width across the wind, leaves included. A blade of grass has 0.004.
    float width = 0.004f;
    /// [N m2] 1e-12 to 1e12, default 4.2e-5. E I. 4.2e-5 is a blade creased to a V, folded_rigidity(5e8, 0.004, 2.5e-4, 0.001).
    float rigidity = 4.2e-5f;
    /// 0 to 10, default 1.95. A flat plate has 1.95 (Luhar & Nepf 2011), a round stem 1.1, a crown 0.3; 0: no wind bends it.
    float drag_coefficient = 1.95f;
    /// [kg/m3] 0 to 2000, default 1.2. 1.2 is air at 20 C.
    float air_density = 1.2f;
    /// -2 to 0, default 0. Loss of drag as leaves close up: speed to this power above vogel_speed. 0: only the loss by the bend,
    /// which is -2/3. Crowns have -0.7 (Vogel 1989).
    float vogel_exponent = 0.0f;
    /// [m/s] 0.001 to 1000, default 5. Speed above which leaves turn and close up.
    float vogel_speed = 5.0f;
    /// [rad] 0 to 2.5, default 1.5707964. Upper bound of the tip's bend. No steady wind exceeds pi/2, a spring that overshoots
    /// may; shells stay within pi/2.
    float max_bend = 1.57079633f;

    static constexpr auto settings() {
        return std::tuple{
            Setting(
                "length", &Drag::length, {1e-4, 200.0, "m"},
                "Length of the stalk; 0.3 is meadow grass. In a scene it is that of the class. The bend grows with its cube."),
            Setting("width", &Drag::width, {1e-6, 100.0, "m"},
                    "Width across the wind, leaves included. A blade of grass has 0.004."),
            Setting("rigidity", &Drag::rigidity, {1e-12, 1e12, "N m2"},
                    "E I. 4.2e-5 is a blade creased to a V, folded_rigidity(5e8, 0.004, 2.5e-4, 0.001)."),
            Setting("drag_coefficient", &Drag::drag_coefficient, {0.0, 10.0},
                    "A flat plate has 1.95 (Luhar & Nepf 2011), a round stem 1.1, a crown 0.3; 0: no wind bends it."),
            Setting("air_density", &Drag::air_density, {0.0, 2000.0, "kg/m3"}, "1.2 is air at 20 C."),
            Setting("vogel_exponent", &Drag::vogel_exponent, {-2.0, 0.0},
                    "Loss of drag as leaves close up: speed to this power above vogel_speed. 0: only the loss by the bend, which "
                    "is -2/3. Crowns have -0.7 (Vogel 1989)."),
            Setting("vogel_speed", &Drag::vogel_speed, {1e-3, 1e3, "m/s"}, "Speed above which leaves turn and close up."),
            Setting(
                "max_bend", &Drag::max_bend, {0.0, 2.5, "rad"},
                "Upper bound of the tip's bend. No steady wind exceeds pi/2, a spring that overshoots may; shells stay within "
                "pi/2."),
        };
    }
};

/// Shader block: WindrowDrag of shaders/numerics/plant_drag.glsl, which documents each component.
struct DragBlock {
    glm::vec4 load{0.0f};
};
static_assert(sizeof(DragBlock) == 16);

/// All reasons why it is invalid, one per line; `name` is put before each field.
[[nodiscard]] WINDROW_API Result<void> validate(const Drag& drag, const char* name = "drag");
/// The block of valid properties.
[[nodiscard]] WINDROW_API DragBlock block(const Drag& drag);

/// Ca at a speed [m/s] across the stalk.
[[nodiscard]] WINDROW_API double cauchy_number(const Drag& drag, double speed);
/// [rad] Lean of the tip in a steady wind [m/s] across the stalk, 0 to pi/2.
[[nodiscard]] WINDROW_API float bend_angle(const Drag& drag, float speed);

/// [N m2] E I of sections of one material of Young's modulus E [Pa]; all lengths [m].
[[nodiscard]] WINDROW_API float rectangle_rigidity(float young, float width, float thickness);
/// E I of a strip of this width and thickness, creased along its middle to a V of this depth. 16 times that of the flat strip
/// where the depth is 4 times the thickness.
[[nodiscard]] WINDROW_API float folded_rigidity(float young, float width, float thickness, float depth);
[[nodiscard]] WINDROW_API float rod_rigidity(float young, float diameter);
[[nodiscard]] WINDROW_API float tube_rigidity(float young, float outer_diameter, float inner_diameter);

} // namespace windrow
