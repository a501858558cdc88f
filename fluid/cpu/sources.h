// The sources stage: what motors do to the air, gathered a cell at a time from the motors that reach it.
#pragma once

#include "fluid/cpu/aligned.h"
#include "fluid/motors.h"
#include "fluid/parallel.h"
#include "fluid/window.h"

#include <glm/vec4.hpp>

#include <cstdint>
#include <span>

namespace windrow::cpu {

/// The acceleration field of the motors that push by force. Rows that no such motor reaches hold nothing and are never read.
class ForceField {
  public:
    explicit ForceField(glm::ivec3 cells);

    /// velocity += factor * f, on the rows that hold a force.
    void add_to(std::span<glm::vec4> velocity, float factor, const ParallelFor& parallel_for) const;
    [[nodiscard]] bool empty() const { return !any_; }
    /// [m/s^2] Largest component.
    [[nodiscard]] float largest() const { return largest_; }
    [[nodiscard]] std::size_t memory_bytes() const { return values_.bytes() + row_holds_.bytes() + plane_largest_.bytes(); }

  private:
    friend int apply_motors(Motors&, const Window&, float, std::span<glm::vec4>, ForceField&, const ParallelFor&);

    glm::ivec3 cells_;
    Buffer<glm::vec4> values_;
    Buffer<std::uint8_t> row_holds_; ///< one a row of x
    Buffer<float> plane_largest_;
    bool any_ = false;
    float largest_ = 0.0f;
};

/// Drives act on `velocity`; forces are left in `forces`. Paths of wakes end. Returns how many motors reached the box.
/// Each cell sums its motors in the order of their slots, whatever the threads.
int apply_motors(Motors& motors, const Window& window, float dt, std::span<glm::vec4> velocity, ForceField& forces, const ParallelFor& parallel_for);

} // namespace windrow::cpu
