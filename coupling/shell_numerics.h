// The public block of the shells as the shared text's own type.
#pragma once

#include "coupling/plant_numerics.h"
#include "coupling/shell.h"

namespace windrow::detail {

inline numerics::WindrowShells shared(const ShellBlock& block) {
    return {block.form, block.push, block.sag, {block.drag.load}};
}

} // namespace windrow::detail
