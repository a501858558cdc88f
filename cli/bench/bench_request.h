// What `windrow bench` is asked for.
#pragma once

#include "cli/backend/backend_request.h"
#include "fluid/simd.h"

#include <filesystem>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

namespace windrow::cli {

inline constexpr glm::ivec3 k_bench_grids[] = {{32, 16, 32}, {64, 32, 64}, {128, 64, 128}};
/// The window of one player, as Config has it by default.
inline constexpr glm::ivec3 k_volume_cells{32, 16, 32};
/// Most volumes at once; memory ends earlier.
inline constexpr int k_most_volumes = 65536;
/// [s] A grid, or a number of volumes, is measured at least so long by default.
inline constexpr double k_bench_seconds = 5.0;

struct BenchRequest {
    std::vector<glm::ivec3> grids; ///< none: only volumes are measured
    std::vector<int> volumes;
    BackendRequest backend{};
    int threads = 0; ///< 0: one a core
    Simd simd = Simd::best;
    double seconds = k_bench_seconds;
    std::optional<std::filesystem::path> json;
};

} // namespace windrow::cli
