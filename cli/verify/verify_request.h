// What `windrow verify` is asked for.
#pragma once

#include "cli/verify/verify_case.h"
#include "fluid/simd.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace windrow::cli {

struct VerifyRequest {
    std::vector<VerifyCase> cases{};
    bool list = false;           ///< tell the cases, run none
    std::string backend = "cpu"; ///< what runs the air; there is no other yet
    int threads = 0;             ///< 0: one a core
    Simd simd = Simd::best;
    std::optional<std::filesystem::path> json{};
};

} // namespace windrow::cli
