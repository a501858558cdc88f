// Advection beside thin bodies (solids.h), for the cells whose read may pass through one. It replaces what the kernels found.
//
// A trajectory slides along the closed faces that it meets. A read takes the nodes that a path from the point's own cell reaches,
// a path that never turns back along an axis and passes open faces only. A node that none reaches takes the value of the nodes
// before it, with the velocity across a closed face mirrored about the body's own. So a plate without thickness separates the air
// on its two sides.
//
// The air of a closed room is carried so too, in walls of any thickness, since no prescribed wind blows there. Walls of the box
// count as closed faces of a room.
#include "fluid/cpu/stopwatch.h"
#include "fluid/cpu/workspace.h"
#include "fluid/grid/box_rules.h"

#include <array>
#include <cmath>
#include <glm/common.hpp>

namespace windrow {
namespace {

// A point of a trajectory: `cell` is the cell that holds it, `place` its distance from the first cell's centre, in cells.
struct Point {
    glm::ivec3 cell{0};
    glm::vec3 place{0.0f};
};

constexpr std::array<std::array<int, 4>, 2> k_outward{{{1, 2, 0, 3}, {2, 1, 3, 0}}}; // nodes 0..3, from the own one

class ThinReader {
  public:
    /// `room`: for the air of closed rooms.
    ThinReader(const Workspace::State& state, const cpu::AdvectTask& task, bool room)
        : state_(state), solids_(*state.solids), task_(task), room_(room) {}

    // Where a displacement from a cell's centre ends. `stopped` is set where a closed face was met.
    Point walk(glm::ivec3 from, glm::vec3 displacement, bool& stopped) const {
        glm::vec3 left;
        for (int axis = 0; axis < 3; ++axis) {
            const auto cell = static_cast<float>(from[axis]);
            left[axis] = std::min(std::max(displacement[axis], task_.legal.low[axis] - cell), task_.legal.high[axis] - cell);
            if (!(left[axis] == left[axis]))
                left[axis] = 0.0f;
        }
        Point at{.cell = from};
        for (int crossed = 0; crossed < k_most_crossings; ++crossed) {
            int axis = -1;
            float way = 1.0f;
            for (int a = 0; a < 3; ++a) {
                if (left[a] == 0.0f)
                    continue;
                const float face = static_cast<float>(at.cell[a] - from[a]) + (left[a] > 0.0f ? 0.5f : -0.5f);
                const float part = (face - at.place[a]) / left[a];
                if (part < way)
                    way = part, axis = a;
            }
            way = std::max(way, 0.0f);
            at.place += way * left;
            if (axis < 0)
                break;
            left *= 1.0f - way;
            const int side = left[axis] > 0.0f ? 1 : -1;
            if (left[axis] == 0.0f)
                continue;
            if (closed(at.cell, axis, side)) {
                stopped = true;
                left[axis] = 0.0f;
            } else {
                at.cell[axis] += side;
            }
        }
        return at;
    }

