// Obstacles in a step of the cells (step.cpp): where they are, the pressure around them, and what reads beside them find.
#include "fluid/cpu/cells.h"
#include "fluid/message.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace windrow::cpu {
namespace {

constexpr int k_first_solves = 16; // of the pressure around obstacles, in the first step of a flow
constexpr float k_first_residual = 1e-3f;
constexpr float k_steady_residual = 1e-2f, k_gusty_residual = 6e-2f; // for which one solve does

} // namespace

void Cells::place_obstacles(const CellStep& step, double early, Diagnostics& report) {
    bodies_move_ = std::any_of(step.obstacles.begin(), step.obstacles.end(), [](const auto& body) { return body.moves(); });
    if (!step.obstacles_changed && !place_again_ && !(bodies_move_ && report.substeps > 1))
        return;
    const bool placed = detail::memory_lasts([&] {
        placed_.assign(step.obstacles.begin(), step.obstacles.end());
        for (PlacedObstacle& body : placed_) {
            const auto back = static_cast<float>(early);
            body.position -= back * body.velocity;
            if (const float angle = back * glm::length(body.spin); angle > 0.0f)
                body.axes = glm::mat3(glm::rotate(glm::mat4(1.0f), -angle, body.spin)) * body.axes;
        }
        work.state().set_obstacles(placed_, unplaced_shift_);
    });
    unplaced_shift_ = glm::ivec3(0);
    place_again_ = !placed;
    if (!placed) { // the air does without them in this step
        work.state().solids.reset();
        report.out_of_memory = true;
    }
}

PrescribedFlow Cells::prescribed() const {
    return {.ambient = around_.gusting() ? ambient_field_.data() : nullptr,
            .source_flow = has_source_flow() ? std::span<const glm::vec4>(source_flow) : std::span<const glm::vec4>()};
}

// One solve begins from the pressure of the last step. A second follows where bodies move, since theirs is another by now, or
// where one leaves too much; a flow without a last step takes more.
void Cells::project_around(std::span<glm::vec4> velocity, const Workspace::State::GradientNote& note, float guess_scale,
                           Diagnostics& report) {
    Workspace::State::SolidSolve around{.keeps_terms = true, .guess_scale = guess_scale, .given = prescribed()};
    if (config_.pressure_solves > 0)
        around.solves = config_.pressure_solves;
    else if (guess_scale == 0.0f)
        around.solves = k_first_solves, around.tolerance = k_first_residual;
    else {
        around.solves = 2;
        around.tolerance = bodies_move_ ? 0.0f : around_.gusting() ? k_gusty_residual : k_steady_residual;
    }
    work.state().project(velocity, {}, note, nullptr, &around);
    report.pressure_residual = around.residual;
    report.pressure_solves = work.state().has_solids() ? around.solved : 0;
}

// A read of the air beside a body finds air in the body too.
void Cells::extend_into_bodies() {
    if (!work.state().has_solids())
        return;
    const SolidFlow flow = work.state().solid_flow();
    flow.extend(air.velocity, {});
    if (air.fresh)
        return;
    flow.extend(air.velocity_old, {});
    flow.extend_history(air.history);
}

} // namespace windrow::cpu
