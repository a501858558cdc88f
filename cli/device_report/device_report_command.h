// `windrow device-report`: one program that measures any machine's Vulkan device and keeps all figures in a folder.
#pragma once

#include "cli/console.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace windrow::cli {

/// [s] Of a whole report, and of a quick one. A quick report ends within three minutes on a software device.
inline constexpr double k_report_seconds = 600.0, k_quick_report_seconds = 90.0;

struct DeviceReportRequest {
    std::optional<std::filesystem::path> out;
    int device = -1; ///< place in the list of `windrow info`; -1: the best
    bool quick = false;
    double seconds = 0.0;            ///< for all sections together; 0: by `quick`
    std::vector<std::string> only{}; ///< names of sections; none: all. The facts are in every report.
};

/// Adds the command; where it is chosen, `chosen` runs it.
void add_device_report(CLI::App& app, std::function<int()>& chosen, const Console& console);

/// Writes report.json after each section, so that a run that is cut keeps what it has, and report.md at the end. Returns the exit
/// code: k_exit_out_of_bounds where the device leaves the bounds of parity, k_exit_machine where there is no device.
[[nodiscard]] int run_device_report(const DeviceReportRequest& request, const Console& console,
                                    const std::function<int()>& stop_signal);

} // namespace windrow::cli
