// Obstacles: bodies that the air flows around. A house, a trunk, a person, a train, a fence, a sail.
//
// A body is a shape with a place and an orientation. Cells whose centre is inside are closed; the faces of cells that the
// surface cuts are open in part, so a sphere is round and a slow body moves without jerks. A plate has no thickness: it closes
// the faces between cells before and behind it. So does each body that is thinner than a cell, where the line between two cell
// centres passes through it.
#pragma once

#include "api.h"
#include "motor.h"
#include "shapes/height_map.h"
#include "shapes/triangle_mesh.h"
#include "shapes/voxel_grid.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <variant>

namespace windrow {

/// Box with its own axes.
struct Block {
    static constexpr const char* k_name = "block";
    static constexpr const char* k_meaning = "A box with its own axes: a house, a wall.";
    /// [m] Each component a number above 0, at most 1e6, default (1, 1, 1). From the centre to the faces, along its own axes.
    glm::vec3 half_size{1.0f};

    static constexpr auto settings() {
        return std::tuple{
            Setting("half_size", &Block::half_size, k_size_range, "From the centre to the faces, along its own axes.")};
    }
};

/// Cylinder along its own y axis.
struct Cylinder {
    static constexpr const char* k_name = "cylinder";
    static constexpr const char* k_meaning = "A cylinder along its own y axis: a trunk, a tower.";
    /// [m] A number above 0, at most 1e6, default 1. Radius.
    float radius = 1.0f;
    /// [m] A number above 0, at most 1e6, default 1. From the centre to each end.
    float half_length = 1.0f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("radius", &Cylinder::radius, k_size_range, "Radius."),
            Setting("half_length", &Cylinder::half_length, k_size_range, "From the centre to each end."),
        };
    }
};

/// Rectangle without thickness, normal to its own z axis.
struct Plate {
    static constexpr const char* k_name = "plate";
    static constexpr const char* k_meaning = "A rectangle without thickness, across its own z axis: a fence, a sail, a door.";
    /// [m] Each component a number above 0, at most 1e6, default (1, 1). From the centre to the edges, along its own x and y
    /// axes.
    glm::vec2 half_size{1.0f};

    static constexpr auto settings() {
        return std::tuple{Setting("half_size", &Plate::half_size, k_size_range.of_pair("x, y"),
                                  "From the centre to the edges, along its own x and y axes.")};
    }
};

/// Closed mesh in its own coordinates; any number of bodies may use one. Parts thinner than four cells of the air make it a thin body,
/// as a thin block is.
struct MeshShape {
    static constexpr const char* k_name = "mesh";
    static constexpr const char* k_meaning = "A closed mesh of triangles: a house, a statue, a vehicle.";
    std::shared_ptr<const TriangleMesh> mesh{}; ///< null is rejected
    /// 1e-6 to 1e6, default 1. Factor on its size.
    float scale = 1.0f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("file", &MeshShape::mesh,
                    "OBJ file with a closed surface, beside the scene: y up, in metres. Its origin is at the position."),
            Setting("scale", &MeshShape::scale, {1e-6, 1e6}, "Factor on its size."),
        };
    }
};

/// Closed cells of a grid, which is centred; any number of bodies may use one.
struct VoxelShape {
    static constexpr const char* k_name = "voxels";
    static constexpr const char* k_meaning = "Closed cells of a grid: a building of a voxel game.";
    std::shared_ptr<const VoxelGrid> grid{}; ///< null is rejected
    /// [m] 1e-6 to 1e6, default 1. Edge of a voxel.
    float cell_size = 1.0f;

    static constexpr auto settings() {
        return std::tuple{
            Setting(
                "file", &VoxelShape::grid,
                "MagicaVoxel file (.vox) beside the scene: all models that are not hidden, as they stand in its editor. Its z "
                "axis points up; the middle of all is at the position."),
            Setting("cell_size", &VoxelShape::cell_size, {1e-6, 1e6, "m"}, "Edge of a voxel."),
        };
    }
};

/// What is beyond the edge of a ground's height map.
enum class Beyond : std::uint8_t {
    edge,    ///< The ground goes on as on its edge, so that it ends nowhere. The default: one map for the whole world.
    nothing, ///< It ends in an upright face along its outermost corners: one tile of several.
};
template <>
inline constexpr std::array<const char*, 2> k_words<Beyond>{"edge", "nothing"};

