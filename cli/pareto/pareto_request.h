// What `windrow pareto` is asked for.
#pragma once

#include "cli/backend/backend_request.h"
#include "cli/pareto/pareto_flow.h"
#include "fluid/simd.h"

#include <filesystem>
#include <vector>

namespace windrow::cli {

struct ParetoRequest {
    std::vector<ParetoFlow> flows{};
    std::vector<double> cfls{};
    bool one_thread_too = true; ///< times with one thread beside those with all
    double seconds = 1.0;       ///< [s] a grid is timed at least so long, up to ten times as long where samples are few
    BackendRequest backend{};
    int threads = 0; ///< 0: one a core
    Simd simd = Simd::best;
    std::filesystem::path out;
};

} // namespace windrow::cli
