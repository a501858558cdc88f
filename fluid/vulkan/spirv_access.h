// What a compiled shader does with its bindings, as its own decorations tell.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace windrow::vulkan {

/// Of one binding of set 0. Both where the shader's text says neither readonly nor writeonly.
struct Access {
    bool reads = true, writes = true;
};

/// For bindings 0 to `bindings` - 1; one that the shader does not declare is neither read nor written.
[[nodiscard]] std::vector<Access> access_of(std::span<const std::uint32_t> spirv, std::size_t bindings);

} // namespace windrow::vulkan
