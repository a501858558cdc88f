// The public blocks of the blades as the shared text's own types.
#pragma once

#include "coupling/blade.h"
#include "coupling/plant_numerics.h"

namespace windrow::detail {

inline numerics::WindrowBlade shared(const BladeBlock& block) {
    return {block.size, block.form, block.own, {block.drag.load}};
}

constexpr glm::vec3 k_up{0.0f, 1.0f, 0.0f};

} // namespace windrow::detail
