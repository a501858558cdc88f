// A scene that runs: the wind, the motors that come and go, the box that follows.
#pragma once

#include "cli/backend/command_wind.h"
#include "cli/scene.h"

#include <cstdint>
#include <string>
#include <vector>

namespace windrow::cli {

class Playback {
  public:
    /// Makes the air of a scene; the scene must outlive it. `threads` may be empty: serial.
    [[nodiscard]] static Result<Playback> create(const Scene& scene, ParallelFor threads, const Backend& backend = {});

    /// Advances by one tick: what moves is put where it is at the tick's end, and the air follows.
    [[nodiscard]] Result<Diagnostics> tick();

    /// [s] Ticks so far over tick_hz: no sum of rounded steps.
    [[nodiscard]] double time() const { return static_cast<double>(ticks_) / scene_->tick_hz; }
    [[nodiscard]] std::int64_t ticks() const { return ticks_; }
    [[nodiscard]] const CommandWind& wind() const { return *wind_; }
    [[nodiscard]] const Scene& scene() const { return *scene_; }

    /// A motor of the scene as it stands now.
    struct Acting {
        const SceneMotor* motor;
        Motor now;
        /// Share of its full strength in the coming tick: its envelope's, or a burst's form, which is below 0 while it draws
        /// back.
        double strength = 1.0;
    };
    /// Those that act at this time, in the scene's order; not those that have ended by themselves.
    [[nodiscard]] std::vector<Acting> acting() const;

  private:
    Playback(const Scene& scene, std::unique_ptr<CommandWind> wind)
        : scene_(&scene), wind_(std::move(wind)), parts_(scene.motors.size()) {}

    /// A motor of the scene in the air. Its handle turns stale when the motor ends by itself; it does not begin again.
    struct Part {
        MotorId id;
        bool begun = false;
        double since = 0.0; ///< [s] of the scene's time, when it was added
    };

    [[nodiscard]] Result<void> place_box(double time);
    [[nodiscard]] Result<void> place_motors(double start, double end);
    [[nodiscard]] Result<void> place_motor(const SceneMotor& motor, Part& part, double start, double end);
    [[nodiscard]] bool stands(const Part& part) const { return wind_->motors().find(part.id) != nullptr; }

    const Scene* scene_;
    std::unique_ptr<CommandWind> wind_;
    std::vector<Part> parts_; ///< one for each of the scene's motors
    std::int64_t ticks_ = 0;
};

} // namespace windrow::cli
