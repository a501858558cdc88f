// The obstacles of one wind: a list in world space (double) that may change while the wind runs.
//
// Obstacles at rest are in a grid that is searched where the box moves or the list changes; only those that move are visited in
// every tick. So a town outside of the box costs nothing.
//
// The effect on the air does not depend on the order in which obstacles were added: those in reach are sorted by what they are.
#pragma once

#include "api.h"
#include "boundaries.h"
#include "obstacle.h"
#include "obstacle_grid.h"
#include "result.h"
#include "slot_list.h"
#include "timed_path.h"
#include "window.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace windrow {

class EventLog;

/// Handle of an obstacle of one Obstacles object: slot, generation, owner.
using ObstacleId = Handle<class Obstacles>;

/// The obstacles of one Wind, at most 16384. A handle that was removed, or that another wind gave, is rejected. The obstacles of a
/// wind that was loaded keep their handles. Without memory a call fails and the list stays as it was.
class WINDROW_API Obstacles {
  public:
    static constexpr std::uint32_t k_capacity = 16384;

    Obstacles();

    /// Adds an obstacle, at rest. Rejects what `validate` rejects and a full list.
    [[nodiscard]] Result<ObstacleId> add(const Obstacle& obstacle);
    /// Replaces an obstacle whole. It appears at its new place at rest and pushes no air on the way. The shape may change.
    [[nodiscard]] Result<void> set(ObstacleId id, const Obstacle& obstacle);
    /// Moves an obstacle to where it is at the end of the coming step (or frame, with Wind::advance). It pushes the air on the
    /// way. The first move of an obstacle at rest may allocate.
    [[nodiscard]] Result<void> move(ObstacleId id, glm::dvec3 position);
    /// The same with its orientation, of any length but 0; it turns the shorter way from each frame to the next.
    [[nodiscard]] Result<void> move(ObstacleId id, glm::dvec3 position, glm::quat orientation);
    /// The same of a body that turns at `spin` [rad/s], about its position, along the world's axes: a wheel, a propeller. Two poses
    /// are the same after one turn and after two. Beyond a sixth of a turn a step, or a cell at its tips, blades meet the air at few
    /// places (Diagnostics::fast_turns).
    [[nodiscard]] Result<void> move(ObstacleId id, glm::dvec3 position, glm::quat orientation, glm::vec3 spin);
    /// Removes an obstacle; a stale handle is rejected.
    Result<void> remove(ObstacleId id);

    /// Rejects a stale handle.
    [[nodiscard]] Result<void> check(ObstacleId id) const;
    /// The obstacle as it stands, orientation normalised; null for a stale handle.
    [[nodiscard]] const Obstacle* find(ObstacleId id) const;
    [[nodiscard]] int count() const { return list_.count(); }
    [[nodiscard]] std::size_t memory_bytes() const;

    /// One slot of the list.
    struct Slot {
        Obstacle obstacle; ///< where it goes
        std::uint32_t generation = 0;
        std::uint32_t motion = k_at_rest; ///< index in the list of what moves
        bool used = false;
        bool named_here = false; ///< false: restored from a snapshot, its handle is that of the wind that was saved
    };

