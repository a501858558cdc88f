#include "fluid/vulkan/free_ranges.h"

#include <cassert>
#include <iterator>

namespace windrow::vulkan {

FreeRanges::FreeRanges(std::uint64_t size) : free_{{0, size}} {}

std::optional<std::uint64_t> FreeRanges::take(std::uint64_t size, std::uint64_t alignment) {
    assert(size > 0 && alignment > 0 && (alignment & (alignment - 1)) == 0);
    for (auto range = free_.begin(); range != free_.end(); ++range) {
        const auto [begin, length] = *range;
        const std::uint64_t padding = (alignment - begin % alignment) % alignment;
        if (length < padding || length - padding < size)
            continue;
        const std::uint64_t offset = begin + padding;
        free_.erase(range);
        if (padding > 0)
            free_[begin] = padding;
        if (length - padding > size)
            free_[offset + size] = length - padding - size;
        taken_[offset] = size;
        return offset;
    }
    return std::nullopt;
}

std::uint64_t FreeRanges::give_back(std::uint64_t offset) {
    const auto piece = taken_.find(offset);
    assert(piece != taken_.end());
    const std::uint64_t size = piece->second;
    taken_.erase(piece);

    auto range = free_.emplace(offset, size).first;
    if (const auto next = std::next(range); next != free_.end() && offset + size == next->first) {
        range->second += next->second;
        free_.erase(next);
    }
    if (range != free_.begin())
        if (const auto before = std::prev(range); before->first + before->second == offset) {
            before->second += range->second;
            free_.erase(range);
        }
    return size;
}

} // namespace windrow::vulkan
