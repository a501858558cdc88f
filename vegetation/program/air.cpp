#include "vegetation/program/air.h"

#include <algorithm>
#include <chrono>

namespace windrow::vegetation::program {

Result<Air> Air::create(engine::Device& device, Config config, const AirSettings& settings) {
    Air made;
    if (settings.backend.value_or(device.software() ? Backend::cpu : Backend::vulkan) == Backend::cpu) {
        made.threads_ = std::make_unique<ThreadPool>();
        config.parallel_for = made.threads_->parallel_for();
        auto wind = engine::CpuWind::create(device, config);
        if (!wind)
            return Error{wind.error()};
        made.cpu_ = *std::move(wind);
        return made;
    }
    using windrow::vulkan::ReadBack;
    auto wind = windrow::vulkan::Wind::create(device.host(), config,
                                              {.frames_in_flight = engine::k_frames_in_flight,
                                               .timestamps = settings.pass_times,
                                               .queries = settings.queries ? ReadBack::cells : ReadBack::none});
    if (!wind)
        return Error{wind.error()};
    made.device_ = *std::move(wind);
    return made;
}

Motors& Air::motors() {
    return cpu_ ? cpu_->air().motors() : device_->motors();
}
Obstacles& Air::obstacles() {
    return cpu_ ? cpu_->air().obstacles() : device_->obstacles();
}
Result<void> Air::follow(glm::dvec3 point) {
    return cpu_ ? cpu_->air().follow(point) : device_->follow(point);
}
Result<void> Air::set_floor(double height) {
    return cpu_ ? cpu_->air().set_floor(height) : device_->set_floor(height);
}
void Air::reset() {
    return cpu_ ? cpu_->air().reset() : device_->reset();
}

Result<void> Air::record(const engine::Frame& frame, double dt) {
    if (!cpu_) {
        const auto recorded = device_->record(frame.commands, {.dt = dt, .slot = frame.slot});
        return recorded ? Result<void>{} : Error{recorded.error()};
    }
    const auto begin = std::chrono::steady_clock::now();
    if (const Diagnostics last = cpu_->air().advance(dt).last; last.out_of_memory && !last.stepped)
        return Error{"there is no memory for the air's next step; give the scene fewer cells."};
    const auto recorded = cpu_->record(frame.commands, frame.slot);
    cpu_us_ = std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count();
    return recorded;
}

engine::SampledWind Air::sampled() const {
    return cpu_ ? engine::SampledWind(*cpu_) : engine::SampledWind(*device_);
}

const Config& Air::config() const {
    return cpu_ ? cpu_->config() : device_->config();
}
Box Air::box() const {
    return cpu_ ? cpu_->air().box() : device_->box();
}
glm::dvec3 Air::origin() const {
    return cpu_ ? cpu_->air().origin() : device_->origin();
}
glm::vec3 Air::velocity(glm::dvec3 place) const {
    return cpu_ ? cpu_->air().velocity(place) : device_->velocity(place);
}

void Air::velocity(std::span<const glm::dvec3> places, std::span<glm::vec3> velocities) const {
    if (const auto view = cpu_ ? cpu_->air().view() : device_->queried())
        view->velocity(places, velocities);
    else
        std::fill(velocities.begin(), velocities.end(), device_->ambient());
}

std::optional<windrow::vulkan::PassTimes> Air::pass_times() const {
    return cpu_ ? std::nullopt : device_->pass_times();
}
std::uint64_t Air::memory_bytes() const {
    return cpu_ ? cpu_->memory_bytes() : device_->memory_bytes();
}
std::uint64_t Air::reserved_bytes() const {
    return cpu_ ? cpu_->memory_bytes() : device_->reserved_bytes();
}

} // namespace windrow::vegetation::program
