// A scene that runs: the wind, and what moves in it.
#pragma once

#include "cases/backend_wind.h"
#include "scene/scene_motion.h"

#include <cstdint>
#include <vector>

namespace windrow::cli {

class Playback {
  public:
    /// Makes the air of a scene; the scene must outlive it. `threads` may be empty: serial.
    [[nodiscard]] static Result<Playback> create(const scene::Scene& scene, ParallelFor threads,
                                                 const cases::Backend& backend = {});

    /// Advances by one step of the times given: what moves is put where it is at the step's end, and the air follows.
    [[nodiscard]] Result<Diagnostics> step(const scene::FrameTimes& times);
    /// The same by one tick of the scene, 1 / tick_hz.
    [[nodiscard]] Result<Diagnostics> tick() { return step({0.0, scene_->tick_hz, scene_->tick_hz}); }

    /// [s]
    [[nodiscard]] double time() const { return time_; }
    [[nodiscard]] std::int64_t steps() const { return steps_; }
    [[nodiscard]] const cases::BackendWind& wind() const { return *wind_; }
    [[nodiscard]] cases::BackendWind& wind() { return *wind_; }
    [[nodiscard]] const scene::Scene& scene() const { return *scene_; }

    using ActingMotor = scene::SceneMotion::ActingMotor;
    /// Those that act at this time, in the scene's order; not those that have ended by themselves.
    [[nodiscard]] std::vector<ActingMotor> acting() const { return motion_.acting(wind().motors(), time()); }

    /// Obstacles that are there at this time, in the scene's order.
    [[nodiscard]] std::vector<scene::SceneMotion::StandingObstacle> standing() const { return motion_.standing(time()); }

  private:
    Playback(const scene::Scene& scene, std::unique_ptr<cases::BackendWind> wind)
        : scene_(&scene), wind_(std::move(wind)), motion_(scene) {}

    const scene::Scene* scene_;
    std::unique_ptr<cases::BackendWind> wind_;
    scene::SceneMotion motion_;
    std::int64_t steps_ = 0;
    double time_ = 0.0;
};

} // namespace windrow::cli
