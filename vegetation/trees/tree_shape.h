// How a tree grows: trunk, limbs on it, branches on them, twigs with leaves on these.
//
// Based on: Weber & Penn 1995, Creation and rendering of realistic trees: limb lengths by the crown's form (ShapeRatio), child
// angles between a low and a high one, the turn of 137.5 or 140 degrees from child to child, radii by the power 1.2 of the ratio
// of lengths. Their splits of stems are left out.
#pragma once

#include "vegetation/trees/tree_settings.h"

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace windrow::vegetation::trees::shape {

// Rings of vertices along a stem, and vertices a ring.
inline constexpr int k_trunk_rings = 14, k_trunk_sides = 10;
inline constexpr int k_limb_rings = 7, k_limb_sides = 6;
inline constexpr int k_branch_rings = 3, k_branch_sides = 3;
inline constexpr std::uint32_t k_trunk_vertices = k_trunk_rings * k_trunk_sides;
// Afar the trunk is these of its rings, of every other vertex.
inline constexpr std::array k_coarse_rings{0, 2, 4, 8, 13};
inline constexpr std::uint32_t k_coarse_vertices = k_coarse_rings.size() * k_trunk_sides / 2;

/// A tapering tube along its middle line.
struct Stem {
    std::vector<glm::vec3> points{}; ///< [m] from the trunk's base
    std::vector<float> radii{};      ///< [m]
    int limb = -1;                   ///< that it is or grows on; -1: the trunk
};

/// A twig with leaf cards: what bends as one.
struct Cluster {
    glm::vec3 root{0.0f};             ///< [m] on its branch
    glm::vec3 axis{0.0f, 1.0f, 0.0f}; ///< unit vector
    float length = 0.3f;              ///< [m]
    int limb = 0;
};

struct Shape {
    Stem trunk;
    std::vector<Stem> limbs;
    std::vector<Stem> branches;
    std::vector<Cluster> clusters;
};

/// Branches of a limb, the one that ends it among them: as many a metre on all limbs, so that short ones are no denser.
[[nodiscard]] int branches_of(const TreeSettings& settings, int limb);
/// Of valid settings.
[[nodiscard]] Shape grow(const TreeSettings& settings);

/// Limb length over the longest, at a share of the crown's height from its top (0) to its base (1).
[[nodiscard]] float form_length(CrownForm form, float from_top);
/// [m] A point at share t of a stem's way, and its radius there.
[[nodiscard]] glm::vec3 point_on(const Stem& stem, float t);
[[nodiscard]] float radius_on(const Stem& stem, float t);

} // namespace windrow::vegetation::trees::shape
