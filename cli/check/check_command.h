// `windrow check`: one program that tells of any machine's device whether the wind is right on it, and how fast.
#pragma once

#include "cli/check/check_request.h"
#include "cli/console.h"

#include <functional>

namespace windrow::cli {

/// Runs the parity stories under validation where the layer is installed, then the benchmark; prints one report. Returns the exit
/// code: k_exit_out_of_bounds where a story leaves its bounds or the layer spoke.
[[nodiscard]] int run_check(const CheckRequest& request, const Console& console, const std::function<int()>& stop_signal);

} // namespace windrow::cli
