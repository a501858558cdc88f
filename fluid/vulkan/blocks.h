// Parameter blocks of the passes of a tick: shaders/fluid/blocks.glsl as C++.
#pragma once

#include "fluid/core/ambient_numerics.h"
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
static_assert(sizeof(WindrowAmbient) == 7 * 16 && sizeof(WindrowStep) == 25 * 16);
static_assert(offsetof(WindrowStep, ambient) == 5 * 16 && offsetof(WindrowStep, gust_speed) == 6 * 16);
static_assert(offsetof(WindrowStep, low) == 8 * 16 && offsetof(WindrowStep, wind) == 18 * 16);
static_assert(sizeof(WindrowPlan) == 4 * 16 && offsetof(WindrowPlan, first_slot) == 16);
static_assert(sizeof(WindrowControl) == 26 * 16 && offsetof(WindrowControl, plan) == 2 * 16);
static_assert(offsetof(WindrowControl, last_duration) == 6 * 16 && offsetof(WindrowControl, diffused_time) == 8 * 16);
static_assert(sizeof(WindrowRule) == 4 * 16 && offsetof(WindrowRule, scale) == 16);
static_assert(sizeof(WindrowReport) == 4 * 16 && sizeof(WindrowPoint) == 4 * 16 && sizeof(WindrowReadPush) == 32);
static_assert(offsetof(WindrowPoint, high) == 16 && offsetof(WindrowPoint, ambient) == 3 * 16);
static_assert(sizeof(WindrowRow) == 16 && sizeof(WindrowLiftPush) == 16);
static_assert(sizeof(WindrowStagePush) == 32 && sizeof(WindrowAround) == (9 + 2 * WINDROW_RESIDUAL_GROUPS) * 4);
static_assert(sizeof(WindrowPlacePush) == 20 && sizeof(WindrowUncoverPush) == 20 && sizeof(WindrowAdjustPush) == 32);
static_assert(sizeof(WindrowMotor) == sizeof(detail::MotorReach));

} // namespace windrow::vulkan
