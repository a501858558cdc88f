// Sources stage: effect of the motors on the air, gathered per cell from the motors that reach it.
#pragma once

#include "fluid/api.h"
#include "fluid/box.h"
#include "fluid/core/ambient_numerics.h"
#include "fluid/cpu/aligned.h"
#include "fluid/motor_reach.h"
#include "fluid/parallel.h"
#include "fluid/solids/solids.h"

#include <cstdint>
#include <glm/vec4.hpp>
#include <span>

namespace windrow::cpu {

/// Result of the motors for the step: the acceleration f of forces, the target velocities of drives, the divergence S of volume
/// sources. Rows that no motor reaches are unset and never read.
class WINDROW_INTERNAL SourceField {
  public:
    explicit SourceField(glm::ivec3 cells);

    /// A cell sums its motors in the order of `motors`; nothing acts on cells `inside` obstacles. `velocity` is read for
    /// largest_driven(), `tile` by motors with eddies.
    void gather(std::span<const detail::MotorReach> motors, const Box& box, std::span<const glm::vec4> velocity,
                const numerics::TileView& tile, const ParallelFor& parallel_for, std::span<const Solids::InsideCell> inside = {});

    /// velocity += factor * f, on the rows that hold a force.
    void add_force_to(std::span<glm::vec4> velocity, float factor, const ParallelFor& parallel_for) const;
    [[nodiscard]] bool any_force() const { return any_force_; }
    /// f of a row of x; null where it holds none.
    [[nodiscard]] const glm::vec4* force_row(std::size_t row) const {
        return any_force_ && row_holds_force_[row] != 0 ? force_.data() + row * cells_.x : nullptr;
    }
    /// The cells of a row that are driven, low <= i < high.
    struct Range {
        std::uint16_t low = 0, high = 0;
    };
    [[nodiscard]] bool any_drive() const { return any_drive_; }
    [[nodiscard]] Range driven(std::size_t row) const { return any_drive_ ? row_driven_[row] : Range{}; }
    /// Of a row, sum of E U, and of E in w; valid where it is driven.
    [[nodiscard]] const glm::vec4* drive_row(std::size_t row) const { return drives_.data() + row * cells_.x; }
    /// Scratch of Acting: the original history of the cells where something acts.
    [[nodiscard]] std::span<glm::vec4> kept() { return kept_; }
    /// The drives act whole on `velocity`.
    void drive(std::span<glm::vec4> velocity, const ParallelFor& parallel_for) const;
    /// Limits the target velocities of drives to `most` [m/s], in each component.
    void limit_drives(float most);
    /// [m/s^2] Largest component of f.
    [[nodiscard]] float largest_force() const { return largest_force_; }
    /// [m/s] Largest component in a cell after the drives act whole.
    [[nodiscard]] float largest_driven() const { return largest_driven_; }
    /// [1/s] S at every cell; empty without volume sources.
    [[nodiscard]] std::span<const float> expansion() const;
    [[nodiscard]] std::span<float> expansion();
    [[nodiscard]] std::size_t memory_bytes() const;

  private:
    void gather_plane(std::span<const detail::MotorReach> motors, const Box& box, std::span<const glm::vec4> velocity,
                      const numerics::TileView& tile, std::span<const Solids::InsideCell> inside, int plane);

    void leave_out(std::size_t row, std::size_t cell);

    glm::ivec3 cells_;
    Buffer<glm::vec4> force_;
    Buffer<std::uint8_t> row_holds_force_; ///< one a row of x
    Buffer<glm::vec4> drives_, kept_;
    Buffer<Range> row_driven_;
    Buffer<float> plane_largest_;        ///< of f
    Buffer<float> plane_largest_driven_; ///< after the drives act
    Buffer<float> expansion_;
    bool any_force_ = false;
    bool any_drive_ = false;
    bool any_expansion_ = false;
    float largest_force_ = 0.0f;
    float largest_driven_ = 0.0f;
};

/// What is beyond open boundaries, in the ghost cell next to `cell` at the low (0) or high (1) end of an axis.
class Beyond {
  public:
    /// phi / h [m/s].
    [[nodiscard]] virtual float potential(glm::ivec3 cell, int axis, int end) const = 0;
    /// [m/s] By which the wind along the axis is more there than in `cell`.
    [[nodiscard]] virtual float rise(glm::ivec3, int, int) const { return 0.0f; }

  protected:
    Beyond() = default;
    Beyond(const Beyond&) = default;
    Beyond& operator=(const Beyond&) = default;
    ~Beyond() = default;
};

/// Free-space potential of the volume sources, phi / h [m/s], in the ghost cells of open boundaries: the potential of each ball
/// and of its mirror images in walls.
class FreeAir final : public Beyond {
  public:
    /// Allocates for a box, unless there is room.
    void make_room(const Box& box);
    /// The box must have room. `open_parts`: of each volume source, the fraction that obstacles leave of it; empty: all.
    void gather(std::span<const detail::MotorReach> motors, const Box& box, std::span<const float> open_parts,
                const ParallelFor& parallel_for);
    [[nodiscard]] float potential(glm::ivec3 cell, int axis, int end) const override {
        return ghosts_[axis][end][place(cell, axis)];
    }
    [[nodiscard]] std::size_t memory_bytes() const;

  private:
    /// Index in a boundary's array, stored in the box's order without the axis.
    [[nodiscard]] std::size_t place(glm::ivec3 cell, int axis) const {
        const int along = axis == 0 ? 1 : 0, across = axis == 2 ? 1 : 2;
        return static_cast<std::size_t>(cell[across]) * cells_[along] + cell[along];
    }

    glm::ivec3 cells_{0};
    Buffer<float> ghosts_[3][2];
};

} // namespace windrow::cpu
