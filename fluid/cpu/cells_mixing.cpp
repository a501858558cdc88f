// Viscosity, and the turbulence over rough ground, in a step of the cells (step.cpp).
#include "fluid/core/wind_core.h"
#include "fluid/cpu/cells.h"
#include "fluid/cpu/stopwatch.h"

#include <utility>

namespace windrow::cpu {

// The velocity after diffusion; the input where viscosity has no effect. Diffusion time too short to act is accumulated:
// dropped, it would be lost for any number of sub-steps.
std::span<const glm::vec4> Cells::diffuse(std::span<const glm::vec4> field, float dt, Diagnostics& report) {
    if (!wind_.viscous(dt))
        return field;
    air.undiffused_time += dt;
    const DiffusionMethod method = diffusion_method(config_.viscosity, air.undiffused_time, box().finest());
    report.diffusion = method;
    if (method == DiffusionMethod::none)
        return field;
    OuterStopwatch watch("windrow diffusion", report.times_ms.diffusion, work.state().obstacles_ms);
    (void)windrow::diffuse(work, field, config_.viscosity, std::exchange(air.undiffused_time, 0.0f), diffused_);
    if (work.state().has_solids() && !layer_) // the mixing reads no cell inside, and extends what it makes
        work.state().solid_flow().extend(diffused_, prescribed());
    return diffused_;
}

// The velocity after the mixing over rough ground; the input without.
std::span<const glm::vec4> Cells::mix(std::span<const glm::vec4> field, float dt, Diagnostics& report) {
    if (!layer_)
        return field;
    OuterStopwatch watch("windrow diffusion", report.times_ms.diffusion, work.state().obstacles_ms);
    Workspace::State& state = work.state();
    layer_->renew(around_, wind_.window(), config_.boundaries, state.has_solids() ? state.solids.get() : nullptr,
                  std::exchange(placed_anew_, false), config_.parallel_for);
    const bool gusting = around_.gusting();
    const glm::vec3 mean = gusting ? glm::vec3(0.0f) : state.ambient;
    const StressTask task{.cells = {box().cells.x, box().cells.y, box().cells.z},
                          .velocity = &air.velocity[0].x,
                          .carried = floats(field),
                          .result = &diffused_[0].x,
                          .faces = layer_->faces().data(),
                          .wind = gusting ? ambient_field_.data() : state.mean_cells,
                          .ambient = {mean.x, mean.y, mean.z, 0.0f},
                          .prescribed = gusting,
                          .wind_mixing = layer_->wind_mixing().empty() ? nullptr : layer_->wind_mixing().data(),
                          .wind_drag = layer_->wind_drag().data(),
                          .cells_per_speed = dt / box().cell_size,
                          .row_scales = state.row_scales()};
    config_.parallel_for(box().cells.z, [&](int plane) { state.kernels->stress_plane(task, plane); });
    if (state.has_solids())
        state.solid_flow().extend(diffused_, prescribed());
    return diffused_;
}

} // namespace windrow::cpu
