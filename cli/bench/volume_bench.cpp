#include "cli/bench/volume_bench.h"

#include "cli/bench/bench_request.h"
#include "cli/bench/contest.h"
#include "cli/bench/jets.h"
#include "cli/bench/wind_contestant.h"
#include "cli/machine.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace windrow::cli {

std::uint64_t volume_bench_bytes(int volumes) {
    constexpr std::uint64_t k_bytes_a_cell = 192; // as `run` counts
    return k_bytes_a_cell * bench_box(k_volume_cells).cell_count() * static_cast<std::uint64_t>(volumes);
}

Result<std::optional<VolumesResult>> measure_volumes(const VolumesRequest& request, const ParallelFor& parallel_for,
                                                     const std::function<bool()>& stopped) {
    const std::vector<glm::vec4> flow = jets(bench_box(k_volume_cells));
    const Config config = bench_config(k_volume_cells, Scheme::second_order, request.simd, {});
    std::vector<WindContestant> winds;
    winds.reserve(static_cast<std::size_t>(request.volumes));
    std::size_t bytes = 0;
    for (int n = 0; n < request.volumes; ++n) {
        if (stopped())
            return std::optional<VolumesResult>();
        auto wind = Wind::create(config);
        if (!wind)
            return Error{wind.error()};
        bytes = wind->memory_bytes();
        winds.emplace_back(std::move(*wind), flow);
    }

    Contest contest;
    const std::size_t all = contest.add(
        {.run = [&] { parallel_for(request.volumes, [&](int n) { winds[static_cast<std::size_t>(n)].step(); }); },
         .prepare = [&] { parallel_for(request.volumes, [&](int n) { winds[static_cast<std::size_t>(n)].refresh(); }); }});
    if (!contest.hold(request.seconds, stopped))
        return std::optional<VolumesResult>();

    VolumesResult result{.volumes = request.volumes, .round_ms = contest.milliseconds(all), .bytes_per_volume = bytes};
    result.volumes_per_s = 1000.0 * request.volumes / result.round_ms.median;
    result.volumes_per_s_core = result.volumes_per_s / std::min({request.threads, request.volumes, usable_cores()});
    return std::optional(result);
}

} // namespace windrow::cli
