// How a wind in metres per second becomes a bend: drag against stiffness.
//
//     windrow::Drag stem{.length = 0.8f, .width = 0.008f, .rigidity = windrow::tube_rigidity(4.8e9f, 0.004f, 0.003f)};
//     float lean = windrow::bend_angle(stem, 5.0f);     // [rad] of the tip in 5 m/s
//
// The Cauchy number Ca = rho C_d w L^3 U^2 / (2 E I) alone decides the shape (shaders/numerics/plant_drag.glsl has the equation
// and its sources): Ca = 1 leans the tip by 9 degrees, 10 by 47, 100 by 77.
#pragma once

#include "fluid/result.h"

#include <glm/vec4.hpp>

namespace windrow {

/// A stalk that the wind bends, taken as even along its length.
struct Drag {
    /// [m] L, 1e-4 to 200. Default 0.3: meadow grass. The bend grows with its cube.
    float length = 0.3f;
    /// [m] w, what the wind meets across the stalk, leaves included; 1e-6 to 100. Default 0.004: a blade's width.
    float width = 0.004f;
    /// [N m2] E I, 1e-12 to 1e12. Default 4.2e-5: a blade folded to a V, folded_rigidity(5e8, 0.004, 2.5e-4, 0.001).
    float rigidity = 4.2e-5f;
    /// C_d, 0 to 10. Default 1.95: a long flat plate across the wind (Luhar & Nepf 2011). A round stem has 1.1, a crown 0.3. 0:
    /// no wind bends it.
    float drag_coefficient = 1.95f;
    /// [kg/m3] rho, 0 to 2000. Default 1.2: air at 20 C.
    float air_density = 1.2f;
    /// V, -2 to 0: what the drag loses by closing up of leaves and twigs, as U^V beyond `vogel_speed`. Default 0: only what the
    /// bend itself takes away, which makes -2/3. Crowns: -0.7 (Vogel 1989 and others: -0.2 to -1.2).
    float vogel_exponent = 0.0f;
    /// [m/s] U_r, 1e-3 to 1e3, only with an exponent. Default 5: where leaves begin to turn and fold.
    float vogel_speed = 5.0f;
    /// [rad] The bend that the tip never exceeds, 0 to 2.5. Default pi/2, which no wind exceeds; a spring that overshoots may.
    /// Shells keep to pi/2 whatever stands here.
    float most_bend = 1.57079633f;
};

/// For shaders: WindrowDrag of shaders/numerics/plant_drag.glsl, which says what each component is.
struct DragBlock {
    glm::vec4 load{0.0f};
};
static_assert(sizeof(DragBlock) == 16);

/// Every reason why it cannot be used, a line each; `name` stands before each field.
[[nodiscard]] Result<void> validate(const Drag& drag, const char* name = "drag");
/// Of a valid one.
[[nodiscard]] DragBlock block(const Drag& drag);

/// Ca at a speed [m/s] across the stalk.
[[nodiscard]] double cauchy_number(const Drag& drag, double speed);
/// [rad] Lean of the tip in a steady wind [m/s] across the stalk, 0 to pi/2.
[[nodiscard]] float bend_angle(const Drag& drag, float speed);

/// [N m2] E I of sections of one material of Young's modulus E [Pa]; all lengths [m].
[[nodiscard]] float rectangle_rigidity(float young, float width, float thickness);
/// A strip of this width and thickness folded along its middle to a V of this depth: 16 times as stiff as flat, if the depth is 4
/// times the thickness.
[[nodiscard]] float folded_rigidity(float young, float width, float thickness, float depth);
[[nodiscard]] float rod_rigidity(float young, float diameter);
[[nodiscard]] float tube_rigidity(float young, float outer_diameter, float inner_diameter);

} // namespace windrow
