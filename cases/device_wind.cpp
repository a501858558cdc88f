#include "cases/device_wind.h"

#include "fluid/vulkan/own_device.h"

#include <chrono>
#include <memory>
#include <string_view>

namespace windrow::cases {

namespace {

// The stage of the step that a pass belongs to. What is at obstacles is a stage of its own, as on the CPU; `lift`, which follows a box
// that rose, belongs to none.
void add_to_stage(const vulkan::PassTimes::Pass& pass, StageTimes& times) {
    const std::string_view name = pass.name;
    const auto is_one_of = [&](const auto&... names) { return ((name == names) || ...); };
    if (name == "lift")
        return;
    double& stage = name.starts_with("diffuse") || name == "stress"                 ? times.diffusion
                    : name == "pad" || name.starts_with("advect")                   ? times.advection
                    : name.starts_with("modes") || is_one_of("columns", "gradient") ? times.projection
                    : is_one_of("residual", "surface", "rooms", "terms", "loads")   ? times.obstacles
                    : is_one_of("show", "report", "read_cells", "read_points")      ? times.report
                                                                                    : times.sources;
    stage += 1e-3 * pass.us;
}

} // namespace

Result<std::unique_ptr<BackendWind>> DeviceWind::create(const Config& config, const Backend& backend, BackendClock clock,
                                                        const std::shared_ptr<const Wind>& outer) {
    vulkan::Settings settings{.texel = vulkan::Texel::single, .frames_in_flight = 1, .queries = vulkan::ReadBack::cells};
    settings.timestamps = clock == BackendClock::on;
    settings.forces = backend.forces;
    auto wind = vulkan::Wind::create(backend.device()->host(), config, settings, outer);
    if (!wind && settings.timestamps) { // a queue that counts no time
        settings.timestamps = false;
        wind = vulkan::Wind::create(backend.device()->host(), config, settings, outer);
    }
    if (!wind)
        return wind.failure();
    return std::unique_ptr<BackendWind>(new DeviceWind(backend, std::make_unique<vulkan::Wind>(*std::move(wind))));
}

Diagnostics DeviceWind::run(double dt) const {
    const auto begin = std::chrono::steady_clock::now();
    if (!backend_.fault().empty())
        return {};
    Result<Diagnostics> recorded = Diagnostics{};
    const auto ran =
        backend_.device()->run([&](VkCommandBuffer commands) { recorded = wind_->record_step(commands, {.dt = dt, .slot = 0}); });
    if (!ran || !recorded) {
        backend_.note_fault(ran ? recorded.error() : ran.error());
        return {};
    }
    Diagnostics done = *recorded;
    const bool taken = wind_->collect(0); // none while it sleeps
    read_ = taken || (read_ && done.asleep);
    if (!taken && !done.asleep)
        backend_.note_fault("The device's read-back cannot be read: its memory was not made visible to the host.");
    if (taken && done.asleep) { // what the last step before sleep did
        const Diagnostics reported = wind_->reported();
        done.repaired_cells = reported.repaired_cells;
        done.limited_cells = reported.limited_cells;
    } else if (taken && done.stepped) {
        // A recording reports the step before; what the host decides is of this one.
        Diagnostics reported = wind_->reported();
        reported.stepped = true;
        reported.out_of_memory = done.out_of_memory;
        reported.regridded = done.regridded;
        reported.motors_in_reach = done.motors_in_reach;
        reported.motors_lost = done.motors_lost;
        reported.jumps = done.jumps;
        reported.fast_turns = done.fast_turns;
        reported.filling_obstacles = done.filling_obstacles;
        reported.diffusion = done.diffusion;
        reported.sealed_sources = done.sealed_sources;
        reported.sealed_rooms = done.sealed_rooms;
        done = reported;
        if (const auto times = wind_->pass_times())
            for (const vulkan::PassTimes::Pass& pass : times->passes)
                add_to_stage(pass, done.times_ms);
    }
    done.times_ms.total = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    return done;
}

WindReader& DeviceWind::reader() const {
    const auto read = wind_->queried();
    const bool of_now = read_ && read && read->origin() == wind_->origin() && !wind_->waits();
    if (!of_now && backend_.fault().empty())
        run(0.0);
    return *wind_;
}

} // namespace windrow::cases
