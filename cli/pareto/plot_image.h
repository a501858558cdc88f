// A plot as pixels; built where windrow draws pictures.
#pragma once

#include "cli/pareto/plot.h"
#include "fluid/result.h"

#include <filesystem>

namespace windrow::cli {

/// A PNG of k_plot_pixels pixels a page unit. Where the disk is to blame the error begins with k_disk_fault (pictures.h).
[[nodiscard]] Result<void> write_plot(const Plot& plot, const std::filesystem::path& file);

inline constexpr double k_plot_pixels = 1.25;

} // namespace windrow::cli
