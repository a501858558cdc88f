// The sources stage: what motors do to the air, gathered a cell at a time from the motors that reach it.
#pragma once

#include "fluid/cpu/aligned.h"
#include "fluid/motor_reach.h"
#include "fluid/parallel.h"

#include <cstdint>
#include <glm/vec4.hpp>
#include <span>

namespace windrow::cpu {

/// What motors leave for the step: the acceleration f of those that push, the divergence S of those that let air in.
/// Rows that no motor reaches hold nothing and are never read.
class SourceField {
  public:
    explicit SourceField(glm::ivec3 cells);

    /// Drives act on `velocity`; f and S are gathered. A cell sums its motors in the order of `motors`.
    void gather(std::span<const detail::MotorReach> motors, float cell_size, std::span<glm::vec4> velocity,
                const ParallelFor& parallel_for);

    /// velocity += factor * f, on the rows that hold a force.
    void add_force_to(std::span<glm::vec4> velocity, float factor, const ParallelFor& parallel_for) const;
    /// [m/s^2] Largest component of f.
    [[nodiscard]] float largest_force() const { return largest_force_; }
    /// [1/s] S at every cell; empty where no motor lets air in or out.
    [[nodiscard]] std::span<const float> expansion() const;
    [[nodiscard]] std::size_t memory_bytes() const;

  private:
    void gather_plane(std::span<const detail::MotorReach> motors, float cell_size, std::span<glm::vec4> velocity, int plane);

    glm::ivec3 cells_;
    Buffer<glm::vec4> force_;
    Buffer<std::uint8_t> row_holds_force_; ///< one a row of x
    Buffer<float> plane_largest_;
    Buffer<float> expansion_;
    bool any_force_ = false;
    bool any_expansion_ = false;
    float largest_force_ = 0.0f;
};

} // namespace windrow::cpu
