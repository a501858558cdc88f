// Backend-independent part of a wind: window, ambient wind, motors, obstacles, ticks, sleep. The cells are a CellStorage, on the CPU or on a
// device.
//
// `step` and `advance` are in wind_advance.cpp, from top to bottom; the other calls of a host are in wind_core.cpp.
#pragma once

#include "fluid/api.h"
#include "fluid/core/cell_storage.h"
#include "fluid/core/frame_history.h"
#include "fluid/core/message.h"
#include "fluid/core/sleep.h"
#include "fluid/core/speed_bound.h"
#include "fluid/core/window_history.h"
#include "fluid/event_log.h"
#include "fluid/wind.h"

#include <memory>
#include <optional>

namespace windrow {

class WINDROW_INTERNAL WindCore {
  public:
    /// `outer`: the wind around; null: the ambient one.
    WindCore(const Config& config, const AmbientWind& ambient, CellStorage& cells, std::shared_ptr<const Wind> outer = {});
    WindCore(const WindCore&) = delete;
    WindCore& operator=(const WindCore&) = delete;

    static constexpr float k_longest_prepared = 1.0f; ///< [s] step that allocates nothing

    Config config;
    const std::shared_ptr<const RowTable> rows; ///< of the config; null: none
    WindowHistory place;
    AmbientWind ambient;
    Motors motors;
    Obstacles obstacles;
    DragField drag;
    std::uint64_t source_name = 0; ///< of the set of volume sources whose flow is in the velocity; 0: none
    Sleep sleep;
    SpeedBound speed;
    std::optional<FrameHistory> frames; ///< with `advance`
    Diagnostics last{.times_ms = {}};   ///< of the last step or tick
    EventLog* log = nullptr;
    const std::shared_ptr<const Wind> outer; ///< null: none

    [[nodiscard]] const Window& window() const { return place.window; }
    [[nodiscard]] const Box& box() const { return box_; }
    /// [m/s] Mean wind that the open boundaries carry.
    [[nodiscard]] glm::vec3 mean_wind() const { return admissible_ambient(config.boundaries, config.ambient); }
    /// Viscosity does something that floats hold within a second, or within `dt` [s]; else it is left out.
    [[nodiscard]] bool viscous(float dt = k_longest_prepared) const;
    /// The stress of rough ground acts.
    [[nodiscard]] bool rough() const { return config.roughness && config.stages.diffusion; }
    [[nodiscard]] BlendZone blend_zone(glm::dvec3 point) const;
    /// The wind of the last frame, or of the last step.
    [[nodiscard]] ShownFrame shown() const;
    [[nodiscard]] WindowBlock window_block(glm::dvec3 anchor, const WindView& view, const WindView& previous_view) const;
    [[nodiscard]] FrameBlock frame_block(glm::dvec3 anchor, const Sampling& sampling, const WindView& view,
                                         const WindView& previous_view) const;

    /// Ambient everywhere, once the storage can hold cells.
    void start();

    // What the calls of Wind do; see there.
    Diagnostics step(double dt);
    Advance advance(double dt);
    Result<void> set_ambient(glm::vec3 wind);
    Result<void> set_gusts(const Gusts& gusts);
    Result<void> set_boundaries(const Boundaries& boundaries);
    Result<void> follow(glm::dvec3 point);
    Result<void> set_floor(double height);
    Result<void> shift_origin(glm::dvec3 offset);
    Result<void> set_velocity(const std::function<glm::vec3(glm::dvec3)>& velocity_at);
    Result<void> set_velocity(std::span<const glm::vec4> field);
    /// As they stand now, in a box at `in`.
    Result<void> write_obstacles(std::span<float> cells, const Window& in) const;
    void reset();
    void record_to(EventLog* to);

    /// The ambient wind after a change of boundaries, mean wind, gusts or position.
    void renew_ambient();

  private:
    friend struct StateFields; // wind_snapshot.cpp

    // --- wind_advance.cpp: time --------------------------------------------------------------------------------------------
    /// `outer_way`: CellStep::outer_way.
    Diagnostics step_air(double duration, float outer_way = 1.0f);
    void run_step(double duration, float outer_way, Diagnostics& report);
    [[nodiscard]] Diagnostics tick(double duration, float outer_way);
    void follow_outer_ambient();
    void drop(double seconds);
    void drift(double seconds);
    void follow_now(glm::dvec3 point);
    void shift_to(CellIndex origin_cells);
    [[nodiscard]] bool renew_sources(std::span<const detail::MotorReach> reached);
    [[nodiscard]] CanopyRows canopy_rows() const;
    [[nodiscard]] bool changes_ambient() const;
    [[nodiscard]] AirNow now() const { return {place.window, place.point, ambient, sleep.asleep()}; }

    // --- Changes of the cells ------------------------------------------------------------------------------------------------
    [[nodiscard]] CellChange change(CellChange::Kind kind) const;
    void apply(const CellChange& change) {
        speed.note(change);
        cells_.apply(change);
    }
    void apply(CellChange::Kind kind) { apply(change(kind)); }
    void add_ambient(float factor);
    void fill_with_ambient();
    /// Before and after a change of the wind around the box, by which all air of the box changes too.
    void take_ambient_out();
    void put_ambient_in();
    void change_ambient(glm::vec3 wind);
    Result<void> change_gusts(const Gusts& gusts);
    [[nodiscard]] bool has_room(const CellNeeds& needs);
    void note(const auto& event) {
        if (log != nullptr)
            log->note(event);
    }

    Box box_;
    CellStorage& cells_;
};

// Checks that Wind::create and the calls above use.
namespace detail {
[[nodiscard]] bool can_hold_point(const Config& config, glm::dvec3 point);
void check_ambient(Reasons& reasons, glm::vec3 ambient);
/// `rows`: the box has rows of its own.
void check_follow(Reasons& reasons, const std::optional<glm::bvec3>& follow, const Boundaries& boundaries, bool rows);
void check_rows(Reasons& reasons, const Config& config);
/// A config inside `outer`, whose ambient wind it takes; and why it cannot be inside.
[[nodiscard]] WINDROW_INTERNAL Config config_within(const Config& config, const Wind& outer);
[[nodiscard]] WINDROW_INTERNAL Config config_loaded(const Config& config, const Wind& outer);
WINDROW_INTERNAL void check_within(Reasons& reasons, const Config& config, const Wind& outer);
WINDROW_INTERNAL void check_span(Reasons& reasons, const Config& config, const Wind& outer);
[[nodiscard]] WINDROW_INTERNAL Result<void> check_room(const char* call, std::size_t values, const Box& box);
} // namespace detail

} // namespace windrow
