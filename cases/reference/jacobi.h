// Jacobi sweeps for L phi = rhs on a box with any sides: what game solvers run 20 to 80 times a step, and so the yardstick of the
// direct solve. Written as carefully as the solver: rows in unit stride, two arrays, threads by planes, the
// solver's SIMD levels.
#pragma once

#include "cases/reference/kernels.h"
#include "fluid/box.h"
#include "fluid/cpu/aligned.h"
#include "fluid/parallel.h"
#include "fluid/simd.h"

#include <algorithm>
#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <utility>

namespace windrow::reference {

class Jacobi {
  public:
    /// Open sides over a solid floor.
    explicit Jacobi(glm::ivec3 cells, Simd simd = Simd::best)
        : Jacobi(Box{.cells = cells, .boundaries = Boundaries::open_over_floor()}, simd) {}
    explicit Jacobi(const Box& box, Simd simd = Simd::best)
        : kernels_(kernels_for(simd)), cells_(box.cells), pitch_(pitch_of(box.cells)),
          now_(k_first + pitch_ * box.cells.y * box.cells.z), next_(now_.size()) {
        int axes = 3;
        for (int axis = 0; axis < 3; ++axis) {
            sweep_.cells[axis] = box.cells[axis];
            sweep_.periodic[axis] = box.boundaries.periodic(axis);
            for (int end = 0; end < 2; ++end)
                sweep_.ghost[axis][end] = box.boundaries.at(axis, end).kind == BoundaryKind::open ? 0.0f : 1.0f;
            if (box.cells[axis] > 1 || box.boundaries.has_open(axis))
                continue;
            // One cell between walls, or its own neighbour: nothing differs along this axis, and a box of two axes is swept as
            // one.
            --axes;
            sweep_.periodic[axis] = false;
            sweep_.ghost[axis][0] = sweep_.ghost[axis][1] = 0.0f;
        }
        open_over_floor_ = box.boundaries == Boundaries::open_over_floor();
        sweep_.weight = axes > 0 ? 1.0f / static_cast<float>(2 * axes) : 0.0f;
    }

    /// phi after `sweeps` from zero; `rhs` dense and in units of h = 1. x fastest. Row j, k of the result starts at row(j, k).
    void solve(std::span<const float> rhs, int sweeps, const ParallelFor& parallel_for) {
        parallel_for(cells_.z, [&](int k) {
            const std::size_t plane = pitch_ * cells_.y; // from a row's low ghost to the next plane's
            std::fill_n(now_.data() + k_first - 1 + plane * k, plane, 0.0f);
        });
        const auto plane = open_over_floor_ ? kernels_.jacobi_plane : kernels_.jacobi_plane_any_sides;
        for (int n = 0; n < sweeps; ++n) {
            JacobiTask task = sweep_;
            task.pitch = pitch_;
            task.source = rhs.data();
            task.now = now_.data() + k_first;
            task.next = next_.data() + k_first;
            parallel_for(cells_.z, [&](int k) { plane(task, k); });
            std::swap(now_, next_);
        }
    }
    [[nodiscard]] const float* row(int j, int k) const {
        return now_.data() + k_first + (static_cast<std::size_t>(k) * cells_.y + j) * pitch_;
    }
    /// [floats] From one row to the next.
    [[nodiscard]] std::size_t pitch() const { return pitch_; }
    [[nodiscard]] std::size_t memory_bytes() const { return now_.bytes() + next_.bytes(); }

  private:
    // Rows with a ghost at each end. While the arrays fit in a cache near the core, each row starts on a cache line, so that of a
    // cell's reads only those of its x-neighbours straddle two; beyond, the padding would cost more bandwidth than that saves.
    static constexpr std::size_t k_line = 16;      ///< [floats]
    static constexpr std::size_t k_first = k_line; ///< cell (0, 0, 0)
    static std::size_t pitch_of(glm::ivec3 cells) {
        const std::size_t tight = static_cast<std::size_t>(cells.x) + 2;
        const std::size_t padded = (tight + k_line - 1) / k_line * k_line;
        return padded * static_cast<std::size_t>(cells.y) * static_cast<std::size_t>(cells.z) <= (1u << 18) ? padded : tight;
    }

    const Kernels& kernels_;
    glm::ivec3 cells_;
    JacobiTask sweep_{}; ///< but for its fields
    bool open_over_floor_ = false;
    std::size_t pitch_;
    cpu::Buffer<float> now_, next_;
};

} // namespace windrow::reference
