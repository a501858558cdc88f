// `windrow plants`: how plants bend and move, as a table and as curves.
#pragma once

#include "cli/console.h"

#include <filesystem>

namespace windrow::cli {

/// Prints the table of bends and writes plants.csv into a folder (plot_csv.h). Returns the exit code.
[[nodiscard]] int run_plants(const std::filesystem::path& out, const Console& console);

} // namespace windrow::cli
