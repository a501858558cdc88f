// The classic step of StamStep with obstacles as game code has them: whole cells. A cell whose centre is in a body is solid, and its
// velocity is 0. The pressure has no slope across a face to a solid cell, and the component of the velocity across such a face is the
// solid's. Plain loops, made to be right and not fast: times are those of StamStep, which handles no obstacle.
//
// Based on: Crane, Llamas & Tariq 2007, Real-Time Simulation and Rendering of 3D Fluids, GPU Gems 3; Stam 1999 (stam.h).
#pragma once

#include "fluid/parallel.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

namespace windrow::reference {

class VoxelStep {
  public:
    /// Boundaries as StamStep's. `is_solid`: of a cell.
    VoxelStep(glm::ivec3 cells, float cell_size, int sweeps, glm::vec3 ambient, const std::function<bool(glm::ivec3)>& is_solid,
              ParallelFor parallel_for = {});

    void step(float dt);
    /// A velocity [m/s] a cell, x fastest; solid cells keep 0.
    void set_velocity(std::span<const glm::vec4> velocity);
    [[nodiscard]] std::span<const glm::vec4> velocity() const { return velocity_; }

  private:
    [[nodiscard]] std::size_t index(glm::ivec3 cell) const {
        return (static_cast<std::size_t>(cell.z) * cells_.y + cell.y) * cells_.x + cell.x;
    }
    [[nodiscard]] glm::vec3 at(glm::ivec3 cell) const;
    [[nodiscard]] glm::vec3 sample(glm::vec3 cell) const;
    template <class Visit>
    void for_each_air(const Visit& visit) const;
    [[nodiscard]] float pressure_beside(glm::ivec3 cell, int axis, int side) const;

    glm::ivec3 cells_;
    float cell_size_;
    int sweeps_;
    glm::vec3 ambient_;
    ParallelFor parallel_for_;
    std::vector<std::uint8_t> solid_;
    std::vector<glm::vec4> velocity_, advected_;
    std::vector<float> divergence_, pressure_, next_pressure_;
};

} // namespace windrow::reference
