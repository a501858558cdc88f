// Passes of a step over the faces and cells at obstacles (solids.h): each visits lists, none the whole grid.
#pragma once

#include "fluid/cpu/solids.h"

#include <glm/vec4.hpp>
#include <span>

namespace windrow::cpu {

/// The prescribed part of the wind in the box: gusts and the flow of volume sources. The projection sees the rest of the wind,
/// and a wall stops the whole.
struct PrescribedFlow {
    const float* ambient = nullptr; ///< four floats a padded cell; null: none
    std::span<const glm::vec4> source_flow{};
    [[nodiscard]] bool any() const { return ambient != nullptr || !source_flow.empty(); }
};

class SolidFlow {
  public:
    SolidFlow(const Solids& solids, const Box& box, const ParallelFor& parallel_for)
        : solids_(solids), box_(box), parallel_for_(parallel_for) {}

    /// Writes the air's values into the ghost cells, mirrored about the bodies' own velocity less the prescribed part, so that a
    /// read beside a body finds air. The history of the pressure is mirrored about 0.
    void extend(std::span<glm::vec4> velocity, const PrescribedFlow& given) const;
    void extend_history(std::span<glm::vec4> history) const;
    /// Divergence of surface and inside cells, as their closed faces have it; `potential` holds that of the empty box.
    void close_divergence(std::span<const glm::vec4> velocity, const PrescribedFlow& given, bool bodies_move,
                          float* potential) const;
    /// slope[n] = closed times the potential's difference over face n: cells take + at the low end and - at the high one, B phi.
    void closed_slopes(const float* potential, std::span<float> slope) const;
    /// Takes the closed faces' slopes off the gradient: velocity += fix, note -= weight * fix. `note` may be empty.
    void open_gradient(std::span<const float> slope, std::span<glm::vec4> velocity, std::span<glm::vec4> note,
                       float weight) const;
    /// Sets cells inside to the bodies' own velocity, less the prescribed part.
    void hold_bodies(const PrescribedFlow& given, bool bodies_move, std::span<glm::vec4> velocity) const;
    /// Corrects one explicit pass of diffusion: closed faces have no flux, or that of a wall to which the air sticks.
    void close_diffusion(std::span<const glm::vec4> field, float ratio, std::span<glm::vec4> result) const;

    /// Squares of the divergence [1/s] that surface cells have beyond those of the empty box: a correction of a sum over all cells.
    /// `flux` is scratch, one a surface cell.
    [[nodiscard]] double correct_divergence(std::span<const glm::vec4> velocity, std::span<const float> expansion,
                                            std::span<float> flux) const;
    /// [m/s] Sum over a body's faces of closed phi n, n into the body: momentum over density and h^3.
    [[nodiscard]] glm::vec3 push_on(std::size_t body, const float* potential) const;

  private:
    [[nodiscard]] glm::vec3 given_at(const PrescribedFlow& given, std::uint32_t cell) const;
    [[nodiscard]] float central_divergence(std::span<const glm::vec4> velocity, const Solids::SurfaceCell& cell) const;
    template <class Wall>
    void extend_by(std::span<glm::vec4> field, const Wall& wall) const;

    const Solids& solids_;
    const Box& box_;
    const ParallelFor& parallel_for_;
};

} // namespace windrow::cpu
