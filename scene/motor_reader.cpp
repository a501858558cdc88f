#include "fluid/core/message.h"
#include "scene/scene_parts.h"
#include "scene/setting_reader.h"

namespace windrow::scene {
namespace {

using detail::message;
using nlohmann::json;

/// Place of a motor: an optional position, or a path. Without a path a wake would never move, and so never act.
template <class Kind>
void read_place(JsonObject& object, const Key& key, std::span<const std::string> path_names, Kind& kind, SceneMotor& motor) {
    constexpr bool k_moves = std::same_as<Kind, WakeMotor>;
    if constexpr (!k_moves) {
        kind.position = object.vector(key, kind.position, k_place_rule);
        object.not_both("position", "path");
    }
    motor.path = object.name({"path", "Name of the path that the position moves along."}, path_names, "paths", k_moves);
}

/// Reads the keys of one kind; the keys common to all kinds are read before.
template <class Kind>
void read_motor_kind(JsonObject& object, std::span<const std::string> path_names, SceneMotor& motor) {
    Kind kind;
    read_settings(object, kind, [&](const auto& row, auto& member) {
        if constexpr (std::same_as<std::remove_cvref_t<decltype(member)>, glm::dvec3>) {
            read_place(object, {row.name, row.meaning}, path_names, kind, motor);
            return true;
        } else {
            return false;
        }
    });
    motor.motor = kind;
}

SceneMotor read_motor(const json& value, const std::string& path, std::span<const std::string> path_names, ReadLog& log) {
    const std::size_t faults_before = log.faults();
    JsonObject object(value, path, "$.motors[]", log);
    SceneMotor motor;
    const auto& kinds = k_alternatives<Motor>;
    const std::size_t chosen = object.word_index({"kind", "What it is."}, "", {kinds.begin(), kinds.end()});
    // Without a kind, the other keys cannot be checked.
    if (chosen == kinds.size())
        return motor;
    constexpr auto k_meanings = []<class... Kinds>(std::variant<Kinds...>*) {
        return std::array{Kinds::k_meaning...};
    }(static_cast<Motor*>(nullptr));
    object.set_kind(kinds.at(chosen), k_meanings.at(chosen));
    motor.name = object.text({"name", "Written beside the motor in pictures."}, kinds.at(chosen));
    read_times(object, "motor", motor.from, motor.until);
    [&]<class... Kinds>(std::variant<Kinds...>*) {
        std::size_t index = 0;
        ((index++ == chosen ? read_motor_kind<Kinds>(object, path_names, motor) : void()), ...);
    }(static_cast<Motor*>(nullptr));
    object.finish();
    if (log.faults() == faults_before)
        std::visit([&](const auto& kind) { check_read(object, kind); }, motor.motor);
    return motor;
}

} // namespace

void read_times(JsonObject& object, const char* what, double& from, double& until) {
    constexpr Range k_time_rule{-MotionPath::k_farthest, MotionPath::k_farthest, "s"};
    from =
        object.number({"from", "Time at which it begins to act, with its envelope; before 0 it begins at 0."}, from, k_time_rule);
    const auto end = object.optional_number({"until", "Time at which it ends, later than from. Default: never."}, k_time_rule);
    if (!end)
        return;
    until = *end;
    if (!(from < until))
        object.reject("until", message("is ", until, " s but the ", what, " begins at ", from, " s: give a later time."));
}

void check_object(JsonObject& object, const Envelope&) {
    object.needs("decay", "hold", "never begins without a \"hold\": say how long the motor acts before it.");
}

std::vector<SceneMotor> read_motors(JsonObject& scene, std::span<const std::string> path_names) {
    std::vector<SceneMotor> motors;
    const auto items = scene.array({"motors", "What pushes the air."}, Motors::k_capacity);
    for (std::size_t i = 0; i < items.size(); ++i)
        motors.push_back(read_motor(items[i], message(scene.path(), ".motors[", i, "]"), path_names, scene.log()));
    return motors;
}

std::vector<DragDeposit> read_drag(JsonObject& scene) {
    constexpr std::size_t k_most = 65536;
    std::vector<DragDeposit> deposits;
    const auto items = scene.array({"drag", "What slows the air without being a body: plants, hedges, fences, nets."}, k_most);
    for (std::size_t i = 0; i < items.size(); ++i) {
        const std::size_t faults_before = scene.log().faults();
        const std::string path = message(scene.path(), ".drag[", i, "]");
        DragDeposit& deposit = deposits.emplace_back();
        read_kind(JsonObject(items[i], path, "$.drag[]", scene.log()), deposit,
                  [](JsonObject kind, auto& alternative) { read_object(std::move(kind), alternative); });
        if (scene.log().faults() == faults_before)
            std::visit(
                [&](const auto& kind) {
                    JsonObject object(items[i], path + "." + kind.k_name, "$.drag[]", scene.log());
                    check_read(object, kind);
                },
                deposit);
    }
    return deposits;
}

} // namespace windrow::scene
