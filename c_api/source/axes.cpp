// Axes and unit of the host: what the kinds of numbers do not tell. axes.h has the rest.
#include "c_api/source/axes.h"

#include "c_api/source/axes_own.inl"
#include "c_api/source/axes_structs.inl"
#include "c_api/source/convert.h"
#include "c_api/source/handles.h"
#include "fluid/core/message.h"
#include "fluid/wind_control.h"

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <variant>

using namespace windrow;
using namespace windrow::c_api;

namespace windrow::c_api {

HostAxes host_axes;

windrow_result run_guarded(windrow_result (*run)(const void* body), const void* body) noexcept {
    return guarded([&]() -> AlreadySaid { return {run(body)}; });
}

namespace {

bool is_mirrored(std::size_t axis) {
    return host_axes.sign[axis] < 0.0;
}

/// [m] Along the world's axes, from the first corner of a map as the host has it to its first corner here: its rows along z are mirrored
/// where that axis is.
glm::dvec3 corner_of(const HeightMap* map, float scale_z, glm::quat orientation) {
    if (map == nullptr || !is_mirrored(2))
        return glm::dvec3(0.0);
    const double length = (map->data().corners.y - 1) * static_cast<double>(map->data().spacing) * static_cast<double>(scale_z);
    const glm::dquat turn(orientation);
    const double square = glm::dot(turn, turn);
    return square > 0.0 ? (turn / std::sqrt(square)) * glm::dvec3(0.0, 0.0, -length) : glm::dvec3(0.0);
}
glm::dvec3 corner_of(const windrow_obstacle& own) {
    if (own.shape.kind != WINDROW_SHAPE_GROUND || own.shape.heights == nullptr)
        return glm::dvec3(0.0);
    return corner_of(own.shape.heights->map.get(), own.shape.scale.z, to_cpp(own.orientation));
}
glm::dvec3 corner_of(const Obstacle& own, glm::quat orientation) {
    const auto* const ground = std::get_if<Ground>(&own.shape);
    return ground != nullptr ? corner_of(ground->heights.get(), ground->scale.z, orientation) : glm::dvec3(0.0);
}
const Obstacle* found(const windrow_wind* wind, windrow_obstacle_id id) {
    return wind != nullptr ? wind->control->obstacles().find(id_of<ObstacleId>(id)) : nullptr;
}
void add_to(windrow_dvec3& position, glm::dvec3 offset) {
    position = {position.x + offset.x, position.y + offset.y, position.z + offset.z};
}

/// Obstacles as they are here; grounds by their first corner here.
const windrow_obstacle* obstacles_in(Keep& keep, const windrow_obstacle* obstacles, std::uint64_t count) {
    const windrow_obstacle* const own = turned_in<Whole>(keep, obstacles, count);
    if (own != obstacles && own->struct_size >= sizeof *own)
        for (std::uint64_t n = 0; n < count; ++n) {
            auto* const at = reinterpret_cast<std::byte*>(const_cast<windrow_obstacle*>(own)) + n * own->struct_size;
            auto& obstacle = *reinterpret_cast<windrow_obstacle*>(at);
            add_to(obstacle.position, corner_of(obstacle));
        }
    return own;
}

/// A grid with its cells in the library's order: x fastest. `size` is that of the library.
template <class Value>
const Value* grid_in(Keep& keep, const Value* from, std::array<std::int32_t, 3> size) {
    const auto cells = [&](std::size_t axis) { return static_cast<std::size_t>(size[axis]); };
    auto* const made = reinterpret_cast<Value*>(keep.room(cells(0) * cells(1) * cells(2) * sizeof(Value)));
    std::array<std::size_t, 3> step{}; // of the host's array along each axis of the library
    for (std::size_t i = 0; i < 3; ++i) {
        step[i] = 1;
        for (int a = 0; a < host_axes.from[i]; ++a) // the host's axes that run faster
            for (std::size_t other = 0; other < 3; ++other)
                if (host_axes.from[other] == a)
                    step[i] *= cells(other);
    }
    const auto place = [&](std::size_t axis, std::size_t n) {
        return step[axis] * (is_mirrored(axis) ? cells(axis) - 1 - n : n);
    };
    Value* to = made;
    for (std::size_t k = 0; k < cells(2); ++k)
        for (std::size_t j = 0; j < cells(1); ++j)
            for (std::size_t i = 0; i < cells(0); ++i)
                *to++ = from[place(0, i) + place(1, j) + place(2, k)];
    return made;
}
/// Rows of a map along z. `size` has as many entries as the array.
template <class Value>
const Value* map_in(Keep& keep, const Value* from, windrow_ivec2 size, std::uint64_t count) {
    const bool fits =
        size.x > 0 && size.y > 0 && count == static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y);
    if (from == nullptr || !fits)
        return from; // rejected as it is
    const auto width = static_cast<std::size_t>(size.x), rows = static_cast<std::size_t>(size.y);
    auto* const made = reinterpret_cast<Value*>(keep.room(width * rows * sizeof(Value)));
    for (std::size_t k = 0; k < rows; ++k)
        std::copy_n(from + (is_mirrored(2) ? rows - 1 - k : k) * width, width, made + k * width);
    return made;
}
const float* heights_in(Keep& keep, const float* from, windrow_ivec2 corners, std::uint64_t count) {
    const float* const made = map_in(keep, from, corners, count);
    if (made != from)
        for (std::uint64_t n = 0; n < count; ++n)
            Number<1>::turn(Way::in, const_cast<float*>(made)[n]);
    return made;
}
/// [m] From a map's first corner here.
windrow_vec2 place_in(const windrow_height_map* map, windrow_vec2 place) {
    Level<1>::turn(Way::in, place);
    if (map != nullptr && is_mirrored(2))
        place.y += static_cast<float>(map->map->data().corners.y - 1) * map->map->data().spacing;
    return place;
}

/// The low corner of a box, which is another one where an axis is mirrored.
void turn_corner(Way way, windrow_dvec3& corner, windrow_vec3 own_size) {
    const auto shift = [&](double sign) {
        const std::array size = parts_of(own_size);
        std::array<double, 3> offset{};
        for (std::size_t i = 0; i < 3; ++i)
            offset[i] = is_mirrored(i) ? sign * static_cast<double>(size[i]) : 0.0;
        add_to(corner, {offset[0], offset[1], offset[2]});
    };
    if (way == Way::out)
        shift(1.0);
    Vector<1>::turn(way, corner);
    if (way == Way::in)
        shift(-1.0);
}

} // namespace

