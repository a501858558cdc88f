#include "vegetation/program/air.h"

#include <chrono>
#include <utility>

namespace windrow::vegetation::program {

namespace {

bool on_cpu(const engine::Device& device, const AirSettings& settings) {
    return settings.backend.value_or(device.software() ? Backend::cpu : Backend::vulkan) == Backend::cpu;
}

windrow::vulkan::Settings device_settings(const AirSettings& settings) {
    using windrow::vulkan::ReadBack;
    windrow::vulkan::Settings made;
    made.frames_in_flight = engine::k_frames_in_flight;
    made.gusts = settings.gusts;
    made.timestamps = settings.pass_times;
    made.queries = settings.queries ? ReadBack::cells : ReadBack::none;
    made.forces = settings.forces;
    return made;
}

} // namespace

Air::Air(std::unique_ptr<ThreadPool> threads, std::unique_ptr<engine::CpuWind> wind)
    : threads_(std::move(threads)), cpu_(std::move(wind)), control_(&cpu_->air()), reader_(&cpu_->air()) {}

Air::Air(windrow::vulkan::Wind wind)
    : device_(std::make_unique<windrow::vulkan::Wind>(std::move(wind))), control_(device_.get()), reader_(device_.get()) {}

Result<Air> Air::create(engine::Device& device, Config config, const AirSettings& settings,
                        const std::shared_ptr<const Wind>& outer) {
    if (on_cpu(device, settings)) {
        auto threads = std::make_unique<ThreadPool>();
        config.parallel_for = threads->parallel_for();
        auto wind = Wind::create(config, outer);
        if (!wind)
            return wind.failure();
        auto shown = engine::CpuWind::create(device, *std::move(wind));
        return shown ? Result<Air>(Air(std::move(threads), *std::move(shown))) : shown.failure();
    }
    auto wind = windrow::vulkan::Wind::create(device.host(), config, device_settings(settings), outer);
    return wind ? Result<Air>(Air(*std::move(wind))) : wind.failure();
}

Result<Air> Air::load(engine::Device& device, std::span<const std::byte> bytes, const AirSettings& settings,
                      const std::shared_ptr<const Wind>& outer) {
    if (on_cpu(device, settings)) {
        auto threads = std::make_unique<ThreadPool>();
        auto wind = Wind::load(bytes, threads->parallel_for(), outer);
        if (!wind)
            return wind.failure();
        auto shown = engine::CpuWind::create(device, *std::move(wind));
        return shown ? Result<Air>(Air(std::move(threads), *std::move(shown))) : shown.failure();
    }
    auto wind = windrow::vulkan::Wind::load(device.host(), bytes, device_settings(settings), outer);
    return wind ? Result<Air>(Air(*std::move(wind))) : wind.failure();
}

Result<std::vector<std::byte>> Air::save(engine::Frames& frames) {
    if (cpu_)
        return cpu_->air().save();
    const auto frame = frames.begin();
    if (!frame)
        return frame.failure();
    const auto recorded = device_->record(frame->commands, {.dt = 0.0, .slot = frame->slot, .save = true});
    const auto done = frames.finish(*frame);
    if (!recorded)
        return recorded.failure();
    if (!done)
        return done.failure();
    (void)device_->collect(frame->slot);
    return device_->saved();
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
