// What a program allocates of a device's memory, counted at the call itself: vkAllocateMemory and vkGetInstanceProcAddr of this
// program stand before the loader's. So an accounting can be held to what was allocated, whoever did.
#pragma once

#include <cstdint>

namespace windrow::vegetation::bench {

/// [bytes] Allocated and not freed, of all devices.
[[nodiscard]] std::uint64_t allocated_bytes();

} // namespace windrow::vegetation::bench
