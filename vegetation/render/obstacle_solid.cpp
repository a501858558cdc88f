#include "vegetation/render/obstacle_solid.h"

#include "fluid/shapes/triangle_mesh.h"
#include "fluid/shapes/voxel_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>
#include <vector>

namespace windrow::vegetation::render {
namespace {

constexpr glm::vec3 k_plaster{0.56f, 0.51f, 0.42f};
constexpr glm::vec3 k_timber{0.20f, 0.135f, 0.080f};
constexpr glm::vec3 k_solid_cloth{0.150f, 0.042f, 0.026f};
constexpr glm::vec3 k_stone{0.30f, 0.29f, 0.27f};
constexpr float k_plate_half = 0.02f;                     // [m] of the drawn thickness
constexpr float k_frame_out = 0.03f, k_glass_out = 0.05f; // [m] before the wall, so that neither flickers
constexpr float k_frame_width = 0.10f;                    // [m]
constexpr glm::vec2 k_door{1.1f, 2.1f};
constexpr int k_sides = 32, k_arcs = 8; // around, and from a pole to the equator

/// A ball, or one drawn apart along y, by its profile.
Solid capsule(float radius, float half_length, glm::vec3 colour) {
    std::vector<glm::vec2> profile;
    for (const float end : {-1.0f, 1.0f})
        for (int n = 0; n <= k_arcs; ++n) {
            const float angle = glm::half_pi<float>() * (static_cast<float>(n) / k_arcs + (end < 0.0f ? -1.0f : 0.0f));
            profile.push_back({radius * std::cos(angle), radius * std::sin(angle) + end * half_length});
        }
    if (half_length == 0.0f) // the equator once
        profile.erase(profile.begin() + k_arcs);
    return lathe(profile, k_sides, colour);
}

Solid cylinder(const Cylinder& shape, glm::vec3 colour) {
    const float r = shape.radius, h = shape.half_length;
    // Apart, so that the edges are sharp.
    Solid solid = lathe(std::array{glm::vec2(r, -h), glm::vec2(r, h)}, k_sides, colour);
    add(solid, lathe(std::array{glm::vec2(0.0f, -h), glm::vec2(r, -h)}, k_sides, colour));
    add(solid, lathe(std::array{glm::vec2(r, h), glm::vec2(0.0f, h)}, k_sides, colour));
    return solid;
}

/// A rectangle before the side of a wall: its middle from the wall's, in the wall's own axes.
void add_panel(Solid& solid, const glm::mat4& wall, glm::vec2 middle, glm::vec2 half, float out, glm::vec3 colour) {
    add(solid, box({half, 0.5f * out}, colour), glm::translate(wall, {middle, 0.5f * out}));
}

void add_windows(Solid& solid, const Block& block, const WallWindows& windows) {
    const glm::vec2 half = 0.5f * glm::vec2(windows.width, windows.height);
    const auto count = [](float length, float each) { return static_cast<int>(std::clamp(length / each, 0.0f, 200.0f)); };
    const int storeys = count(2.0f * block.half_size.y + 0.3f, windows.storey);
    for (int side = 0; side < 4; ++side) { // +z, +x, -z, -x
        const glm::vec3 size =
            side % 2 == 0 ? block.half_size : glm::vec3(block.half_size.z, block.half_size.y, block.half_size.x);
        const glm::mat4 turned =
            glm::rotate(glm::mat4(1.0f), static_cast<float>(side) * glm::half_pi<float>(), glm::vec3(0.0f, 1.0f, 0.0f));
        const glm::mat4 wall = glm::translate(turned, {0.0f, -size.y, size.z});
        const int columns = count(2.0f * size.x - 0.6f, windows.spacing);
        const bool door = windows.door && side == 0 && 2.0f * size.x > k_door.x && 2.0f * size.y > k_door.y;
        if (door) {
            const glm::vec2 frame = 0.5f * k_door + k_frame_width * glm::vec2(1.0f, 0.5f);
            add_panel(solid, wall, {0.0f, frame.y}, frame, k_frame_out, windows.frame);
            add_panel(solid, wall, {0.0f, 0.5f * k_door.y}, 0.5f * k_door, k_glass_out, windows.glass);
        }
        for (int storey = 0; storey < storeys; ++storey)
            for (int column = 0; column < columns; ++column) {
                const glm::vec2 middle(windows.spacing * (static_cast<float>(column) - 0.5f * static_cast<float>(columns - 1)),
                                       windows.storey * static_cast<float>(storey) + windows.sill + half.y);
                const bool fits = middle.y + half.y < 2.0f * size.y;
                if (!fits || (door && storey == 0 && std::abs(middle.x) < half.x + 0.5f * k_door.x + 2.0f * k_frame_width))
                    continue;
                add_panel(solid, wall, middle, half + k_frame_width, k_frame_out, windows.frame);
                add_panel(solid, wall, middle, half, k_glass_out, windows.glass);
            }
    }
}

/// Flat faces, each triangle with its own normal.
Solid mesh(const MeshShape& shape, glm::vec3 colour) {
    const MeshData& data = shape.mesh->data();
    Solid solid;
    for (const glm::uvec3 corners : data.triangles) {
        const glm::vec3 a = shape.scale * data.vertices[corners.x], b = shape.scale * data.vertices[corners.y],
                        c = shape.scale * data.vertices[corners.z];
        const glm::vec3 across = glm::cross(b - a, c - a);
        const float length = glm::length(across);
        const glm::vec3 normal = length > 0.0f ? across / length : glm::vec3(0.0f, 1.0f, 0.0f);
        for (const glm::vec3 at : {a, b, c})
            solid.push_back({glm::vec4(at, 0.0f), glm::vec4(normal, 0.0f), glm::vec4(colour, 0.0f)});
    }
    return solid;
}

/// The faces between closed and open cells.
Solid voxels(const VoxelShape& shape, glm::vec3 colour) {
    const VoxelGrid& grid = *shape.grid;
    const glm::ivec3 cells = grid.data().cells;
    Solid solid;
    for (int z = 0; z < cells.z; ++z)
        for (int y = 0; y < cells.y; ++y)
            for (int x = 0; x < cells.x; ++x)
                for (int face = 0; face < 6 && grid.closed({x, y, z}); ++face) {
                    const int axis = face / 2;
                    glm::ivec3 beside(x, y, z);
                    beside[axis] += face % 2 == 0 ? -1 : 1;
                    if (beside[axis] >= 0 && beside[axis] < cells[axis] && grid.closed(beside))
                        continue;
                    glm::vec3 normal(0.0f), u(0.0f), v(0.0f);
                    normal[axis] = face % 2 == 0 ? -0.5f : 0.5f;
                    u[(axis + 1) % 3] = 0.5f;
                    v[(axis + 2) % 3] = 0.5f;
                    const glm::vec3 middle = glm::vec3(x, y, z) + 0.5f - 0.5f * glm::vec3(cells) + normal;
                    for (const glm::vec3 corner : {-u - v, u - v, u + v, -u - v, u + v, v - u})
                        solid.push_back({glm::vec4(shape.cell_size * (middle + corner), 0.0f), glm::vec4(2.0f * normal, 0.0f),
                                         glm::vec4(colour, 0.0f)});
                }
    return solid;
}

struct SolidOf {
    const ObstacleLook& look;

