// The step with its stages to choose: time scheme, interpolation, pressure. What `windrow pareto` compares.
//
// The library's own pieces in the library's own order (fluid/cpu/step.cpp), with another solve in the place of the direct one:
// divergence and gradient around it are the library's too, so that nothing but the solve differs. With Pressure::direct it is
// Wind's step to the bit, guard and report included. Iterations begin at zero in each step.
//
// Not in it: settling, gusts, sources of air, sub-steps.
#pragma once

#include "cases/reference/jacobi.h"
#include "cases/reference/multigrid.h"
#include "fluid/cpu/acting.h"
#include "fluid/cpu/workspace.h"
#include "fluid/motors.h"
#include "fluid/operators.h"
#include "fluid/result.h"
#include "fluid/wind.h"
#include "fluid/window.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <vector>

namespace windrow::reference {

enum class Pressure : std::uint8_t { direct, multigrid, jacobi80, jacobi40, jacobi20 };

/// V(2,2) cycles of Pressure::multigrid in a step.
inline constexpr int k_multigrid_cycles = 2;

struct StepMethod {
    Scheme scheme = Scheme::second_order;
    Interpolation interpolation = Interpolation::cubic;
    Pressure pressure = Pressure::direct;
    friend bool operator==(const StepMethod&, const StepMethod&) = default;
};

class ComposedStep {
  public:
    struct StepSettings {
        Box box{};
        glm::vec3 ambient{0.0f};     ///< [m/s] beyond open boundaries
        float viscosity = 0.0f;      ///< [m^2/s]
        std::vector<Motor> motors{}; ///< positions from the box's low corner; none that lets air in
        Simd simd = Simd::best;
        ParallelFor parallel_for{};
    };
    [[nodiscard]] static Result<ComposedStep> create(const StepSettings& settings);

    /// Lays a field in, without history; motors begin anew.
    [[nodiscard]] Result<void> start(std::span<const glm::vec4> velocity);
    /// dt [s] > 0. A method may follow another: the history that it finds is then the other's.
    void step(const StepMethod& method, double dt);
    /// [m/s] As box.h lays it out.
    [[nodiscard]] std::span<const glm::vec4> velocity() const { return velocity_; }
    /// [m/s] Largest component after the last step.
    [[nodiscard]] float largest_speed() const { return largest_speed_; }

  private:
    ComposedStep(const StepSettings& settings, Workspace work);

    [[nodiscard]] std::span<const glm::vec4> diffuse(float dt);
    void advance_second_order(const StepMethod& method, float dt);
    void perform(const StepMethod& method, float dt);
    void advance_stable_fluids(const StepMethod& method, float dt);
    using GradientNote = Workspace::State::GradientNote;
    void project(Pressure pressure, std::span<glm::vec4> velocity, const GradientNote& note);
    void divergence_rows(std::span<const glm::vec4> velocity, float* rows, int pitch);
    void subtract_gradient(const float* rows, int pitch, std::span<glm::vec4> velocity, const GradientNote& note);

    StepSettings settings_;
    Workspace work_;
    Motors motors_;
    cpu::SourceField sources_;
    cpu::Buffer<glm::vec4> velocity_, velocity_old_, history_, diffused_;
    cpu::Buffer<float> rhs_; ///< of Jacobi, dense
    Jacobi jacobi_;
    Multigrid multigrid_;
    bool fresh_ = true;
    float dt_old_ = 0.0f;
    float largest_speed_ = 0.0f;
};

} // namespace windrow::reference
