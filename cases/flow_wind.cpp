#include "cases/flow_wind.h"

#include "cases/cell_values.h"
#include "fluid/wind_state.h"

namespace windrow::cases {

Result<FlowWind> FlowWind::create(const ParetoFlow& flow, glm::ivec3 cells, const FlowSettings& settings,
                                  const Backend& backend) {
    const Box box = box_of(flow, cells);
    auto wind = BackendWind::create({.cells = box.cells,
                                     .cell_size = box.cell_size,
                                     .boundaries = box.boundaries,
                                     .centre = 0.5 * static_cast<double>(box.cell_size) * glm::dvec3(box.cells),
                                     .ambient = glm::vec3(flow.mean),
                                     .profile = flow.profile,
                                     .gusts = flow.gusts,
                                     .viscosity = 0.0f,
                                     .relaxation_time = 0.0f,
                                     .scheme = settings.method.scheme,
                                     .interpolation = settings.method.interpolation,
                                     .max_cfl = 1e5f,
                                     .max_substeps = 1,
                                     .simd = settings.simd,
                                     .parallel_for = settings.parallel_for},
                                    backend);
    if (!wind)
        return wind.failure();
    FlowWind made;
    made.wind_ = *std::move(wind);
    if (!has_voxels(flow, settings.method))
        made.set_method(settings.method);
    made.motion_ = flow.motion;
    for (const Motor& motor : flow.motors) {
        const auto added = made.wind_->motors().add(motor);
        if (!added)
            return added.failure();
        if (&motor == &flow.motors.front())
            made.first_ = *added;
    }
    for (const Obstacle& obstacle : flow.obstacles)
        if (const auto added = made.wind_->obstacles().add(obstacle); !added)
            return added.failure();
    if (has_voxels(flow, settings.method))
        made.voxels_ = std::make_unique<reference::VoxelStep>(
            cells, box.cell_size, reference::sweeps_of(settings.method.pressure), glm::vec3(flow.mean),
            [&](glm::ivec3 cell) { return is_solid(flow, glm::dvec3(box.centre(cell.x, cell.y, cell.z))); },
            settings.parallel_for);
    if (flow.start)
        made.start_ = velocities_of(box, flow.start);
    else if (made.voxels_)
        made.start_.assign(box.cell_count(), glm::vec4(glm::vec3(flow.mean), 0.0f));
    made.begin();
    return made;
}

void FlowWind::set_method(const Method& method) {
    Wind* const wind = wind_->on_cpu();
    if (wind == nullptr || voxels_)
        return;
    Config& config = wind->state().core.config;
    config.scheme = method.scheme;
    config.interpolation = method.interpolation;
    if (!other_solve_ && method.pressure != Pressure::direct)
        other_solve_ = std::make_unique<reference::OtherSolve>(*wind);
    if (other_solve_)
        other_solve_->exchange(*wind, method.pressure);
}

void FlowWind::begin() {
    if (voxels_)
        return voxels_->set_velocity(start_);
    if (start_.empty())
        wind_->reset();
    else
        static_cast<void>(wind_->set_velocity(start_)); // of the box's size
}

void FlowWind::step(double dt) {
    time_ += dt;
    if (voxels_)
        return voxels_->step(static_cast<float>(dt));
    if (motion_)
        static_cast<void>(wind_->motors().move(first_, motion_(time_))); // finite, and the motor has no end
    wind_->step(dt);
}

} // namespace windrow::cases
