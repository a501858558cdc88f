// `windrow verify`: runs cases whose truth is known and tells whether the errors are what they must be.
#pragma once

#include "cli/console.h"
#include "cli/verify/verify_request.h"

#include <functional>

namespace windrow::cli {

/// Returns the exit code: well where each case passes. `stop_signal` is asked between resolutions; anything but 0 ends the run
/// there, and no file is made.
[[nodiscard]] int run_verify(const VerifyRequest& request, const Console& console, const std::function<int()>& stop_signal);

} // namespace windrow::cli