void turn(Keep& keep, Way way, windrow_boundaries& value) {
    using Faces = std::array<std::array<windrow_boundary*, 2>, 3>;
    const auto faces = [](windrow_boundaries& of) {
        return Faces{{{&of.x_low, &of.x_high}, {&of.y_low, &of.y_high}, {&of.z_low, &of.z_high}}};
    };
    windrow_boundaries given = value;
    const Faces from = faces(given), to = faces(value);
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t side = 0; side < 2; ++side) {
            const auto a = static_cast<std::size_t>(host_axes.from[i]);
            const std::size_t other = is_mirrored(i) ? 1 - side : side;
            if (way == Way::in)
                *to[i][side] = *from[a][other];
            else
                *to[a][other] = *from[i][side];
        }
    for (const auto& axis : to)
        for (windrow_boundary* const face : axis)
            turn(keep, way, *face);
}
void turn(Keep& keep, Way way, windrow_box& value) {
    const windrow_vec3 given_size = value.size;
    Extents<0>::turn(way, value.cells);
    Number<1>::turn(way, value.cell_size);
    Extents<1>::turn(way, value.size);
    turn_corner(way, value.origin, way == Way::in ? value.size : given_size);
    turn(keep, way, value.boundaries);
}
void turn_by_hand(Keep&, Way way, windrow_config& value) {
    if (value.follow_axes < 0 || value.follow_axes > 7)
        return; // the default, or rejected
    std::int32_t made = 0;
    for (int i = 0; i < 3; ++i) {
        const int a = host_axes.from[static_cast<std::size_t>(i)];
        const int from = way == Way::in ? a : i, to = way == Way::in ? i : a;
        made |= (value.follow_axes >> from & 1) << to;
    }
    value.follow_axes = made;
}
void turn_by_hand(Keep&, Way way, windrow_query& value) {
    Vector<1>::turn(way, value.anchor);
}
void turn_by_hand(Keep&, Way way, windrow_roughness_map& value) {
    Vector<1>::turn(way, value.position);
    if (way == Way::in && value.lengths != nullptr) // a map that comes out is null
        add_to(value.position, corner_of(value.lengths->map.get(), value.scale.z, glm::quat(1.0f, 0.0f, 0.0f, 0.0f)));
}
void turn_by_hand(Keep&, Way way, windrow_vdb_film& value) {
    Vector<1>::turn(way, value.low);
    Vector<1>::turn(way, value.high);
    const windrow_dvec3 a = value.low, b = value.high;
    for (const auto part : {&windrow_dvec3::x, &windrow_dvec3::y, &windrow_dvec3::z}) {
        value.low.*part = std::min(a.*part, b.*part);
        value.high.*part = std::max(a.*part, b.*part);
    }
}

