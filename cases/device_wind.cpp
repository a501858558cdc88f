#include "cases/device_wind.h"

#include "fluid/vulkan/own_device.h"

#include <chrono>
#include <limits>
#include <memory>
#include <string_view>

namespace windrow::cases {

namespace {

// The stage of the step that a pass belongs to.
void add_to_stage(const vulkan::PassTimes::Pass& pass, StageTimes& times) {
    const std::string_view name = pass.name;
    double& stage = name.starts_with("diffuse")                                            ? times.diffusion
                    : name == "pad" || name == "advect"                                    ? times.advection
                    : name.starts_with("modes") || name == "columns" || name == "gradient" ? times.projection
                    : name == "show"                                                       ? times.report
                                                                                           : times.sources;
    stage += 1e-3 * pass.us;
}

} // namespace

Result<DeviceWind> DeviceWind::create(const Config& config, const Backend& backend, BackendClock clock) {
    vulkan::Settings settings{.texel = vulkan::Texel::single, .frames_in_flight = 1, .queries = vulkan::ReadBack::cells};
    settings.timestamps = clock == BackendClock::on;
    auto wind = vulkan::Wind::create(backend.device()->host(), config, settings);
    if (!wind && settings.timestamps) { // a queue that counts no time
        settings.timestamps = false;
        wind = vulkan::Wind::create(backend.device()->host(), config, settings);
    }
    if (!wind)
        return Error{wind.error()};
    return DeviceWind(backend, *std::move(wind));
}

Diagnostics DeviceWind::run(double dt) const {
    const auto begin = std::chrono::steady_clock::now();
    if (!backend_.fault().empty())
        return {};
    Result<Diagnostics> recorded = Diagnostics{};
    const auto ran =
        backend_.device()->run([&](VkCommandBuffer commands) { recorded = wind_.record_step(commands, {.dt = dt, .slot = 0}); });
    if (!ran || !recorded) {
        backend_.note_fault(ran ? recorded.error() : ran.error());
        return {};
    }
    Diagnostics done = *recorded;
    const bool taken = wind_.collect(0); // none while it sleeps
    read_ = taken || (read_ && done.asleep);
    if (!taken && !done.asleep)
        backend_.note_fault("The device's read-back cannot be read: its memory was not made visible to the host.");
    if (taken && done.asleep) { // what the last step before sleep did
        const Diagnostics reported = wind_.reported();
        done.repaired_cells = reported.repaired_cells;
        done.limited_cells = reported.limited_cells;
    } else if (taken && done.stepped) {
        // A recording tells of the step before; which motors act, and how it diffuses, it knows itself.
        Diagnostics reported = wind_.reported();
        reported.stepped = true;
        reported.motors_in_reach = done.motors_in_reach;
        reported.diffusion = done.diffusion;
        done = reported;
        if (const auto times = wind_.pass_times())
            for (const vulkan::PassTimes::Pass& pass : times->passes)
                add_to_stage(pass, done.times_ms);
    }
    done.times_ms.total = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    return done;
}

WindView DeviceWind::view() const {
    if (!read_)
        run(0.0);
    if (const auto read = wind_.queried(); read && backend_.fault().empty())
        return *read;
    broken_.assign(box_.cell_count(), glm::vec4(std::numeric_limits<float>::quiet_NaN()));
    return {box_, Window{.cells = box_.cells, .cell_size = box_.cell_size}, BlendZone{}, wind_.ambient_wind(), broken_};
}

} // namespace windrow::cases
