// Forces of the air on obstacles, found beside the pressure.
//
// grad phi + s q is the pressure impulse of a sub-step (shaders/numerics/history.glsl). The air that it acts on gives
//
//   J = sum over a body's closed faces of c (phi + s psi) n h^3,   n into the body
//
// to the body, psi the potential of q. All is linear in the potentials, so a body keeps the sums of psi, not psi itself. When the
// flow of volume sources changes, its potential acts as an impulse.
#pragma once

#include "fluid/api.h"
#include "fluid/cpu/solid_flow.h"
#include "fluid/solids/loads.h"

#include <cstdint>
#include <span>
#include <vector>

namespace windrow::cpu {

class BodyLoads {
  public:
    /// Replaces the bodies; those that were there keep their loads. Throws std::bad_alloc.
    void place(std::span<const PlacedObstacle> bodies);
    /// A step of so many seconds begins.
    void begin(float duration);
    /// After a projection. s, and the weights of grad phi and q in q'.
    void add(const SolidFlow& flow, const float* potential, float scale, float weight, float kept);
    /// After the flow of volume sources was found.
    void renew_sources(const SolidFlow& flow, const float* potential);
    void end_sources();
    /// A rehearsal is over, of which the history alone is kept.
    void forget_pressure();
    /// The air is still.
    void clear();

    [[nodiscard]] ObstacleForce force_on(std::uint32_t slot, std::uint32_t generation) const;
    [[nodiscard]] std::span<const BodyLoad> loads() const { return loads_; }
    [[nodiscard]] float duration() const { return duration_; }
    /// From a snapshot. Throws std::bad_alloc.
    void restore(std::vector<BodyLoad>&& loads, float duration);
    [[nodiscard]] std::size_t memory_bytes() const;

  private:
    void index(std::span<const BodyLoad> loads);
    [[nodiscard]] const BodyLoad* find(std::uint32_t slot, std::uint32_t generation) const;

    float duration_ = 0.0f;       ///< [s] of the step
    std::vector<BodyLoad> loads_; ///< in the order of the bodies placed
    std::vector<BodyLoad> others_;
    std::vector<std::uint32_t> by_slot_; ///< place in `loads_` of each slot
    std::vector<PressurePush> pushes_;   ///< of one potential
};

} // namespace windrow::cpu
