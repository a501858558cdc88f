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

/// Mean strength between two ages [s].
double strength_of(const Motor& motor, double from, double to) {
    return std::visit(
        [&](const auto& kind) {
            if constexpr (requires { kind.envelope; })
                return kind.envelope.mean(from, to);
            else
                return kind.mean(from, to);
        },
        motor);
}

} // namespace

Result<Playback> Playback::create(const Scene& scene, ParallelFor threads, const Backend& backend) {
    Config config = scene.air;
    config.parallel_for = threads;
    auto wind = CommandWind::create(config, backend, StageClock::on);
    if (!wind)
        return Error{message(scene.file.string(), ": $.air: ", wind.error())};
    Playback playback(scene, *std::move(wind));
    // The first frame is taken before any step: the box already lies where it will be needed.
    if (const auto placed = playback.place_box(0.0); !placed)
        return Error{placed.error()};
    // Air that was filled in before the floor stood where it belongs has the wind of other heights.
    playback.wind_->reset();
    return playback;
}

Result<Diagnostics> Playback::tick() {
    const double start = time();
    const double end = static_cast<double>(ticks_ + 1) / scene_->tick_hz;
    if (const auto placed = place_box(end); !placed)
        return Error{placed.error()};
    if (const auto placed = place_motors(start, end); !placed)
        return Error{placed.error()};
    const Diagnostics diagnostics = wind_->step(1.0 / scene_->tick_hz);
    ++ticks_;
    return diagnostics;
}

std::vector<Playback::Acting> Playback::acting() const {
    std::vector<Acting> result;
    const double now = time();
    for (std::size_t i = 0; i < scene_->motors.size(); ++i) {
        const SceneMotor& motor = scene_->motors[i];
        const Part& part = parts_[i];
        if (now < motor.from || now >= motor.until || (part.begun && !stands(part)))
            continue;
        const double age = part.begun ? now - part.since : 0.0;
        result.push_back({&motor, motor.path ? moved(motor.motor, scene_->paths[*motor.path].path.at(now)) : motor.motor,
                          strength_of(motor.motor, age, age + 1.0 / scene_->tick_hz)});
    }
    return result;
}

Result<void> Playback::place_box(double time) {
    const std::string file = scene_->file.string();
    if (!std::holds_alternative<std::monostate>(scene_->follow))
        if (const auto followed = wind_->follow(scene_->followed_point(time)); !followed)
            return Error{message(file, ": $.follow at ", time, " s: ", followed.error())};
    if (scene_->has_floor())
        if (const auto placed = wind_->set_floor(scene_->floor_height(time)); !placed)
            return Error{message(file, ": $.floor at ", time, " s: ", placed.error())};
    return {};
}

Result<void> Playback::place_motors(double start, double end) {
    for (std::size_t i = 0; i < scene_->motors.size(); ++i)
        if (const auto placed = place_motor(scene_->motors[i], parts_[i], start, end); !placed)
            return Error{message(scene_->file.string(), ": $.motors[", i, "]: ", placed.error())};
    return {};
}

Result<void> Playback::place_motor(const SceneMotor& motor, Part& part, double start, double end) {
    const double middle = 0.5 * (start + end);
    const bool acts = motor.from <= middle && middle < motor.until;
    Motors& motors = wind_->motors();
    if (acts && !part.begun) {
        // A wake begins its path where the body is at the tick's start, then is moved like any other.
        const auto added = motors.add(motor.path ? moved(motor.motor, scene_->paths[*motor.path].path.at(start)) : motor.motor);
        if (!added)
            return Error{added.error()};
        part = {.id = *added, .begun = true, .since = start};
    }
    if (!stands(part))
        return {};
    if (!acts)
        return motors.remove(part.id);
    return motor.path ? motors.move(part.id, scene_->paths[*motor.path].path.at(end)) : Result<void>{};
}

} // namespace windrow::cli
