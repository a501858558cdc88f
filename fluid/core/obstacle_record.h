// Parts of a snapshot (wind_snapshot.cpp): paths of what moves, the list of obstacles, and the history of the air at their surfaces.
#pragma once

#include "fluid/box.h"
#include "fluid/core/archive.h"
#include "fluid/core/shape_record.h"
#include "fluid/obstacles.h"
#include "fluid/solids/loads.h"
#include "fluid/track.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>
#include <span>
#include <vector>

namespace windrow {
namespace detail {

inline constexpr double k_farthest_cells = 1e12;

[[nodiscard]] inline bool in_range(glm::dvec3 point, double most) {
    return std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)}) <= most;
}

[[nodiscard]] inline bool in_range(CellIndex origin) {
    return in_range(glm::dvec3(origin), k_farthest_cells + k_max_axis_cells);
}

// An orientation as normalised by Obstacles::add.
template <class Number>
[[nodiscard]] bool has_unit_length(const glm::qua<Number>& orientation) {
    return std::abs(glm::length(glm::dquat(orientation)) - 1.0) < 1e-3;
}

/// As a tick of the wind places bodies: those that meet the box grown by some cells.
[[nodiscard]] inline bool is_in_reach(const PlacedObstacle& body, const Box& box) {
    const Extent extent = extent_of(body);
    const glm::vec3 size = box.size(), margin(4.0f * box.cell_size);
    bool meets = true;
    for (int axis = 0; axis < 3; ++axis)
        meets =
            meets && (box.boundaries.periodic(axis) ? std::abs(body.position[axis]) <= 2.0f * size[axis]
                                                    : body.position[axis] + extent.high[axis] >= -margin[axis] &&
                                                          body.position[axis] + extent.low[axis] <= size[axis] + margin[axis]);
    return meets;
}

/// The bodies of a placement, seen from a box that has moved by `way` [m] since: those in its reach.
inline void follow_box(std::vector<PlacedObstacle>& placed, glm::vec3 way, const Box& box) {
    for (PlacedObstacle& body : placed)
        body.position -= way;
    std::erase_if(placed, [&](const PlacedObstacle& body) { return !is_in_reach(body, box); });
}

void fields(auto& archive, Like<BodyPose> auto& pose) {
    auto& [position, orientation] = pose;
    archive(position, orientation);
}

} // namespace detail

/// Access to the private members of paths.
struct PathFields {
    /// `path` is a TimedPath.
    static void path(auto& archive, auto& path) {
        auto& [here, target, points, count, timed, moves] = path;
        archive(here, target, count, timed, moves);
        if constexpr (detail::Reading<decltype(archive)>) {
            archive.require(timed >= 0 && timed <= count && count <= static_cast<int>(points.size()) && moves >= count - timed &&
                                moves <= 1'000'000,
                            "a path has an impossible number of points.");
            if (archive.rejected())
                count = timed = 0; // valid for any later reader
        }
        for (int n = 0; n < count; ++n) {
            auto& [time, place] = points[static_cast<std::size_t>(n)];
            archive(place, time);
            if constexpr (detail::Reading<decltype(archive)>)
                archive.require(time >= 0.0, "a point of a path has a time below 0.");
        }
    }

    static void track(auto& archive, detail::Like<Track> auto& track) {
        auto& [path, pieces, middle] = track;
        PathFields::path(archive, path);
    }

    static bool lies_within(glm::dvec3 position, double most) { return detail::in_range(position, most); }
    static bool lies_within(const BodyPose& pose, double most) {
        return detail::in_range(pose.position, most) && detail::has_unit_length(pose.orientation);
    }
    /// Bounds check of the places in a path.
    template <class Place>
    static bool lies_within(const TimedPath<Place>& path, double most) {
        return lies_within(path.here_, most) && lies_within(path.target_, most) &&
               std::all_of(path.points_.begin(), path.points_.begin() + path.count_,
                           [&](const auto& point) { return lies_within(point.place, most); });
    }
    static bool lies_within(const Track& track, double most) { return lies_within(track.path_, most); }
};

/// Access to the private members of a list with handles.
struct SlotFields {
    static constexpr std::size_t k_min_bytes = 5; ///< of a slot

    /// The slots, each by write_slot(slot). False where they cannot be read.
    static bool require_slots(auto& archive, auto& list, const char* too_many, const auto& write_slot) {
        std::uint32_t size = list.size();
        archive(size);
        if constexpr (detail::Reading<decltype(archive)>) {
            archive.require(size <= list.most_, too_many);
            if (!archive.can_hold(size, k_min_bytes))
                return false;
            list.slots_.resize(size);
        }
        for (auto& slot : list.slots_)
            write_slot(slot);
        return true;
    }

