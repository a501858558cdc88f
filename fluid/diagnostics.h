// Report of a step: figures of the air, and each correction beyond the equations (limits, repairs, sleep).
#pragma once

#include "operators.h"

#include <cstdint>

namespace windrow {

/// Wall-clock time of one step by stage. [ms]
struct StageTimes {
    double sources = 0.0; ///< Motors, NaN guard, speed limit.
    double ambient = 0.0; ///< The ambient wind cell by cell; 0 without gusts.
    double diffusion = 0.0;
    double advection = 0.0; ///< Gathering the carried field included.
    double projection = 0.0;
    double obstacles = 0.0; ///< Rasterisation, and all passes over faces and cells at obstacles. Further solves are projection.
    double report = 0.0;    ///< Energy, largest speed, divergence.
    double total = 0.0;
};

struct Diagnostics {
    bool stepped = false; ///< false: dt was 0, negative or not finite, or out_of_memory; nothing was done.
    /// The system has no memory that the step needs: the wind is unchanged. Free some and call again.
    bool out_of_memory = false;
    /// The box, with rows of its own, was at another height in the last step: air that stayed in it was interpolated. After
    /// `advance`, in any of its ticks.
    bool regridded = false;
    /// [m/s] Largest component of the velocity after the step.
    float max_speed = 0.0f;
    /// Largest component * dt / h after the sources, before sub-steps and limit: how many cells the air would cross at once.
    float cfl = 0.0f;
    int substeps = 0;             ///< Number of sub-steps: ceil(cfl / Config::max_cfl), at most Config::max_substeps.
    bool substeps_capped = false; ///< More sub-steps were needed than allowed: speeds were limited.
    /// [s] Time that the next steps make up for, on a device whose speeds rose further than its host could foresee; 0 on the CPU.
    float carried_time = 0.0f;
    /// Cells whose speed was scaled down to max_cfl * max_substeps cells a step, before the air moved or, where forces and
    /// pressure had made them faster, after it.
    std::int64_t limited_cells = 0;
    std::int64_t repaired_cells = 0; ///< Cells that held NaN or infinity and were set to ambient.
    /// Motors that acted in the box; a wake counts once per segment of its path. In free air also a volume source outside of the
    /// box that makes 1 cm/s in it.
    int motors_in_reach = 0;
    DiffusionMethod diffusion = DiffusionMethod::none;
    /// Around obstacles: what the pressure's solution leaves of the divergence at their surfaces, relative to that before it, and
    /// the number of direct solves in the last sub-step. 0 without obstacles in the box.
    float pressure_residual = 0.0f;
    int pressure_solves = 0;
    /// Volume sources in air that no opening joins to the boundary of the box. What comes out of one there is taken out again,
    /// evenly, from all air of that room: incompressible air cannot leave it.
    int sealed_sources = 0;
    /// [1/s] Root mean square of the central divergence that the collocated projection leaves.
    double divergence_rms = 0.0;
    /// [m^5/s^2] Kinetic energy of the box per unit of density: sum of |u|^2 / 2 h^3.
    double energy = 0.0;
    /// The air had relaxed to the ambient wind and no motor acted: the step did nothing. The other figures, those of gusts too,
    /// stay as in the step that fell asleep. Gusts go on.
    bool asleep = false;
    StageTimes times_ms;
};

} // namespace windrow
