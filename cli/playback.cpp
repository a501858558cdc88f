#include "cli/playback.h"

#include "fluid/message.h"

namespace windrow::cli {

using namespace cases;

using detail::message;

Result<Playback> Playback::create(const scene::Scene& scene, ParallelFor threads, const Backend& backend) {
    Config config = scene.air;
    config.parallel_for = threads;
    auto wind = BackendWind::create(config, backend, BackendClock::on);
    if (!wind)
        return Error{message(scene.file.string(), ": $.air: ", wind.error())};
    Playback playback(scene, *std::move(wind));
    // The first frame is taken before any step: the box already lies where it will be needed.
    if (const auto placed = playback.motion_.begin(*playback.wind_); !placed)
        return Error{placed.error()};
    // Air that was filled in before the floor stood where it belongs has the wind of other heights.
    playback.wind_->reset();
    return playback;
}

Result<Diagnostics> Playback::step(const scene::FrameTimes& times) {
    const double end = times.time_of_step(steps_ + 1);
    if (const auto placed = motion_.place(*wind_, time_, end); !placed)
        return Error{placed.error()};
    const Diagnostics diagnostics = wind_->step(times.length_of_step(steps_ + 1));
    ++steps_;
    time_ = end;
    return diagnostics;
}

} // namespace windrow::cli
