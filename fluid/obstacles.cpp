#include "fluid/obstacles.h"

#include "fluid/core/message.h"
#include "fluid/event_log.h"
#include "fluid/portable_math.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>
#include <utility>

namespace windrow {
namespace {

using detail::PlacedObstacle;

constexpr double k_fast_turn = 0.999 * std::numbers::pi / 3.0; // [rad] in a tick; with rounding
constexpr float k_margin_cells = 2.0f;                         // reads and trajectories beside the box

// Whether a turn is more than steps resolve: by its angle, or since the body's outermost place passes more than a cell by it.
bool turns_fast(const PlacedObstacle& body, double duration, float cell_size) {
    if (body.spin == glm::vec3(0.0f))
        return false;
    const detail::Extent extent = detail::extent_of(body);
    const double angle = static_cast<double>(glm::length(body.spin)) * duration;
    const auto reach = static_cast<double>(glm::length(glm::max(glm::abs(extent.low), glm::abs(extent.high))));
    return angle > k_fast_turn || (angle * reach > static_cast<double>(cell_size) && std::isfinite(reach) &&
                                   !std::holds_alternative<Sphere>(body.shape));
}

// In double, so that the longest and the shortest keep their direction.
glm::quat normalised(const glm::quat& orientation) {
    return glm::quat(glm::normalize(glm::dquat(orientation)));
}

Obstacle prepared(Obstacle obstacle) {
    obstacle.orientation = normalised(obstacle.orientation);
    return obstacle;
}

BodyPose pose(const Obstacle& obstacle) {
    return {obstacle.position, glm::dquat(obstacle.orientation)};
}

// `turned`: by this vector [rad] from start to end.
PlacedObstacle placed(const Obstacle& obstacle, const BodyPose& start, const BodyPose& end, glm::dvec3 turned, double duration,
                      const Window& window, const Boundaries& boundaries) {
    PlacedObstacle result;
    result.shape = obstacle.shape;
    result.surface = obstacle.surface;
    const glm::dvec3 units = window.units();
    glm::dvec3 place = window.local_rounded(end.position);
    if (!(start == end)) {
        result.velocity = glm::vec3((place - window.local_rounded(start.position)) * (units / duration));
        result.spin = glm::vec3(turned / duration);
    }
    for (int axis = 0; axis < 3; ++axis)
        if (boundaries.periodic(axis))
            place[axis] -= window.cells[axis] * std::floor(place[axis] / window.cells[axis]);
    result.position = glm::vec3(place * units);
    result.axes = glm::mat3(glm::mat3_cast(glm::normalize(end.orientation)));
    return result;
}

PlacedObstacle placed(const Obstacle& obstacle, const BodyPose& here, const Window& window, const Boundaries& boundaries) {
    return placed(obstacle, here, here, glm::dvec3(0.0), 1.0, window, boundaries);
}

bool meets(const PlacedObstacle& obstacle, const Window& window, const Boundaries& boundaries) {
    const detail::Extent extent = detail::extent_of(obstacle);
    const glm::vec3 margin(k_margin_cells * window.cell_size), low = extent.low - margin, high = extent.high + margin;
    const glm::vec3 size(window.size());
    for (int axis = 0; axis < 3; ++axis)
        if (!boundaries.periodic(axis) &&
            (obstacle.position[axis] + high[axis] < 0.0f || obstacle.position[axis] + low[axis] > size[axis]))
            return false;
    return true;
}

} // namespace

Obstacles::Obstacles() : list_({"obstacle", "removed, or never added"}, k_capacity) {}

// --- Changes by the host -----------------------------------------------------------------------------------------------------

Result<ObstacleId> Obstacles::add(const Obstacle& obstacle) {
    if (auto valid = validate(obstacle); !valid)
        return valid.failure();
    if (auto room = list_.check_room(); !room)
        return room.failure();
    const bool has_room = detail::memory_lasts([&] {
        list_.make_room();
        make_room();
    });
    if (!has_room)
        return detail::out_of_memory();
    const ObstacleId id = list_.add();
    list_[id.slot].obstacle = prepared(obstacle);
    rest(id.slot);
    note_change(id.slot);
    if (log_ != nullptr)
        log_->note(ObstacleAdded{id.unowned(), obstacle});
    return id;
}

void Obstacles::make_room() {
    const std::size_t room = list_.capacity();
    grid_.reserve(room);
    resting_.reserve(room);
    placed_.reserve(room);
}

Result<void> Obstacles::set(ObstacleId id, const Obstacle& obstacle) {
    const auto found = list_.find(id);
    if (!found)
        return found.failure();
    if (auto valid = validate(obstacle); !valid)
        return valid;
    note_change(id.slot);
    end_motion(id.slot);
    grid_.erase(id.slot);
    (*found)->obstacle = prepared(obstacle);
    rest(id.slot);
    note_change(id.slot);
    if (log_ != nullptr)
        log_->note(ObstacleSet{id.unowned(), obstacle});
    return {};
}

Result<void> Obstacles::move(ObstacleId id, glm::dvec3 position) {
    return move(id, position, nullptr, std::nullopt);
}

Result<void> Obstacles::move(ObstacleId id, glm::dvec3 position, glm::quat orientation) {
    return move(id, position, &orientation, std::nullopt);
}

Result<void> Obstacles::move(ObstacleId id, glm::dvec3 position, glm::quat orientation, glm::vec3 spin) {
    return move(id, position, &orientation, spin);
}

Result<void> Obstacles::move(ObstacleId id, glm::dvec3 position, const glm::quat* orientation, std::optional<glm::vec3> spin) {
    const auto found = list_.find(id);
    if (!found)
        return found.failure();
    Slot& slot = **found;
    if (auto valid = detail::validate_pose(position, orientation != nullptr ? *orientation : slot.obstacle.orientation, spin);
        !valid)
        return valid;
    if (slot.motion == k_at_rest && !detail::memory_lasts([&] { begin_motion(id.slot); }))
        return detail::out_of_memory();
    slot.obstacle.position = position;
    if (orientation != nullptr)
        slot.obstacle.orientation = normalised(*orientation);
    motions_[slot.motion].path.move_to(pose(slot.obstacle));
    motions_[slot.motion].spin = spin;
    if (log_ != nullptr)
        log_->note(
            ObstacleMoved{id.unowned(), position, orientation != nullptr ? std::optional(*orientation) : std::nullopt, spin});
    return {};
}

Result<void> Obstacles::remove(ObstacleId id) {
    if (const auto found = list_.find(id); !found)
        return found.failure();
    note_change(id.slot);
    end_motion(id.slot);
    grid_.erase(id.slot);
    list_.release(id.slot);
    if (log_ != nullptr)
        log_->note(ObstacleRemoved{id.unowned()});
    return {};
}

Result<void> Obstacles::check(ObstacleId id) const {
    const auto slot = list_.find(id);
    return slot ? Result<void>() : slot.failure();
}

const Obstacle* Obstacles::find(ObstacleId id) const {
    const auto slot = list_.find(id);
    return slot ? &(*slot)->obstacle : nullptr;
}

void Obstacles::note_change(std::uint32_t index) {
    if (!reaches(list_[index]))
        return;
    search_ = changed_ = moved_ = true;
}

// --- Rest and motion ---------------------------------------------------------------------------------------------------------

BodyPose Obstacles::pose_of(const Slot& slot) const {
    return slot.motion == k_at_rest ? pose(slot.obstacle) : motions_[slot.motion].path.here();
}

bool Obstacles::reaches(const Slot& slot) const {
    const BodyPose here = pose_of(slot);
    return !ticked_ || meets(placed(slot.obstacle, here, window_, boundaries_), window_, boundaries_);
}

void Obstacles::rest(std::uint32_t index) {
    const Obstacle& obstacle = list_[index].obstacle;
    grid_.insert(index, obstacle.position, static_cast<double>(glm::length(detail::half_extent(obstacle.shape))));
}

// Throws std::bad_alloc, and nothing has changed then.
void Obstacles::begin_motion(std::uint32_t index) {
    Slot& slot = list_[index];
    motions_.reserve(motions_.size() + 1 <= motions_.capacity() ? motions_.capacity() : 2 * motions_.size() + 4);
    moving_.reserve(motions_.capacity());
    const bool in_reach = reaches(slot);
    motions_.push_back({.slot = index, .path = TimedPath<BodyPose>(pose(slot.obstacle)), .moved = false, .reaches = in_reach});
    grid_.erase(index);
    slot.motion = static_cast<std::uint32_t>(motions_.size() - 1);
    search_ = search_ || in_reach;
}

// The obstacle is at rest where it goes.
void Obstacles::end_motion(std::uint32_t index) {
    Slot& slot = list_[index];
    if (slot.motion == k_at_rest)
        return;
    search_ = search_ || motions_[slot.motion].reaches || reaches(slot);
    motions_[slot.motion] = motions_.back();
    list_[motions_[slot.motion].slot].motion = slot.motion;
    slot.motion = k_at_rest;
    motions_.pop_back();
    rest(index);
}

void Obstacles::shift_origin(glm::dvec3 offset, CellIndex cells) {
    window_.origin_cells += cells;
    for (Motion& motion : motions_)
        motion.path.visit_places([&](BodyPose& place) { place.position += offset; });
    for (std::uint32_t index = 0; index < list_.size(); ++index) {
        Slot& slot = list_[index];
        slot.obstacle.position += offset;
        if (!slot.used || slot.motion != k_at_rest)
            continue;
        grid_.erase(index);
        rest(index);
    }
}

void Obstacles::begin_frame(double lead, double duration) {
    for (Motion& motion : motions_)
        motion.path.begin_frame(lead, duration);
}

void Obstacles::squeeze(double factor) {
    for (Motion& motion : motions_)
        motion.path.squeeze(factor);
}

void Obstacles::pass(double duration) {
    for (Motion& motion : motions_) {
        const BodyPose start = motion.path.here();
        motion.path.tick(duration, [](double, double, const BodyPose&, const BodyPose&) {});
        motion.moved = motion.moved || !(motion.path.here() == start);
    }
}

void Obstacles::name(PlacedObstacle& obstacle, std::uint32_t index) const {
    obstacle.slot = index;
    obstacle.generation = list_[index].generation;
}

// Advances what moves and places it. True where that changes what is placed.
bool Obstacles::carry(double duration, float jump_speed) {
    bool changed = false;
    jumps_ = fast_turns_ = 0;
    moving_.clear();
    for (std::size_t n = 0; n < motions_.size(); ++n) {
        Motion* motion = &motions_[n];
        ++visited_;
        // One that has come to rest was placed there with its velocity, and is now placed without.
        while (motion->path.ended() && !motion->moved) {
            end_motion(motion->slot);
            if (n == motions_.size())
                return changed;
            motion = &motions_[n]; // the last one took its place
            ++visited_;
        }
        const BodyPose start = motion->path.here();
        bool given = false, jumped = false;
        glm::dvec3 turned(0.0);
        motion->path.tick(duration, [&](double from, double to, const BodyPose& before, const BodyPose& after) {
            given = true;
            jumped = jumped || detail::is_jump(after.position - before.position, to - from, jump_speed);
            turned += detail::turn_between(before.orientation, after.orientation);
        });
        const BodyPose& end = motion->path.here();
        PlacedObstacle now = jumped ? placed(list_[motion->slot].obstacle, end, window_, boundaries_)
                                    : placed(list_[motion->slot].obstacle, start, end, turned, duration, window_, boundaries_);
        if (given && !jumped && motion->spin)
            now.spin = *motion->spin;
        name(now, motion->slot);
        const bool moves = !(start == end) || now.moves(),
                   reached = std::exchange(motion->reaches, meets(now, window_, boundaries_));
        if ((moves || motion->moved) && (reached || motion->reaches))
            changed = true;
        motion->moved = moves;
        if (motion->reaches)
            moving_.push_back(now);
        if (motion->reaches || reached) {
            jumps_ += jumped ? 1 : 0;
            fast_turns_ += turns_fast(now, duration, window_.cell_size) ? 1 : 0;
        }
        moved_ = moved_ || (motion->reaches && moves);
    }
    return changed;
}

void Obstacles::find_resting() {
    resting_.clear();
    const double h = window_.cell_size, margin = (static_cast<double>(k_margin_cells) + 1.0) * h; // more than meets()
    glm::dvec3 low = window_.origin() - margin, high = low + window_.size() + 2.0 * margin;
    for (int axis = 0; axis < 3; ++axis)
        if (boundaries_.periodic(axis)) {
            low[axis] = -2.0 * k_world_range.max;
            high[axis] = 2.0 * k_world_range.max;
        }
    grid_.find(low, high, [&](std::uint32_t index) {
        ++visited_;
        const BodyPose here = pose(list_[index].obstacle);
        PlacedObstacle now = placed(list_[index].obstacle, here, window_, boundaries_);
        name(now, index);
        if (meets(now, window_, boundaries_))
            resting_.push_back(now);
    });
    std::sort(resting_.begin(), resting_.end(), detail::precedes);
}

std::span<const detail::PlacedObstacle> Obstacles::tick(double duration, const Window& window, const Boundaries& boundaries,
                                                        float jump_speed) {
    visited_ = 0;
    const bool elsewhere = !ticked_ || window.origin_cells != window_.origin_cells || !(boundaries == boundaries_);
    window_ = window;
    boundaries_ = boundaries;
    ticked_ = true;
    const bool moved = carry(duration, jump_speed), searched = std::exchange(search_, false) || elsewhere;
    if (searched)
        find_resting();
    if (!searched && !moved)
        return placed_;
    changed_ = changed_ || moved || (elsewhere && !(placed_.empty() && resting_.empty() && moving_.empty()));
    std::sort(moving_.begin(), moving_.end(), detail::precedes);
    placed_.resize(resting_.size() + moving_.size());
    std::merge(resting_.begin(), resting_.end(), moving_.begin(), moving_.end(), placed_.begin(), detail::precedes);
    return placed_;
}

std::vector<PlacedObstacle> Obstacles::standing_in(const Window& window, const Boundaries& boundaries) const {
    std::vector<PlacedObstacle> standing;
    for (std::uint32_t index = 0; index < list_.size(); ++index) {
        if (!list_[index].used)
            continue;
        const BodyPose here = pose_of(list_[index]);
        PlacedObstacle now = placed(list_[index].obstacle, here, window, boundaries);
        name(now, index);
        if (meets(now, window, boundaries))
            standing.push_back(now);
    }
    std::sort(standing.begin(), standing.end(), detail::precedes);
    return standing;
}

std::size_t Obstacles::memory_bytes() const {
    return list_.memory_bytes() + motions_.capacity() * sizeof(Motion) + grid_.memory_bytes() +
           (resting_.capacity() + moving_.capacity() + placed_.capacity()) * sizeof(PlacedObstacle);
}

} // namespace windrow
