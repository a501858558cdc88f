// A wind whose cells lie on a device, for the files that implement it.
#pragma once

#include "fluid/vulkan/air.h"
#include "fluid/vulkan/wind.h"
#include "fluid/vulkan/work_queue.h"
#include "fluid/wind_host.h"

#include <optional>
#include <vector>

namespace windrow::vulkan {

/// What one frame in flight reads back.
struct ReadBack {
    Buffer buffer;
    bool pending = false;        ///< recorded, and not taken yet
    bool ticked = false;         ///< with ticks of its own, whose counts its report tells
    double time = 0.0;           ///< [s] of the wind's own clock
    std::uint64_t recording = 0; ///< counted from 1
    std::uint64_t tick = 0;      ///< the last one in it or before
    windrow::Frame frame;        ///< where its cells lie
    Box box{};                   ///< with the sides of its time
    Rim rim{};
};

struct Wind::State : WindHost {
    State(std::unique_ptr<Air> air, const Config& config, const Settings& settings, const AmbientWind& ambient);

    std::unique_ptr<Air> air;
    Settings settings;
    std::optional<PassClock> clock; ///< where passes are timed; its address is the air's
    std::vector<ReadBack> slots;
    std::vector<glm::vec4> queried_cells;        ///< [m/s] of the last read-back that was taken
    std::optional<windrow::Frame> queried_frame; ///< where they lie
    double queried_time = 0.0;
    double time = 0.0; ///< [s] of the frames recorded, less what was dropped
    AirReport report;  ///< of the last read-back
    int set = 0;       ///< of textures, of the frame last recorded
    int dispatches = 0, barriers = 0;
    Box queried_box; ///< its address is the view's
    Rim queried_rim;

    Advance record(VkCommandBuffer commands, const Frame& frame);
    Diagnostics record_step(VkCommandBuffer commands, const Frame& frame);
    Result<void> set_velocity(std::span<const glm::vec4> field);
    void reset();
    bool collect(int slot);
    [[nodiscard]] Diagnostics reported();
    void forget();
    [[nodiscard]] windrow::Frame frame_now() const;
    /// Where the textures of the last recording lie, and of the one before it.
    std::optional<windrow::Frame> recorded, recorded_before;

  protected:
    void around_changed() override;
    void make_room_around(const Gusts&) override { queue_.make_room(); }
    void make_room(double) override { queue_.make_room(); }
    [[nodiscard]] Result<void> change_sides(const Sides& sides, bool kinds) override;
    void fill_cells() override;
    void fill_before() override;
    void add_ambient_to_cells(float factor) override;
    void add_change_to_cells(glm::vec3 change, bool before_only) override;
    void shift_cells(CellIndex by, bool exposed_hold_ambient) override;
    void begin_keeping() override;
    void keep_before() override;
    void hide_broken_cells() override {} // the device knows in time, the host does not (Pass::show)
    void blend(float factor) override;
    void show_ambient() override;
    void gusts_passed() override { gusts_held_ = false; }
    void step_cells(double dt, std::span<const detail::MotorReach> reached, Diagnostics& report) override;
    [[nodiscard]] bool at_ambient() const override;
    void measure(Diagnostics& report) override;

  private:
    /// A work with what blows around the box now.
    [[nodiscard]] Work work_of(Work::Kind kind) const;
    /// Records now, or with the next frame.
    void do_or_queue(Work work);
    /// The air that sleeps becomes what blows now.
    void hold_gusts();
    [[nodiscard]] bool begin(VkCommandBuffer commands, const Frame& frame);
    void end(const Frame& frame);
    void read_back(ReadBack& slot);
    bool take(ReadBack& slot);
    void tell(Diagnostics& diagnostics) const;
    void tell_counts(Diagnostics& diagnostics);

    VkCommandBuffer commands_ = VK_NULL_HANDLE; ///< while a frame is recorded
    WorkQueue queue_;
    std::optional<Air::NewSides> new_sides_; ///< from the next recording on
    int slot_ = -1;                          ///< of the last recording
    int slot_before_ = -1;                   ///< and of the one before it
    std::uint64_t recording_ = 0, taken_recording_ = 0;
    std::int64_t repaired_ = 0, limited_ = 0; ///< cells that were read back and not told yet
    bool asked_ = false;                      ///< something was asked for since the frame before this one
    std::uint64_t tick_ = 0;
    std::uint64_t disturbed_tick_ = 0; ///< the last one in which something acted
    std::uint64_t report_tick_ = 0;    ///< the one that `report` tells of
    std::optional<float> blend_;       ///< the textures of this frame are to be written, so far between the ticks
    bool ticked_ = false;              ///< in this recording
    bool gusts_held_ = true;           ///< false: the air sleeps, and its cells are not what the gusts are now
    bool filled_ = false;              ///< the next tick begins with the ambient wind in all cells
    bool left_alone_ = false;          ///< the last one did, where it is steady, and nothing acted
    int written_sets_ = 0;             ///< of textures that hold a frame: as many need writing before sleep may leave them
    int unshown_ = 2;                  ///< of the two sets, how many do not hold the sleeping air yet
};

} // namespace windrow::vulkan
