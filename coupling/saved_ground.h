// A ground memory between its bytes and a backend: those of a device load on the CPU and the other way.
#pragma once

#include "coupling/ground_host.h"
#include "coupling/motion_numerics.h"

#include <cstddef>
#include <span>
#include <vector>

namespace windrow::detail {

struct WINDROW_INTERNAL SavedGround {
    /// At rest, before any step.
    explicit SavedGround(const GroundConfig& config)
        : host(config), texels(host.texel_count()), leans_before(host.texel_count()), shown_before(host.texel_count()) {}

    GroundHost host;
    bool stepped = false;
    std::vector<numerics::WindrowGround> texels;
    std::vector<glm::vec2> leans_before; ///< [rad] of the wind, a step ago
    std::vector<glm::vec4> shown_before; ///< what was sampled a step ago; what is sampled now follows from the texels
};

[[nodiscard]] WINDROW_INTERNAL Result<std::vector<std::byte>> to_bytes(const SavedGround& ground);
/// Rejects bytes that `to_bytes` did not return.
[[nodiscard]] WINDROW_INTERNAL Result<SavedGround> ground_of(std::span<const std::byte> bytes);

} // namespace windrow::detail
