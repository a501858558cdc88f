// Read-backs of the frames in flight, and the latest that was taken.
//
// There is one buffer more than frames in flight: what was taken stays the host's, who reads it in place, until a newer one is
// taken in exchange for it.
#pragma once

#include "fluid/vulkan/air.h"

#include <optional>
#include <utility>
#include <vector>

namespace windrow::vulkan {

/// A frame that was recorded: where its cells lie, and when.
struct RecordedFrame {
    ShownFrame frame;
    Box box{}; ///< with the sides of its time
    BlendZone blend_zone{};
    double time = 0.0;                               ///< [s] of the wind's own clock
    std::uint64_t tick = 0;                          ///< the last one in it or before
    std::shared_ptr<const SurfaceReading> reading{}; ///< how its cells are sampled; null: as they are
    SurfaceReading::Part part{};                     ///< of the reading's box
    const windrow::Wind* outer = nullptr;            ///< the wind around; null: the ambient one
};

/// What a frame asks to be read: a place, and points.
struct ReadPlaces {
    std::optional<glm::dvec3> around;     ///< [m] of ReadBack::box; none: what the box follows
    std::span<const glm::dvec3> points{}; ///< [m] of ReadBack::points; those beyond the room for them are left out
};

class ReadBacks {
  public:
    /// For `slots` frames in flight of an air with one slot more; `start`: the wind before the first recording.
    void make(const Air& air, int slots, const RecordedFrame& start);

    [[nodiscard]] bool has(int slot) const { return slot >= 0 && slot < static_cast<int>(slots_.size()); }
    /// A recording begins: its slot, the next in turn for -1. What was recorded there before is taken; nothing changes where
    /// that fails.
    [[nodiscard]] Result<int> begin(const Air& air, int slot);
    /// True where the places are not those of the last read-back: it is due in a pause too.
    [[nodiscard]] bool asks(const Air& air, const RecordedFrame& frame, const ReadPlaces& places) const;
    /// Entry of Fields::slots that `record` would use.
    [[nodiscard]] int next() const { return slots_[static_cast<std::size_t>(last_)].reading; }
    void record(Air& air, VkCommandBuffer commands, const RecordedFrame& frame, const ReadPlaces& places);
    [[nodiscard]] bool recorded_any() const { return recorded_any_; }
    /// False where nothing waits there, or what is newer was taken already. The error: its memory could not be made visible to
    /// the host; it waits on.
    [[nodiscard]] Result<bool> take(const Air& air, int slot);
    /// The frames in flight too.
    void shift_origin(const OriginShift& shift);
    /// Drops waiting read-backs; the last slot has its turn again.
    void forget();

    /// Of the last tick that was read, without counts.
    void report_to(Diagnostics& diagnostics, const Box& box) const;
    /// Cells that were repaired or limited since the last call.
    void take_counts(Diagnostics& diagnostics);
    [[nodiscard]] const AirReport& report() const { return report_; }
    [[nodiscard]] std::uint64_t tick() const { return tick_; } ///< of the report; 0: none was read

    /// The frame that was taken last; null before the first. Its box is the one that was read.
    [[nodiscard]] const RecordedFrame* frame() const { return taken_recording_ > 0 ? &held().frame : nullptr; }
    /// Counts what was taken.
    [[nodiscard]] std::uint64_t recording() const { return taken_recording_; }
    /// The bytes in its buffer after the report.
    [[nodiscard]] std::span<const std::byte> bytes(const Air& air) const { return air.read(held_); }
    [[nodiscard]] std::span<const glm::dvec3> points() const { return held().points; }
    /// Of the tick that was read; nothing where no part of the body was in the box.
    [[nodiscard]] ObstacleForce force_on(const Air& air, std::uint32_t slot, std::uint32_t generation) const;

  private:
    struct Reading {
        RecordedFrame frame;
        std::vector<glm::dvec3> points{};                              ///< with room for all
        std::vector<std::pair<std::uint32_t, std::uint32_t>> bodies{}; ///< whose forces are read, with room for all
        double duration = 0.0;                                         ///< [s] of the tick
    };
    struct Slot {
        int reading = 0;
        bool pending = false;        ///< recorded, and not taken yet
        bool ticked = false;         ///< with ticks of its own, whose counts it reports
        std::uint64_t recording = 0; ///< counted from 1
    };
    [[nodiscard]] const Reading& held() const { return readings_[static_cast<std::size_t>(held_)]; }

    std::vector<Reading> readings_;    ///< one for each of Fields::slots
    std::vector<Slot> slots_;          ///< frames in flight
    int held_ = 0;                     ///< the reading that the host holds
    std::vector<WindrowPoint> places_; ///< scratch
    int last_ = -1, before_last_ = -1; ///< slots of the last two recordings
    std::optional<glm::ivec3> low_;    ///< of the last recording, with ReadBack::box
    std::uint64_t recording_ = 0, taken_recording_ = 0;
    bool recorded_any_ = false;
    AirReport report_;
    std::uint64_t tick_ = 0;
    std::int64_t repaired_ = 0, limited_ = 0; ///< cells that were read back and not taken yet
};

} // namespace windrow::vulkan
