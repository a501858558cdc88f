// The motors of one wind: a list in world space (double) that may change while the wind runs.
//
// The effect on the air does not depend on the order in which motors were added: a cell sums them in a fixed order.
#pragma once

#include "api.h"
#include "gust_tile.h"
#include "motor.h"
#include "motor_reach.h"
#include "result.h"
#include "slot_list.h"
#include "track.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace windrow {

class EventLog;

/// Handle of a motor of one Motors object: slot, generation, owner.
using MotorId = Handle<class Motors>;

/// The motors of one Wind, at most 4096. A handle that was removed, or that another wind gave, is rejected. The motors of a wind
/// that was loaded keep their handles.
class WINDROW_API Motors {
  public:
    static constexpr std::uint32_t k_capacity = 4096;

    Motors();

    /// Adds a motor. Rejects what `validate` rejects and a full list. Without memory it fails and the list stays as it was.
    [[nodiscard]] Result<MotorId> add(const Motor& motor);
    /// Replaces a motor whole, its position and its age too; a wake starts a new path there and sweeps nothing in between. The
    /// kind may change. Without memory it fails and the motor stays as it was.
    [[nodiscard]] Result<void> set(MotorId id, const Motor& motor);
    /// Moves a motor to where it is at the end of the coming step (or frame, with Wind::advance). A wake sweeps the path through
    /// all positions given since the last one.
    [[nodiscard]] Result<void> move(MotorId id, glm::dvec3 position);
    /// Removes a motor; a stale handle is rejected.
    Result<void> remove(MotorId id);

    /// The motor as it stands, direction normalised; null for a stale handle.
    [[nodiscard]] const Motor* find(MotorId id) const;
    [[nodiscard]] int count() const { return list_.count(); }
    [[nodiscard]] std::size_t memory_bytes() const;

    /// One slot of the list, as the step reads it.
    struct Slot {
        Motor motor;
        Track track{};    ///< where it was and where it goes
        double age = 0.0; ///< [s] of steps since it was added
        std::uint32_t generation = 0;
        bool used = false;
        bool named_here = false; ///< false: restored from a snapshot, its handle is that of the wind that was saved
        bool reaches = false;    ///< some air of the box, in the last tick
    };

    // --- Called by Wind -----------------------------------------------------------------------------------------------
    /// A frame of `duration` [s] begins `lead` [s] after the last tick; see track.h.
    void begin_frame(double lead, double duration);
    /// Scales the times of the positions given in this frame by `factor`.
    void squeeze(double factor);
    /// Advances every motor by a tick, ends those whose time is over, and returns what reaches the box, in an order that does not
    /// depend on the list's. Does not allocate. The span lasts until the next call.
    [[nodiscard]] std::span<const detail::MotorReach> tick(double duration, const Window& window, const Boundaries& boundaries,
                                                           float jump_speed = 0.0f);
    [[nodiscard]] std::span<const Slot> slots() const { return list_.slots(); }
    /// Wakes of the last tick that went faster than its jump_speed on a part of their way, which is left out.
    [[nodiscard]] int jumps() const { return jumps_; }
    /// Motors that reached no air in the last tick and never will where they are: under the ground, or farther outside of the box
    /// than its size, on an axis along which it does not follow.
    [[nodiscard]] int lost(const Window& window, const Boundaries& boundaries, glm::bvec3 follows) const;
    /// Some motor is a volume source, whether or not it reaches the box.
    [[nodiscard]] bool has_volume_source() const;
    /// Tile of the motors' eddies: the wind's own, else the standard one. May be null where no motor has eddies.
    [[nodiscard]] const std::shared_ptr<const GustTile>& tile(const std::shared_ptr<const GustTile>& of_wind) const {
        return of_wind ? of_wind : tile_;
    }
    /// The world's origin has moved: every place moves by `offset` [m].
    void shift_origin(glm::dvec3 offset);
    /// Every change is noted in `log` from now on; null: no longer.
    void record_to(EventLog* log) { log_ = log; }

  private:
    friend struct StateFields; // wind_snapshot.cpp: bytes and back

    void start(Slot& slot, const Motor& motor);
    /// Room for what a tick of all motors returns, and of `more` (null: none). Changes nothing that the air feels.
    void reserve_reach(const Motor* more);

    detail::SlotList<Slot, Motors> list_;
    int jumps_ = 0;
    std::vector<detail::MotorReach> reach_; ///< room for all that a tick can return
    std::shared_ptr<const GustTile> tile_;  ///< standard, held from the first motor with eddies on
    EventLog* log_ = nullptr;
};

} // namespace windrow
