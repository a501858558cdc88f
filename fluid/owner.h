// Numbers of the lists that give handles, so that a handle of another wind is rejected.
#pragma once

#include <atomic>
#include <cstdint>

namespace windrow::detail {

/// Unique in the process; never 0.
[[nodiscard]] inline std::uint32_t next_owner() {
    static std::atomic<std::uint32_t> last{0};
    return 1 + last.fetch_add(1, std::memory_order_relaxed) % (~std::uint32_t{0} - 1);
}

} // namespace windrow::detail
