// A wind but for its cells: where the box lies, what blows around it, its motors, its ticks, whether it sleeps. The cells lie on
// the CPU (wind_state.h) or on a device (fluid/vulkan/wind_state.h); this is one text for both.
#pragma once

#include "fluid/cpu/acting.h"
#include "fluid/cpu/aligned.h"
#include "fluid/event_log.h"
#include "fluid/message.h"
#include "fluid/track.h"
#include "fluid/wind.h"
#include "fluid/window.h"

#include <optional>

namespace windrow {

/// The wind of one frame, between two ticks.
struct Frame {
    cpu::Buffer<glm::vec4> field; ///< [m/s] empty where the cells lie on a device
    Window window;
    glm::dvec3 rim_point{0.0}; ///< [m]
    AmbientWind ambient;
    bool still = false; ///< the air slept: the field is `ambient` in `window`
    bool held = true;   ///< what the field is stands in it; false only while still, and written when it is read
};

/// What `advance` keeps beside the air.
struct Frames {
    cpu::Buffer<glm::vec4> before; ///< [m/s] air at the tick before the last one, in the window of today; empty on a device
    bool before_still = false;     ///< it slept
    glm::dvec3 rim_point_before{0.0};
    glm::dvec3 gust_phase_before{0.0};
    double lead = 0.0; ///< [s] time of the frame after the last tick
    Frame shown, shown_before;
    Track follow; ///< of the point that the box follows

    [[nodiscard]] std::size_t memory_bytes() const { return before.bytes() + shown.field.bytes() + shown_before.field.bytes(); }
};

struct WindHost {
    WindHost(const Config& config, const AmbientWind& ambient);
    virtual ~WindHost() = default;
    WindHost(const WindHost&) = delete;
    WindHost& operator=(const WindHost&) = delete;

    static constexpr float k_longest_prepared = 1.0f; ///< [s] step that allocates nothing

    Config config;
    glm::bvec3 follow_axes;
    Window window;
    glm::dvec3 follow_point{0.0};    ///< [m] what the box is centred on, to whole cells
    glm::dvec3 stepped_point{0.0};   ///< [m] the same in the last step
    glm::dvec3 previous_point{0.0};  ///< [m] and in the step before that
    CellIndex stepped_origin_cells;  ///< where the box lay in the last step
    CellIndex previous_origin_cells; ///< where it lay in the step before that
    AmbientWind ambient;
    Motors motors;
    std::uint64_t sources_of_air = 0; ///< names the sources of air whose flow is in the velocity; 0: none
    bool calm = false;                ///< every cell is ambient to the bit, history included: filled so, and not stepped since
    bool asleep = false;              ///< calm, and nothing acts: a step carries the gusts on and does nothing else
    Diagnostics at_rest;              ///< what a step reports while asleep
    std::optional<Frames> frames;     ///< with `advance`
    EventLog* log = nullptr;

    [[nodiscard]] Box box() const { return {config.cells, config.cell_size, config.sides}; }
    /// [m/s] Mean wind that the open sides carry.
    [[nodiscard]] glm::vec3 mean_wind() const { return admissible_ambient(config.sides, config.ambient); }
    /// Viscosity does something that floats hold within a second, or within `dt` [s]; else it is left out.
    [[nodiscard]] bool viscous(float dt = k_longest_prepared) const;
    /// Of a canopy that acts. Nothing where none reaches the box.
    [[nodiscard]] std::optional<cpu::CanopyRows> canopy_rows() const;
    [[nodiscard]] Rim rim(glm::dvec3 point) const;
    [[nodiscard]] WindowBlock window_block(glm::dvec3 anchor, const WindView& view, const WindView& previous_view) const;

    [[nodiscard]] FrameBlock frame_block(glm::dvec3 anchor, const Sampling& sampling, const WindView& view,
                                         const WindView& previous_view) const;

