// What `windrow verify` is asked for.
#pragma once

#include "cli/backend/backend_request.h"
#include "cli/verify/verify_case.h"
#include "fluid/simd.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace windrow::cli {

struct VerifyRequest {
    std::vector<VerifyCase> cases{};
    std::vector<std::string> left_out{};       ///< cases that the backend cannot run
    std::span<const NotMet> known = not_met(); ///< rows that miss their bounds
    bool list = false;                         ///< tell the cases, run none
    BackendRequest backend{};
    int threads = 0; ///< 0: one a core
    Simd simd = Simd::best;
    std::optional<std::filesystem::path> json{};
    std::optional<std::filesystem::path> plots{}; ///< a folder
};

} // namespace windrow::cli
