// The air of a session goes from one solver to the other, and both are compared.
#include "vegetation/view/session.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <utility>

namespace windrow::vegetation::view {
namespace {

using program::Air;
using program::Backend;

/// So many ticks, and, of a device, the frames until the last has been read back.
Result<void> advance_alone(Air& air, scene::SceneLevels& around, engine::Frames& frames, int ticks, double tick) {
    for (int n = 0; n < ticks + engine::k_frames_in_flight; ++n) {
        if (n < ticks)
            if (auto passed = around.pass(tick); !passed)
                return passed;
        const auto frame = frames.begin();
        if (!frame)
            return frame.failure();
        const auto recorded = air.record(*frame, n < ticks ? tick : 0.0);
        if (auto done = frames.finish(*frame); !done)
            return done;
        if (!recorded)
            return recorded;
    }
    return {};
}

} // namespace

Result<void> Session::go_on(std::span<const std::byte> bytes, Backend backend) {
    if (auto done = player_->frames().wait(); !done)
        return done;
    program::AirSettings settings = player_->air_settings();
    settings.backend = backend;
    auto air = Air::load(device_, bytes, settings, player_->levels() != nullptr ? player_->levels()->nearest() : nullptr);
    if (!air)
        return air.failure();
    player_->take_air(*std::move(air));
    player_->scene_air().restore(player_->scene_air().state().unowned());
    owed_ = 0.0;
    return {};
}

Result<void> Session::look(Slice& slice, SliceOf what, double height, double step) {
    return slice.look(what, height, step, wind(), player_->air().reader());
}

std::int64_t Session::step_at(double time) const {
    const scene::FrameTimes times = scene_->air.frame_times();
    auto step = static_cast<std::int64_t>(std::max(std::floor(time * times.step_hz()), 0.0));
    while (step > 0 && times.time_of_step(step) > time + 1e-9)
        --step;
    while (times.time_of_step(step + 1) <= time + 1e-9)
        ++step;
    return step;
}

Result<void> Session::set_solver(Backend backend) {
    if (backend == solver())
        return {};
    if (auto can = can_change(); !can)
        return can;
    if (auto done = player_->frames().wait(); !done)
        return done;
    const auto bytes = player_->air().save(player_->frames());
    if (!bytes)
        return bytes.failure();
    // Where the other solver takes over, the logs of what was kept are written no more.
    record_to(nullptr);
    if (auto gone = go_on(*bytes, backend); !gone) {
        if (!segments_.empty())
            record_to(rewound_.empty() ? &segments_.back()->logs : &rewound_);
        return gone;
    }
    settings_.backend = backend;
    segments_.clear();
    rewound_.clear();
    latest_ = shown_ = time();
    scene::SceneAir::State state = player_->scene_air().state();
    state.steps = step_at(state.time);
    player_->scene_air().restore(state);
    return begin_segment();
}

Result<Session::Difference> Session::compare_solvers(int ticks) {
    engine::Frames& frames = player_->frames();
    if (auto done = frames.wait(); !done)
        return done.failure();
    const auto bytes = player_->air().save(frames);
    if (!bytes)
        return bytes.failure();
    std::vector<scene::SceneLevels::Kept> starts;
    if (const scene::SceneLevels* const around = player_->levels()) {
        auto kept = around->keep();
        if (!kept)
            return kept.failure();
        starts = *std::move(kept);
    }
    starts.emplace_back();
    const double tick = 1.0 / wind().config().ticks.hz;
    std::vector<glm::vec4> first;
    Difference found{.time = time(), .ticks = ticks};
    for (const Backend backend : {Backend::cpu, Backend::vulkan}) {
        auto around = levels_from(starts);
        if (!around)
            return around.failure();
        auto air = Air::load(device_, *bytes, {.backend = backend, .queries = true}, around->nearest());
        if (!air)
            return air.failure();
        if (auto done = advance_alone(*air, *around, frames, ticks, tick); !done)
            return done.failure();
        const auto cells = air->reader().cells();
        if (!cells)
            return cells.failure();
        if (first.empty())
            first.assign(cells->begin(), cells->end());
        else
            for (std::size_t n = 0; n < first.size(); ++n) {
                found.largest = std::max(found.largest, glm::length(glm::vec3((*cells)[n] - first[n])));
                found.fastest = std::max(found.fastest, glm::length(glm::vec3(first[n])));
            }
    }
    return found;
}

} // namespace windrow::vegetation::view
