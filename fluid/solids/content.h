// Identity of shared things by what they hold, not by where they are in memory.
#pragma once

#include "fluid/core/bytes.h"

#include <algorithm>
#include <compare>
#include <span>
#include <vector>

namespace windrow::detail {

/// Of numbers without padding; equal for equal bits.
template <class Item>
[[nodiscard]] std::uint64_t content_hash(const std::vector<Item>& items) {
    return checksum(std::as_bytes(std::span(items)));
}

/// An order of lists; 0 for equal bits.
template <class Item>
[[nodiscard]] std::strong_ordering compare_content(const std::vector<Item>& a, const std::vector<Item>& b) {
    const auto left = std::as_bytes(std::span(a)), right = std::as_bytes(std::span(b));
    return std::lexicographical_compare_three_way(left.begin(), left.end(), right.begin(), right.end());
}

} // namespace windrow::detail