namespace {

/// Runs use(keep) where the host's axes are others, else plain().
template <class Plain, class Use>
windrow_result by_hand(const Plain& plain, const Use& use) noexcept {
    if (!host_axes.turned) [[likely]]
        return plain();
    return guarded([&]() -> AlreadySaid {
        Keep keep;
        return {use(keep)};
    });
}

} // namespace
} // namespace windrow::c_api

// --- The host's axes -----------------------------------------------------------------------------------------------------
WINDROW_EXPORT windrow_result windrow_set_axes(windrow_axes axes, double unit) {
    return call({}, [&]() -> windrow_result {
        if (axes < WINDROW_AXES_Y_UP_RIGHT || axes > WINDROW_AXES_Z_UP_LEFT)
            return fail(WINDROW_REJECTED,
                        detail::message("axes is ", axes, ": give y_up_right, y_up_left, z_up_right or z_up_left, as 0 to 3."));
        if (!(unit >= 1e-6 && unit <= 1e6))
            return fail(WINDROW_REJECTED, detail::message("unit is ", unit, " m: give 1e-6 to 1e6."));
        const bool z_up = axes == WINDROW_AXES_Z_UP_RIGHT || axes == WINDROW_AXES_Z_UP_LEFT;
        const bool left = axes == WINDROW_AXES_Y_UP_LEFT || axes == WINDROW_AXES_Z_UP_LEFT;
        HostAxes made;
        made.turned = axes != WINDROW_AXES_Y_UP_RIGHT || unit != 1.0;
        if (z_up)
            made.from = {0, 2, 1};
        made.sign[2] = z_up == left ? 1.0 : -1.0;
        made.unit = unit;
        made.hand = left ? -1.0 : 1.0;
        host_axes = made;
        return WINDROW_OK;
    });
}
WINDROW_EXPORT windrow_result windrow_axes_matrix(double* matrix) {
    return call({{matrix, "matrix"}}, [&]() -> windrow_result {
        std::fill_n(matrix, 16, 0.0);
        for (std::size_t i = 0; i < 3; ++i)
            matrix[4 * static_cast<std::size_t>(host_axes.from[i]) + i] = host_axes.sign[i] * host_axes.unit;
        matrix[15] = 1.0;
        return WINDROW_OK;
    });
}

