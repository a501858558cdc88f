// Drag of a uniform plant canopy on the wind inside it.
//
//     auto wind = windrow::Wind::create({.boundaries = windrow::Boundaries::open_over_floor(), .ambient = {6.0f, 0.0f, 0.0f},
//                                        .profile = windrow::LogProfile{}, .canopy = windrow::Canopy{.height = 0.8f}});
#pragma once

#include "api.h"
#include "result.h"
#include "setting.h"

#include <tuple>

namespace windrow {

/// A field of plants on the ground, of uniform height and density. The ground is that of the wind profile: the box's floor, or
/// height 0 without one. Within it du/dt = -drag |u| u. Costs one pass over the rows of cells that it reaches.
struct Canopy {
    /// [m] 0 (none) to 1000, default 0.8. Height of the plants; 0.8 is ripe wheat. A cell that it fills in part is slowed by that
    /// fraction.
    float height = 0.8f;
    /// [1/m] 0 (none) to 1000, default 0.6. Drag coefficient, 0.15 to 0.3, times leaf area in a volume of air: wheat 0.6 (0.2
    /// times leaves of 2.4 times the area of its ground), short grass 2 to 5, a forest 0.03 to 0.1. Based on: Shaw & Schumann
    /// 1992, Boundary-Layer Meteorology 61 (0.15).
    float drag = 0.6f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("height", &Canopy::height, {.min = 0.0, .max = 1000.0, .unit = "m", .zero = "none"},
                    "Height of the plants; 0.8 is ripe wheat. A cell that it fills in part is slowed by that fraction."),
            Setting(
                "drag", &Canopy::drag, {.min = 0.0, .max = 1000.0, .unit = "1/m", .zero = "none"},
                "Drag coefficient, 0.15 to 0.3, times leaf area in a volume of air: wheat 0.6 (0.2 times leaves of 2.4 times the "
                "area of its ground), short grass 2 to 5, a forest 0.03 to 0.1. Based on: Shaw & Schumann 1992, Boundary-Layer "
                "Meteorology 61 (0.15)."),
        };
    }
};

/// All reasons why it is invalid, one per line.
[[nodiscard]] WINDROW_API Result<void> validate(const Canopy& canopy);

} // namespace windrow