/// All that is below a height map, to any depth. The position is that of height 0 at the map's first corner. Upright, it takes less
/// time than turned about a level axis.
///
/// Upright grounds at rest with `nothing` beyond are tiles of one surface: where two meet or overlap, the higher counts, and no wall
/// is between them. They come, go and are replaced while the wind runs; one that has not come yet leaves a gap, with walls about it.
///
/// Where its map has a hole (HoleMask) there is no ground to any depth: a shaft with upright walls, in which other bodies stand, as the
/// walls and the roof of a tunnel. Ground between holes that is thinner than a cell and a half is not tight.
struct Ground {
    static constexpr const char* k_name = "ground";
    static constexpr const char* k_meaning = "All below a height map: hills, a valley, a dam.";
    std::shared_ptr<const HeightMap> heights{}; ///< null is rejected
    /// Each component 0.001 to 100000, default (1, 1, 1). Factor on its size along x, y and z: the metres of a pixel, and the
    /// metres of white over black.
    glm::vec3 scale{1.0f};
    /// Default edge. What is beyond the edge of its heights. edge: they go on as on it. nothing: it ends there; such grounds,
    /// upright and at rest, are the tiles of one surface, whose higher one counts where two meet.
    Beyond beyond = Beyond::edge;

    static constexpr auto settings() {
        return std::tuple{
            Setting(
                "file", &Ground::heights,
                "Picture of 8 or 16 bits beside the scene, PGM, PNG or a raw square of 16 bits: a pixel a metre, black is 0 "
                "m, white 1 m, "
                "rows along z. A TIFF of floats or of numbers with a sign has metres, and so has an ASCII grid (.asc). Its first "
                "pixel is at "
                "the position."),
            Setting("scale", &Ground::scale, {1e-3, 1e5},
                    "Factor on its size along x, y and z: the metres of a pixel, and the metres of white over black."),
            Setting("beyond", &Ground::beyond,
                    "What is beyond the edge of its heights. edge: they go on as on it. nothing: it ends there; such grounds, "
                    "upright and at rest, are the tiles of one surface, whose higher one counts where two meet."),
        };
    }
};

/// Rejects a mesh, a grid and heights that are missing, and those of more than 1e6 m.
WINDROW_API void check_rules(detail::Reasons& reasons, const detail::FieldPath& path, const MeshShape& shape);
WINDROW_API void check_rules(detail::Reasons& reasons, const detail::FieldPath& path, const VoxelShape& shape);
WINDROW_API void check_rules(detail::Reasons& reasons, const detail::FieldPath& path, const Ground& shape);

using Shape = std::variant<Sphere, Capsule, Block, Cylinder, Plate, MeshShape, VoxelShape, Ground>;

/// What the air does along a surface.
enum class Surface : std::uint8_t {
    free_slip, ///< It slides. The default: at 1 m cells the layer that a wall slows is thinner than a cell.
    no_slip,   ///< It sticks, through the viscosity.
};
template <>
inline constexpr std::array<const char*, 2> k_words<Surface>{"free_slip", "no_slip"};

/// A body that the air flows around, at rest or moved by its host.
struct Obstacle {
    /// [m] Each component -1e12 to 1e12, default (0, 0, 0). Centre of the shape; the origin of a mesh.
    glm::dvec3 position{0.0};
    /// A finite vector that is not 0. From the shape's own axes to the world's. Default: not turned.
    glm::quat orientation{1, 0, 0, 0};
    /// Its form and size.
    Shape shape = Block{};
    /// Default free_slip. free_slip: the air slides along it. At 1 m cells the layer that a wall slows is thinner than a cell.
    /// no_slip: the air sticks to it, through the viscosity.
    Surface surface = Surface::free_slip;

    static constexpr auto settings() {
        return std::tuple{
            Setting("position", &Obstacle::position, k_world_range, "Centre of the shape; the origin of a mesh."),
            Setting("orientation", &Obstacle::orientation, Range::direction(),
                    "From the shape's own axes to the world's. Default: not turned."),
            Setting("shape", &Obstacle::shape, "Its form and size."),
            Setting("surface", &Obstacle::surface,
                    "free_slip: the air slides along it. At 1 m cells the layer that a wall slows is thinner than a cell. "
                    "no_slip: the air sticks to it, through the viscosity."),
        };
    }
};

/// All reasons why an obstacle is invalid, one per line.
[[nodiscard]] WINDROW_API Result<void> validate(const Obstacle& obstacle);

/// An obstacle as a step sees it, relative to the box's low corner.
struct PlacedObstacle {
    Shape shape = Block{};
    Surface surface = Surface::free_slip;
    glm::vec3 position{0.0f};             ///< [m] from the low corner, at the end of the step
    glm::mat3 axes{1.0f};                 ///< from its own axes to the world's
    glm::vec3 velocity{0.0f}, spin{0.0f}; ///< [m/s], [rad/s] of its motion in the step
    std::uint32_t slot = 0;               ///< of its handle, where a Wind places it
    std::uint32_t generation = 0;         ///< as `slot`

