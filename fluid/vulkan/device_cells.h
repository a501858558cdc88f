// The cells of a wind on a device. Operations of the core are recorded within a frame; between two frames they are queued.
#pragma once

#include "fluid/event_log.h"
#include "fluid/vulkan/air.h"
#include "fluid/vulkan/read_backs.h"
#include "fluid/vulkan/saved_air.h"
#include "fluid/vulkan/work_queue.h"

#include <algorithm>
#include <deque>
#include <functional>
#include <memory>
#include <optional>

namespace windrow {
class WindCore;
}

namespace windrow::vulkan {

class DeviceCells final : public CellStorage {
  public:
    /// Both outlive it.
    DeviceCells(const WindCore& wind, const ReadBacks& read_backs, std::unique_ptr<Air> air);

    void make_room(const CellNeeds& needs) override;
    [[nodiscard]] Result<void> set_boundaries(const Boundaries& boundaries, bool kinds) override;
    void apply(const CellChange& change) override;
    [[nodiscard]] bool step(const CellStep& step, Diagnostics& report) override;
    void show(const FrameBlend& blend) override;
    void show_air() override { shows_anew = true; }
    void shift_origin(const OriginShift& shift) override;
    [[nodiscard]] MeasuredSpeeds measured() const override;
    [[nodiscard]] Result<void> check(const Gusts& gusts) const override;
    /// Changes wait for the next recording.
    [[nodiscard]] bool waits() const { return !queue_.empty() || new_sides_ || restored_; }

    /// Records what waits, and from now on all changes. False where nothing waited.
    bool begin(VkCommandBuffer commands, int slot);
    void end();
    /// Air that sleeps becomes what blows now. False where it is that already.
    bool materialise_gusts();
    /// In an outer wind, air that was filled and not stepped since becomes what blows now, as on the CPU.
    void refill(const AmbientWind& ambient, const Window& window);
    /// Nothing that was recorded counts.
    void forget();
    /// The next recording begins with this air; nothing else waits.
    /// `filled`: as LevelState.
    void continue_from(RestoredAir&& restored, bool filled);
    [[nodiscard]] bool filled() const override { return filled_; }
    /// The next tick that is not dictated yet is recorded so: of a replay.
    void dictate(const TickRecorded& tick) { dictated_.push_back(tick); }

    std::unique_ptr<Air> air;
    std::function<void(const OriginShift&)> when_shifted; ///< called by shift_origin: frames that were recorded move too
    std::optional<float> blend; ///< the textures of this frame are to be written, so far between the ticks
    bool shows_anew = false;    ///< the frame before the next is that frame: the wind was reset

  private:
    static constexpr std::uint64_t k_unheld = ~std::uint64_t{0};

    /// Records now, or with the next frame.
    void record(const CellChange& change);
    void report_ambient(const CellStep& step, Diagnostics& report) const;
    /// The tick whose air is known: read back, or that of the wind that was loaded.
    [[nodiscard]] std::uint64_t known_tick() const { return std::max(loaded_tick_, read_backs_.tick()); }
    /// As many sub-steps as the bound of the speed asks for.
    [[nodiscard]] Air::Recorded recording_of(const CellStep& step) const;

    const WindCore& wind_;
    const ReadBacks& read_backs_;
    VkCommandBuffer commands_ = VK_NULL_HANDLE; ///< while a frame is recorded
    WorkQueue queue_;
    std::optional<RestoredAir> restored_; ///< of a loaded wind, until its first recording
    std::deque<TickRecorded> dictated_;
    std::optional<Air::NewBoundaries> new_sides_; ///< from the next recording on
    bool filled_ = false;                         ///< and not stepped since
    std::uint64_t loaded_tick_ = 0;               ///< the last one before this wind was loaded
    std::uint64_t held_at_ = 0; ///< Sleep::drift at which sleeping cells were written; another: they are not what blows now
};

} // namespace windrow::vulkan
