// Takes the place of GustTile::bake by `ld --wrap`: a tile takes milliseconds to bake, and inputs name the same few seeds again and
// again. What is baked is not the parsers' concern.
#include "fluid/gust_tile.h"

#include <array>
#include <utility>

namespace windrow::fuzz {

using Tile = std::shared_ptr<const GustTile>;

Tile real_bake(std::uint32_t seed) asm("__real__ZN7windrow8GustTile4bakeEj");
Tile kept_bake(std::uint32_t seed) asm("__wrap__ZN7windrow8GustTile4bakeEj");

Tile kept_bake(std::uint32_t seed) {
    static std::array<Tile, 16> kept;
    static std::size_t next = 0;
    for (const Tile& tile : kept)
        if (tile && tile->seed() == seed)
            return tile;
    return kept[next++ % kept.size()] = real_bake(seed);
}

} // namespace windrow::fuzz