    // The field at a point, by the nodes of its own side. `mixed` is set where one was on another. `skips_open`: no result is
    // needed where no face among the nodes is closed.
    template <int Components, bool Cubic>
    void read(const float* padded, glm::ivec3 from, const Point& at, bool own_side, float* result, bool& mixed,
              bool skips_open = false) const {
        constexpr int k_first = Cubic ? 0 : 1, k_end = Cubic ? 4 : 3;
        glm::ivec3 base, own;
        float weights[3][4];
        for (int axis = 0; axis < 3; ++axis) {
            const float whole = std::floor(at.place[axis]), t = at.place[axis] - whole;
            base[axis] = from[axis] + static_cast<int>(whole);
            own[axis] = std::min(std::max(at.cell[axis] - base[axis], 0), 1);
            if constexpr (Cubic) {
                const float a = t - 1.0f, b = t - 2.0f, c = t + 1.0f;
                weights[axis][0] = t * a * b * (-1.0f / 6.0f);
                weights[axis][2] = c * t * b * -0.5f;
                weights[axis][3] = c * t * a * (1.0f / 6.0f);
                weights[axis][1] = 1.0f - (weights[axis][0] + weights[axis][2] + weights[axis][3]);
            } else {
                weights[axis][1] = 1.0f - t, weights[axis][2] = t;
            }
        }
        if (open_around(base + k_first - 1, base + k_end - 2)) {
            if (skips_open)
                return;
            read_open<Components, k_first, k_end>(padded, base, own, weights, result);
            return;
        }
        float values[4][4][4][Components];
        bool reached[4][4][4];
        float own_value[Components] = {};
        for (const int z : k_outward[own.z])
            for (const int y : k_outward[own.y])
                for (const int x : k_outward[own.x]) {
                    const glm::ivec3 node(x, y, z);
                    if (x < k_first || y < k_first || z < k_first || x >= k_end || y >= k_end || z >= k_end)
                        continue;
                    const glm::ivec3 cell = base + node - 1;
                    float* const value = values[z][y][x];
                    bool here = !own_side || node == own + 1;
                    float sum[Components] = {};
                    float count = 0.0f;
                    for (int axis = 0; axis < 3 && !here; ++axis) {
                        const int away = node[axis] - (own[axis] + 1);
                        if (away == 0)
                            continue;
                        const int back = away > 0 ? -1 : 1;
                        glm::ivec3 before = node;
                        before[axis] += back;
                        const bool blocked = closed(cell, axis, back), had = reached[before.z][before.y][before.x];
                        here = had && !blocked;
                        const float* const source = values[before.z][before.y][before.x];
                        for (int n = 0; n < Components; ++n)
                            sum[n] += source[n];
                        if (Components > 1 && had && blocked)
                            sum[axis] += 2.0f * (scale_of(padded, cell, axis) * wall(cell, axis, back) - source[axis]);
                        count += 1.0f;
                    }
                    reached[z][y][x] = here;
                    mixed = mixed || !here;
                    const float* const stored = padded + Components * padded_index(cell);
                    for (int n = 0; n < Components; ++n)
                        value[n] = here ? stored[n] : sum[n] / count;
                    if (node == own + 1)
                        for (int n = 0; n < Components; ++n)
                            own_value[n] = value[n];
                }
        // About the own node's value, so that a uniform wind stays uniform to the bit.
        float sum[Components] = {};
        for (int z = k_first; z < k_end; ++z)
            for (int y = k_first; y < k_end; ++y)
                for (int x = k_first; x < k_end; ++x)
                    for (int n = 0; n < Components; ++n)
                        sum[n] += weights[2][z] * weights[1][y] * weights[0][x] * (values[z][y][x][n] - own_value[n]);
        for (int n = 0; n < Components; ++n)
            result[n] = own_value[n] + sum[n];
    }

    // Whether no face of the cells from `low` to `high` is closed, all in the box.
    bool open_around(glm::ivec3 low, glm::ivec3 high) const {
        const glm::ivec3 size = state_.box.cells;
        for (int axis = 0; axis < 3; ++axis)
            if (low[axis] < 0 || high[axis] >= size[axis])
                return false;
        for (int z = low.z; z <= high.z; ++z)
            for (int y = low.y; y <= high.y; ++y)
                if (solids_.any_blocked(static_cast<std::uint32_t>(state_.box.index(low.x, y, z)), high.x - low.x + 1))
                    return false;
        return true;
    }

