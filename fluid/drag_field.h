// What slows the air of one wind without being a body: plants, hedges, fences, nets. A list of deposits in world space (double) that
// may change while the wind runs, and the drag that they add up to in each cell of the box.
//
//     const auto hedge = wind.drag().add(windrow::BeltDrag{.start = {-10.0, 0.0, 6.0}, .end = {10.0, 0.0, 6.0}});
//     wind.advance(frame_seconds);
//     const auto load = wind.force_on(*hedge);                         // [N]
//
// The drag of a cell does not depend on the order in which deposits came, nor on how the box moved there. Cells that stay in a box
// that moves keep theirs; a wind without deposits does nothing for them.
#pragma once

#include "api.h"
#include "boundaries.h"
#include "box.h"
#include "drag_deposit.h"
#include "drag_spread.h"
#include "obstacle_grid.h"
#include "result.h"
#include "slot_list.h"
#include "window.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace windrow {

class EventLog;

/// Handle of a deposit of one DragField: slot, generation, owner.
using DragId = Handle<class DragField>;

/// Drag of a box's cells.
struct DragCells {
    /// Cells of a row of x that have any, low <= i < high.
    struct Run {
        std::uint16_t low = 0, high = 0;
    };
    std::span<const float> drag{}; ///< [1/m] c of each cell, in the order of box.h; empty: no deposit meets the box
    std::span<const Run> runs{};   ///< one a row of x
    [[nodiscard]] bool any() const { return !drag.empty(); }
};

/// Where the drag of cells is not what it was, after the box has moved.
struct DragChange {
    bool whole = false;
    int count = 0;
    std::array<detail::CellRange, 4> ranges{};
    [[nodiscard]] bool any() const { return whole || count > 0; }
    void add(const detail::CellRange& range);
};

/// The deposits of one Wind, at most 262144. A handle that was removed, or that another wind gave, is rejected. The deposits of a wind
/// that was loaded keep their handles. Without memory a call fails and the list stays as it was.
class WINDROW_API DragField {
  public:
    static constexpr std::uint32_t k_capacity = 262144;

    /// For a box of such cells.
    explicit DragField(const Box& box);

    /// Adds a deposit. Rejects what `validate` rejects and a full list.
    [[nodiscard]] Result<DragId> add(const DragDeposit& deposit);
    /// Adds all of them or, where one is rejected, none. `ids`: as many handles in the same order, or empty.
    [[nodiscard]] Result<void> add(std::span<const DragDeposit> deposits, std::span<DragId> ids = {});
    /// Replaces a deposit whole; its kind may change.
    [[nodiscard]] Result<void> set(DragId id, const DragDeposit& deposit);
    /// Removes a deposit; a stale handle is rejected.
    Result<void> remove(DragId id);

    /// Rejects a stale handle.
    [[nodiscard]] Result<void> check(DragId id) const;
    /// Null for a stale handle.
    [[nodiscard]] const DragDeposit* find(DragId id) const;
    [[nodiscard]] int count() const { return list_.count(); }
    [[nodiscard]] std::size_t memory_bytes() const;

    /// One slot of the list.
    struct Slot {
        DragDeposit deposit;
        std::uint32_t generation = 0;
        bool used = false;
        bool named_here = false; ///< false: restored from a snapshot, its handle is that of the wind that was saved
    };

    // --- Called by Wind -----------------------------------------------------------------------------------------------
    /// The cells of the box where it is now. Does not allocate. The spans last until the next call.
    [[nodiscard]] DragCells cells_in(const Window& window, const Boundaries& boundaries);
    /// What has changed since this was asked last.
    [[nodiscard]] DragChange take_change() { return std::exchange(change_, {}); }
    /// Of the air's cells in a box at `window`.
    [[nodiscard]] Result<DragForce> force_on(DragId id, const Window& window, const Boundaries& boundaries,
                                             std::span<const glm::vec4> velocity) const;
    [[nodiscard]] std::span<const Slot> slots() const { return list_.slots(); }
    /// The world's origin has moved: every place moves by `offset` [m].
    void shift_origin(glm::dvec3 offset);
    /// Every change is noted in `log` from now on; null: no longer.
    void record_to(EventLog* log) { log_ = log; }

  private:
    friend struct DragFields; // wind_snapshot.cpp: bytes and back

    void make_room(std::size_t more);
    [[nodiscard]] DragId put(const DragDeposit& deposit);
    /// Adds what a deposit does to the cells, or takes it out.
    void apply(const DragDeposit& deposit, bool out);
    void link(std::uint32_t index);
    void link_all();
    void fill(const detail::CellRange& range);
    void move(glm::ivec3 by);
    void convert(const detail::CellRange& range);

    Box box_;
    detail::SlotList<Slot, DragField> list_;
    detail::ObstacleGrid grid_;         ///< of all, along x and z
    std::vector<detail::DragSum> sums_; ///< of each cell; empty until there was a deposit
    std::vector<float> drag_;           ///< the same [1/m]
    std::vector<DragCells::Run> runs_;
    detail::DragLattice lattice_{}; ///< that they are of
    bool filled_ = false;           ///< else they are of none
    bool any_ = false;
    detail::CellRange edited_{}; ///< sums that are not converted yet
    DragChange change_{};
    EventLog* log_ = nullptr;
};

} // namespace windrow
