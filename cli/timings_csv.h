// A run as a table: one row a step, every figure of Diagnostics.
#pragma once

#include "cli/output_file.h"
#include "fluid/diagnostics.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace windrow::cli {

/// The names of the columns, with units, ended by a line break.
[[nodiscard]] std::string timings_header();
/// One row, ended by a line break; figures in their shortest exact form.
[[nodiscard]] std::string timings_row(std::int64_t step, double time, const Diagnostics& diagnostics);

} // namespace windrow::cli
