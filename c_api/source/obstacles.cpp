// Calls of obstacles.h.
#include "c_api/obstacles.h"

#include "c_api/source/tables.h"
#include "fluid/core/message.h"

#include <string>
#include <vector>

using namespace windrow;
using namespace windrow::c_api;

namespace {

/// The outcome of a call with an id; its class is WINDROW_STALE where the id names nothing.
template <class T>
windrow_result done_with(const windrow_wind* wind, ObstacleId id, const Result<T>& outcome) {
    if (!outcome && wind->control->obstacles().find(id) == nullptr)
        return fail(WINDROW_STALE, outcome.error());
    return done(outcome);
}

Error wrong_count(const char* what, std::uint64_t count, std::uint64_t wanted) {
    return Error{detail::message(std::string_view(what), " has ", count, " entries: give ", wanted, ".")};
}

std::uint64_t positive(std::int32_t number) {
    return number > 0 ? static_cast<std::uint64_t>(number) : 0;
}

template <class Fill>
windrow_shape made(windrow_shape_kind kind, const Fill& fill) {
    windrow_shape shape{};
    shape.kind = kind;
    shape.scale = {1.0f, 1.0f, 1.0f};
    fill(shape);
    return shape;
}

} // namespace

// --- Forms -------------------------------------------------------------------------------------------------------------
WINDROW_EXPORT windrow_result windrow_mesh_create(const windrow_vec3* vertices, uint64_t vertex_count, const uint32_t* indices,
                                                  uint64_t triangle_count, windrow_mesh** mesh) {
    if (mesh != nullptr)
        *mesh = nullptr;
    return call({{vertices, "vertices"}, {indices, "indices"}}, [&] {
        return create(mesh, [&]() -> Result<std::shared_ptr<const TriangleMesh>> {
            if (triangle_count > TriangleMesh::k_max_triangles || vertex_count > 3 * TriangleMesh::k_max_triangles)
                return Error{detail::message("mesh has ", triangle_count, " triangles and ", vertex_count,
                                             " vertices: give at most ", TriangleMesh::k_max_triangles, " triangles.")};
            const auto* corners = same_layout<const glm::vec3>(vertices);
            MeshData data{.vertices = {corners, corners + vertex_count}, .triangles = {}};
            data.triangles.reserve(static_cast<std::size_t>(triangle_count));
            for (std::uint64_t n = 0; n < triangle_count; ++n)
                data.triangles.emplace_back(indices[3 * n], indices[3 * n + 1], indices[3 * n + 2]);
            return TriangleMesh::create(std::move(data));
        });
    });
}
WINDROW_EXPORT void windrow_mesh_destroy(windrow_mesh* mesh) {
    delete mesh;
}
WINDROW_EXPORT windrow_result windrow_mesh_save(const windrow_mesh* mesh, windrow_bytes** bytes) {
    if (mesh == nullptr)
        return fail_null("mesh");
    return create(bytes, [&] { return mesh->mesh->save(); });
}
WINDROW_EXPORT windrow_result windrow_mesh_load(const void* bytes, uint64_t size, windrow_mesh** mesh) {
    if (mesh != nullptr)
        *mesh = nullptr;
    return call({{bytes, "bytes"}}, [&] {
        return create(mesh, [&] {
            return TriangleMesh::load({static_cast<const std::byte*>(bytes), static_cast<std::size_t>(size)});
        });
    });
}
WINDROW_EXPORT float windrow_mesh_distance(const windrow_mesh* mesh, windrow_vec3 point) {
    return value_of(mesh, "mesh", [&] { return mesh->mesh->distance_to(to_cpp(point)); });
}

WINDROW_EXPORT windrow_result windrow_voxels_create(windrow_ivec3 cells, const uint8_t* closed, uint64_t count,
                                                    windrow_voxels** voxels) {
    if (voxels != nullptr)
        *voxels = nullptr;
    return call({{closed, "closed"}}, [&] {
        return create(voxels, [&]() -> Result<std::shared_ptr<const VoxelGrid>> {
            if (count > VoxelGrid::k_max_cells)
                return wrong_count("closed", count, positive(cells.x) * positive(cells.y) * positive(cells.z));
            return VoxelGrid::create({.cells = to_cpp(cells), .closed = {closed, closed + count}});
        });
    });
}
WINDROW_EXPORT void windrow_voxels_destroy(windrow_voxels* voxels) {
    delete voxels;
}

