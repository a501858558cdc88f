#include "cli/bench/vulkan/wind_recordings.h"

#include "fluid/vulkan/wind_state.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace windrow::cli {

using namespace cases;
namespace {

using vulkan::Pass;

// How often a kind of pass does work in a step of one sub-step, without motors, viscosity or a shift of the box.
int ran_in_a_step(const vulkan::Passes& passes, Pass pass) {
    const auto stages = passes.substep(DiffusionMethod::none);
    const auto in_substep =
        std::count_if(stages.begin(), stages.end(), [&](const vulkan::Passes::Stage& stage) { return stage.pass == pass; });
    const bool once = pass == Pass::residual || pass == Pass::show;
    return static_cast<int>(in_substep) + (once ? 1 : 0);
}

bool is_of_read_back(std::string_view name) {
    return name == name_of(Pass::report) || name == name_of(Pass::read_cells) || name == name_of(Pass::read_points);
}

} // namespace

WindRecordings::WindRecordings(vulkan::Wind wind, RecordingPlan plan)
    : wind_(std::move(wind)), plan_(std::move(plan)), age_(plan_.steps_of_flow) {}

void WindRecordings::record(VkCommandBuffer commands, int slot) {
    if (plan_.before_step)
        plan_.before_step(wind_, static_cast<double>(all_steps_ + 1) * plan_.dt);
    const auto report = wind_.record_step(commands, {.dt = plan_.dt, .slot = slot});
    if (!report) {
        if (recorded_)
            recorded_ = report.failure();
        return;
    }
    max_substeps_ = std::max(max_substeps_, report->substeps);
    slept_ = slept_ || report->asleep;
    ++age_;
    ++all_steps_;
}

DeviceContestant WindRecordings::contestant() {
    return {.warm =
                [this](VkCommandBuffer commands) {
                    if (age_ >= plan_.steps_of_flow && !plan_.flow.empty()) {
                        static_cast<void>(wind_.set_velocity(plan_.flow)); // of the box's size
                        age_ = 0;
                    }
                    record(commands, 0);
                },
            .run =
                [this](VkCommandBuffer commands, const DeviceContestant::Mark& mark) {
                    wind_.state().before_read_back = mark;
                    record(commands, 1);
                    wind_.state().before_read_back = {};
                },
            .note = [this] { note(); }};
}

void WindRecordings::note() {
    dispatches_ = wind_.dispatches();
    barriers_ = wind_.barriers();
    static_cast<void>(wind_.collect(1)); // the turn is over: its times are in
    const auto times = wind_.pass_times();
    if (!times)
        return;
    double sum = 0.0;
    for (const vulkan::PassTimes::Pass& pass : times->passes) {
        Samples& samples = passes_[pass.name];
        samples.us.push_back(static_cast<float>(pass.us));
        samples.dispatches = pass.dispatches;
        sum += is_of_read_back(pass.name) ? 0.0 : pass.us;
    }
    timed_.push_back(static_cast<float>(times->whole_us - times->read_back_us));
    between_.push_back(static_cast<float>(times->whole_us - times->read_back_us - sum));
    read_back_.push_back(static_cast<float>(times->read_back_us));
}

DeviceStepResult WindRecordings::result(const char* name) const {
    return {.name = name, .dispatches = dispatches_, .barriers = barriers_};
}

void WindRecordings::add_passes(DeviceGridResult& result) const {
    const vulkan::Air& air = *wind_.state().cells.air;
    for (std::size_t n = 0; n < vulkan::k_passes; ++n) {
        const auto pass = static_cast<Pass>(n);
        const auto found = passes_.find(name_of(pass));
        if (found == passes_.end() || reads_back(pass))
            continue;
        const int ran = ran_in_a_step(air.passes(), pass);
        result.passes.push_back({.name = found->first,
                                 .us = device_spread(found->second.us),
                                 .dispatches = found->second.dispatches,
                                 .dispatches_ran = ran,
                                 .bytes = static_cast<std::uint64_t>(ran) * air.passes().bytes(pass)});
        result.pass_bytes += result.passes.back().bytes;
    }
    result.read_back_bytes = vulkan::Air::slot_bytes(air.reads());
    result.timed_us = device_spread(timed_);
    result.between_us = device_spread(between_);
    result.read_back_us = device_spread(read_back_);
}

Result<void> WindRecordings::compare(vulkan::OwnDevice& own, windrow::Wind& cpu, DeviceGridResult& result) {
    // A recording without time takes what the last one read back.
    const auto ran = own.run([&](VkCommandBuffer commands) {
        if (const auto paused = wind_.record(commands, {.dt = 0.0, .slot = 1}); recorded_ && !paused)
            recorded_ = paused.failure();
    });
    if (!ran || !recorded_)
        return ran ? recorded_ : ran;
    if (auto set = cpu.set_velocity(plan_.flow); !set)
        return set;
    for (int n = 0; n < age_; ++n)
        cpu.step(plan_.dt);
    const auto view = wind_.queried();
    if (!view)
        return Error{"nothing was read back from the device."};
    const auto device = view->field(), host = cpu.field();
    double worst = 0.0, largest = 1e-30;
    for (std::size_t n = 0; n < host.size(); ++n)
        for (int axis = 0; axis < 3; ++axis) {
            const double apart = std::abs(static_cast<double>(device[n][axis]) - static_cast<double>(host[n][axis]));
            worst = std::isfinite(apart) ? std::max(worst, apart) : apart;
            largest = std::max(largest, std::abs(static_cast<double>(host[n][axis])));
            if (!std::isfinite(worst))
                return Error{"the device's velocities are not finite."};
        }
    result.parity = worst / largest;
    result.parity_steps = age_;
    result.all_steps = all_steps_;
    return {};
}

} // namespace windrow::cli
