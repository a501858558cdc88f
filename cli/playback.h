// A scene that runs: the wind, the motors that come and go, the box that follows.
#pragma once

#include "cli/scene.h"
#include "fluid/wind.h"

#include <cstdint>
#include <string>
#include <vector>

namespace windrow::cli {

class Playback {
  public:
    /// Makes the air of a scene; the scene must outlive it. `threads` may be empty: serial.
    [[nodiscard]] static Result<Playback> create(const Scene& scene, ParallelFor threads);

    /// Advances by one tick: what moves is put where it is at the tick's end, and the air follows.
    [[nodiscard]] Result<Diagnostics> tick();

    /// [s] Ticks so far over tick_hz: no sum of rounded steps.
    [[nodiscard]] double time() const { return static_cast<double>(ticks_) / scene_->tick_hz; }
    [[nodiscard]] std::int64_t ticks() const { return ticks_; }
    [[nodiscard]] const Wind& wind() const { return wind_; }
    [[nodiscard]] const Scene& scene() const { return *scene_; }

    /// A motor of the scene as it stands now.
    struct Acting {
        const SceneMotor* motor;
        Motor now;
    };
    /// Those that act at this time, in the scene's order.
    [[nodiscard]] std::vector<Acting> acting() const;

  private:
    Playback(const Scene& scene, Wind wind) : scene_(&scene), wind_(std::move(wind)), ids_(scene.motors.size()) {}

    [[nodiscard]] Result<void> place_box(double time);
    [[nodiscard]] Result<void> place_motors(double start, double end);

    const Scene* scene_;
    Wind wind_;
    std::vector<MotorId> ids_; ///< of the scene's motors; a default one while a motor does not act
    std::int64_t ticks_ = 0;
};

} // namespace windrow::cli
