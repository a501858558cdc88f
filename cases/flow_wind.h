// What runs a flow of `windrow pareto` by one of its methods, raw: a wind, or its step with another pressure solve.
#pragma once

#include "cases/backend_wind.h"
#include "cases/pareto_flow.h"
#include "cases/pareto_method.h"

#include <functional>
#include <memory>
#include <span>

namespace windrow::cases {

class FlowWind {
  public:
    struct FlowSettings {
        Method method = k_default_method; ///< of direct pressure: a wind has no other
        Simd simd = Simd::best;
        ParallelFor parallel_for{};
    };
    [[nodiscard]] static Result<FlowWind> create(const ParetoFlow& flow, glm::ivec3 cells, const FlowSettings& settings,
                                                 const Backend& backend = {});

    /// The flow's start again, without history. Gusts and motors go on.
    void begin();
    /// Moves the first motor to where the flow has it at the step's end, and steps.
    void step(double dt);
    [[nodiscard]] std::span<const glm::vec4> field() const { return wind_->field(); }
    /// Now.
    [[nodiscard]] AmbientWind ambient() const { return wind_->view().ambient(); }

  private:
    FlowWind() = default;

    std::unique_ptr<BackendWind> wind_;
    std::vector<glm::vec4> start_;
    std::function<glm::dvec3(double t)> motion_;
    MotorId first_{};
    double time_ = 0.0; ///< [s]
};

/// For flows that do not need a wind.
[[nodiscard]] Result<reference::ComposedStep> composed_step(const ParetoFlow& flow, glm::ivec3 cells, Simd simd,
                                                            const ParallelFor& parallel_for);

} // namespace windrow::cases