    // The same sum as in read(), all nodes reached.
    template <int Components, int First, int End>
    void read_open(const float* padded, glm::ivec3 base, glm::ivec3 own, const float (&weights)[3][4], float* result) const {
        const glm::ivec3 size = state_.box.cells + k_halo;
        const std::ptrdiff_t row = Components * static_cast<std::ptrdiff_t>(size.x), plane = row * size.y;
        const float* const first = padded + Components * windrow::padded_index(state_.box.cells, base - 1);
        const float* const own_value = first + (own.z + 1) * plane + (own.y + 1) * row + (own.x + 1) * Components;
        float sum[Components] = {};
        for (int z = First; z < End; ++z)
            for (int y = First; y < End; ++y)
                for (int x = First; x < End; ++x) {
                    const float weight = weights[2][z] * weights[1][y] * weights[0][x];
                    for (int n = 0; n < Components; ++n)
                        sum[n] += weight * (first[z * plane + y * row + x * Components + n] - own_value[n]);
                }
        for (int n = 0; n < Components; ++n)
            result[n] = own_value[n] + sum[n];
    }

    template <int Components, bool Cubic>
    void advect(std::uint32_t n) const {
        const glm::ivec3 cell = solids_.place_of(n);
        const float* const u = task_.velocity + 4 * static_cast<std::size_t>(n);
        const float along_rows = task_.row_scales != nullptr ? task_.row_scales[cell.y] : 1.0f;
        const glm::vec3 speed = task_.cells_per_speed * glm::vec3(u[0], along_rows * u[1], u[2]);
        bool mixed = false;
        float traced[4], value[Components];
        const Point start = walk(cell, -speed, mixed);
        read<4, false>(task_.padded_trace, cell, start, true, traced, mixed);
        const glm::vec3 way = -0.5f * (speed + task_.cells_per_speed * glm::vec3(traced[0], traced[1], traced[2]));
        const Point end = walk(cell, way, mixed);
        read<Components, Cubic>(task_.padded_carried, cell, end, true, value, mixed, !room_ && !mixed);
        float* const result = task_.result + Components * static_cast<std::size_t>(n);
        if (room_ || (mixed && task_.prescribed.now == nullptr))
            std::copy(value, value + Components, result);
        if (room_ || !mixed || task_.prescribed.now == nullptr)
            return;
        // The kernels have added the background's part.
        float crossing[Components];
        bool ignored = false;
        read<4, false>(task_.padded_trace, cell, straight(cell, -speed), false, traced, ignored);
        const glm::vec3 crossing_way = -0.5f * (speed + task_.cells_per_speed * glm::vec3(traced[0], traced[1], traced[2]));
        read<Components, Cubic>(task_.padded_carried, cell, straight(cell, crossing_way), false, crossing, ignored);
        for (int c = 0; c < Components; ++c)
            result[c] += value[c] - crossing[c];
    }

  private:
    static constexpr int k_most_crossings = 512;

    Point straight(glm::ivec3 from, glm::vec3 displacement) const {
        Point at{.cell = from};
        for (int axis = 0; axis < 3; ++axis) {
            const auto cell = static_cast<float>(from[axis]);
            at.place[axis] = std::min(std::max(displacement[axis], task_.legal.low[axis] - cell), task_.legal.high[axis] - cell);
            at.cell[axis] += static_cast<int>(std::floor(at.place[axis] + 0.5f));
        }
        return at;
    }

    // The cell of the box that a cell beyond it mirrors, repeats or continues.
    int inside(int cell, int axis) const {
        const int count = state_.box.cells[axis];
        if (cell >= 0 && cell < count)
            return cell;
        if (state_.box.boundaries.periodic(axis))
            return (cell % count + count) % count;
        const int end = cell < 0 ? 0 : 1;
        if (state_.box.boundaries.at(axis, end).kind == BoundaryKind::open)
            return end * (count - 1);
        return std::min(std::max(end == 0 ? -1 - cell : 2 * count - 1 - cell, 0), count - 1);
    }

    // Beyond a wall of the box the prescribed wind is that of the cell that is mirrored.
    glm::ivec3 slipped(glm::ivec3 cell) const {
        for (int axis = 0; axis < 3; ++axis)
            if (state_.box.boundaries.at(axis, cell[axis] < 0 ? 0 : 1).kind != BoundaryKind::open)
                cell[axis] = inside(cell[axis], axis);
        return cell;
    }

