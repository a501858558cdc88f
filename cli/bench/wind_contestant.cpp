#include "cli/bench/wind_contestant.h"

#include "cases/jets.h"

#include <algorithm>
#include <utility>

namespace windrow::cli {

using namespace cases;
namespace {

// Stands in for a pool and counts what it is asked for.
struct LoopCounter {
    int loops = 0;

    static void run(void* context, int count, void (*task)(void*, int), void* argument) {
        ++static_cast<LoopCounter*>(context)->loops;
        for (int index = 0; index < count; ++index)
            task(argument, index);
    }
};

} // namespace

Config bench_config(glm::ivec3 cells, Scheme scheme, Simd simd, const ParallelFor& parallel_for) {
    const Box box = bench_box(cells);
    return {.cells = box.cells,
            .cell_size = box.cell_size,
            .boundaries = box.boundaries,
            .ambient = k_bench_ambient,
            .scheme = scheme,
            .simd = simd,
            .parallel_for = parallel_for};
}

WindContestant::WindContestant(std::unique_ptr<BackendWind> wind, std::span<const glm::vec4> flow)
    : wind_(std::move(wind)), flow_(flow), age_(k_steps_of_flow) {}

void WindContestant::refresh() {
    if (age_ < k_steps_of_flow)
        return;
    static_cast<void>(wind_->set_velocity(flow_)); // of the box's size
    age_ = 0;
    step();
}

void WindContestant::step() {
    last_ = wind_->step(k_bench_dt);
    ++age_;
}

void WindContestant::note() {
    for (std::size_t n = 0; n < stage_ms_.size(); ++n)
        stage_ms_[n].push_back(static_cast<float>(last_.times_ms.*StageTimes::rows()[n].member));
    largest_cfl_ = std::max(largest_cfl_, last_.cfl);
    at_obstacles_.push_back(static_cast<float>(last_.times_ms.obstacles / std::max(last_.times_ms.total, 1e-9)));
    most_solves_ = std::max(most_solves_, last_.pressure_solves);
    max_substeps_ = std::max(max_substeps_, last_.substeps);
    slept_ = slept_ || last_.asleep;
}

double WindContestant::stages_at_obstacles() const {
    return quantile(at_obstacles_, 0.5);
}

Contestant WindContestant::contestant() {
    return {.run = [this] { step(); }, .prepare = [this] { refresh(); }, .note = [this] { note(); }};
}

SchemeResult WindContestant::result(const char* name) const {
    SchemeResult result{.name = name};
    for (std::size_t n = 0; n < stage_ms_.size(); ++n)
        result.stages_ms[n] = spread_of(stage_ms_[n]);
    result.bytes_per_cell = static_cast<double>(wind_->reader().memory_bytes()) / static_cast<double>(wind_->box().cell_count());
    result.largest_cfl = largest_cfl_;
    result.max_substeps = max_substeps_;
    result.slept = slept_;
    return result;
}

int count_loops(const Config& config, std::span<const glm::vec4> flow) {
    LoopCounter counter;
    Config counted = config;
    counted.parallel_for = {.run = LoopCounter::run, .context = &counter};
    auto wind = Wind::create(counted);
    if (!wind)
        return 0;
    static_cast<void>(wind->set_velocity(flow));
    wind->step(k_bench_dt); // starts the history
    counter.loops = 0;
    wind->step(k_bench_dt);
    return counter.loops;
}

} // namespace windrow::cli
