// Tiles of ground among the bodies of a box: what a placement knows of each (tiles.cpp).
#pragma once

#include "fluid/obstacle.h"

#include <cstdint>

namespace windrow {

struct GroundTile {
    std::size_t body;
    detail::Extent extent; ///< [m] around its middle
    std::uint32_t kind;    ///< as TiledGround::add
};

/// An image of one.
struct GroundTilePlace {
    const PlacedObstacle* body;
    glm::ivec3 image;              ///< by how many boxes it is from the body
    glm::vec3 position, low, high; ///< [m]
};

/// Of a column of cells: the first tile that holds its centre, the first that reaches into it, the highest whose cells it is among.
struct ColumnTiles {
    static constexpr std::uint32_t k_none = ~std::uint32_t{0};
    std::uint32_t holder = k_none, beside = k_none, highest = k_none; ///< numbers of places
};

} // namespace windrow
