// A wind whose cells are on a device, for the files that implement it.
#pragma once

#include "fluid/core/wind_core.h"
#include "fluid/vulkan/device_cells.h"
#include "fluid/vulkan/read_backs.h"
#include "fluid/vulkan/wind.h"

#include <functional>
#include <mutex>
#include <optional>
#include <vector>

namespace windrow::vulkan {

/// The two sets of textures, of this frame and the one before, in turns.
struct TextureSets {
    int current = 0; ///< of the frame last recorded
    int written = 0; ///< sets that hold a frame; sleep may leave them from 2 on
    int stale = 2;   ///< sets that do not hold the sleeping air yet, in a wind without ticks
};

/// A save that was recorded.
struct WindSave {
    int slot = 0;
    bool done = false; ///< the device is
    SavedAir air;
    SnapshotDraft draft;
    std::optional<ShownFrame> shown; ///< with ticks
};

struct WINDROW_HIDDEN Wind::State {
    State(std::unique_ptr<Air> air, const Config& config, const Settings& settings, const AmbientWind& ambient,
          std::shared_ptr<const windrow::Wind> outer);

    WindCore core;
    DeviceCells cells; // before what is made from its device
    ReadBacks read_backs;
    TextureSets textures;
    Settings settings;
    std::optional<PassClock> clock; ///< where passes are timed; its address is the air's
    /// Called while a frame is recorded, after all of it but the read-back: for a tool that times the two apart.
    std::function<void(VkCommandBuffer)> before_read_back;
    double time = 0.0; ///< [s] of the frames recorded, less what was dropped
    int dispatches = 0, barriers = 0;
    int slot = 0; ///< of the last recording
    std::optional<WindSave> save;
    std::vector<WindSave> old_saves; ///< replaced while their recordings may be in flight
    std::string save_error;          ///< why the last recording with Frame::save has none; empty: there is none, or it has
    /// Position of the textures of the last recording, and of the one before it.
    std::optional<ShownFrame> recorded, recorded_before;

    [[nodiscard]] Result<Advance> record(VkCommandBuffer commands, const Frame& frame);
    [[nodiscard]] Result<Diagnostics> record_step(VkCommandBuffer commands, const Frame& frame);
    bool collect(int slot);
    [[nodiscard]] Diagnostics diagnostics() const;
    [[nodiscard]] Diagnostics reported();
    void forget();
    [[nodiscard]] RecordedFrame frame_now() const;
    [[nodiscard]] ShownCells sampled(const std::function<std::span<const glm::vec4>()>& own) const;
    [[nodiscard]] Result<std::vector<std::byte>> saved();
    [[nodiscard]] Result<void> continue_from(LoadedWind from);

  private:
    [[nodiscard]] Result<void> check(VkCommandBuffer commands, const Frame& frame) const;
    [[nodiscard]] Result<void> begin(VkCommandBuffer commands, const Frame& frame);
    void end(VkCommandBuffer commands, const Frame& frame);
    [[nodiscard]] bool write_textures(VkCommandBuffer commands, bool reads);

    void record_save(VkCommandBuffer commands);
    [[nodiscard]] LevelState level_state() const;
    /// What was recorded for this slot before is done.
    void note_done(int slot_done) {
        if (save && save->slot == slot_done)
            save->done = true;
        std::erase_if(old_saves, [&](const WindSave& old) { return old.slot == slot_done; });
    }
    /// The recording that holds it may run still. Throws std::bad_alloc.
    void put_save_away() {
        if (save && !save->done)
            old_saves.push_back(*std::exchange(save, {}));
        save.reset();
    }

    bool save_failed_ = false;    ///< for lack of host memory
    mutable std::mutex sampling_; ///< of the two below, for queries of several threads
    mutable std::vector<glm::vec4> sampled_;
    mutable std::uint64_t sampled_of_ = 0; ///< ReadBacks::recording
    bool asked_ = false;                   ///< in this recording: for something since the frame before it
};

} // namespace windrow::vulkan