namespace {

Result<HeightData> heights_of(windrow_ivec2 corners, float spacing, const float* heights, std::uint64_t count) {
    if (const std::uint64_t wanted = positive(corners.x) * positive(corners.y); count != wanted)
        return wrong_count("heights", count, wanted);
    if (corners.x > HeightMap::k_max_corners || corners.y > HeightMap::k_max_corners) // before they are copied
        return Error{
            detail::message("corners is ", to_cpp(corners), ": give at most ", HeightMap::k_max_corners, " along an axis.")};
    return HeightData{.corners = to_cpp(corners), .spacing = spacing, .heights = {heights, heights + count}};
}

} // namespace

WINDROW_EXPORT windrow_result windrow_height_map_create(windrow_ivec2 corners, float spacing, const float* heights,
                                                        uint64_t count, windrow_height_map** map) {
    if (map != nullptr)
        *map = nullptr;
    return call({{heights, "heights"}}, [&] {
        return create(map, [&]() -> Result<std::shared_ptr<const HeightMap>> {
            auto data = heights_of(corners, spacing, heights, count);
            if (!data)
                return data.failure();
            return HeightMap::create(*std::move(data));
        });
    });
}
WINDROW_EXPORT windrow_result windrow_height_map_create_with_holes(windrow_ivec2 corners, float spacing, const float* heights,
                                                                   uint64_t count, windrow_ivec2 cells, const uint8_t* open,
                                                                   uint64_t cell_count, windrow_height_map** map) {
    if (map != nullptr)
        *map = nullptr;
    return call({{heights, "heights"}, {open, "open"}}, [&] {
        return create(map, [&]() -> Result<std::shared_ptr<const HeightMap>> {
            auto data = heights_of(corners, spacing, heights, count);
            if (!data)
                return data.failure();
            if (const std::uint64_t wanted = positive(cells.x) * positive(cells.y); cell_count != wanted)
                return wrong_count("open", cell_count, wanted);
            if (cells.x > HeightMap::k_max_corners || cells.y > HeightMap::k_max_corners)
                return Error{
                    detail::message("cells is ", to_cpp(cells), ": give at most ", HeightMap::k_max_corners, " along an axis.")};
            data->holes = {.cells = to_cpp(cells), .open = {open, open + cell_count}};
            return HeightMap::create(*std::move(data));
        });
    });
}
WINDROW_EXPORT void windrow_height_map_destroy(windrow_height_map* map) {
    delete map;
}
WINDROW_EXPORT float windrow_height_map_height(const windrow_height_map* map, windrow_vec2 place) {
    return value_of(map, "map", [&] { return map->map->height(to_cpp(place)); });
}
WINDROW_EXPORT windrow_vec3 windrow_height_map_normal(const windrow_height_map* map, windrow_vec2 place) {
    return value_of(map, "map", [&] { return to_c(map->map->normal(to_cpp(place))); });
}

// --- Shapes ------------------------------------------------------------------------------------------------------------
WINDROW_EXPORT windrow_shape windrow_shape_sphere(float radius) {
    return made(WINDROW_SHAPE_SPHERE, [&](windrow_shape& shape) { shape.radius = radius; });
}
WINDROW_EXPORT windrow_shape windrow_shape_capsule(windrow_vec3 half_axis, float radius) {
    return made(WINDROW_SHAPE_CAPSULE, [&](windrow_shape& shape) {
        shape.half_axis = half_axis;
        shape.radius = radius;
    });
}
WINDROW_EXPORT windrow_shape windrow_shape_block(windrow_vec3 half_size) {
    return made(WINDROW_SHAPE_BLOCK, [&](windrow_shape& shape) { shape.half_size = half_size; });
}
WINDROW_EXPORT windrow_shape windrow_shape_cylinder(float radius, float half_length) {
    return made(WINDROW_SHAPE_CYLINDER, [&](windrow_shape& shape) {
        shape.radius = radius;
        shape.half_length = half_length;
    });
}
WINDROW_EXPORT windrow_shape windrow_shape_plate(windrow_vec2 half_size) {
    return made(WINDROW_SHAPE_PLATE, [&](windrow_shape& shape) { shape.half_size = {half_size.x, half_size.y, 0.0f}; });
}
WINDROW_EXPORT windrow_shape windrow_shape_mesh(const windrow_mesh* mesh, float scale) {
    return made(WINDROW_SHAPE_MESH, [&](windrow_shape& shape) {
        shape.mesh = mesh;
        shape.scale.x = scale;
    });
}
WINDROW_EXPORT windrow_shape windrow_shape_voxels(const windrow_voxels* voxels, float cell_size) {
    return made(WINDROW_SHAPE_VOXELS, [&](windrow_shape& shape) {
        shape.voxels = voxels;
        shape.cell_size = cell_size;
    });
}
WINDROW_EXPORT windrow_shape windrow_shape_ground(const windrow_height_map* heights, windrow_vec3 scale) {
    return made(WINDROW_SHAPE_GROUND, [&](windrow_shape& shape) {
        shape.heights = heights;
        shape.scale = scale;
    });
}