    /// Which of them are free, after `require_slots`. False where they cannot be read.
    static bool require_free(auto& archive, auto& list, const char* no_match) {
        if constexpr (detail::Reading<decltype(archive)>) {
            const auto used = std::count_if(list.slots_.begin(), list.slots_.end(), [](const auto& slot) { return slot.used; });
            list.count_ = static_cast<int>(used);
            list.free_.reserve(list.slots_.capacity());
            list.free_.resize(list.slots_.size() - static_cast<std::size_t>(used));
            if (!archive.can_hold(list.free_.size(), sizeof(std::uint32_t)))
                return false;
        }
        for (auto& index : list.free_)
            archive(index);
        if constexpr (detail::Reading<decltype(archive)>) {
            std::vector<bool> listed(list.slots_.size());
            for (const std::uint32_t index : list.free_) {
                if (archive.rejected() || index >= listed.size() || listed[index] || list.slots_[index].used) {
                    archive.reject(no_match);
                    return false;
                }
                listed[index] = true;
            }
        }
        return true;
    }
};

namespace detail {

void fields(auto& archive, Like<PressurePush> auto& push) {
    auto& [impulse, twist, potential, wetted] = push;
    archive(impulse, twist, potential, wetted);
}

void fields(auto& archive, Like<BodyLoad> auto& load) {
    auto& [slot, generation, in_box, history, sources, sum, blast] = load;
    archive(slot, generation, in_box, history, sources, sum, blast);
}

void fields(auto& archive, Like<PlacedObstacle> auto& body) {
    auto& [shape, surface, position, axes, velocity, spin, slot, generation] = body;
    archive(shape, surface, position, axes[0], axes[1], axes[2], velocity, spin, slot, generation);
}

} // namespace detail

/// Access to the private members of the list of obstacles.
struct ObstacleFields {
    static constexpr std::size_t k_load_bytes = 9 + 4 * 8 * sizeof(double), k_placed_bytes = 82; ///< and a shape

    static void slot(auto& archive, detail::Like<Obstacles::Slot> auto& slot) {
        auto& [obstacle, generation, motion, used, named_here] = slot; // read: named by the wind that was saved
        archive(used, generation);
        if (used)
            archive(obstacle);
    }

    static void motion(auto& archive, detail::Like<Obstacles::Motion> auto& motion) {
        auto& [slot, path, moved, reaches, spin] = motion;
        archive(slot, moved, reaches, spin);
        if constexpr (detail::Reading<decltype(archive)>)
            archive.require(!spin || (std::isfinite(spin->x) && std::isfinite(spin->y) && std::isfinite(spin->z)),
                            "an obstacle turns at no finite rate.");
        PathFields::path(archive, path);
    }

    static void obstacles(auto& archive, detail::Like<Obstacles> auto& obstacles) {
        auto& [list, motions, grid, resting, moving, placed, window, boundaries, ticked, search, changed, moved, visited, jumps,
               fast_turns, log] = obstacles;
        auto in_motion = static_cast<std::uint32_t>(motions.size());
        if (!SlotFields::require_slots(archive, list, "it has more obstacles than fit.",
                                       [&](auto& slot) { ObstacleFields::slot(archive, slot); }))
            return;
        archive(in_motion);
        if constexpr (detail::Reading<decltype(archive)>) {
            archive.require(in_motion <= list.size(), "more obstacles move than there are.");
            if (!archive.can_hold(in_motion, sizeof(BodyPose)))
                return;
            motions.resize(in_motion);
        }
        for (auto& motion : motions)
            ObstacleFields::motion(archive, motion);
        if (!SlotFields::require_free(archive, list, "its list of free obstacles does not match its obstacles."))
            return;
        archive(ticked, window.origin_cells, moved);
        if constexpr (detail::Reading<decltype(archive)>)
            check(archive, obstacles);
    }

    /// Boxes of the last tick have gone: the next one searches and places again. `placed`: what the last one returned.
    static void settle(Obstacles& obstacles, const Window& window, const Boundaries& boundaries,
                       std::span<const PlacedObstacle> placed) {
        obstacles.make_room();
        obstacles.moving_.reserve(obstacles.motions_.size());
        for (std::uint32_t n = 0; n < obstacles.motions_.size(); ++n)
            obstacles.list_[obstacles.motions_[n].slot].motion = n;
        for (std::uint32_t n = 0; n < obstacles.list_.size(); ++n)
            if (obstacles.list_[n].used && obstacles.list_[n].motion == Obstacles::k_at_rest)
                obstacles.rest(n);
        const CellIndex origin = obstacles.window_.origin_cells;
        obstacles.window_ = window;
        obstacles.window_.origin_cells = origin;
        obstacles.boundaries_ = boundaries;
        obstacles.search_ = true;
        obstacles.placed_.assign(placed.begin(), placed.end());
        obstacles.changed_ = !placed.empty() || obstacles.count() > 0;
    }

