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
            return wind.failure();
        made.cpu_ = *std::move(wind);
        made.control_ = &made.cpu_->air();
        made.reader_ = &made.cpu_->air();
        return made;
    }
    using windrow::vulkan::ReadBack;
    auto wind = windrow::vulkan::Wind::create(device.host(), config,
                                              {.frames_in_flight = engine::k_frames_in_flight,
                                               .timestamps = settings.pass_times,
                                               .queries = settings.queries ? ReadBack::cells : ReadBack::none});
    if (!wind)
        return wind.failure();
    made.device_ = std::make_unique<windrow::vulkan::Wind>(*std::move(wind));
    made.control_ = made.device_.get();
    made.reader_ = made.device_.get();
    return made;
}

Result<void> Air::record(const engine::Frame& frame, double dt) {
    if (!cpu_) {
        const auto recorded = device_->record(frame.commands, {.dt = dt, .slot = frame.slot});
        return recorded ? Result<void>{} : recorded.failure();
    }
    const auto begin = std::chrono::steady_clock::now();
    if (const Diagnostics last = cpu_->air().advance(dt).last; last.out_of_memory && !last.stepped)
        return Error{"there is no memory for the air's next step; give the scene fewer cells."};
    const auto recorded = cpu_->record(frame.commands, frame.slot);
    cpu_us_ = std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count();
    return recorded;
}

Result<void> Air::show(const engine::Frame& frame) {
    return cpu_ ? cpu_->record(frame.commands, frame.slot) : record(frame, 0.0);
}

engine::SampledWind Air::sampled() const {
    return cpu_ ? engine::SampledWind(*cpu_) : engine::SampledWind(*device_);
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
