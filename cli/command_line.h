// The command: its flags, and what becomes of them.
#pragma once

#include "cli/console.h"

#include <functional>
#include <variant>

namespace windrow::cli {

/// A command whose flags were read and checked; running it returns the exit code. Or an exit code at once: help, wrong use.
using ReadCommand = std::variant<int, std::function<int()>>;

/// Reads the arguments (the program's name first) and runs nothing. `console` must outlive the command.
[[nodiscard]] ReadCommand read_command_line(int count, const char* const* arguments, const Console& console);

/// Runs `windrow` with these arguments (the program's name first) and returns its exit code.
[[nodiscard]] int run_command_line(int count, const char* const* arguments, const Console& console);

} // namespace windrow::cli
