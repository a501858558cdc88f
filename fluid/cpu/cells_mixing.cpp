// Viscosity, and the turbulence over rough ground, in a step of the cells (step.cpp).
#include "fluid/core/numerics.h"
#include "fluid/core/wind_core.h"
#include "fluid/cpu/acting.h"
#include "fluid/cpu/cells.h"
#include "fluid/cpu/stopwatch.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
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
    const DragRows drag{canopy_, drag_, box().cells};
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
                          .row_scales = state.row_scales(),
                          .lee = drag.any()};
    config_.parallel_for(box().cells.z, [&](int plane) { state.kernels->stress_plane(task, plane); });
    if (drag.any())
        config_.parallel_for(box().cells.z, [&](int plane) { deepen_lee(drag, dt, plane); });
    if (state.has_solids())
        state.solid_flow().extend(diffused_, prescribed());
    return diffused_;
}

// The lee after the step, by its wind at the start, into the fourth components of what is carried. Over a floor the air is at rest; a
// body beside the cell makes no shear, and the face between them is the stress's.
void Cells::deepen_lee(const DragRows& drag, float dt, int plane) {
    const glm::ivec3 cells = box().cells;
    const Solids* const solids = work.state().has_solids() ? work.state().solids.get() : nullptr;
    const auto inside = [&](std::size_t n) { return solids != nullptr && solids->inside(static_cast<std::uint32_t>(n)); };
    const auto level = [&](std::size_t n) { return glm::vec2(air.velocity[n].x, air.velocity[n].z); };
    for (int j = 0; j < cells.y; ++j) {
        const DragRows::Row row = drag.at(j, plane);
        const float middle = box().centre(0, j, 0).y;
        for (int i = 0; i < cells.x; ++i) {
            const std::size_t n = box().index(i, j, plane), over = n + static_cast<std::size_t>(cells.x),
                              under = n - static_cast<std::size_t>(cells.x);
            const glm::vec4 u = air.velocity[n];
            const float c = row.of(i);
            diffused_[n].w = 0.0f;
            if (!(u.w > 0.0f) && !(c > 0.0f))
                continue;
            glm::vec2 high = level(n), low = high;
            float top = middle, bottom = middle;
            if (j + 1 < cells.y && !inside(over)) {
                high = level(over);
                top = box().centre(0, j + 1, 0).y;
            }
            if (j == 0 && config_.boundaries.y_low.solid()) {
                low = glm::vec2(0.0f);
                bottom = 0.0f;
            } else if (j > 0 && !inside(under)) {
                low = level(under);
                bottom = box().centre(0, j - 1, 0).y;
            }
            const float per_height = top > bottom ? dt / (top - bottom) : 0.0f;
            diffused_[n].w = numerics::windrow_lee(u.w, per_height * glm::length(high - low), c * dt * glm::length(glm::vec3(u)));
        }
    }
}

} // namespace windrow::cpu
