// Passes of a step over the faces and cells at obstacles (solids.h): each visits lists, none the whole grid.
#pragma once

#include "fluid/solids/loads.h"
#include "fluid/solids/solids.h"

#include <array>
#include <glm/vec4.hpp>
#include <span>

namespace windrow::cpu {

/// The prescribed part of the wind that passes through bodies: gusts. The projection sees the rest of the wind, and a wall stops
/// both. The flow of volume sources goes around bodies by itself.
struct PrescribedFlow {
    const float* ambient = nullptr; ///< four floats a padded cell; null: none
    [[nodiscard]] bool any() const { return ambient != nullptr; }
};

class SolidFlow {
  public:
    SolidFlow(const Solids& solids, const Box& box) : solids_(solids), box_(box) {}

    /// Writes the air's values into the ghost cells, slipping along the bodies' surfaces, so that a
    /// read beside a body finds air. That of the history has no part normal to them.
    void extend(std::span<glm::vec4> velocity, const PrescribedFlow& prescribed) const;
    void extend_history(std::span<glm::vec4> history) const;
    /// All that a step reads, where no wind is prescribed.
    void extend_all(std::span<glm::vec4> velocity, std::span<glm::vec4> before, std::span<glm::vec4> history) const;
    /// The same, or of the velocity alone where the others are empty, in fields that have moved with their box by `shift` cells since
    /// the lists were made.
    void extend_moved(std::span<glm::vec4> velocity, std::span<glm::vec4> before, std::span<glm::vec4> history,
                      glm::ivec3 shift) const;
    /// Divergence of surface and inside cells, as their closed faces have it; `potential` holds that of the empty box. `guessed`,
    /// in surface cells: B phi of `factor` times the slopes of a guess.
    void close_divergence(std::span<const glm::vec4> velocity, const PrescribedFlow& prescribed, bool bodies_move,
                          std::span<const float> guess, float factor, float* potential, std::span<float> guessed) const;
    /// The pressure in sealed air is relative to none: takes the mean of a potential off in each of its parts.
    void level(float* potential) const;
    /// Takes from what a potential leaves, in surface cells, what none can take: the constant in each sealed part, which is rounding.
    void balance(std::span<float> residual) const;
    /// slope[n] = closed times the potential's difference over face n.
    void closed_slopes(const float* potential, std::span<float> slope) const;
    /// terms += factor times B phi of such slopes, in surface cells.
    void add_masked(std::span<const float> slope, float factor, std::span<float> terms) const;
    /// The slopes, and B phi of them less that of `factor` times the slopes that a solve guessed, in surface cells.
    void find_residual(const float* potential, std::span<const float> guess, float factor, std::span<float> slope,
                       std::span<float> residual) const;
    /// Takes the closed faces' slopes off the gradient: velocity += fix, note -= weight * fix. `note` may be empty.
    void open_gradient(std::span<const float> slope, std::span<glm::vec4> velocity, std::span<glm::vec4> note,
                       float weight) const;
    /// Sets cells inside to the bodies' own velocity, less the prescribed part.
    void hold_bodies(const PrescribedFlow& prescribed, bool bodies_move, std::span<glm::vec4> velocity) const;
    /// Corrects one explicit pass of diffusion: closed faces have no flux, or that of a wall to which the air sticks.
    void close_diffusion(std::span<const glm::vec4> field, const PrescribedFlow& prescribed, float ratio,
                         std::span<glm::vec4> result) const;

    /// Before an implicit pass of diffusion, which is that of the empty box: air beside closed faces takes the drag of the walls,
    /// implicit in each cell, and ghost cells take the air's values, so that they exchange nothing with it.
    void drag_along_walls(const PrescribedFlow& prescribed, float ratio, std::span<glm::vec4> field) const;

    /// Writes the divergence [1/s] of surface cells and of cells inside, which is 0. `flux`: scratch, one a surface cell.
    void find_divergence(std::span<const glm::vec4> velocity, std::span<float> flux, std::span<float> divergence) const;
    /// Squares of the divergence [1/s] that surface cells have beyond those of the empty box: a correction of a sum over all cells.
    /// `flux` is scratch, one a surface cell.
    [[nodiscard]] double correct_divergence(std::span<const glm::vec4> velocity, std::span<const float> expansion,
                                            std::span<float> flux) const;
    /// What the potential does to a body, and to each; a face that several close counts for the one that closes most.
    [[nodiscard]] PressurePush push_on(std::size_t body, const float* potential) const;
    void find_pushes(const float* potential, std::span<PressurePush> pushes) const;

  private:
    /// [m/s] Of the body that closes a face, at the face.
    [[nodiscard]] glm::vec3 wall_at(const ClosedFace& face) const;
    /// The prescribed part at a cell: the wind, which does not blow in a closed room.
    [[nodiscard]] glm::vec3 prescribed_at(const PrescribedFlow& prescribed, std::uint32_t cell) const;
    [[nodiscard]] glm::vec3 ambient_at(const PrescribedFlow& prescribed, std::uint32_t cell) const;
    [[nodiscard]] float blown_past(const PrescribedFlow& prescribed, const ClosedFace& face, int end) const;
    /// Sealed air takes its change of volume evenly.
    void spread_changes(float* divergence) const;
    [[nodiscard]] float central_divergence(std::span<const glm::vec4> velocity, const Solids::SurfaceCell& cell) const;
    /// What closed faces take from the sums of central_divergence, one a surface cell.
    void find_flux(std::span<const glm::vec4> velocity, std::span<float> flux) const;
    template <std::size_t Count, class Across, class Map>
    void extend_by(const std::array<std::span<glm::vec4>, Count>& fields, const Across& across, const Map& map) const;

    const Solids& solids_;
    const Box& box_;
};

} // namespace windrow::cpu
