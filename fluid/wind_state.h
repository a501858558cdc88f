// What a Wind holds, for the files that implement it.
#pragma once

#include "fluid/cpu/aligned.h"
#include "fluid/cpu/sources.h"
#include "fluid/wind.h"
#include "fluid/window.h"

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

struct Wind::State {
    State(const Config& config, Workspace workspace);

    Config config;
    glm::bvec3 follow_axes;
    Workspace work;
    Window window;
    CellIndex stepped_origin_cells;  ///< where the box lay in the last step
    CellIndex previous_origin_cells; ///< where it lay in the step before that
    Air air;
    cpu::Buffer<glm::vec4> diffused; ///< the velocity after diffusion; empty while viscosity asks for none
    Motors motors;
    cpu::ForceField forces;

    [[nodiscard]] const Box& box() { return work.box(); }
    [[nodiscard]] glm::vec4 ambient() const { return {work.ambient(), 0.0f}; }
    void shift_to(CellIndex origin_cells);
    void fill_with_ambient();
    void change_ambient(glm::vec3 wind);

    Diagnostics step(float dt);

  private:
    void add_sources(float dt, Diagnostics& report);
    void limit_speeds(float dt, Diagnostics& report);
    void repair_broken_cells();
    [[nodiscard]] std::span<const glm::vec4> diffuse(float dt, Diagnostics& report);
    void advance_second_order(float dt, Diagnostics& report);
    void advance_stable_fluids(float dt, Diagnostics& report);
    void advance_in_place(float dt, Diagnostics& report);
    void measure(Diagnostics& report);
};

} // namespace windrow