// --- Obstacles -----------------------------------------------------------------------------------------------------------
WINDROW_C_INIT(windrow_obstacle)
WINDROW_C_INIT(windrow_obstacle_force)
WINDROW_EXPORT windrow_result windrow_wind_add_obstacle(windrow_wind* wind, const windrow_obstacle* obstacle,
                                                        windrow_obstacle_id* id) {
    return call({{wind, "wind"}, {obstacle, "obstacle"}}, [&] {
        return with(obstacle, [&](const Obstacle& wanted) -> windrow_result {
            const Result<ObstacleId> added = wind->control->obstacles().add(wanted);
            if (added && id != nullptr)
                *id = {added->slot, added->generation, added->owner};
            return done(added);
        });
    });
}
WINDROW_EXPORT windrow_result windrow_wind_set_obstacle(windrow_wind* wind, windrow_obstacle_id id,
                                                        const windrow_obstacle* obstacle) {
    return call({{wind, "wind"}, {obstacle, "obstacle"}}, [&] {
        return with(obstacle, [&](const Obstacle& wanted) {
            const auto named = id_of<ObstacleId>(id);
            return done_with(wind, named, wind->control->obstacles().set(named, wanted));
        });
    });
}
WINDROW_EXPORT windrow_result windrow_wind_get_obstacle(const windrow_wind* wind, windrow_obstacle_id id,
                                                        windrow_obstacle* obstacle) {
    return call({{wind, "wind"}, {obstacle, "obstacle"}}, [&]() -> windrow_result {
        if (const windrow_result outcome = check_output(obstacle); outcome != WINDROW_OK)
            return outcome;
        const auto named = id_of<ObstacleId>(id);
        if (const Result<void> there = wind->control->obstacles().check(named); !there)
            return fail(WINDROW_STALE, there.error());
        give_cpp(*wind->control->obstacles().find(named), obstacle);
        return WINDROW_OK;
    });
}
WINDROW_EXPORT windrow_result windrow_wind_move_obstacle(windrow_wind* wind, windrow_obstacle_id id, windrow_dvec3 position,
                                                         const windrow_quat* orientation, const windrow_vec3* spin) {
    return call({{wind, "wind"}}, [&] {
        const auto named = id_of<ObstacleId>(id);
        Obstacles& obstacles = wind->control->obstacles();
        if (orientation == nullptr && spin == nullptr)
            return done_with(wind, named, obstacles.move(named, to_cpp(position)));
        const Obstacle* const here = obstacles.find(named);
        const glm::quat turned = orientation != nullptr ? to_cpp(*orientation)
                                 : here != nullptr      ? here->orientation
                                                        : glm::quat();
        return done_with(wind, named,
                         spin != nullptr ? obstacles.move(named, to_cpp(position), turned, to_cpp(*spin))
                                         : obstacles.move(named, to_cpp(position), turned));
    });
}
WINDROW_EXPORT windrow_result windrow_wind_remove_obstacle(windrow_wind* wind, windrow_obstacle_id id) {
    return call({{wind, "wind"}}, [&] {
        const auto named = id_of<ObstacleId>(id);
        return done_with(wind, named, wind->control->obstacles().remove(named));
    });
}
WINDROW_EXPORT int32_t windrow_wind_obstacle_count(const windrow_wind* wind) {
    return value_of(wind, "wind", [&] { return wind->control->obstacles().count(); });
}
WINDROW_EXPORT windrow_result windrow_wind_force_on(const windrow_wind* wind, windrow_obstacle_id id,
                                                    windrow_obstacle_force* force) {
    return call({{wind, "wind"}, {force, "force"}}, [&]() -> windrow_result {
        if (const windrow_result outcome = check_output(force); outcome != WINDROW_OK)
            return outcome;
        const auto named = id_of<ObstacleId>(id);
        const Result<ObstacleForce> acting = wind->reader->force_on(named);
        if (acting)
            give_cpp(*acting, force);
        return done_with(wind, named, acting);
    });
}
