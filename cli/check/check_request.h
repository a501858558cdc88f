// What `windrow check` is asked for.
#pragma once

#include <filesystem>
#include <optional>

namespace windrow::cli {

/// [s] A grid is measured so long by default.
inline constexpr double k_check_seconds = 5.0;

struct CheckRequest {
    int device = -1; ///< place in the list of `windrow info`; -1: the best
    double seconds = k_check_seconds;
    bool gpu_validation = false; ///< the stories once more, under GPU-assisted validation
    bool full = false;           ///< all steps of all stories on a software device too
    std::optional<std::filesystem::path> json;
};

} // namespace windrow::cli
