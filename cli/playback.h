// A scene that runs: its air (scene/scene_air.h) in a wind of the command's backend.
#pragma once

#include "cases/backend_wind.h"
#include "scene/scene_air.h"
#include "scene/scene_levels.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace windrow::cli {

class Playback {
  public:
    /// Makes the air of a scene; the scene must outlive it. `threads` may be empty: serial.
    [[nodiscard]] static Result<Playback> create(const scene::Scene& scene, ParallelFor threads,
                                                 const cases::Backend& backend = {});

    /// Goes on from the bytes of SceneLevels::save, Wind::save and SceneAir::save, on the CPU.
    [[nodiscard]] static Result<Playback> load(const scene::Scene& scene, ParallelFor threads, std::span<const std::byte> levels,
                                               std::span<const std::byte> wind, std::span<const std::byte> air);

    /// Advances by one step of the times given: what moves is put where it is at the step's end, and the air follows.
    [[nodiscard]] Result<Diagnostics> step(const scene::FrameTimes& times);
    /// The same by one tick of the scene, 1 / tick_hz.
    [[nodiscard]] Result<Diagnostics> tick() { return step({0.0, scene().tick_hz, scene().tick_hz}); }

    /// [s]
    [[nodiscard]] double time() const { return air_.time(); }
    [[nodiscard]] std::int64_t steps() const { return air_.steps(); }
    [[nodiscard]] const cases::BackendWind& wind() const { return *wind_; }
    [[nodiscard]] cases::BackendWind& wind() { return *wind_; }
    [[nodiscard]] const scene::SceneAir& air() const { return air_; }
    [[nodiscard]] const scene::SceneLevels& levels() const { return levels_; }
    [[nodiscard]] const scene::Scene& scene() const { return air_.scene(); }

    using ActingMotor = scene::SceneAir::ActingMotor;
    /// Those that act at this time, in the scene's order; not those that have ended by themselves.
    [[nodiscard]] std::vector<ActingMotor> acting() const { return air_.acting(wind().motors()); }

    /// Obstacles that are there at this time, in the scene's order.
    [[nodiscard]] std::vector<scene::SceneAir::StandingObstacle> standing() const { return air_.standing(time()); }

  private:
    Playback(const scene::Scene& scene, scene::SceneLevels levels, std::unique_ptr<cases::BackendWind> wind)
        : levels_(std::move(levels)), wind_(std::move(wind)), air_(scene::SceneAir::within(scene)) {}

    scene::SceneLevels levels_;
    std::unique_ptr<cases::BackendWind> wind_;
    scene::SceneAir air_;
};

} // namespace windrow::cli
