// The front of those that nothing beats: of a set of points, those than which no other is at once no dearer and no worse, and
// better in one of the two.
//
// Based on: Kung, Luccio & Preparata 1975, Journal of the ACM 22 (the maxima of a set of vectors: sort by one figure, sweep the
// other).
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace windrow::cli {

struct CostError {
    double cost = 0.0;
    double error = 0.0;
};

/// True where `a` is no dearer and no worse than `b`, and better in one.
[[nodiscard]] bool beats(const CostError& a, const CostError& b);

/// The points on the front, by rising cost; equal points are all on it or none. What is not finite is on no front.
[[nodiscard]] std::vector<std::size_t> front_of(std::span<const CostError> points);

/// Of those that beat a point the one with the least error, the cheapest of these; nothing where the point is on the front.
[[nodiscard]] std::optional<std::size_t> beaten_by(std::span<const CostError> points, std::size_t point);

} // namespace windrow::cli
