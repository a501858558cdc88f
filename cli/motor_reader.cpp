#include "cli/motor_reader.h"

#include "cli/air_reader.h"
#include "cli/json_document.h"
#include "fluid/message.h"

#include <algorithm>
#include <string_view>

namespace windrow::cli {
namespace {

using detail::message;
using nlohmann::json;

constexpr NumberRule k_radius_rule{.least = 0.0, .most = 1e6, .above_least = true, .unit = "m"};
constexpr NumberRule k_time_rule{.least = -MotionPath::k_farthest, .most = MotionPath::k_farthest, .unit = "s"};

Region read_region(JsonObject region) {
    Region read = Sphere{};
    switch (region.one_of({"sphere", "capsule", "box"}, "sphere")) {
    case 0: {
        JsonObject shape = region.object("sphere");
        read = Sphere{.radius = shape.real("radius", Sphere{}.radius, k_radius_rule)};
        shape.finish();
        break;
    }
    case 1: {
        JsonObject shape = region.object("capsule");
        const Capsule fallback;
        Capsule capsule;
        capsule.half_axis =
            glm::vec3(shape.vector("half_axis", glm::dvec3(fallback.half_axis), {.least = -1e6, .most = 1e6, .unit = "m"}));
        capsule.radius = shape.real("radius", fallback.radius, k_radius_rule);
        read = capsule;
        shape.finish();
        break;
    }
    case 2: {
        JsonObject shape = region.object("box");
        read = AlignedBox{.half_size = glm::vec3(shape.vector("half_size", glm::dvec3(AlignedBox{}.half_size), k_radius_rule))};
        shape.finish();
        break;
    }
    default:
        break;
    }
    region.finish();
    return read;
}

std::variant<Force, Drive> read_directional_law(JsonObject law) {
    std::variant<Force, Drive> read = Drive{};
    switch (law.one_of({"force", "drive"}, "drive")) {
    case 0: {
        JsonObject force = law.object("force");
        read = Force{.acceleration =
                         force.real("acceleration", Force{}.acceleration, {.least = -1e6, .most = 1e6, .unit = "m/s^2"})};
        force.finish();
        break;
    }
    case 1: {
        JsonObject drive = law.object("drive");
        Drive values;
        values.speed = drive.real("speed", values.speed, {.least = -1e4, .most = 1e4, .unit = "m/s"});
        values.rate = drive.real("rate", values.rate, {.least = 0.0, .most = 1e6, .unit = "1/s"});
        read = values;
        drive.finish();
        break;
    }
    default:
        break;
    }
    law.finish();
    return read;
}

std::variant<WakeForce, WakeDrive> read_wake_law(JsonObject law) {
    std::variant<WakeForce, WakeDrive> read = WakeDrive{};
    switch (law.one_of({"force", "drive"}, "drive")) {
    case 0: {
        JsonObject force = law.object("force");
        read = WakeForce{.strength = force.real("strength", WakeForce{}.strength, {.least = 0.0, .most = 1e4, .unit = "1/s"})};
        force.finish();
        break;
    }
    case 1: {
        JsonObject drive = law.object("drive");
        WakeDrive values;
        values.per_metre = drive.real("per_metre", values.per_metre, {.least = 0.0, .most = 1e4, .unit = "1/m"});
        values.entrainment = drive.real("entrainment", values.entrainment, {.least = 0.0, .most = 2.0});
        read = values;
        drive.finish();
        break;
    }
    default:
        break;
    }
    law.finish();
    return read;
}

// --- Kinds -----------------------------------------------------------------------------------------------------------

void read_directional(JsonObject& object, const MotorContext& context, SceneMotor& motor) {
    DirectionalMotor read;
    const auto position = object.optional_vector("position", k_place_rule);
    motor.path = object.name("path", context.path_names, "paths");
    if (position && motor.path)
        object.refuse("holds both \"position\" and \"path\": keep one of them.");
    read.position = position.value_or(read.position);
    const glm::dvec3 direction = object.vector("direction", glm::dvec3(read.direction), {.least = -1e6, .most = 1e6});
    read.direction = glm::vec3(direction);
    if (direction == glm::dvec3(0.0))
        object.refuse("direction", "is [0, 0, 0]: give a vector of any length but 0.");
    read.region = read_region(object.object("region"));
    read.law = read_directional_law(object.object("law"));
    motor.motor = read;
}

void read_wake(JsonObject& object, const MotorContext& context, SceneMotor& motor) {
    WakeMotor read;
    // Without a path a wake would never move, and so never act.
    motor.path = object.name("path", context.path_names, "paths", true);
    read.radius = object.real("radius", read.radius, k_radius_rule);
    read.law = read_wake_law(object.object("law"));
    motor.motor = read;
}

constexpr MotorKind k_kinds[] = {{"directional", &read_directional}, {"wake", &read_wake}};

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

} // namespace windrow::cli
