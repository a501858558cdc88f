// `windrow info`: what this build and this machine can do, for a bug report.
#pragma once

#include "cli/console.h"

#include <string>

namespace windrow::cli {

/// "windrow 0.1.0"
[[nodiscard]] std::string version_line();

int tell_info(const Console& console);

} // namespace windrow::cli