// --- Forms ---------------------------------------------------------------------------------------------------------------
WINDROW_EXPORT windrow_result windrow_mesh_create(const windrow_vec3* vertices, uint64_t vertex_count, const uint32_t* indices,
                                                  uint64_t triangle_count, windrow_mesh** mesh) {
    const auto plain = [&] { return own_windrow_mesh_create(vertices, vertex_count, indices, triangle_count, mesh); };
    return by_hand(plain, [&](Keep& keep) {
        if (vertices == nullptr || indices == nullptr || triangle_count > TriangleMesh::k_max_triangles ||
            vertex_count > 3 * TriangleMesh::k_max_triangles)
            return plain(); // rejected
        const uint32_t* corners = indices;
        if (host_axes.hand < 0.0) { // counter-clockwise from outside there is clockwise here
            auto* const made =
                reinterpret_cast<uint32_t*>(keep.room(3 * static_cast<std::size_t>(triangle_count) * sizeof(uint32_t)));
            for (std::size_t n = 0; n < 3 * static_cast<std::size_t>(triangle_count); n += 3) {
                made[n] = indices[n];
                made[n + 1] = indices[n + 2];
                made[n + 2] = indices[n + 1];
            }
            corners = made;
        }
        return own_windrow_mesh_create(turned_in<Vector<1>>(keep, vertices, vertex_count), vertex_count, corners, triangle_count,
                                       mesh);
    });
}
WINDROW_EXPORT windrow_result windrow_voxels_create(windrow_ivec3 cells, const uint8_t* closed, uint64_t count,
                                                    windrow_voxels** voxels) {
    const auto plain = [&] { return own_windrow_voxels_create(cells, closed, count, voxels); };
    return by_hand(plain, [&](Keep& keep) {
        windrow_ivec3 own = cells;
        Extents<0>::turn(Way::in, own);
        const auto fits = [](int n) { return n > 0 && n <= k_max_axis_cells; };
        if (closed == nullptr || !fits(own.x) || !fits(own.y) || !fits(own.z) ||
            count != static_cast<std::uint64_t>(own.x) * static_cast<std::uint64_t>(own.y) * static_cast<std::uint64_t>(own.z))
            return own_windrow_voxels_create(own, closed, count, voxels); // rejected
        return own_windrow_voxels_create(own, grid_in(keep, closed, {own.x, own.y, own.z}), count, voxels);
    });
}
WINDROW_EXPORT windrow_result windrow_height_map_create(windrow_ivec2 corners, float spacing, const float* heights,
                                                        uint64_t count, windrow_height_map** map) {
    return by_hand([&] { return own_windrow_height_map_create(corners, spacing, heights, count, map); },
                   [&](Keep& keep) {
                       return own_windrow_height_map_create(corners, scaled(Way::in, 1, spacing),
                                                            heights_in(keep, heights, corners, count), count, map);
                   });
}
WINDROW_EXPORT windrow_result windrow_height_map_create_with_holes(windrow_ivec2 corners, float spacing, const float* heights,
                                                                   uint64_t count, windrow_ivec2 cells, const uint8_t* open,
                                                                   uint64_t cell_count, windrow_height_map** map) {
    return by_hand(
        [&] { return own_windrow_height_map_create_with_holes(corners, spacing, heights, count, cells, open, cell_count, map); },
        [&](Keep& keep) {
            return own_windrow_height_map_create_with_holes(corners, scaled(Way::in, 1, spacing),
                                                            heights_in(keep, heights, corners, count), count, cells,
                                                            map_in(keep, open, cells, cell_count), cell_count, map);
        });
}
WINDROW_EXPORT float windrow_height_map_height(const windrow_height_map* map, windrow_vec2 place) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_height_map_height(map, place);
    return scaled(Way::out, 1, own_windrow_height_map_height(map, place_in(map, place)));
}
WINDROW_EXPORT windrow_vec3 windrow_height_map_normal(const windrow_height_map* map, windrow_vec2 place) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_height_map_normal(map, place);
    windrow_vec3 normal = own_windrow_height_map_normal(map, place_in(map, place));
    Vector<0>::turn(Way::out, normal);
    return normal;
}
WINDROW_EXPORT windrow_shape windrow_shape_plate(windrow_vec2 half_size) {
    windrow_shape shape = own_windrow_shape_plate(half_size);
    if (host_axes.turned) // its x and y here
        Extents<0>::turn(Way::out, shape.half_size);
    return shape;
}