    // What the calls of Wind do; see there.
    Diagnostics step(double dt);
    Advance advance(double dt);
    Result<void> set_ambient(glm::vec3 wind);
    Result<void> set_gusts(const Gusts& gusts);
    Result<void> set_sides(const Sides& sides);
    Result<void> follow(glm::dvec3 point);
    Result<void> set_floor(double height);
    void record_to(EventLog* to);

    /// After a change of sides, mean wind, gusts or place: what blows around the box.
    void renew_ambient();
    /// Back to ambient everywhere, with no past.
    void fill_with_ambient();

  protected:
    // --- The cells -------------------------------------------------------------------------------------------------------------
    /// What blows around the box changed.
    virtual void around_changed() = 0;
    /// Makes room for what `gusts` ask of the cells. Changes no cell; throws where memory is missing.
    virtual void make_room_around(const Gusts& gusts) = 0;
    /// Makes room for all that a step of `dt` [s] may ask of the cells. Changes no cell; throws where memory is missing.
    virtual void make_room(double dt) = 0;
    /// The boundaries become `sides`; their kinds change if `kinds`. An error, with nothing changed, where the cells cannot have them.
    [[nodiscard]] virtual Result<void> change_sides(const Sides& sides, bool kinds) = 0;
    /// The air becomes ambient, with no past and no flow of sources.
    virtual void fill_cells() = 0;
    /// The air of the tick before becomes ambient.
    virtual void fill_before() = 0;
    /// Adds `factor` times the ambient wind to the air and to what is kept of it.
    virtual void add_ambient_to_cells(float factor) = 0;
    /// Adds a change of the mean wind, by its profile, to what is kept of the air and, unless `before_only`, to the air.
    virtual void add_change_to_cells(glm::vec3 change, bool before_only) = 0;
    /// The air stays where it is while the box moves by whole cells. Cells that this exposes hold the ambient wind, or 0, with no
    /// past.
    virtual void shift_cells(CellIndex by, bool exposed_hold_ambient) = 0;
    /// From now on the air of the tick before is kept: now it is that of now.
    virtual void begin_keeping() = 0;
    /// The air of now becomes the air of the tick before.
    virtual void keep_before() = 0;
    /// The tick repaired cells: what is kept of them shows nowhere.
    virtual void hide_broken_cells() = 0;
    /// Makes the wind of this frame, `factor` of the way from the tick before to now.
    virtual void blend(float factor) = 0;
    /// The wind of this frame is the ambient wind of its moment.
    virtual void show_ambient() = 0;
    /// The air sleeps and the gusts have passed on: what the cells hold is no longer what blows.
    virtual void gusts_passed() = 0;
    /// A step of the air: `dt` [s] with what the motors do in it.
    virtual void step_cells(double dt, std::span<const detail::MotorReach> reached, Diagnostics& report) = 0;
    /// The air has become still and nothing but sleep is left to do.
    [[nodiscard]] virtual bool at_ambient() const = 0;
    /// What the air reports now.
    virtual void measure(Diagnostics& report) = 0;

    /// Takes note of the sources of air among the motors: true where they, or the box under them, are not what they were.
    bool renew_sources(std::span<const detail::MotorReach> reached);

  private:
    [[nodiscard]] bool has_room_around(const Gusts& gusts);
    Diagnostics tick_air(double duration);
    void run_step(double duration, Diagnostics& report);
    void follow_now(glm::dvec3 point);
    void shift_to(CellIndex origin_cells);
    void change_ambient(glm::vec3 wind);
    /// Around a change of the wind around the box, by which all air of the box changes too.
    void take_ambient_out();
    void put_ambient_in();
    void fall_asleep_if_settled(Diagnostics& report);
    Advance run_ticks(double dt);
    void begin_ticks();
    void drop_ticks(double seconds);
    void tick(double duration, Diagnostics& report);
    void show_frame();
};

// Checks that Wind::create and the calls above share.
namespace detail {
[[nodiscard]] bool can_hold_point(const Config& config, glm::dvec3 point);
void check_ambient(Reasons& reasons, glm::vec3 ambient);
void check_follow(Reasons& reasons, const std::optional<glm::bvec3>& follow, const Sides& sides);
} // namespace detail

} // namespace windrow
