// What stands in the air while a step is timed, on the CPU and on a device: the same scenes for both.
#pragma once

#include "fluid/box.h"
#include "fluid/obstacles.h"

#include <glm/vec3.hpp>

namespace windrow::cli {

/// Where they are built, by a wind of either backend.
struct BuildingPlace {
    Obstacles& obstacles;
    Box box;
    glm::dvec3 origin; ///< the box's low corner [m]
};
template <class AnyWind>
[[nodiscard]] BuildingPlace place_of(AnyWind& wind) {
    return {wind.obstacles(), wind.box(), wind.origin()};
}

/// Each returns false where an obstacle was rejected.
[[nodiscard]] bool build_block(const BuildingPlace& place, glm::dvec3 position, glm::vec3 half_size);
/// 8 m each way, on the floor in the middle of the box.
[[nodiscard]] bool build_cube(const BuildingPlace& place);
/// Houses in rows over the floor, with 3 % of the cells at a surface; `length` times as far along x as the box is.
[[nodiscard]] bool build_town(const BuildingPlace& place, double length);
/// Ground that cuts every column of the box: two waves each way, up to three eighths of its height.
[[nodiscard]] bool build_hills(const BuildingPlace& place);

} // namespace windrow::cli