// --- Obstacles -----------------------------------------------------------------------------------------------------------
WINDROW_EXPORT windrow_result windrow_wind_add_obstacle(windrow_wind* wind, const windrow_obstacle* obstacle,
                                                        windrow_obstacle_id* id) {
    return by_hand([&] { return own_windrow_wind_add_obstacle(wind, obstacle, id); },
                   [&](Keep& keep) { return own_windrow_wind_add_obstacle(wind, obstacles_in(keep, obstacle, 1), id); });
}
WINDROW_EXPORT windrow_result windrow_wind_set_obstacle(windrow_wind* wind, windrow_obstacle_id id,
                                                        const windrow_obstacle* obstacle) {
    return by_hand([&] { return own_windrow_wind_set_obstacle(wind, id, obstacle); },
                   [&](Keep& keep) { return own_windrow_wind_set_obstacle(wind, id, obstacles_in(keep, obstacle, 1)); });
}
WINDROW_EXPORT windrow_result windrow_wind_get_obstacle(const windrow_wind* wind, windrow_obstacle_id id,
                                                        windrow_obstacle* obstacle) {
    return by_hand([&] { return own_windrow_wind_get_obstacle(wind, id, obstacle); },
                   [&](Keep& keep) {
                       const windrow_result result = own_windrow_wind_get_obstacle(wind, id, obstacle);
                       if (result != WINDROW_OK)
                           return result;
                       const Obstacle& own = *found(wind, id);
                       if (obstacle->struct_size >= offsetof(windrow_obstacle, position) + sizeof obstacle->position)
                           add_to(obstacle->position, -corner_of(own, own.orientation));
                       turn_out<Whole>(keep, obstacle, 1);
                       return result;
                   });
}
WINDROW_EXPORT windrow_result windrow_wind_move_obstacle(windrow_wind* wind, windrow_obstacle_id id, windrow_dvec3 position,
                                                         const windrow_quat* orientation, const windrow_vec3* spin) {
    return by_hand([&] { return own_windrow_wind_move_obstacle(wind, id, position, orientation, spin); },
                   [&](Keep& keep) {
                       windrow_dvec3 place = position;
                       Vector<1>::turn(Way::in, place);
                       const windrow_quat* const turned_by = turned_in<Turn>(keep, orientation, 1);
                       if (const Obstacle* const own = found(wind, id); own != nullptr)
                           add_to(place, corner_of(*own, turned_by != nullptr ? to_cpp(*turned_by) : own->orientation));
                       return own_windrow_wind_move_obstacle(wind, id, place, turned_by, turned_in<Axial<0>>(keep, spin, 1));
                   });
}
WINDROW_EXPORT windrow_result windrow_workspace_set_obstacles(windrow_workspace* work, const windrow_obstacle* obstacles,
                                                              const windrow_vec3* velocities, const windrow_vec3* spins,
                                                              uint64_t count) {
    const auto plain = [&] { return own_windrow_workspace_set_obstacles(work, obstacles, velocities, spins, count); };
    return by_hand(plain, [&](Keep& keep) {
        if (count > k_largest_struct)
            return plain(); // rejected
        return own_windrow_workspace_set_obstacles(work, obstacles_in(keep, obstacles, count),
                                                   turned_in<Vector<1>>(keep, velocities, count),
                                                   turned_in<Axial<0>>(keep, spins, count), count);
    });
}

