// Viscosity, and the turbulence over rough ground, in a step of the cells (step.cpp).
#include "fluid/core/numerics.h"
#include "fluid/core/wind_core.h"
#include "fluid/cpu/acting.h"
#include "fluid/cpu/cells.h"
#include "fluid/cpu/stopwatch.h"

#include <algorithm>
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
    const int nx = box().cells.x, top = box().cells.y - 1;
    const auto centre = [this](int row) { return box().centre(0, row, 0).y; };
    for (int j = 0; j <= top; ++j) {
        const DragRows::Row row = drag.at(j, plane);
        const bool on_floor = j == 0 && config_.boundaries.y_low.solid();
        const int over = std::min(j + 1, top), under = std::max(j - 1, 0);
        const float high = centre(over), low = on_floor ? 0.0f : centre(under);
        const auto cells = [&](int of) { return &air.velocity[box().index(0, of, plane)].x; };
        const LeeTask task{.count = nx,
                           .velocity = cells(j),
                           .above = cells(over),
                           .below = on_floor ? nullptr : cells(under),
                           .time_per_height = high > low ? dt / (high - low) : 0.0f,
                           .deposits = row.deposits,
                           .canopy = row.canopy,
                           .dt = dt,
                           .carried = &diffused_[box().index(0, j, plane)].x};
        work.state().kernels->deepen_lee(task);
        if (work.state().has_solids())
            for (int i = 0; i < nx; ++i)
                deepen_lee_beside(*work.state().solids, {i, j, plane}, row.of(i), dt);
    }
}

// The same of a cell below or above a body.
void Cells::deepen_lee_beside(const Solids& solids, glm::ivec3 cell, float drag, float dt) {
    const auto inside = [&](int row) {
        return row >= 0 && row < box().cells.y && solids.inside(static_cast<std::uint32_t>(box().index(cell.x, row, cell.z)));
    };
    const bool over = inside(cell.y + 1), under = inside(cell.y - 1);
    if (!over && !under)
        return;
    const auto level = [&](int row) {
        const glm::vec4 u = air.velocity[box().index(cell.x, row, cell.z)];
        return glm::vec2(u.x, u.z);
    };
    const bool on_floor = cell.y == 0 && config_.boundaries.y_low.solid();
    const int above = over ? cell.y : std::min(cell.y + 1, box().cells.y - 1), below = under ? cell.y : std::max(cell.y - 1, 0);
    const float high = box().centre(0, above, 0).y, low = on_floor ? 0.0f : box().centre(0, below, 0).y;
    const float shear =
        high > low ? dt / (high - low) * glm::length(level(above) - (on_floor ? glm::vec2(0.0f) : level(below))) : 0.0f;
    const std::size_t n = box().index(cell.x, cell.y, cell.z);
    const glm::vec4 u = air.velocity[n];
    diffused_[n].w = numerics::windrow_lee(u.w, shear, drag * dt * glm::length(glm::vec3(u)));
}

} // namespace windrow::cpu
