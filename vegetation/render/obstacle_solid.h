// Obstacles of the wind as solids to draw: the surface of each shape, in a colour, with windows on the walls of a house.
#pragma once

#include "../../fluid/obstacle.h"
#include "solids.h"

#include <glm/vec3.hpp>
#include <optional>
#include <tuple>

namespace windrow::vegetation::render {

/// Rows of windows on the four walls of a block.
struct WallWindows {
    float width = 0.9f;
    float height = 1.2f;
    float spacing = 2.4f;
    float storey = 2.7f;
    float sill = 0.9f;
    bool door = false;
    glm::vec3 glass{0.030f, 0.036f, 0.045f};
    glm::vec3 frame{0.55f, 0.52f, 0.46f};

    static constexpr auto settings() {
        return std::tuple{
            Setting("width", &WallWindows::width, Range::above(0.0, 1e3, "m"), "Width of a window."),
            Setting("height", &WallWindows::height, Range::above(0.0, 1e3, "m"), "Height of a window."),
            Setting("spacing", &WallWindows::spacing, {0.2, 1e3, "m"}, "Distance of their middles along a wall."),
            Setting("storey", &WallWindows::storey, {0.5, 1e3, "m"},
                    "Height of a storey: one row of windows each, from the block's foot upward."),
            Setting("sill", &WallWindows::sill, {0.0, 1e3, "m"},
                    "Height of a window's lower edge above the floor of its storey."),
            Setting("door", &WallWindows::door, "Whether the wall that faces along its own +z axis has a door in the middle."),
            Setting("glass", &WallWindows::glass, {0.0, 1.0}, "Linear albedo of panes and door."),
            Setting("frame", &WallWindows::frame, {0.0, 1.0}, "Linear albedo of the frames."),
        };
    }
};

/// How the obstacles of one name are drawn. Default: plaster for blocks, meshes and voxels, timber for a plate or a cylinder, cloth
/// for a capsule, stone for a sphere.
struct ObstacleLook {
    std::string name = "obstacle";
    std::optional<glm::vec3> colour{};
    std::optional<glm::vec3> ends{};
    std::optional<WallWindows> windows{};
    bool hidden = false;

    static constexpr auto settings() {
        return std::tuple{
            Setting("name", &ObstacleLook::name, "Name of the obstacles that it is for."),
            Setting("colour", &ObstacleLook::colour, {0.0, 1.0}, "Linear albedo. Default: by the shape, as plaster or timber."),
            Setting("ends", &ObstacleLook::ends, {0.0, 1.0},
                    "Linear albedo of the two faces of a block across its own x axis, as the gables below a roof. Default: as "
                    "colour."),
            Setting("windows", &ObstacleLook::windows, "On the four walls of a block. Default: none."),
            Setting("hidden", &ObstacleLook::hidden, "Whether they are not drawn."),
        };
    }
};

/// In the shape's own axes. A plate has a thickness of 4 cm.
[[nodiscard]] Solid obstacle_solid(const Shape& shape, const ObstacleLook& look);

} // namespace windrow::vegetation::render