// --- Winds ---------------------------------------------------------------------------------------------------------------
WINDROW_EXPORT windrow_dvec3 windrow_wind_origin(const windrow_wind* wind) {
    windrow_dvec3 origin = own_windrow_wind_origin(wind);
    if (host_axes.turned && wind != nullptr)
        turn_corner(Way::out, origin, to_c(wind->control->box().size()));
    return origin;
}
WINDROW_EXPORT windrow_result windrow_wind_set_velocity(windrow_wind* wind, windrow_velocity_at velocity_at, void* user) {
    struct Host {
        windrow_velocity_at velocity_at;
        void* user;
    };
    Host host{velocity_at, user};
    const windrow_velocity_at turned_at = [](void* context, const windrow_dvec3* centre, windrow_vec3* velocity) {
        const Host& given = *static_cast<Host*>(context);
        windrow_dvec3 place = *centre;
        Vector<1>::turn(Way::out, place);
        Vector<1>::turn(Way::out, *velocity);
        given.velocity_at(given.user, &place, velocity);
        Vector<1>::turn(Way::in, *velocity);
    };
    return by_hand(
        [&] { return own_windrow_wind_set_velocity(wind, velocity_at, user); },
        [&](Keep&) { return own_windrow_wind_set_velocity(wind, velocity_at != nullptr ? turned_at : nullptr, &host); });
}
WINDROW_EXPORT windrow_result windrow_wind_debug_lines(const windrow_wind* wind, const windrow_debug_view* view,
                                                       windrow_debug_draw draw, void* user) {
    struct Host {
        windrow_debug_draw draw;
        void* user;
    };
    Host host{draw, user};
    const windrow_debug_draw turned_draw = [](void* context, const windrow_debug_line* line) {
        const Host& given = *static_cast<Host*>(context);
        Keep keep;
        windrow_debug_line shown = *line;
        turn(keep, Way::out, shown);
        given.draw(given.user, &shown);
    };
    return by_hand([&] { return own_windrow_wind_debug_lines(wind, view, draw, user); },
                   [&](Keep& keep) {
                       return own_windrow_wind_debug_lines(wind, turned_in<Whole>(keep, view, 1),
                                                           draw != nullptr ? turned_draw : nullptr, &host);
                   });
}
WINDROW_EXPORT windrow_result windrow_wind_sample(const windrow_wind* wind, const windrow_query* query) {
    const auto plain = [&] { return own_windrow_wind_sample(wind, query); };
    return by_hand(plain, [&](Keep& keep) {
        windrow_query asked{};
        if (query == nullptr || query->struct_size < offsetof(windrow_query, sampling))
            return plain(); // rejected
        std::memcpy(static_cast<void*>(&asked), query, std::min<std::size_t>(query->struct_size, sizeof asked));
        const bool doubles = asked.number == WINDROW_NUMBER_DOUBLE;
        const std::size_t size = 3 * (doubles ? sizeof(double) : sizeof(float));
        const std::size_t step = asked.position_stride != 0 ? asked.position_stride : size;
        const std::size_t out_step = asked.velocity_stride != 0 ? asked.velocity_stride : sizeof(windrow_vec3);
        if (wind == nullptr || asked.count == 0 || asked.positions == nullptr || asked.velocities == nullptr || step < size ||
            out_step < sizeof(windrow_vec3) || (!doubles && asked.number != WINDROW_NUMBER_FLOAT))
            return plain(); // nothing to sample, or rejected
        constexpr std::size_t k_block = 256;
        std::array<windrow_dvec3, k_block> places;
        std::array<windrow_vec3, k_block> velocities;
        windrow_query own = asked;
        own.struct_size = sizeof own;
        own.number = WINDROW_NUMBER_DOUBLE;
        own.positions = places.data();
        own.velocities = &velocities[0].x;
        own.position_stride = own.velocity_stride = 0;
        own.anchor = {};
        own.sampling = turned_in<Whole>(keep, asked.sampling, 1);
        const auto* from = static_cast<const std::byte*>(asked.positions);
        auto* to = reinterpret_cast<std::byte*>(asked.velocities);
        for (std::uint64_t first = 0; first < asked.count; first += k_block) {
            own.count = std::min<std::uint64_t>(k_block, asked.count - first);
            for (std::size_t n = 0; n < own.count; ++n, from += step) {
                windrow_vec3 single;
                if (doubles)
                    std::memcpy(&places[n], from, sizeof places[n]);
                else {
                    std::memcpy(&single, from, sizeof single);
                    places[n] = {static_cast<double>(single.x), static_cast<double>(single.y), static_cast<double>(single.z)};
                }
                add_to(places[n], to_cpp(asked.anchor));
                Vector<1>::turn(Way::in, places[n]);
            }
            if (const windrow_result result = own_windrow_wind_sample(wind, &own); result != WINDROW_OK)
                return result;
            for (std::size_t n = 0; n < own.count; ++n, to += out_step) {
                Vector<1>::turn(Way::out, velocities[n]);
                std::memcpy(to, &velocities[n], sizeof velocities[n]);
            }
        }
        return windrow_result{WINDROW_OK};
    });
}
WINDROW_EXPORT windrow_plant_key windrow_place_key(float x, float z) {
    windrow_vec2 place{x, z};
    if (host_axes.turned)
        Level<1>::turn(Way::in, place);
    return own_windrow_place_key(place.x, place.y);
}

// --- All others ----------------------------------------------------------------------------------------------------------
#include "c_api/source/axes_body_calls.inl"
#include "c_api/source/axes_calls.inl"
#include "c_api/source/axes_plant_calls.inl"
