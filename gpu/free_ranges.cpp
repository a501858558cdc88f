#include "gpu/free_ranges.h"

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
        std::map<std::uint64_t, std::uint64_t> rest; // made before anything changes
        if (padding > 0)
            rest[begin] = padding;
        if (length - padding > size)
            rest[offset + size] = length - padding - size;
        auto piece = free_.extract(range);
        piece.key() = offset;
        piece.mapped() = size;
        taken_.insert(std::move(piece));
        free_.merge(rest);
        return offset;
    }
    return std::nullopt;
}

std::uint64_t FreeRanges::give_back(std::uint64_t offset) {
    auto piece = taken_.extract(offset); // and back without allocating, as a destructor must
    assert(!piece.empty());
    const std::uint64_t size = piece.mapped();
    auto range = free_.insert(std::move(piece)).position;
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
