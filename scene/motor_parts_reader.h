// Reads what several kinds of motor have in common: where they act, by which law, for how long.
#pragma once

#include "fluid/motor.h"
#include "scene/json_object.h"

namespace windrow::scene {

/// Radii and lengths.
inline constexpr NumberRule k_size_rule{.least = 0.0, .most = 1e6, .above_least = true, .unit = "m"};
inline constexpr NumberRule k_speed_rule{.least = -1e4, .most = 1e4, .unit = "m/s"};

// Each finishes the object that it is given.
[[nodiscard]] Region read_region(JsonObject region);
/// `drive` is the kind's own default.
[[nodiscard]] std::variant<Force, Drive> read_law(JsonObject law, const Drive& drive);
[[nodiscard]] std::variant<WakeForce, WakeDrive> read_wake_law(JsonObject law);
/// Refuses a decay that no hold would ever let begin.
[[nodiscard]] Envelope read_envelope(JsonObject envelope);
/// `fallback` is the kind's own default.
[[nodiscard]] Turbulence read_turbulence(JsonObject turbulence, const Turbulence& fallback);
/// A vector of any length but 0.
[[nodiscard]] glm::vec3 read_direction(JsonObject& object, const char* key, glm::vec3 fallback);

} // namespace windrow::scene
