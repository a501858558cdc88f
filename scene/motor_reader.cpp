#include "scene/motor_reader.h"

#include "fluid/message.h"
#include "scene/air_reader.h"
#include "scene/json_document.h"
#include "scene/motor_parts_reader.h"

#include <algorithm>
#include <string_view>

namespace windrow::scene {
namespace {

using detail::message;
using nlohmann::json;

constexpr NumberRule k_time_rule{.least = -MotionPath::k_farthest, .most = MotionPath::k_farthest, .unit = "s"};

// --- Kinds -----------------------------------------------------------------------------------------------------------

/// The place of a motor that need not move; a path says where instead.
glm::dvec3 read_place(JsonObject& object, const MotorContext& context, SceneMotor& motor) {
    const auto position = object.optional_vector("position", k_place_rule);
    motor.path = object.name("path", context.path_names, "paths");
    if (position && motor.path)
        object.refuse("holds both \"position\" and \"path\": keep one of them.");
    return position.value_or(glm::dvec3(0.0));
}

void read_directional(JsonObject& object, const MotorContext& context, SceneMotor& motor) {
    DirectionalMotor read;
    read.position = read_place(object, context, motor);
    read.direction = read_direction(object, "direction", read.direction);
    read.region = read_region(object.object("region"));
    read.law = read_law(object.object("law"), std::get<Drive>(read.law));
    read.envelope = read_envelope(object.object("envelope"));
    read.turbulence = read_turbulence(object.object("turbulence"), read.turbulence);
    motor.motor = read;
}

void read_wake(JsonObject& object, const MotorContext& context, SceneMotor& motor) {
    WakeMotor read;
    // Without a path a wake would never move, and so never act.
    motor.path = object.name("path", context.path_names, "paths", true);
    read.radius = object.real("radius", read.radius, k_size_rule);
    read.law = read_wake_law(object.object("law"));
    read.envelope = read_envelope(object.object("envelope"));
    read.turbulence = read_turbulence(object.object("turbulence"), read.turbulence);
    motor.motor = read;
}

void read_jet(JsonObject& object, const MotorContext& context, SceneMotor& motor) {
    JetMotor read;
    read.position = read_place(object, context, motor);
    read.direction = read_direction(object, "direction", read.direction);
    read.length = object.real("length", read.length, k_size_rule);
    read.start_radius = object.real("start_radius", read.start_radius, k_size_rule);
    read.end_radius = object.real("end_radius", read.end_radius, k_size_rule);
    read.law = read_law(object.object("law"), std::get<Drive>(read.law));
    read.envelope = read_envelope(object.object("envelope"));
    read.turbulence = read_turbulence(object.object("turbulence"), read.turbulence);
    motor.motor = read;
}

void read_vortex(JsonObject& object, const MotorContext& context, SceneMotor& motor) {
    VortexMotor read;
    read.position = read_place(object, context, motor);
    read.axis = read_direction(object, "axis", read.axis);
    read.radius = object.real("radius", read.radius, k_size_rule);
    read.half_length = object.real("half_length", read.half_length, k_size_rule);
    read.lift = object.real("lift", read.lift, {.least = -10.0, .most = 10.0});
    read.law = read_law(object.object("law"), std::get<Drive>(read.law));
    read.envelope = read_envelope(object.object("envelope"));
    motor.motor = read;
}

void read_omni(JsonObject& object, const MotorContext& context, SceneMotor& motor) {
    OmniMotor read;
    read.position = read_place(object, context, motor);
    read.radius = object.real("radius", read.radius, k_size_rule);
    read.speed = object.real("speed", read.speed, k_speed_rule);
    read.envelope = read_envelope(object.object("envelope"));
    motor.motor = read;
}

void read_pressure(JsonObject& object, const MotorContext& context, SceneMotor& motor) {
    PressureMotor read;
    read.position = read_place(object, context, motor);
    read.radius = object.real("radius", read.radius, k_size_rule);
    read.speed = object.real("speed", read.speed, k_speed_rule);
    read.duration = object.real("duration", read.duration, {.least = 0.0, .most = 1e9, .above_least = true, .unit = "s"});
    motor.motor = read;
}

constexpr MotorKind k_kinds[] = {{"directional", &read_directional}, {"wake", &read_wake}, {"jet", &read_jet},
                                 {"vortex", &read_vortex},           {"omni", &read_omni}, {"pressure", &read_pressure}};

/// Notes what windrow::validate says of a motor whose single values were found good.
void check_motor(const Motor& motor, JsonObject& object) {
    const auto valid = validate(motor);
    if (valid)
        return;
    std::string_view lines = valid.error();
    while (!lines.empty()) {
        const std::size_t end = lines.find('\n');
        std::string_view line = lines.substr(0, end);
        // The library's lines begin with "motor.", and the scene's keys below the motor bear the same names.
        const bool named = line.starts_with("motor.");
        if (named)
            line.remove_prefix(5);
        object.log().refuse_as_is(message(object.log().file(), ": ", object.path(), named ? "" : ": ", line));
        lines.remove_prefix(end == lines.npos ? lines.size() : end + 1);
    }
}

SceneMotor read_motor(const json& value, const std::string& path, const MotorContext& context, ReadLog& log) {
    const std::size_t faults_before = log.faults();
    JsonObject object(value, path, "$.motors[]", log);
    SceneMotor motor;
    std::vector<std::string> names;
    for (const MotorKind& kind : k_kinds)
        names.emplace_back(kind.name);
    const std::size_t chosen = object.word_index("kind", "", names);
    // Nothing is known of the other keys without a kind.
    if (chosen == names.size())
        return motor;
    object.set_kind(names[chosen]);
    motor.name = object.text("name", names[chosen]);
    motor.from = object.number("from", motor.from, k_time_rule);
    if (const auto until = object.optional_number("until", k_time_rule)) {
        motor.until = *until;
        if (!(motor.from < motor.until))
            object.refuse("until",
                          message("is ", motor.until, " s but the motor begins at ", motor.from, " s: give a later time."));
    }
    k_kinds[chosen].read(object, context, motor);
    object.finish();
    if (log.faults() == faults_before)
        check_motor(motor.motor, object);
    return motor;
}

} // namespace

std::span<const MotorKind> motor_kinds() {
    return k_kinds;
}

std::vector<SceneMotor> read_motors(JsonObject& scene, const MotorContext& context) {
    std::vector<SceneMotor> motors;
    const auto items = scene.array("motors", Motors::k_capacity);
    for (std::size_t i = 0; i < items.size(); ++i)
        motors.push_back(read_motor(items[i], message(scene.path(), ".motors[", i, "]"), context, scene.log()));
    return motors;
}

} // namespace windrow::scene
