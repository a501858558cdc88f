// The command: its flags, and what becomes of them.
#pragma once

#include "cli/console.h"

namespace windrow::cli {

/// Runs `windrow` with these arguments (the program's name first) and returns its exit code.
[[nodiscard]] int run_command_line(int count, const char* const* arguments, const Console& console);

} // namespace windrow::cli
