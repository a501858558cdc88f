// Jacobi sweeps for L phi = rhs on a box with open sides and a solid floor: what game solvers run 20 to 80 times a step, and so
// the yardstick of the direct solve. Written as carefully as the solver: rows in unit stride, two arrays, threads by planes, the
// solver's SIMD levels.
#pragma once

#include "fluid/cpu/aligned.h"
#include "fluid/parallel.h"
#include "fluid/simd.h"
#include "tests/bench/reference/kernels.h"

#include <algorithm>
#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <utility>

namespace windrow::bench {

class Jacobi {
  public:
    explicit Jacobi(glm::ivec3 cells, Simd simd = Simd::best)
        : kernels_(kernels_for(simd)), cells_(cells), pitch_(pitch_of(cells)), now_(k_first + pitch_ * cells.y * cells.z),
          next_(now_.size()) {}

    /// phi after `sweeps` from zero; `rhs` dense and in units of h = 1. x fastest. Row j, k of the result starts at row(j, k).
    void solve(std::span<const float> rhs, int sweeps, const ParallelFor& parallel_for) {
        parallel_for(cells_.z, [&](int k) {
            const std::size_t plane = pitch_ * cells_.y; // from a row's low ghost to the next plane's
            std::fill_n(now_.data() + k_first - 1 + plane * k, plane, 0.0f);
        });
        for (int n = 0; n < sweeps; ++n) {
            const JacobiTask task{.cells = {cells_.x, cells_.y, cells_.z},
                                  .pitch = pitch_,
                                  .source = rhs.data(),
                                  .now = now_.data() + k_first,
                                  .next = next_.data() + k_first};
            parallel_for(cells_.z, [&](int k) { kernels_.jacobi_plane(task, k); });
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
    std::size_t pitch_;
    cpu::Buffer<float> now_, next_;
};

} // namespace windrow::bench