    // The low cell of a face, and whether there is one inside the box.
    bool face(glm::ivec3 cell, int axis, int side, std::uint32_t& low) const {
        glm::ivec3 next = cell;
        next[axis] += side;
        for (int a = 0; a < 3; ++a)
            cell[a] = inside(cell[a], a), next[a] = inside(next[a], a);
        const int apart = next[axis] - cell[axis];
        if (apart == 0)
            return false;
        const bool across = apart != 1 && apart != -1; // a periodic boundary
        const bool cell_is_low = across ? apart < 0 : apart > 0;
        const glm::ivec3 from = cell_is_low ? cell : next;
        low = static_cast<std::uint32_t>(state_.box.index(from.x, from.y, from.z));
        return true;
    }

    bool closed(glm::ivec3 cell, int axis, int side) const {
        std::uint32_t low;
        return face(cell, axis, side, low) ? solids_.blocked(low, axis) : room_;
    }

    // The trace counts rows along y.
    float scale_of(const float* padded, glm::ivec3 cell, int axis) const {
        return axis == 1 && task_.row_scales != nullptr && padded == task_.padded_trace ? task_.row_scales[inside(cell.y, 1)]
                                                                                        : 1.0f;
    }

    // Velocity across a closed face of its body, less the prescribed wind's.
    float wall(glm::ivec3 cell, int axis, int side) const {
        std::uint32_t low;
        if (!face(cell, axis, side, low))
            return 0.0f;
        const ClosedFace* const closed_face = solids_.face(low, axis);
        float speed = closed_face != nullptr ? closed_face->wall / closed_face->closed : 0.0f;
        if (task_.prescribed.now != nullptr && !room_)
            speed -= task_.prescribed.now[4 * padded_index(slipped(cell)) + axis];
        return speed;
    }

    std::size_t padded_index(glm::ivec3 cell) const {
        const glm::ivec3 size = state_.box.cells;
        for (int axis = 0; axis < 3; ++axis)
            cell[axis] = state_.box.boundaries.periodic(axis)
                             ? inside(cell[axis], axis)
                             : std::min(std::max(cell[axis], -k_halo_low), size[axis] + k_halo_high - 1);
        return windrow::padded_index(size, cell);
    }

    const Workspace::State& state_;
    const Solids& solids_;
    const cpu::AdvectTask& task_;
    bool room_;
};

} // namespace

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

void Workspace::State::advect_beside_thin_bodies(const cpu::AdvectTask& task, bool scalar, bool cubic) {
    if (!has_solids())
        return;
    const cpu::Stopwatch watch("windrow obstacles", obstacles_ms);
    const auto advect = [&](std::span<const std::uint32_t> cells, bool rooms) {
        constexpr std::size_t k_chunk = 64;
        const ThinReader reader(*this, task, rooms);
        parallel_for(static_cast<int>((cells.size() + k_chunk - 1) / k_chunk), [&](int chunk) {
            const std::size_t first = k_chunk * static_cast<std::size_t>(chunk), end = std::min(first + k_chunk, cells.size());
            for (std::size_t n = first; n < end; ++n) {
                if (scalar)
                    cubic ? reader.advect<1, true>(cells[n]) : reader.advect<1, false>(cells[n]);
                else
                    cubic ? reader.advect<4, true>(cells[n]) : reader.advect<4, false>(cells[n]);
            }
        });
    };
    if (solids->any_thin()) {
        constexpr float k_extrapolated = 1.5f; // a trajectory's velocity over that of its cell
        if (!fastest)
            fastest = box.rows ? fastest_by_rows(task.velocity) : survey(task.velocity).largest_component;
        solids->reach_past_thin(k_extrapolated * task.cells_per_speed * *fastest);
        advect(solids->thin(), false);
    }
    fastest.reset();
    advect(solids->rooms(), true);
}

} // namespace windrow
