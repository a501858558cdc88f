// A Wind whose cells lie on the CPU, for the files that implement it.
#pragma once

#include "fluid/cpu/aligned.h"
#include "fluid/cpu/ambient_field.h"
#include "fluid/cpu/sources.h"
#include "fluid/wind_host.h"

#include <atomic>
#include <mutex>

namespace windrow {

/// The air of the last two steps and the second-order history; see cpu/step.cpp.
struct Air {
    explicit Air(std::size_t cells) : velocity(cells), velocity_old(cells), history(cells) {}

    cpu::Buffer<glm::vec4> velocity;     ///< u [m/s]
    cpu::Buffer<glm::vec4> velocity_old; ///< u one sub-step earlier; holds nothing while `fresh`
    cpu::Buffer<glm::vec4> history;      ///< q = (dt/2) grad p of the last sub-step [m/s]; holds nothing while `fresh`
    bool fresh = true;                   ///< u_old = u and q = 0 without being written
    float dt_old = 0.0f;                 ///< [s] last sub-step
    float owed_diffusion = 0.0f;         ///< [s] in which viscosity has not acted yet

    [[nodiscard]] std::size_t memory_bytes() const { return velocity.bytes() + velocity_old.bytes() + history.bytes(); }
};

struct Wind::State : WindHost {
    State(const Config& config, Workspace workspace, const AmbientWind& ambient);

    Workspace work;
    cpu::AmbientField mean_field;     ///< the mean wind cell by cell; empty without a profile
    cpu::AmbientField ambient_field;  ///< the same with gusts; empty without gusts
    cpu::AmbientField ambient_next;   ///< within a step: at its end
    std::vector<float> profile_bends; ///< second differences of the profile, one a padded row; empty without profile or gusts
    Air air;
    cpu::Buffer<glm::vec4> diffused; ///< the velocity after diffusion; empty while viscosity asks for none
    cpu::SourceField sources;
    cpu::Buffer<glm::vec4> source_flow; ///< u_S [m/s], part of the velocity; empty until air first comes in, 0 while none does
    cpu::FreeAir free_air;              ///< where sources of air blow; empty until then
    cpu::Buffer<glm::vec4> solved;      ///< scratch for u less its given part; empty until something is given
    glm::dvec3 next_phase{0.0};         ///< [m] of the gusts at the end of the sub-step
    std::atomic<bool> held = true;      ///< false: the cells are ambient and are written when they are read
    bool before_held = true;            ///< the same of frames->before
    std::mutex holding;                 ///< of what is held, in frames too

    [[nodiscard]] const Box& box() const { return work.box(); }
    /// Views of the air, or of a frame; what their cells are stands in them from then on.
    [[nodiscard]] WindView air_view();
    [[nodiscard]] WindView frame_view(Frame& frame);
    /// Writes the ambient wind into cells that are known to be ambient and hold it not yet; those of a frame, of the tick before.
    /// Threads may ask at once.
    void hold_ambient();
    void hold_frame(Frame& frame);
    void hold_before();
    void begin_anew();

  protected:
    void around_changed() override;
    void make_room_around(const Gusts& gusts) override;
    void make_room(double dt) override;
    [[nodiscard]] Result<void> change_sides(const Sides& sides, bool kinds) override;
    void fill_cells() override;
    void fill_before() override;
    void add_ambient_to_cells(float factor) override;
    void add_change_to_cells(glm::vec3 change, bool before_only) override;
    void shift_cells(CellIndex by, bool exposed_hold_ambient) override;
    void begin_keeping() override;
    void keep_before() override;
    void hide_broken_cells() override { keep_before(); }
    void blend(float factor) override;
    void show_ambient() override;
    void gusts_passed() override;
    void step_cells(double dt, std::span<const detail::MotorReach> reached, Diagnostics& report) override;
    [[nodiscard]] bool at_ambient() const override;
    void measure(Diagnostics& report) override;

  private:
    /// [m/s] Ambient wind of a cell of the box.
    [[nodiscard]] glm::vec4 ambient_at(int i, int j, int k) const;
    [[nodiscard]] glm::vec4 mean_at(int i, int j, int k) const;
    void fill(std::span<glm::vec4> field) const;
    /// For calls that change the wind, which no other thread reads meanwhile.
    void hold_ambient_alone(const ParallelFor& parallel_for);
    void hold_gusts(std::span<glm::vec4> field, const AmbientWind& wind, const Window& place);
    void add_ambient(std::span<glm::vec4> field, float factor) const;
    void fill_exposed(std::span<glm::vec4> field, CellIndex shift) const;

    void add_sources(float dt, std::span<const detail::MotorReach> reached, Diagnostics& report);
    [[nodiscard]] bool acts_whole() const;
    void hold_whole(float dt);
    void let_air_in(std::span<const detail::MotorReach> reached);
    void limit_speeds(float dt, Diagnostics& report);
    /// [m/s] Most that a component may be where a step of dt [s] in all sub-steps allowed is to carry it.
    [[nodiscard]] float fastest_carried(float dt) const;
    void cut_speeds(float most, Diagnostics& report);
    void repair_broken_cells();
    /// Finds the gusts at the end of the sub-step; from carry_gusts on they are those of now.
    void foresee_gusts(Diagnostics& report);
    void carry_gusts();
    void bend_profile();
    /// The given part of the wind is out of it, in it again: around what a step solves.
    class Solving;
    void reserve_solved();
    [[nodiscard]] std::span<const glm::vec4> without_given_flow();
    void add_given_flow(std::span<glm::vec4> field, float factor) const;
    [[nodiscard]] std::span<const glm::vec4> diffuse(std::span<const glm::vec4> field, float dt, Diagnostics& report);
    void advance_second_order(float dt, Diagnostics& report);
    void rehearse(float dt, Diagnostics& report);
    void perform(float dt, Diagnostics& report);
    void advance_stable_fluids(float dt, Diagnostics& report);
    void advance_in_place(float dt, Diagnostics& report);
};

} // namespace windrow
