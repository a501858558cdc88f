// Flows with known solutions, as functions of place and time. Positions are metres from the box's low corner, in double.
#pragma once

#include "fluid/motor.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace windrow::cases {

/// Taylor and Green's vortices in the plane of two axes, carried by a mean wind: an exact solution of Navier and Stokes'
/// equations in a periodic box of 2 pi.
///
///     u = U + F sin(x - U t) cos(y - V t),  v = V - F cos(x - U t) sin(y - V t),  F = exp(-2 nu t)
///
/// Based on: Taylor & Green 1937, Proceedings of the Royal Society A 158.
struct TaylorGreen2D {
    glm::dvec3 mean{0.0};   ///< [m/s]
    double viscosity = 0.0; ///< [m^2/s]
    int a = 0, b = 1;       ///< axes of x and y above

    glm::dvec3 operator()(glm::dvec3 x, double t) const {
        const double fade = std::exp(-2.0 * viscosity * t);
        const glm::dvec3 p = x - mean * t;
        glm::dvec3 u = mean;
        u[a] += fade * std::sin(p[a]) * std::cos(p[b]);
        u[b] -= fade * std::cos(p[a]) * std::sin(p[b]);
        return u;
    }
};

/// Arnold, Beltrami and Childress' flow, its own curl, so that u . grad u is a gradient and the flow only fades; in a mean wind
/// W it is W + u(x - W t, t). Exact in a periodic box of 2 pi. Based on: Dombre, Frisch, Greene, Henon, Mehr & Soward 1986,
/// Journal of Fluid Mechanics 167.
struct ArnoldBeltramiChildress {
    glm::dvec3 mean{0.0};   ///< [m/s]
    double viscosity = 0.0; ///< [m^2/s]
    double a = 1.0, b = 0.8, c = 0.6;

    glm::dvec3 operator()(glm::dvec3 x, double t) const {
        const glm::dvec3 p = x - mean * t;
        return mean + std::exp(-viscosity * t) * glm::dvec3(a * std::sin(p.z) + c * std::cos(p.y),
                                                            b * std::sin(p.x) + a * std::cos(p.z),
                                                            c * std::sin(p.y) + b * std::cos(p.x));
    }
};

/// Taylor and Green's vortices in space, at the start: they stretch into sheets, and no closed form is known. Based on: Brachet,
/// Meiron, Orszag, Nickel, Morf & Frisch 1983, Journal of Fluid Mechanics 130.
[[nodiscard]] inline glm::dvec3 taylor_green_3d_start(glm::dvec3 x) {
    return {std::sin(x.x) * std::cos(x.y) * std::cos(x.z), -std::cos(x.x) * std::sin(x.y) * std::cos(x.z), 0.0};
}

/// Vortices in a mean wind that cross a motor, which moves and whose force rises and falls as sin^2(pi t / T), or is on from
/// the start. The weight of the force is prod (1 - s^2)^2 about its centre, wide, since it is only once differentiable.
struct ForcedVortices {
    static constexpr double k_end = 3.14159265358979323846; ///< [s] T
    static constexpr double k_viscosity = 1e-3, k_half_size = 1.4;
    static constexpr glm::dvec3 k_mean{1.0, 0.5, 0.0}, k_direction{0.6, 0.8, 0.0};
    bool at_once = false;

    [[nodiscard]] static glm::dvec3 start(glm::dvec3 x) { return TaylorGreen2D{.mean = k_mean}(x, 0.0); }
    /// [m/s^2] in the middle of the motor
    [[nodiscard]] double strength(double t) const { return at_once ? 1.5 : 3.0 * std::pow(std::sin(k_end * t / k_end), 2.0); }
    [[nodiscard]] static glm::dvec3 centre(double t) { return {2.4 + 0.5 * t, 3.4 - 0.3 * t, 0.0}; }
    [[nodiscard]] glm::dvec3 force(glm::dvec3 x, double t) const {
        const auto weight = [](double s) { return s * s < 1.0 ? std::pow(1.0 - s * s, 2.0) : 0.0; };
        return strength(t) * weight((x.x - 2.4 - 0.5 * t) / k_half_size) * weight((x.y - 3.4 + 0.3 * t) / k_half_size) *
               k_direction;
    }
    /// The same as a motor of the library, in a plane at `height` [m].
    [[nodiscard]] DirectionalMotor motor(double t, double height) const {
        constexpr float k_half = static_cast<float>(k_half_size);
        return {.position = centre(t) + glm::dvec3(0.0, 0.0, height),
                .direction = glm::vec3(k_direction),
                .region = AlignedBox{{k_half, k_half, 10.0f}},
                .law = Force{static_cast<float>(strength(t))},
                .turbulence = {.intensity = 0.0f}};
    }
};

} // namespace windrow::cases
