#include "cli/backend/device_wind.h"

#include "fluid/vulkan/own_device.h"

#include <chrono>
#include <limits>
#include <memory>

namespace windrow::cli {

Result<std::unique_ptr<CommandWind>> DeviceWind::create(const Config& config, const Backend& backend) {
    auto wind = vulkan::Wind::create(backend.device()->host(), config, {.texel = vulkan::Texel::single, .frames_in_flight = 1});
    if (!wind)
        return Error{wind.error()};
    return std::unique_ptr<CommandWind>(new DeviceWind(backend, *std::move(wind)));
}

Diagnostics DeviceWind::run(double dt) const {
    const auto begin = std::chrono::steady_clock::now();
    Diagnostics done;
    if (!backend_.fault().empty())
        return done;
    const auto ran =
        backend_.device()->run([&](VkCommandBuffer commands) { done = wind_.record_step(commands, {.dt = dt, .slot = 0}); });
    if (!ran) {
        backend_.note_fault(ran.error());
        return {};
    }
    const bool taken = wind_.collect(0); // none while it sleeps
    read_ = read_ || taken;
    if (taken && done.stepped && !done.asleep) {
        // A recording tells of the step before; which motors act, and how it diffuses, it knows itself.
        Diagnostics reported = wind_.reported();
        reported.stepped = true;
        reported.motors_in_reach = done.motors_in_reach;
        reported.diffusion = done.diffusion;
        done = reported;
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
    return {box_, Window{.cells = box_.cells, .cell_size = box_.cell_size}, Rim{}, wind_.ambient_wind(), broken_};
}

} // namespace windrow::cli
