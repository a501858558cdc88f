// shaders/fluid/blocks.glsl as C++: what the host tells the passes of a tick.
#pragma once

#include "fluid/ambient_numerics.h"
#include "fluid/motor_reach.h"

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace windrow::vulkan {

using glm::ivec4, glm::uvec4, glm::vec4;
using numerics::WindrowAmbient;
using uint = std::uint32_t;
#include "shaders/fluid/blocks.glsl"

static_assert(sizeof(WindrowAmbient) == 7 * 16 && sizeof(WindrowStep) == 23 * 16);
static_assert(sizeof(WindrowControl) == 20 * 16 && sizeof(WindrowRule) == 4 * 16);
static_assert(sizeof(WindrowMotor) == sizeof(detail::MotorReach));

} // namespace windrow::vulkan
