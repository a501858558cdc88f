// The visible blades of a field in the wind and on ground that remembers who walked there.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_GROUND_SET 2
#define WINDROW_GROUND_BINDING 3
#include "../coupling/windrow_ground.glsl"
#define FIELD_GROUND
#include "field_blades.glsl"
