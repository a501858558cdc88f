// What runs a flow of `windrow pareto` by its methods: a wind, on the CPU also with another pressure solve.
#pragma once

#include "cases/backend_wind.h"
#include "cases/pareto_flow.h"
#include "cases/pareto_method.h"
#include "cases/reference/voxel_step.h"

#include <functional>
#include <memory>
#include <span>

namespace windrow::cases {

class FlowWind {
  public:
    struct FlowSettings {
        Method method = k_default_method; ///< on a device of direct pressure
        Simd simd = Simd::best;
        ParallelFor parallel_for{};
    };
    [[nodiscard]] static Result<FlowWind> create(const ParetoFlow& flow, glm::ivec3 cells, const FlowSettings& settings,
                                                 const Backend& backend = {});

    /// Of the next steps, whose history is then the other's. A device keeps the one that it was created with, and so does one with
    /// whole cells for obstacles.
    void set_method(const Method& method);
    /// The flow's start again, without history. Gusts and motors go on.
    void begin();
    /// Moves the first motor to where the flow has it at the step's end, and steps.
    void step(double dt);
    [[nodiscard]] std::span<const glm::vec4> field() const { return voxels_ ? voxels_->velocity() : wind_->field(); }
    /// Now.
    [[nodiscard]] AmbientWind ambient() const { return wind_->view().ambient(); }

  private:
    FlowWind() = default;

    std::unique_ptr<reference::OtherSolve> other_solve_; ///< from the first other one on; before the wind, which refers to it
    std::unique_ptr<BackendWind> wind_;
    std::unique_ptr<reference::VoxelStep> voxels_; ///< in place of the wind, around obstacles
    std::vector<glm::vec4> start_;
    std::function<glm::dvec3(double t)> motion_;
    MotorId first_{};
    double time_ = 0.0; ///< [s]
};

} // namespace windrow::cases
