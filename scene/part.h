// One of the parts that a work is shared out in, among processes or machines: `--part 2/8`.
#pragma once

#include "scene/number_text.h"

#include <algorithm>
#include <cstdint>
#include <string_view>

namespace windrow::scene {

struct Part {
    std::int64_t number = 1, count = 1; ///< the number is from 1 to the count

    [[nodiscard]] bool is_whole() const { return count == 1; }
    /// Of `total` items in a row: place of the first, and the place behind the last. Parts differ by one item at most.
    [[nodiscard]] std::int64_t first(std::int64_t total) const { return total * (number - 1) / count; }
    [[nodiscard]] std::int64_t end(std::int64_t total) const { return total * number / count; }
    /// Of items that differ in cost, which are dealt out in turn: whether the part has that at a place.
    [[nodiscard]] bool holds(std::int64_t place) const { return place % count == number - 1; }
};

/// "2/8"; the error is the sentence behind the flag's name.
[[nodiscard]] inline Result<Part> parse_part(std::string_view text) {
    constexpr std::int64_t k_most = 10'000;
    const std::size_t slash = std::min(text.find('/'), text.size());
    const auto number = parse_whole_number(text.substr(0, slash));
    const auto count = parse_whole_number(text.substr(std::min(slash + 1, text.size())));
    if (!number || !count || *number < 1 || *count < *number || *count > k_most)
        return Error{detail::message("--part is \"", text, "\": give K/N, part K of N, such as 1/8; N is ", k_most, " at most.")};
    return Part{.number = *number, .count = *count};
}

} // namespace windrow::scene
