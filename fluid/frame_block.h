// All that a renderer's shaders get of a frame's wind, beside its textures.
#pragma once

#include "fluid/ambient.h"
#include "fluid/textures.h"

namespace windrow {

/// A uniform block of std140 layout (23 vec4): WindrowFrame of shaders/coupling/windrow_wind.glsl. Positions are relative to the
/// anchor that it was made for.
struct FrameBlock {
    WindowBlock window{};
    AmbientBlock ambient{};
    AmbientBlock previous_ambient{}; ///< of the frame before, for motion vectors
};
static_assert(sizeof(FrameBlock) == 368);

} // namespace windrow
