#include "cli/playback.h"

#include "fluid/message.h"

namespace windrow::cli {
namespace {

using detail::message;

Motor moved(const Motor& motor, glm::dvec3 position) {
    Motor result = motor;
    std::visit([&](auto& kind) { kind.position = position; }, result);
    return result;
}

} // namespace

Result<Playback> Playback::create(const Scene& scene, ParallelFor threads) {
    Config config = scene.air;
    config.parallel_for = threads;
    auto wind = Wind::create(config);
    if (!wind)
        return Error{message(scene.file.string(), ": $.air: ", wind.error())};
    Playback playback(scene, std::move(*wind));
    // The first frame is taken before any step: the box already lies where it will be needed.
    if (const auto placed = playback.place_box(0.0); !placed)
        return Error{placed.error()};
    return playback;
}

Result<Diagnostics> Playback::tick() {
    const double start = time();
    const double end = static_cast<double>(ticks_ + 1) / scene_->tick_hz;
    if (const auto placed = place_box(end); !placed)
        return Error{placed.error()};
    if (const auto placed = place_motors(start, end); !placed)
        return Error{placed.error()};
    const Diagnostics diagnostics = wind_.step(1.0 / scene_->tick_hz);
    ++ticks_;
    return diagnostics;
}

std::vector<Playback::Acting> Playback::acting() const {
    std::vector<Acting> result;
    const double now = time();
    for (const SceneMotor& motor : scene_->motors)
        if (motor.from <= now && now < motor.until)
            result.push_back({&motor, motor.path ? moved(motor.motor, scene_->paths[*motor.path].path.at(now)) : motor.motor});
    return result;
}

Result<void> Playback::place_box(double time) {
    const std::string file = scene_->file.string();
    if (!std::holds_alternative<std::monostate>(scene_->follow))
        if (const auto followed = wind_.follow(scene_->followed_point(time)); !followed)
            return Error{message(file, ": $.follow at ", time, " s: ", followed.error())};
    if (scene_->has_floor())
        if (const auto placed = wind_.set_floor(scene_->floor_height(time)); !placed)
            return Error{message(file, ": $.floor at ", time, " s: ", placed.error())};
    return {};
}

Result<void> Playback::place_motors(double start, double end) {
    const double middle = 0.5 * (start + end);
    Motors& motors = wind_.motors();
    for (std::size_t i = 0; i < scene_->motors.size(); ++i) {
        const SceneMotor& motor = scene_->motors[i];
        MotorId& id = ids_[i];
        const bool acts = motor.from <= middle && middle < motor.until;
        const bool stands = id.generation != 0;
        Result<void> done;
        if (acts && !stands) {
            // A wake begins its path where the body is at the tick's start, then is moved like any other.
            const auto added =
                motors.add(motor.path ? moved(motor.motor, scene_->paths[*motor.path].path.at(start)) : motor.motor);
            if (added)
                id = *added;
            else
                done = Error{added.error()};
        } else if (!acts && stands) {
            done = motors.remove(id);
            id = {};
        }
        if (done && id.generation != 0 && motor.path)
            done = motors.move(id, scene_->paths[*motor.path].path.at(end));
        if (!done)
            return Error{message(scene_->file.string(), ": $.motors[", i, "]: ", done.error())};
    }
    return {};
}

} // namespace windrow::cli