    /// [m/s] Of the point of the body at a place.
    [[nodiscard]] glm::vec3 velocity_at(glm::vec3 place) const { return velocity + glm::cross(spin, place - position); }
    [[nodiscard]] bool moves() const { return velocity != glm::vec3(0.0f) || spin != glm::vec3(0.0f); }
};

namespace detail {
using windrow::PlacedObstacle;

[[nodiscard]] WINDROW_API Result<void> validate_pose(glm::dvec3 position, glm::quat orientation,
                                                     std::optional<glm::vec3> spin = std::nullopt);

/// [m] From a point in the shape's own axes to its surface, negative inside; a plate has no inside. Beyond `most` it may be any
/// value from `most` on, of the right sign, which takes less time.
[[nodiscard]] WINDROW_API float distance_to(const Shape& shape, glm::vec3 point,
                                            float most = std::numeric_limits<float>::infinity());
/// Unit vector out of the shape's surface at a point near it, from distances at `step` [m] on either side; zero where they are equal.
/// `most`: as in distance_to, above any of them.
[[nodiscard]] WINDROW_API glm::vec3 normal_at(const Shape& shape, glm::vec3 point, float step,
                                              float most = std::numeric_limits<float>::infinity());
/// [m] Half the size of the box along the shape's own axes, about its origin, that holds it.
[[nodiscard]] WINDROW_API glm::vec3 half_extent(const Shape& shape);
/// Box [m] along the world's axes that holds it, from its position.
struct Extent {
    glm::vec3 low{0.0f}, high{0.0f};
};
[[nodiscard]] WINDROW_API Extent extent_of(const PlacedObstacle& obstacle);
/// The same of a box along an obstacle's own axes.
[[nodiscard]] WINDROW_API Extent extent_of(const glm::mat3& axes, Extent own);
/// A part of a ground or a hole of it: a rectangle [m] along its own x and z, from its position; infinite where it goes on beyond an
/// edge.
struct GroundPart {
    glm::vec2 first{0.0f}, last{0.0f};
    /// [m] From a place outside of it; 0: it holds the place.
    [[nodiscard]] float outside(glm::vec2 place) const {
        return glm::length(glm::max(glm::max(first - place, place - last), 0.0f));
    }
    /// [m] From a place within it to its next side.
    [[nodiscard]] float before_end(glm::vec2 place) const {
        const glm::vec2 before = glm::min(place - first, last - place);
        return glm::min(before.x, before.y);
    }
};
/// `part` of its map.
[[nodiscard]] WINDROW_API GroundPart part_of(const Ground& ground, const HeightMap::Part& part);
/// Of the whole map.
[[nodiscard]] WINDROW_API GroundPart whole_of(const Ground& ground);
/// Whether there is ground below all places within `distance` [m] of one along each of its own axes.
[[nodiscard]] WINDROW_API bool holds(const Ground& ground, glm::vec2 place, float distance = 0.0f);
/// [m] Of the ground under a point in its own axes; beyond the edge as on it.
[[nodiscard]] WINDROW_API float height_at(const Ground& ground, glm::vec3 point);
/// [m] Least height over a part of the ground along the line between two points in its own axes, below 0 where the line is under it;
/// infinite where no part of the line is over it. Exact: within a texel the height over a bilinear surface is a quadratic of the way.
[[nodiscard]] WINDROW_API float least_rise(const Ground& ground, const GroundPart& part, glm::vec3 from, glm::vec3 to);
/// The parts of the way from a place to another that are within a part of a ground; from more than to: none.
[[nodiscard]] glm::vec2 part_within(const GroundPart& ground, glm::vec2 from, glm::vec2 to);
/// A line that comes as near as this fraction of its length to a surface touches it.
inline constexpr float k_touches = 1e-4f;
/// [m] Lowest and highest of the ground within a distance of a point, or of more; where it ends, the lowest is that of its depth.
[[nodiscard]] WINDROW_API glm::vec2 heights_near(const Ground& ground, glm::vec3 point, float distance);
/// Places obstacles as they are `early` [s] before the end of the step.
WINDROW_API void move_back(std::span<PlacedObstacle> obstacles, double early);
/// Whether two shapes are the same, to the bit.
[[nodiscard]] WINDROW_API bool same(const Shape& a, const Shape& b);
/// A total order by what bodies are, the place first: none precedes the other only where all is equal.
[[nodiscard]] WINDROW_API bool precedes(const PlacedObstacle& a, const PlacedObstacle& b);
/// [m] Smallest thickness.
[[nodiscard]] WINDROW_API float thickness(const Shape& shape);
/// Whether the segment between two points outside, in the shape's own axes, passes through it.
[[nodiscard]] WINDROW_API bool blocks(const Shape& shape, glm::vec3 from, glm::vec3 to);
} // namespace detail

} // namespace windrow
