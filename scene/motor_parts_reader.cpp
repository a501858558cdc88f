#include "scene/motor_parts_reader.h"

#include <limits>

namespace windrow::scene {
namespace {

constexpr NumberRule k_seconds_rule{.least = 0.0, .most = 1e9, .unit = "s"};
constexpr NumberRule k_seed_rule{.least = 0.0, .most = std::numeric_limits<int>::max()};
constexpr NumberRule k_direction_rule{.least = -1e6, .most = 1e6};

} // namespace

glm::vec3 read_direction(JsonObject& object, const char* key, glm::vec3 fallback) {
    const glm::dvec3 direction = object.vector(key, glm::dvec3(fallback), k_direction_rule);
    if (direction == glm::dvec3(0.0))
        object.refuse(key, "is [0, 0, 0]: give a vector of any length but 0.");
    return glm::vec3(direction);
}

Region read_region(JsonObject region) {
    Region read = Sphere{};
    switch (region.one_of({"sphere", "capsule", "box", "cone"}, "sphere")) {
    case 0: {
        JsonObject shape = region.object("sphere");
        read = Sphere{.radius = shape.real("radius", Sphere{}.radius, k_size_rule)};
        shape.finish();
        break;
    }
    case 1: {
        JsonObject shape = region.object("capsule");
        const Capsule fallback;
        Capsule capsule;
        capsule.half_axis =
            glm::vec3(shape.vector("half_axis", glm::dvec3(fallback.half_axis), {.least = -1e6, .most = 1e6, .unit = "m"}));
        capsule.radius = shape.real("radius", fallback.radius, k_size_rule);
        read = capsule;
        shape.finish();
        break;
    }
    case 2: {
        JsonObject shape = region.object("box");
        read = AlignedBox{.half_size = glm::vec3(shape.vector("half_size", glm::dvec3(AlignedBox{}.half_size), k_size_rule))};
        shape.finish();
        break;
    }
    case 3: {
        JsonObject shape = region.object("cone");
        Cone cone;
        cone.axis = read_direction(shape, "axis", cone.axis);
        cone.start_radius = shape.real("start_radius", cone.start_radius, k_size_rule);
        cone.end_radius = shape.real("end_radius", cone.end_radius, k_size_rule);
        read = cone;
        shape.finish();
        break;
    }
    default:
        break;
    }
    region.finish();
    return read;
}

std::variant<Force, Drive> read_law(JsonObject law, const Drive& fallback) {
    std::variant<Force, Drive> read = fallback;
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
        values.speed = drive.real("speed", fallback.speed, k_speed_rule);
        values.rate = drive.real("rate", fallback.rate, {.least = 0.0, .most = 1e6, .unit = "1/s"});
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

Envelope read_envelope(JsonObject envelope) {
    Envelope read;
    read.attack = envelope.real("attack", read.attack, k_seconds_rule);
    if (const auto hold = envelope.optional_number("hold", k_seconds_rule))
        read.hold = static_cast<float>(*hold);
    read.decay = envelope.real("decay", read.decay, k_seconds_rule);
    if (envelope.value().contains("decay") && !envelope.value().contains("hold"))
        envelope.refuse("decay", "never begins without a \"hold\": say how long the motor acts before it.");
    envelope.finish();
    return read;
}

Turbulence read_turbulence(JsonObject turbulence, const Turbulence& fallback) {
    Turbulence read = fallback;
    read.intensity = turbulence.real("intensity", read.intensity, {.least = 0.0, .most = 1.0});
    read.length = turbulence.real("length", read.length, {.least = 0.0, .most = 1e6, .unit = "m"});
    read.seed = static_cast<std::uint32_t>(turbulence.integer("seed", static_cast<int>(read.seed), k_seed_rule));
    turbulence.finish();
    return read;
}

} // namespace windrow::scene
