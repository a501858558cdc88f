// State of a Workspace: the tables of one box and the scratch memory of its passes.
#pragma once

#include "fluid/cpu/aligned.h"
#include "fluid/cpu/kernels/kernels.h"
#include "fluid/cpu/separable_solver.h"
#include "fluid/cpu/solid_flow.h"
#include "fluid/operators.h"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace windrow {

namespace cpu {
class Beyond;

/// Rows of phi / h, `pitch` floats apart.
struct Potential {
    const float* rows;
    int pitch;
};
/// Another solve of the pressure, for comparison: it takes the divergence times h from rows at `rhs`, `pitch` floats apart.
struct PressureSolve {
    float* rhs = nullptr;
    int pitch = 0;
    std::function<Potential()> solve;
};
} // namespace cpu

struct WINDROW_HIDDEN Workspace::State {
    using Rules = std::array<detail::HostVector<HaloRule>, 3>;

    State(const Settings& settings, const cpu::Kernels& kernels);

    Box box;
    glm::vec3 requested_ambient; ///< as the caller gave it
    glm::vec3 ambient;           ///< at open boundaries: without components along axes closed by walls
    /// The mean wind of each padded cell, four floats each, where it is not uniform; null: `ambient`.
    const float* mean_cells = nullptr;
    /// The same with gusts: the wind seen by trajectories beyond an open boundary.
    const float* ambient_cells = nullptr;
    /// The prescribed background wind, within a step in gusts; the advection sets its `legal`.
    cpu::PrescribedWind prescribed{};
    /// [m/s] Within a step: largest component of the velocity that it begins with, one for all its sub-steps and for the
    /// rehearsal of the first, as on a device. Else an advection looks for that of its own.
    std::optional<float> fastest{};
    ParallelFor parallel_for;
    const cpu::Kernels* kernels;

    /// rules[axis][cell + k_halo_low]: source of a padded velocity, for viscosity.
    Rules rules;
    /// The same for transport: the air slips along every wall.
    Rules carried_rules;
    NormalGhost velocity_ghosts[3][2];
    NormalGhost potential_ghosts[3][2];

    cpu::Buffer<float> padded_carried; ///< four floats a padded cell
    cpu::Buffer<float> padded_trace;
    cpu::Buffer<float> padded_scalar; ///< one float a padded cell; made by the first scalar

    cpu::SeparableSolver pressure;
    std::optional<std::array<cpu::SeparableSolver, 3>> diffusion; ///< one a component, made by reserve_diffusion
    cpu::Buffer<float> potential;                                 ///< data of the direct solves
    cpu::Buffer<float> scratch;                                   ///< scratch of the direct solves
    cpu::Buffer<cpu::PlaneSurvey> surveys;                        ///< one a plane
    cpu::Buffer<float> direction, correction;                     ///< of conjugate gradients; empty without obstacles
    std::vector<float> residual_terms, applied_terms,
        masked_terms;                       ///< by surface cell: the residual; L d, A d of the direction d
    double obstacles_ms = 0.0;              ///< of the passes over faces and cells at obstacles, since a step's start
    std::vector<float> closed_slopes;       ///< by closed face: closed times the difference of phi
    std::vector<std::uint32_t> keys_before; ///< scratch of set_obstacles
    std::vector<float> terms_before;
    std::vector<std::int32_t> face_origins; ///< scratch of set_obstacles

    void set_boundaries(const Boundaries& boundaries);
    void set_ambient(glm::vec3 wind);
    void reserve_diffusion();
    [[nodiscard]] std::size_t padded_cells() const;
    /// Of the rows, by row; null where all are equal.
    [[nodiscard]] const float* row_scales() const { return box.rows ? box.rows->scales().data() : nullptr; }
    [[nodiscard]] std::size_t memory_bytes() const;

