// Many windows stepped at once, as a server with as many players does it: each volume by one thread, the volumes spread over the
// threads. One loop a step instead of one for each pass.
#pragma once

#include "cli/bench/bench_result.h"
#include "fluid/parallel.h"
#include "fluid/result.h"
#include "fluid/simd.h"

#include <cstdint>
#include <functional>
#include <optional>

namespace windrow::cli {

/// [bytes]
[[nodiscard]] std::uint64_t volume_bench_bytes(int volumes);

struct VolumesRequest {
    int volumes = 1;
    int threads = 1;
    Simd simd = Simd::best;
    double seconds = 1.0;
};

/// Nothing inside where `stopped` said so.
[[nodiscard]] Result<std::optional<VolumesResult>> measure_volumes(const VolumesRequest& request, const ParallelFor& parallel_for,
                                                                   const std::function<bool()>& stopped);

} // namespace windrow::cli
