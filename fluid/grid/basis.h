// Eigenvectors of the second difference on one axis, in closed form for any pair of ends.
//
//   (D v)[i] = v[i-1] - 2 v[i] + v[i+1],   D v = lambda v,   lambda = -4 sin^2(theta / 2)
//
// The boundary rule at an end sets the phase: a value that is odd about the ghost's centre or the face gives a sine that vanishes
// there, one that is even about the face a cosine. With both points `length` cells apart, theta is pi/length times
// k + 1 (odd, odd), k (even, even), k + 1/2 (one of each); a periodic axis has the real Fourier basis.
// Like ends give vectors that are even or odd about the middle: an even-odd split makes two transforms of half the size.
// Based on: Strang 1999, "The discrete cosine transform", SIAM Review 41.
#pragma once

#include "fluid/api.h"

#include <vector>

namespace windrow {

/// Kind of one end of an axis.
enum class EndRule {
    zero_at_ghost, ///< value 0 at the ghost's centre, at an open boundary: pressure, velocity relative to ambient
    zero_at_face,  ///< odd about the face: velocity at a wall
    even_at_face,  ///< mirrored about the face: pressure at a wall, tangential velocity at a free-slip wall
    periodic,
};

/// Contribution of the end to the diagonal -2 of the second difference.
[[nodiscard]] constexpr double diagonal_correction(EndRule rule) {
    return rule == EndRule::zero_at_face ? -1.0 : rule == EndRule::even_at_face ? 1.0 : 0.0;
}

/// Orthonormal eigenvectors, split into even and odd where the ends are alike. In a split basis the `even` modes come first and
/// act on value[i] + value[n-1-i], i < even_size (the middle cell of an odd n by itself), then the odd ones on the differences.
struct WINDROW_INTERNAL AxisBasis {
    AxisBasis(int count, EndRule low, EndRule high);

    int count;
    bool folded;
    int even_size; ///< modes of the first part: all of them without an even-odd split
    int odd_size;
    /// [mode][cell of the half axis] row-major; even_size x even_size and odd_size x odd_size.
    std::vector<double> even, odd;
    /// Eigenvalue of each mode, first part then second.
    std::vector<double> eigenvalues;
    int zero_mode; ///< index of the mode with eigenvalue 0, or -1
};

} // namespace windrow
