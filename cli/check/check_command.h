// `windrow check`: one program that says of any machine's device whether the wind is right on it, and how fast.
#pragma once

#include "cases/parity_run.h"
#include "cli/bench/vulkan/device_bench.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace windrow::cli {

/// [s] A grid is measured so long by default.
inline constexpr double k_check_seconds = 5.0;

struct CheckRequest {
    int device = -1; ///< place in the list of `windrow info`; -1: the best
    double seconds = k_check_seconds;
    bool gpu_validation = false; ///< the stories once more, under GPU-assisted validation
    bool full = false;           ///< all steps of all stories on a software device too
    std::optional<std::filesystem::path> json;
};

/// The stories, run under some checks of the validation layer.
struct CheckedStories {
    std::string validation; ///< "core and synchronisation", or why there was none
    bool validated = false;
    std::vector<cases::ParityResult> stories{};
    std::vector<std::string> broken{};   ///< stories that could not run, a sentence each
    std::vector<std::string> messages{}; ///< the layer's first few
    int message_count = 0;               ///< all of them, those at the device's start and end too

    [[nodiscard]] bool pass() const;
};

struct CheckResult {
    vulkan::DeviceFacts device;
    std::vector<CheckedStories> runs{};
    DeviceBenchResult bench{};

    [[nodiscard]] bool pass() const;
};

/// Adds the command; where it is chosen, `chosen` runs it.
void add_check(CLI::App& app, std::function<int()>& chosen, const Console& console);

/// Runs the parity stories under validation where the layer is installed, then the benchmark; prints one report. Returns the exit
/// code: k_exit_out_of_bounds where a story leaves its bounds or the layer spoke.
[[nodiscard]] int run_check(const CheckRequest& request, const Console& console, const std::function<int()>& stop_signal);

void report_check_start(const vulkan::DeviceFacts& device, const Console& console);
/// Before the first story of a run, and after each.
void report_stories_start(const CheckedStories& run, const Console& console);
void report_story(const cases::ParityResult& story, const Console& console);
void report_messages(const CheckedStories& run, const Console& console);
void report_verdict(const CheckResult& result, const Console& console);

[[nodiscard]] std::string check_json(const CheckResult& result);

} // namespace windrow::cli
