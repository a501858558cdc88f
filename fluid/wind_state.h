// What a Wind holds, for the files that implement it.
#pragma once

#include "fluid/cpu/aligned.h"
#include "fluid/cpu/ambient_field.h"
#include "fluid/cpu/sources.h"
#include "fluid/event_log.h"
#include "fluid/track.h"
#include "fluid/wind.h"
#include "fluid/window.h"

#include <optional>

namespace windrow {

/// The air of the last two steps and the second-order history; see cpu/step.cpp.
struct Air {
    explicit Air(std::size_t cells) : velocity(cells), velocity_old(cells), history(cells) {}

    cpu::Buffer<glm::vec4> velocity;     ///< u [m/s]
    cpu::Buffer<glm::vec4> velocity_old; ///< u one sub-step earlier; holds nothing while `fresh`
    cpu::Buffer<glm::vec4> history;      ///< q = (dt/2) (grad p - f) of the last sub-step [m/s]; holds nothing while `fresh`
    bool fresh = true;                   ///< u_old = u and q = 0 without being written
    float dt_old = 0.0f;                 ///< [s] last sub-step

    [[nodiscard]] std::size_t memory_bytes() const { return velocity.bytes() + velocity_old.bytes() + history.bytes(); }
};

/// The wind of one frame, between two ticks.
struct Frame {
    cpu::Buffer<glm::vec4> field; ///< [m/s]
    Window window;
    glm::dvec3 rim_point{0.0}; ///< [m]
    AmbientWind ambient;
    bool still = false; ///< the air slept: the field is ambient everywhere in any window
};

/// What `advance` keeps beside the air.
struct Frames {
    cpu::Buffer<glm::vec4> before; ///< [m/s] air at the tick before the last one, in the window of today
    bool before_still = false;     ///< it slept
    glm::dvec3 rim_point_before{0.0};
    glm::dvec3 gust_phase_before{0.0};
    double lead = 0.0; ///< [s] time of the frame after the last tick
    Frame shown, shown_before;
    Track follow; ///< of the point that the box follows

    [[nodiscard]] std::size_t memory_bytes() const { return before.bytes() + shown.field.bytes() + shown_before.field.bytes(); }
};

struct Wind::State {
    State(const Config& config, Workspace workspace, const AmbientWind& ambient);

    Config config;
    glm::bvec3 follow_axes;
    Workspace work;
    Window window;
    glm::dvec3 follow_point{0.0};    ///< [m] what the box is centred on, to whole cells
    glm::dvec3 stepped_point{0.0};   ///< [m] the same in the last step
    glm::dvec3 previous_point{0.0};  ///< [m] and in the step before that
    CellIndex stepped_origin_cells;  ///< where the box lay in the last step
    CellIndex previous_origin_cells; ///< where it lay in the step before that
    AmbientWind ambient;
    cpu::AmbientField mean_field;    ///< the mean wind cell by cell; empty without a profile
    cpu::AmbientField ambient_field; ///< the same with gusts; empty without gusts
    Air air;
    cpu::Buffer<glm::vec4> diffused; ///< the velocity after diffusion; empty while viscosity asks for none
    Motors motors;
    cpu::SourceField sources;
    std::uint64_t sources_of_air = 0;   ///< names the sources of air whose flow is in the velocity; 0: none
    cpu::Buffer<glm::vec4> source_flow; ///< u_S [m/s], part of the velocity; empty until air first comes in, 0 while none does
    cpu::Buffer<glm::vec4> solved;      ///< scratch for u less its given part; empty until something is given
    bool calm = false;                  ///< every cell is ambient to the bit, history included: filled so, and not stepped since
    bool asleep = false;                ///< calm, and nothing acts: a step does nothing
    Diagnostics at_rest;                ///< what a step reports while asleep
    std::optional<Frames> frames;       ///< with `advance`
    EventLog* log = nullptr;

    [[nodiscard]] const Box& box() const { return work.box(); }
    [[nodiscard]] Rim rim(glm::dvec3 point) const;
    [[nodiscard]] WindView air_view() const;

    void follow(glm::dvec3 point);
    void shift_to(CellIndex origin_cells);
    void fill_with_ambient();
    void change_ambient(glm::vec3 wind);
    /// Changes the wind around the box and, by the same, all air of the box; `change` changes it.
    template <class Change>
    void exchange_ambient(const Change& change) {
        if (calm) {
            change();
            renew_ambient();
            fill_with_ambient();
            if (frames)
                fill(frames->before);
        } else {
            add_ambient_to_air(-1.0f);
            change();
            renew_ambient();
            add_ambient_to_air(1.0f);
        }
        asleep = false;
    }
    /// After a change of sides, mean wind, gusts or place: what blows around the box, and in every cell where it is not the same
    /// everywhere.
    void renew_ambient();

    Diagnostics step(double duration);
    Advance advance(double dt);

  private:
    void step(double duration, Diagnostics& report);
    /// [m/s] Ambient wind of a cell of the box.
    [[nodiscard]] glm::vec4 ambient_at(int i, int j, int k) const;
    [[nodiscard]] glm::vec4 mean_at(int i, int j, int k) const;
    void fill(std::span<glm::vec4> field) const;
    void add_ambient_to_air(float factor);
    void add_ambient(std::span<glm::vec4> field, float factor) const;
    void fill_exposed(std::span<glm::vec4> field, CellIndex shift) const;

    void add_sources(std::span<const detail::MotorReach> reached, Diagnostics& report);
    void let_air_in(std::span<const detail::MotorReach> reached);
    void limit_speeds(float dt, Diagnostics& report);
    void repair_broken_cells();
    void carry_gusts(float dt, Diagnostics& report);
    /// The given part of the wind is out of it, in it again: around what a step solves.
    class Solving;
    void reserve_solved();
    [[nodiscard]] std::span<const glm::vec4> without_given_flow();
    void add_given_flow(std::span<glm::vec4> field, float factor) const;
    [[nodiscard]] std::span<const glm::vec4> diffuse(std::span<const glm::vec4> field, float dt, Diagnostics& report);
    void advance_second_order(float dt, Diagnostics& report);
    void advance_stable_fluids(float dt, Diagnostics& report);
    void advance_in_place(float dt, Diagnostics& report);
    void measure(Diagnostics& report);
    [[nodiscard]] bool at_ambient() const;
    void fall_asleep_if_settled(Diagnostics& report);

    void begin_ticks();
    void drop_ticks(double seconds);
    void tick(double duration, Diagnostics& report);
    void show_frame();
};

} // namespace windrow