    /// An AdvectTask with the legal positions of this box; the caller sets fields and step.
    [[nodiscard]] cpu::AdvectTask advect_task() const;
    /// A DivergenceTask with this box's boundaries; the caller sets its result.
    [[nodiscard]] cpu::DivergenceTask divergence_task(const float* velocity, float scale) const;
    /// Central divergence into `potential`, or into rows elsewhere, times `scale`.
    void divergence_to_potential(const float* velocity, float scale) {
        divergence_to(potential.data(), pressure.pitch(), velocity, scale);
    }
    void divergence_to(float* rows, int pitch, const float* velocity, float scale);
    /// field = factor * potential.
    void copy_potential(std::span<float> field, float factor) const;
    /// potential = field, with the slopes over closed faces.
    void set_potential(std::span<const float> field);
    /// potential -= factor * field.
    void subtract_from_potential(std::span<const float> field, float factor);
    /// Output of a projection: field = weight grad phi + kept field.
    struct GradientNote {
        std::span<glm::vec4> field{}; ///< empty: no output
        float weight = 1.0f, kept = 0.0f;
    };
    void take_gradient(const cpu::Potential& solved, std::span<glm::vec4> velocity, const GradientNote& note);
    /// Solution around obstacles: phi = L^-1 (div w + B phi_guess), then steps of conjugate gradients preconditioned by L^-1.
    /// The residual of such a phi is B (phi - phi_guess): 0 away from surface cells.
    struct SolidSolve {
        bool keeps_terms = false;         ///< solid_terms take B phi of the solution, as `note` keeps q
        float guess_scale = 0.0f;         ///< of solid_terms, for the first solve; 0: no guess
        cpu::PrescribedFlow prescribed{}; ///< not in the velocity, but stopped by walls
        bool bodies_move = true;          ///< false: walls at rest, whatever their bodies do
        int solves = 1;                   ///< most
        float tolerance = 0.0f;           ///< residual at which it stops
        float residual = 0.0f;            ///< result: |div w - A phi| over |div w| of the surface cells
        int solved = 0;                   ///< result
    };
    /// In place of the direct solve; null: none. Beside obstacles and for volume sources the direct solve stays.
    const cpu::PressureSolve* other_solve = nullptr;
    /// As project() in operators.h, with phi / h and the wind from `beyond` beyond open boundaries; null: 0, and the edge's own wind.
    void project(std::span<glm::vec4> velocity, std::span<const float> expansion, const GradientNote& note,
                 const cpu::Beyond* beyond = nullptr, SolidSolve* around = nullptr);
    /// Obstacles in the box; null: none.
    std::unique_ptr<Solids> solids;
    /// Slopes of the last steps' phi over closed faces: history of the pressure around obstacles, as q is that of the air.
    std::vector<float> solid_terms;
    std::vector<std::uint32_t> solid_keys; ///< the faces that they are of: 4 times the low cell, plus the axis; sorted
    /// Replaces the obstacles. Faces keep their terms; `shift`: cells by which the box has moved since.
    void set_obstacles(std::span<const PlacedObstacle> obstacles, glm::ivec3 shift = glm::ivec3(0));
    void still_rooms(const cpu::PadTask& pad);
    [[nodiscard]] float fastest_by_rows(const float* velocity) const;
    void advect_one_sided(const cpu::AdvectTask& task, bool scalar, Interpolation interpolation);
    [[nodiscard]] cpu::SolidFlow solid_flow() const { return {*solids, box}; }
    [[nodiscard]] bool has_solids() const { return solids && solids->any(); }
    /// Sum of the planes' reductions, in order of the planes.
    [[nodiscard]] cpu::PlaneSurvey survey(const float* velocity);
    void survey_rows(const float* velocity, int plane, int first, int end, cpu::PlaneSurvey& found) const;
    /// The same, and the central divergence [1/s], less the prescribed one where `expansion` is not empty.
    [[nodiscard]] cpu::PlaneSurvey survey_with_divergence(const float* velocity, std::span<const float> expansion);

  private:
    template <class Visit>
    void for_each_open_end(const Visit& visit) const;
    void solve_around(std::span<const glm::vec4> velocity, SolidSolve& around, const GradientNote& note);
    void add_to_rows(cpu::Buffer<float>& a, const cpu::Buffer<float>& b, float factor);
    void build_ghosts();
    void grow_solver_buffers(const cpu::SeparableSolver& solver);
};

namespace cpu {
/// The cells as floats, four each.
[[nodiscard]] inline const float* floats(std::span<const glm::vec4> field) {
    return field.empty() ? nullptr : &field.data()->x;
}
[[nodiscard]] inline float* floats(std::span<glm::vec4> field) {
    return field.empty() ? nullptr : &field.data()->x;
}
} // namespace cpu

} // namespace windrow
