// Predefined plants: their drag and stiffness, from measured moduli and typical sizes. docs/plants.md compares them with
// Beaufort's descriptions. The frequencies and dampings of the same classes are in spring.h.
//
// Young's moduli: wheat straw 4.8 GPa (O'Dogherty, Huber, Dyson & Marshall 1995: 4.76 to 6.58 GPa); reed 8 GPa (Albrecht and
// others 2023, The suitability of common reed for load-bearing structural materials); living branches 0.7 to 4.6 GPa, trunks at
// the lower end of 2.4 to 7.5 GPa (Cannell & Morgan 1987, Young's modulus of sections of living branches and tree trunks). Grass
// 0.5 GPa is our assumption: with its V section a blade of 0.3 m then stands upright. Sizes and foliage widths are typical ones,
// ours. Drag coefficients: flat plate 1.95, round stem 1.1, crown 0.3.
#pragma once

#include "drag.h"

namespace windrow {

/// A meadow's blade: 0.3 m, 4 mm wide, 0.25 mm thick, creased to a V 1 mm deep.
[[nodiscard]] inline Drag grass() {
    return {};
}

/// A stem of wheat with leaves and ear: 0.8 m, a tube of 4 and 3 mm.
[[nodiscard]] inline Drag wheat() {
    return {.length = 0.8f, .width = 0.008f, .rigidity = tube_rigidity(4.8e9f, 0.004f, 0.003f), .drag_coefficient = 1.1f};
}

/// A reed with its leaves turned downwind: 2 m, a tube of 6 and 4.4 mm.
[[nodiscard]] inline Drag reed() {
    return {.length = 2.0f, .width = 0.01f, .rigidity = tube_rigidity(8e9f, 0.006f, 0.0044f), .drag_coefficient = 1.1f};
}

/// A leaf on its stalk: 0.1 m, 0.04 m wide, held by a stalk of 1.3 mm of 1 GPa.
[[nodiscard]] inline Drag leaf() {
    return {.length = 0.1f,
            .width = 0.04f,
            .rigidity = rod_rigidity(1e9f, 0.0013f),
            .drag_coefficient = 1.0f,
            .vogel_exponent = -0.7f};
}

/// A leafy twig: 0.5 m, 4 mm thick, 2 GPa, foliage 6 cm wide.
[[nodiscard]] inline Drag twig() {
    return {.length = 0.5f,
            .width = 0.06f,
            .rigidity = rod_rigidity(2e9f, 0.004f),
            .drag_coefficient = 0.5f,
            .vogel_exponent = -0.7f};
}

/// A leafy branch: 2.5 m, 28 mm thick at its mean, 2.5 GPa, foliage 0.6 m wide.
[[nodiscard]] inline Drag branch() {
    return {.length = 2.5f,
            .width = 0.6f,
            .rigidity = rod_rigidity(2.5e9f, 0.028f),
            .drag_coefficient = 0.3f,
            .vogel_exponent = -0.7f};
}

/// The trunk of a small tree in leaf: 8 m, 0.12 m thick, 4 GPa, a crown of 15 m2.
[[nodiscard]] inline Drag small_trunk() {
    return {
        .length = 8.0f, .width = 1.9f, .rigidity = rod_rigidity(4e9f, 0.12f), .drag_coefficient = 0.3f, .vogel_exponent = -0.7f};
}

/// The trunk of a large tree in leaf: 20 m, 0.42 m thick at its mean, 6 GPa, a crown of 96 m2.
[[nodiscard]] inline Drag large_trunk() {
    return {
        .length = 20.0f, .width = 4.8f, .rigidity = rod_rigidity(6e9f, 0.42f), .drag_coefficient = 0.3f, .vogel_exponent = -0.7f};
}

} // namespace windrow
