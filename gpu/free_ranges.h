// Free byte ranges of a block: first fit; freed neighbours merge.
#pragma once

#include <cstdint>
#include <map>
#include <optional>

namespace windrow::vulkan {

class FreeRanges {
  public:
    /// All of [0, size) is free.
    explicit FreeRanges(std::uint64_t size);

    /// Offset of `size` > 0 bytes that were free, a multiple of `alignment` (a power of two); nothing where they do not fit.
    [[nodiscard]] std::optional<std::uint64_t> take(std::uint64_t size, std::uint64_t alignment);
    /// Gives back what `take` gave; the number of bytes. Allocates nothing.
    std::uint64_t give_back(std::uint64_t offset);
    [[nodiscard]] bool all_free() const { return taken_.empty(); }

  private:
    std::map<std::uint64_t, std::uint64_t> free_; // offset to size; no two touch
    std::map<std::uint64_t, std::uint64_t> taken_;
};

} // namespace windrow::vulkan
