#include "cli/playback.h"

#include "fluid/core/message.h"

namespace windrow::cli {

using namespace cases;

using detail::message;

Result<Playback> Playback::create(const scene::Scene& scene, ParallelFor threads, const Backend& backend) {
    auto levels = scene::SceneLevels::create(scene, threads);
    if (!levels)
        return levels.failure();
    Config config = levels->inner_config();
    config.parallel_for = threads;
    auto wind = BackendWind::create(config, backend, BackendClock::on, levels->nearest());
    if (!wind)
        return wind.failure().after(message(scene.file.string(), ": $.air: "));
    Playback playback(scene, *std::move(levels), *std::move(wind));
    if (const auto begun = playback.air_.begin(*playback.wind_); !begun)
        return begun.failure();
    return playback;
}

Result<Playback> Playback::load(const scene::Scene& scene, ParallelFor threads, std::span<const std::byte> levels,
                                std::span<const std::byte> wind, std::span<const std::byte> air) {
    auto around = scene::SceneLevels::load(scene, threads, levels);
    if (!around)
        return around.failure();
    auto loaded = BackendWind::load(wind, threads, around->nearest());
    if (!loaded)
        return loaded.failure();
    Playback playback(scene, *std::move(around), *std::move(loaded));
    if (const auto begun = playback.air_.load(air); !begun)
        return begun.failure();
    return playback;
}

Result<Diagnostics> Playback::step(const scene::FrameTimes& times) {
    const std::int64_t next = steps() + 1;
    if (const auto around = levels_.advance_to(times.time_of_step(next)); !around)
        return around.failure();
    if (const auto placed = air_.advance_to(*wind_, times.time_of_step(next)); !placed)
        return placed.failure();
    return wind_->step(times.length_of_step(next));
}

} // namespace windrow::cli
