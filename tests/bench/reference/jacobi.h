// Jacobi sweeps for L phi = rhs on a box with open sides and a solid floor: what game solvers run 20 to 80 times a step, and so
// the yardstick of the direct solve. Written as carefully as the solver: rows in unit stride, two arrays, threads by planes,
// sides by an affine image of the row inside, so that the loop has no branch.
#pragma once

#include "fluid/parallel.h"

#include <algorithm>
#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

namespace windrow::bench {

class Jacobi {
  public:
    explicit Jacobi(glm::ivec3 cells)
        : cells_(cells), pitch_(static_cast<std::size_t>(cells.x) + 2), now_(pitch_ * cells.y * cells.z), next_(now_.size()) {}

    /// phi after `sweeps` from zero; `rhs` dense and in units of h = 1. x fastest. Row j, k of the result starts at row(j, k).
    void solve(const std::vector<float>& rhs, int sweeps, const ParallelFor& parallel_for) {
        parallel_for(cells_.z, [&](int k) {
            std::fill(&now_[pitch_ * cells_.y * k], &now_[pitch_ * cells_.y * k] + pitch_ * cells_.y, 0.0f);
        });
        for (int n = 0; n < sweeps; ++n) {
            parallel_for(cells_.z, [&](int k) { sweep_plane(rhs.data(), k); });
            now_.swap(next_);
        }
    }
    [[nodiscard]] const float* row(int j, int k) const {
        return &now_[(static_cast<std::size_t>(k) * cells_.y + j) * pitch_ + 1];
    }

  private:
    struct Neighbour {
        const float* values;
        float scale;
    };

    void sweep_plane(const float* rhs, int k) {
        const auto at = [&](int j, int plane) { return &now_[(static_cast<std::size_t>(plane) * cells_.y + j) * pitch_ + 1]; };
        for (int j = 0; j < cells_.y; ++j) {
            const float* const here = at(j, k);
            // p = 0 at an open face: the ghost is minus the cell inside; a floor mirrors it.
            const Neighbour below = j > 0 ? Neighbour{at(j - 1, k), 1.0f} : Neighbour{here, 1.0f};
            const Neighbour above = j + 1 < cells_.y ? Neighbour{at(j + 1, k), 1.0f} : Neighbour{here, -1.0f};
            const Neighbour back = k > 0 ? Neighbour{at(j, k - 1), 1.0f} : Neighbour{here, -1.0f};
            const Neighbour front = k + 1 < cells_.z ? Neighbour{at(j, k + 1), 1.0f} : Neighbour{here, -1.0f};
            const float* const source = rhs + (static_cast<std::size_t>(k) * cells_.y + j) * cells_.x;
            float* const result = &next_[(static_cast<std::size_t>(k) * cells_.y + j) * pitch_ + 1];
            const int count = cells_.x;
#pragma GCC ivdep
            for (int i = 0; i < count; ++i)
                result[i] = (1.0f / 6.0f) * ((here[i - 1] + here[i + 1]) + (below.values[i] + above.scale * above.values[i]) +
                                             (back.scale * back.values[i] + front.scale * front.values[i]) - source[i]);
            result[-1] = -result[0];
            result[count] = -result[count - 1];
        }
    }

    glm::ivec3 cells_;
    std::size_t pitch_;
    std::vector<float> now_, next_;
};

} // namespace windrow::bench