    [[nodiscard]] glm::vec3 colour(glm::vec3 plain) const { return look.colour.value_or(plain); }

    Solid operator()(const Sphere& shape) const { return capsule(shape.radius, 0.0f, colour(k_stone)); }
    Solid operator()(const Capsule& shape) const {
        const float half = glm::length(shape.half_axis);
        const Solid upright = capsule(shape.radius, half, colour(k_solid_cloth));
        if (!(half > 0.0f))
            return upright;
        Solid solid;
        const glm::vec3 y = shape.half_axis / half;
        const glm::vec3 x =
            glm::normalize(glm::cross(y, std::abs(y.z) < 0.9f ? glm::vec3(0.0f, 0.0f, 1.0f) : glm::vec3(1.0f, 0.0f, 0.0f)));
        add(solid, upright, glm::mat4(glm::mat3(x, y, glm::cross(x, y))));
        return solid;
    }
    Solid operator()(const Block& shape) const {
        Solid solid = box(shape.half_size, colour(k_plaster));
        if (look.ends)
            for (SolidVertex& vertex : solid)
                if (vertex.normal.x != 0.0f)
                    vertex.colour = glm::vec4(*look.ends, 0.0f);
        if (look.windows)
            add_windows(solid, shape, *look.windows);
        return solid;
    }
    Solid operator()(const Cylinder& shape) const { return cylinder(shape, colour(k_timber)); }
    Solid operator()(const MeshShape& shape) const { return mesh(shape, colour(k_plaster)); }
    Solid operator()(const VoxelShape& shape) const { return voxels(shape, colour(k_plaster)); }
    Solid operator()(const windrow::Ground&) const { return {}; } // the picture's own ground is drawn
    Solid operator()(const Plate& shape) const { return box({shape.half_size, k_plate_half}, colour(k_timber)); }
};

} // namespace

Solid obstacle_solid(const Shape& shape, const ObstacleLook& look) {
    return std::visit(SolidOf{look}, shape);
}

} // namespace windrow::vegetation::render
