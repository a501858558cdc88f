// One-sided advection beside sub-grid bodies (solids.h), for the cells whose read may pass through one: shaders/numerics/one_sided.glsl
// in the cells of a workspace. It replaces what the kernels found.
//
// The air of a closed room is carried so too, in walls of any thickness, since no prescribed wind blows there. Walls of the box
// count as closed faces of a room.
#include "fluid/core/ambient_numerics.h"
#include "fluid/core/numerics.h"
#include "fluid/cpu/stopwatch.h"
#include "fluid/cpu/workspace.h"
#include "fluid/grid/box_rules.h"

#include <cmath>
#include <cstring>
#include <glm/ext/vector_float1.hpp>

namespace windrow {
namespace numerics {
namespace {

/// The air outside of closed rooms, or in them.
struct SidedAir {
    const Workspace::State& state;
    const cpu::AdvectTask& task;
    bool room, of_32; ///< of a closed room; Interpolation::cubic_32
};

template <int Components>
struct SidedField {
    const SidedAir& air;
    const float* padded;
};

vec3 windrow_lowest(const SidedAir& air) {
    return {air.task.legal.low[0], air.task.legal.low[1], air.task.legal.low[2]};
}
vec3 windrow_highest(const SidedAir& air) {
    return {air.task.legal.high[0], air.task.legal.high[1], air.task.legal.high[2]};
}

bool is_within(const SidedAir& air, int cell, int axis) {
    return cell >= 0 && cell < air.state.box.cells[axis];
}

inline int windrow_cell_within(const SidedAir& air, int cell, int axis) {
    const Box& box = air.state.box;
    return is_within(air, cell, axis) ? cell
                                      : windrow_cell_beyond(cell, box.cells[axis], box.boundaries.periodic(axis),
                                                            box.boundaries.at(axis, cell < 0 ? 0 : 1).kind == BoundaryKind::open);
}

std::uint32_t number_of(const SidedAir& air, ivec3 cell) {
    return static_cast<std::uint32_t>(air.state.box.index(cell.x, cell.y, cell.z));
}

bool windrow_blocked(const SidedAir& air, ivec3 low, int axis) {
    return low.x < 0 ? air.room : air.state.solids->blocked(number_of(air, low), axis);
}

inline std::size_t padded_at(const SidedAir& air, ivec3 cell) {
    const ivec3 size = air.state.box.cells;
    for (int axis = 0; axis < 3; ++axis)
        if (!is_within(air, cell[axis], axis))
            cell[axis] = air.state.box.boundaries.periodic(axis) ? windrow_cell_within(air, cell[axis], axis)
                                                                 : clamp(cell[axis], -k_halo_low, size[axis] + k_halo_high - 1);
    return padded_index(size, cell);
}

// What is carried is the wind less the prescribed one: beyond a wall of the box that of the cell that is mirrored. A trace is the whole
// wind, and counts rows along y.
template <int Components>
float windrow_wall_across(const SidedField<Components>& field, ivec3 low, ivec3 cell, int axis) {
    const SidedAir& air = field.air;
    if (low.x < 0)
        return 0.0f;
    const ClosedFace* const face = air.state.solids->face(number_of(air, low), axis);
    float speed = face != nullptr ? face->wall / face->closed : 0.0f;
    const bool traces = field.padded == air.task.padded_trace;
    if (air.task.prescribed.now != nullptr && !air.room && !traces) {
        ivec3 slipped = cell;
        for (int a = 0; a < 3; ++a)
            if (air.state.box.boundaries.at(a, cell[a] < 0 ? 0 : 1).kind != BoundaryKind::open)
                slipped[a] = windrow_cell_within(air, cell[a], a);
        speed -= air.task.prescribed.now[4 * padded_at(air, slipped) + static_cast<std::size_t>(axis)];
    }
    return axis == 1 && air.task.row_scales != nullptr && traces
               ? air.task.row_scales[windrow_cell_within(air, cell.y, 1)] * speed
               : speed;
}

template <int Components>
vec<Components, float> value_at(const float* at) {
    vec<Components, float> value;
    std::memcpy(&value, at, sizeof(value));
    return value;
}

template <int Components>
vec<Components, float> windrow_stored(const SidedField<Components>& field, ivec3 cell) {
    return value_at<Components>(field.padded + Components * padded_at(field.air, cell));
}

template <int Components>
constexpr bool windrow_is_velocity(const SidedField<Components>&) {
    return Components > 1;
}

template <int Components>
bool windrow_is_clamped(const SidedField<Components>& field) {
    return Components == 1 && field.air.task.clamped;
}

#define WINDROW_FN inline
#define WINDROW_FIELD_FN template <int Components>
#define WINDROW_MARK bool&
#define WINDROW_AIR const SidedAir&
#define WINDROW_FIELD const SidedField<Components>&
#define WINDROW_VALUE vec<Components, float>
#include "shaders/numerics/one_sided.glsl"
#undef WINDROW_VALUE
#undef WINDROW_FIELD
#undef WINDROW_AIR
#undef WINDROW_MARK
#undef WINDROW_FIELD_FN
#undef WINDROW_FN

// Whether no face of the cells from `low` to `high` is closed, all in the box.
bool open_around(const SidedAir& air, ivec3 low, ivec3 high) {
    if (any(lessThan(low, ivec3(0))) || any(greaterThanEqual(high, air.state.box.cells)))
        return false;
    for (int z = low.z; z <= high.z; ++z)
        for (int y = low.y; y <= high.y; ++y)
            if (air.state.solids->any_blocked(number_of(air, {low.x, y, z}), high.x - low.x + 1))
                return false;
    return true;
}

// windrow_one_sided where all nodes are reached, all in the box.
template <int Components, int Count>
vec<Components, float> open_read(const SidedField<Components>& field, const WindrowNodes& nodes) {
    constexpr int k_first = Count == 4 ? 0 : 1;
    const ivec3 cells = field.air.state.box.cells;
    const std::ptrdiff_t row = Components * static_cast<std::ptrdiff_t>(cells.x + k_halo), plane = row * (cells.y + k_halo);
    const float* const first = field.padded + Components * padded_index(cells, nodes.base - 1);
    const auto value = [&](int x, int y, int z) { return value_at<Components>(first + z * plane + y * row + x * Components); };
    const vec<Components, float> own = value(nodes.own.x, nodes.own.y, nodes.own.z);
    vec<Components, float> sum(0.0f);
    for (int z = k_first; z < k_first + Count; ++z)
        for (int y = k_first; y < k_first + Count; ++y)
            for (int x = k_first; x < k_first + Count; ++x)
                sum += windrow_weight(nodes, x, y, z) * (value(x, y, z) - own);
    if (!windrow_is_clamped(field))
        return own + sum;
    vec<Components, float> least = own, most = own;
    for (int corner = 0; corner < 8; ++corner) {
        const vec<Components, float> at = value(1 + (corner & 1), 1 + (corner >> 1 & 1), 1 + (corner >> 2));
        least = min(least, at);
        most = max(most, at);
    }
    return clamp(own + sum, least, most);
}

// The field at a point, by the nodes of its own side, or by all. `mixed` is set where one was on another. `skips_open`: no result is
// needed where no face among the nodes is closed.
template <int Count, int Components>
vec<Components, float> read(const SidedField<Components>& field, ivec3 from, const WindrowWaypoint& at, bool own_side,
                            bool& mixed, bool skips_open = false) {
    const WindrowNodes nodes = windrow_nodes(from, at, Count == 4, Count == 4 && field.air.of_32);
    const ivec3 low = nodes.base + nodes.first - 1;
    if (!open_around(field.air, low, low + Count - 1))
        return windrow_one_sided(field, nodes, !own_side, mixed);
    return skips_open ? vec<Components, float>(0.0f) : open_read<Components, Count>(field, nodes);
}

template <int Components, int Count>
void advect_cell(const SidedAir& air, std::uint32_t n) {
    const cpu::AdvectTask& task = air.task;
    const SidedField<4> trace{air, task.padded_trace};
    const SidedField<Components> carried{air, task.padded_carried};
    const ivec3 cell = air.state.solids->place_of(n);
    const float* const u = task.velocity + 4 * static_cast<std::size_t>(n);
    const float along_rows = task.row_scales != nullptr ? task.row_scales[cell.y] : 1.0f;
    const vec3 speed = task.cells_per_speed * vec3(u[0], along_rows * u[1], u[2]);
    const auto way = [&](const WindrowWaypoint& start, bool own_side, bool& mixed) {
        return -0.5f * (speed + task.cells_per_speed * vec3(read<2>(trace, cell, start, own_side, mixed)));
    };
    bool mixed = false, ignored = false;
    const WindrowWaypoint start = windrow_slide(air, cell, -speed, mixed);
    const WindrowWaypoint end = windrow_slide(air, cell, way(start, true, mixed), mixed);
    auto value = read<Count>(carried, cell, end, true, mixed, !air.room && !mixed);
    if (!air.room && !mixed)
        return;
    float* const result = task.result + Components * static_cast<std::size_t>(n);
    if (!air.room && task.prescribed.now != nullptr) { // the kernels have added the background's part
        const WindrowWaypoint crossing = windrow_straight(air, cell, way(windrow_straight(air, cell, -speed), false, ignored));
        value = value_at<Components>(result) + (value - read<Count>(carried, cell, crossing, false, ignored));
    }
    if constexpr (Components == 4) // the lee of plants is carried as in free air
        std::memcpy(result, &value, 3 * sizeof(float));
    else
        std::memcpy(result, &value, sizeof(value));
}

} // namespace
} // namespace numerics

// [m/s] Largest component, along y in rows.
float Workspace::State::fastest_by_rows(const float* velocity) const {
    float most = 0.0f;
    for (std::size_t row = 0, n = 0; n < 4 * box.cell_count(); ++row) {
        const float scale = box.row_scale(static_cast<int>(row % static_cast<std::size_t>(box.cells.y)));
        for (int i = 0; i < box.cells.x; ++i, n += 4)
            most = std::max({most, std::abs(velocity[n]), scale * std::abs(velocity[n + 1]), std::abs(velocity[n + 2])});
    }
    return most;
}

void Workspace::State::advect_one_sided(const cpu::AdvectTask& task, bool scalar, Interpolation interpolation) {
    if (!has_solids())
        return;
    const cpu::Stopwatch watch("windrow obstacles", obstacles_ms);
    const auto advect = [&](std::span<const std::uint32_t> cells, bool rooms) {
        constexpr std::size_t k_chunk = 64;
        const numerics::SidedAir air{*this, task, rooms, interpolation == Interpolation::cubic_32};
        const bool cubic = interpolation != Interpolation::linear;
        const auto advect_cell = scalar ? (cubic ? numerics::advect_cell<1, 4> : numerics::advect_cell<1, 2>)
                                        : (cubic ? numerics::advect_cell<4, 4> : numerics::advect_cell<4, 2>);
        parallel_for(static_cast<int>((cells.size() + k_chunk - 1) / k_chunk), [&](int chunk) {
            const std::size_t first = k_chunk * static_cast<std::size_t>(chunk), end = std::min(first + k_chunk, cells.size());
            for (std::size_t n = first; n < end; ++n)
                advect_cell(air, cells[n]);
        });
    };
    if (solids->any_thin()) {
        constexpr float k_extrapolated = 1.5f; // a trajectory's velocity over that of its cell
        float most = 0.0f;
        if (fastest)
            most = *fastest;
        else
            most = box.rows ? fastest_by_rows(task.velocity) : survey(task.velocity).largest_component;
        solids->reach_past_thin(k_extrapolated * task.cells_per_speed * most);
        advect(solids->thin(), false);
    }
    advect(solids->rooms(), true);
}

} // namespace windrow
