// Parameter blocks of the passes of a tick: shaders/fluid/blocks.glsl as C++.
#pragma once

#include "fluid/ambient_numerics.h"
#include "fluid/motor_reach.h"

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace windrow::vulkan {

using glm::ivec3, glm::ivec4, glm::vec3, glm::vec4;
using numerics::WindrowAmbient;
using uint = std::uint32_t;
#include "shaders/fluid/blocks.glsl"

// As GLSL lays them out: vectors at multiples of 16 bytes.
static_assert(sizeof(WindrowAmbient) == 7 * 16 && sizeof(WindrowStep) == 23 * 16);
static_assert(offsetof(WindrowStep, ambient) == 4 * 16 && offsetof(WindrowStep, gust_speed) == 5 * 16);
static_assert(offsetof(WindrowStep, low) == 6 * 16 && offsetof(WindrowStep, wind) == 16 * 16);
static_assert(sizeof(WindrowControl) == 20 * 16 && sizeof(WindrowRule) == 4 * 16 && offsetof(WindrowRule, scale) == 16);
static_assert(offsetof(WindrowControl, substep_duration) == 16 && offsetof(WindrowControl, substeps) == 2 * 16);
static_assert(offsetof(WindrowControl, diffused_time) == 3 * 16 && offsetof(WindrowControl, largest_speed) == 19 * 16);
static_assert(sizeof(WindrowReport) == 2 * 16 && sizeof(WindrowPoint) == 4 * 16 && sizeof(WindrowReadPush) == 32);
static_assert(offsetof(WindrowPoint, high) == 16 && offsetof(WindrowPoint, ambient) == 3 * 16);
static_assert(sizeof(WindrowPlacePush) == 16 && sizeof(WindrowAdjustPush) == 32);
static_assert(sizeof(WindrowMotor) == sizeof(detail::MotorReach));

} // namespace windrow::vulkan
