// Reads `motors`. A kind of motor is one function in one table: a new kind adds a line to each.
#pragma once

#include "scene/json_object.h"
#include "scene/scene.h"

#include <span>
#include <string>
#include <vector>

namespace windrow::scene {

/// What a kind's function is given beside its object.
struct MotorContext {
    const std::vector<ScenePath>& paths;
    std::span<const std::string> path_names;
};

/// Reads the keys of one kind into `motor.motor` and `motor.path`; the keys that all kinds share are read before.
using ReadMotorKind = void (*)(JsonObject& object, const MotorContext& context, SceneMotor& motor);

struct MotorKind {
    const char* name;
    ReadMotorKind read;
};

[[nodiscard]] std::span<const MotorKind> motor_kinds();

[[nodiscard]] std::vector<SceneMotor> read_motors(JsonObject& scene, const MotorContext& context);

} // namespace windrow::scene
