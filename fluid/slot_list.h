// A list whose entries keep their place: motors, obstacles. A handle has a generation, so that one of an entry that went is rejected
// and never reaches the next entry in its place.
#pragma once

#include "api.h"
#include "result.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace windrow {

/// Handle of an entry of one list. A default handle names none.
template <class List>
struct Handle {
    std::uint32_t slot = 0;
    std::uint32_t generation = 0; ///< 0 names no entry
    /// Number of the list, unique in the process, so that a handle of another wind is rejected. Default 0: not checked, for a handle
    /// that was sent as slot and generation.
    std::uint32_t owner = 0;
    /// The same slot and generation: also of a wind and of its copy that was loaded.
    friend bool operator==(Handle a, Handle b) { return a.slot == b.slot && a.generation == b.generation; }
    /// As a log has it: valid for any wind that starts from the same snapshot.
    [[nodiscard]] Handle unowned() const { return {.slot = slot, .generation = generation}; }
};

struct SlotFields;

namespace detail {

/// Unique in the process; never 0.
[[nodiscard]] WINDROW_INTERNAL std::uint32_t next_owner();

/// What messages call an entry, and why one may be gone.
struct SlotWords {
    const char* entry; ///< singular; its plural ends with s
    const char* gone;
};
[[nodiscard]] WINDROW_INTERNAL Error list_is_full(const SlotWords& words, int count, std::uint32_t most);
/// `another`: the handle is another list's.
[[nodiscard]] WINDROW_INTERNAL Error no_entry(const SlotWords& words, std::uint32_t slot, std::uint32_t generation, bool another);

/// A Slot has `generation`, `used` and `named_here`. Only make_room, and the sentence of an error, allocate.
template <class Slot, class List>
class SlotList {
  public:
    using Id = Handle<List>;

    SlotList(const SlotWords& words, std::uint32_t most) : words_(words), most_(most), owner_(next_owner()) {}

    [[nodiscard]] std::span<Slot> slots() { return slots_; }
    [[nodiscard]] std::span<const Slot> slots() const { return slots_; }
    [[nodiscard]] Slot& operator[](std::uint32_t index) { return slots_[index]; }
    [[nodiscard]] const Slot& operator[](std::uint32_t index) const { return slots_[index]; }
    [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(slots_.size()); }
    [[nodiscard]] std::size_t capacity() const { return slots_.capacity(); }
    [[nodiscard]] int count() const { return count_; } ///< entries that are used
    [[nodiscard]] std::size_t memory_bytes() const {
        return slots_.capacity() * sizeof(Slot) + free_.capacity() * sizeof(std::uint32_t);
    }

    [[nodiscard]] Result<void> check_room(std::size_t more = 1) const {
        return slots_.size() - free_.size() + more > most_ ? list_is_full(words_, count_, most_) : Result<void>();
    }
    /// For some more, and for all to go. Throws std::bad_alloc.
    void make_room(std::size_t more = 1) {
        const std::size_t wanted = slots_.size() + more - std::min(more, free_.size());
        if (wanted > slots_.capacity())
            slots_.reserve(std::max(wanted, 2 * slots_.capacity()));
        free_.reserve(slots_.capacity());
    }
    /// A used slot of a new generation, whose other members are as the last entry left them.
    [[nodiscard]] Id add() {
        std::uint32_t index = size();
        if (free_.empty()) {
            slots_.emplace_back();
        } else {
            index = free_.back();
            free_.pop_back();
        }
        Slot& slot = slots_[index];
        slot.used = slot.named_here = true;
        ++count_;
        return {index, ++slot.generation, owner_};
    }
    void release(std::uint32_t index) {
        slots_[index].used = false;
        free_.push_back(index);
        --count_;
    }
    /// Rejects a stale handle, and one of another list.
    [[nodiscard]] Result<const Slot*> find(Id id) const {
        const Slot* const slot = id.slot < slots_.size() ? &slots_[id.slot] : nullptr;
        const bool stale = slot == nullptr || !slot->used || slot->generation != id.generation;
        if (stale || (id.owner != 0 && id.owner != owner_ && slot->named_here))
            return no_entry(words_, id.slot, id.generation, !stale);
        return slot;
    }
    [[nodiscard]] Result<Slot*> find(Id id) {
        const auto found = std::as_const(*this).find(id);
        return found ? Result<Slot*>(const_cast<Slot*>(*found)) : found.failure();
    }

  private:
    friend struct windrow::SlotFields; // obstacle_record.h: bytes and back

    std::vector<Slot> slots_;
    std::vector<std::uint32_t> free_;
    int count_ = 0;
    SlotWords words_;
    std::uint32_t most_, owner_;
};

} // namespace detail
} // namespace windrow
