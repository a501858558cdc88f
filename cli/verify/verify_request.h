// What `windrow verify` is asked for.
#pragma once

#include "cli/verify/verify_case.h"
#include "fluid/simd.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace windrow::cli {

struct VerifyRequest {
    std::vector<VerifyCase> cases{};
    bool list = false; ///< tell the cases, run none
    int threads = 0;   ///< 0: one a core
    Simd simd = Simd::best;
    std::optional<std::filesystem::path> json{};
};

} // namespace windrow::cli