    static void check(detail::Reader& reader, Obstacles& obstacles) {
        for (std::uint32_t n = 0; n < obstacles.list_.size() && !reader.rejected(); ++n) {
            const Obstacles::Slot& slot = obstacles.list_[n];
            reader.require(slot.generation > 0, "an obstacle has no generation.");
            if (!slot.used)
                continue;
            if (auto valid = validate(slot.obstacle); !valid)
                reader.reject("obstacle ", n, " cannot be used: ", valid.error());
            reader.require(detail::has_unit_length(slot.obstacle.orientation), "an obstacle's orientation is not of length 1.");
        }
        std::vector<bool> moves(obstacles.list_.size());
        for (const Obstacles::Motion& motion : obstacles.motions_) {
            if (reader.rejected() || motion.slot >= moves.size() || moves[motion.slot] || !obstacles.list_[motion.slot].used)
                return reader.reject("its list of moving obstacles does not match its obstacles.");
            moves[motion.slot] = true;
            const Obstacle& obstacle = obstacles.list_[motion.slot].obstacle;
            reader.require(PathFields::lies_within(motion.path, k_world_range.max) &&
                               motion.path.target() == BodyPose{obstacle.position, glm::dquat(obstacle.orientation)},
                           "an obstacle's path is out of range.");
        }
        reader.require(detail::in_range(obstacles.window_.origin_cells), "its box is out of range.");
    }

    static void check(detail::Reader& reader, const PlacedObstacle& body) {
        const auto finite = [](glm::vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); };
        const glm::mat3 square = glm::transpose(body.axes) * body.axes;
        bool turned = glm::determinant(body.axes) > 0.0f;
        for (int axis = 0; axis < 3; ++axis)
            turned = turned && glm::length(square[axis] - glm::mat3(1.0f)[axis]) < 1e-3f;
        reader.require(finite(body.velocity) && finite(body.spin) && turned &&
                           detail::in_range(glm::dvec3(body.position), 2.0 * k_world_range.max) &&
                           body.slot < Obstacles::k_capacity && validate(Obstacle{.shape = body.shape, .surface = body.surface}),
                       "an obstacle of its last step is out of range.");
    }

    static void surface(auto& archive, auto& history, glm::ivec3 size) {
        auto& [placed, inside_is_air, keys, terms, shift, loads, duration] = history;
        auto standing = static_cast<std::uint32_t>(placed.size());
        archive(standing, inside_is_air);
        if constexpr (detail::Reading<decltype(archive)>) {
            archive.require(standing <= Obstacles::k_capacity, "its last step had more obstacles than fit.");
            if (!archive.can_hold(standing, k_placed_bytes))
                return;
            placed.resize(standing);
        }
        for (auto& body : placed) {
            archive(body);
            if constexpr (detail::Reading<decltype(archive)>)
                check(archive, body);
        }
        auto bodies = static_cast<std::uint32_t>(loads.size());
        archive(bodies, duration);
        if constexpr (detail::Reading<decltype(archive)>) {
            archive.require(bodies <= Obstacles::k_capacity && duration >= 0.0f && std::isfinite(duration),
                            "its forces on obstacles are out of range.");
            if (!archive.can_hold(bodies, k_load_bytes))
                return;
            loads.resize(bodies);
        }
        for (auto& load : loads)
            archive(load);
        if constexpr (detail::Reading<decltype(archive)>)
            archive.require(
                std::all_of(loads.begin(), loads.end(), [](const auto& load) { return load.slot < Obstacles::k_capacity; }),
                "a force is on an obstacle that cannot be.");
        auto count = static_cast<std::uint32_t>(keys.size());
        archive(count);
        if constexpr (detail::Reading<decltype(archive)>) {
            if (!archive.can_hold(count, sizeof(std::uint32_t) + sizeof(float)))
                return;
            keys.resize(count);
            terms.resize(count);
        }
        for (auto& key : keys)
            archive(key);
        for (auto& term : terms)
            archive(term);
        archive(shift);
        if constexpr (detail::Reading<decltype(archive)>) {
            const std::size_t box = Box{.cells = size}.cell_count();
            archive.require(std::adjacent_find(keys.begin(), keys.end(), std::greater_equal()) == keys.end() &&
                                (keys.empty() || keys.back() < 4 * box) && glm::all(glm::lessThan(shift, size)) &&
                                glm::all(glm::lessThan(-size, shift)) &&
                                std::all_of(terms.begin(), terms.end(), [](float term) { return std::isfinite(term); }),
                            "its history at obstacles is out of range.");
        }
    }
};

} // namespace windrow
