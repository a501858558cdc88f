// Reads `air`: the box and how the air in it moves.
#pragma once

#include "fluid/wind.h"
#include "scene/json_object.h"

namespace windrow::scene {

/// Limits of places in a scene. [m]
inline constexpr NumberRule k_place_rule{.least = -1e9, .most = 1e9, .unit = "m"};
/// Limits of velocities, those of Wind::set_ambient. [m/s]
inline constexpr NumberRule k_velocity_rule{.least = -1e4, .most = 1e4, .unit = "m/s"};

/// What was read, and whether the scene itself says where the box lies.
struct ReadAir {
    Config config;
    bool has_centre = false;
};

/// `air` is finished here.
[[nodiscard]] ReadAir read_air(JsonObject& air);

/// Notes what windrow::validate says of the whole config, under `path`. Called where single values were found good.
void check_air(const Config& config, const std::string& path, ReadLog& log);

} // namespace windrow::scene
