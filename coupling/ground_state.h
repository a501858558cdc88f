// The state of a ground memory's texels, for tests.
#pragma once

#include "coupling/ground_memory.h"
#include "coupling/motion_numerics.h"

namespace windrow::detail {

struct GroundState {
    /// In slots, x fastest.
    [[nodiscard]] static std::span<const numerics::WindrowGround> of(const GroundMemory& ground);
};

} // namespace windrow::detail
