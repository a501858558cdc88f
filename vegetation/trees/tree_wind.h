// What the wind meets of a tree: the classes of its trunk, limbs and twigs, and how stiff each limb is within its class.
//
//   Ca ~ rho C_d w L^3 U^2 / (2 E I),  I ~ d^4                         of one wood, the foliage's width w proportional to L
//   stiffness over that of the class = (L_class / L)^4 (d / d_class)^4
//
// A tree that a place scales as a whole keeps all of these: w L^3 and d^4 grow alike.
#pragma once

#include "coupling/tree.h"
#include "vegetation/trees/tree_settings.h"

namespace windrow::vegetation::trees {

/// Of valid settings: classes that windrow::Tree::create takes.
[[nodiscard]] windrow::TreeClasses wind_classes(const TreeSettings& settings);
/// A limb's stiffness over the class, by its length and its radius at the root [m].
[[nodiscard]] float limb_stiffness(const TreeSettings& settings, float length, float radius);

} // namespace windrow::vegetation::trees