    // --- Called by Wind -----------------------------------------------------------------------------------------------
    /// A frame of `duration` [s] begins `lead` [s] after the last tick; see timed_path.h.
    void begin_frame(double lead, double duration);
    /// Scales the times of the poses given in this frame by `factor`.
    void squeeze(double factor);
    /// Advances every obstacle by a tick and returns those whose bounding box meets the box of cells grown by two cells; along a
    /// periodic axis all do. Their order does not depend on the list's. Does not allocate. The span lasts until the next call.
    [[nodiscard]] std::span<const detail::PlacedObstacle> tick(double duration, const Window& window,
                                                               const Boundaries& boundaries, float jump_speed = 0.0f);
    /// Of those in the last tick that met the box: how many jumped, and how many turned by more than a sixth of a turn.
    [[nodiscard]] int jumps() const { return jumps_; }
    [[nodiscard]] int fast_turns() const { return fast_turns_; }
    /// Advances every obstacle by a time in which nothing acts on the air.
    void pass(double duration);
    /// True where what `tick` returned, or the box, may differ from when this was asked last.
    [[nodiscard]] bool take_changed() { return std::exchange(changed_, false); }
    /// True where one that reached the box was added, replaced or removed, or one moves there, since this was asked last.
    [[nodiscard]] bool take_moved() { return std::exchange(moved_, false); }
    /// What the last tick returned, and whether that may differ from what was asked for last: air that sleeps does not ask.
    [[nodiscard]] std::span<const detail::PlacedObstacle> in_reach() const { return placed_; }
    [[nodiscard]] bool changed() const { return changed_; }
    /// Of the box in which the next tick is: of a list that came from another wind.
    void set_rows(const RowTable* rows) { window_.rows = rows; }
    /// Those that meet a box, where they are now, in the order of `tick`; moves since the last tick have not begun. Throws
    /// std::bad_alloc.
    [[nodiscard]] std::vector<detail::PlacedObstacle> standing_in(const Window& window, const Boundaries& boundaries) const;
    [[nodiscard]] std::span<const Slot> slots() const { return list_.slots(); }
    /// Number of obstacles that the last tick looked at.
    [[nodiscard]] std::size_t visited() const { return visited_; }
    /// The world's origin has moved: every place moves by `offset` [m], the box by `cells`. What was placed in it stays.
    void shift_origin(glm::dvec3 offset, CellIndex cells);
    /// Every change is noted in `log` from now on; null: no longer.
    void record_to(EventLog* log) { log_ = log; }

  private:
    friend struct ObstacleFields; // obstacle_record.h: bytes and back

    static constexpr std::uint32_t k_at_rest = ~std::uint32_t{0};

    /// An obstacle that has moved since the tick before the last.
    struct Motion {
        std::uint32_t slot = 0;
        TimedPath<BodyPose> path{};
        bool moved = false;              ///< since it was last placed
        bool reaches = false;            ///< the box, when it was last placed
        std::optional<glm::vec3> spin{}; ///< [rad/s] that was given with the last pose; else it follows from the poses
    };

    [[nodiscard]] Result<void> move(ObstacleId id, glm::dvec3 position, const glm::quat* orientation,
                                    std::optional<glm::vec3> spin);
    /// For what a tick returns of the list, all in reach; throws std::bad_alloc.
    void make_room();
    void begin_motion(std::uint32_t index);
    void end_motion(std::uint32_t index);
    void rest(std::uint32_t index);
    /// What is at `index` came, goes, or is replaced.
    void note_change(std::uint32_t index);
    [[nodiscard]] BodyPose pose_of(const Slot& slot) const;
    [[nodiscard]] bool reaches(const Slot& slot) const;
    void name(detail::PlacedObstacle& obstacle, std::uint32_t index) const;
    [[nodiscard]] bool carry(double duration, float jump_speed);
    void find_resting();

    detail::SlotList<Slot, Obstacles> list_;
    std::vector<Motion> motions_;
    detail::ObstacleGrid grid_;                   ///< of those at rest
    std::vector<detail::PlacedObstacle> resting_; ///< those at rest in reach, sorted
    std::vector<detail::PlacedObstacle> moving_;  ///< those that move in reach, sorted
    std::vector<detail::PlacedObstacle> placed_;  ///< both
    Window window_{};                             ///< of the last tick, as `boundaries_`
    Boundaries boundaries_{};
    bool ticked_ = false;
    bool search_ = false; ///< `resting_` is not that of the list and the window
    bool changed_ = false, moved_ = false;
    std::size_t visited_ = 0;
    int jumps_ = 0, fast_turns_ = 0; ///< in the last tick
    EventLog* log_ = nullptr;
};

} // namespace windrow
