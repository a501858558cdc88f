// Leaf cards on the twigs of a tree, and the order in which they go as it moves away.
#pragma once

#include "vegetation/trees/tree_shape.h"

#include <cstdint>

namespace windrow::vegetation::trees {

/// A card at rest: a kite from its root to its tip, folded along its middle.
struct LeafCard {
    glm::vec3 root{0.0f};              ///< [m]
    glm::vec3 along{0.0f};             ///< unit vector to its tip
    glm::vec3 across{0.0f};            ///< unit vector to its side
    float length = 0.1f, width = 0.1f; ///< [m]
    float chance = 0.0f;               ///< -1 to 1
    std::uint32_t cluster = 0;

    [[nodiscard]] glm::vec3 middle() const { return root + 0.5f * length * along; }
};

/// The cards of all clusters, in their order.
[[nodiscard]] std::vector<LeafCard> leaf_cards(const TreeSettings& settings, const shape::Shape& shape);

/// The order in which cards are kept: each of the first ones as far as can be from those before it, so that any number of them is
/// the whole crown; the rest by chance. Based on: Gonzalez 1985, Clustering to minimize the maximum intercluster distance.
[[nodiscard]] std::vector<std::uint32_t> keeping_order(const std::vector<LeafCard>& cards, std::uint32_t seed);

/// [m] From the middle of each of the first `count` cards of an order to the middle of the cards that are nearer to it than to
/// the others of the first ones.
[[nodiscard]] std::vector<glm::vec3> homes(const std::vector<LeafCard>& cards, const std::vector<std::uint32_t>& order,
                                           std::size_t count);

} // namespace windrow::vegetation::trees
