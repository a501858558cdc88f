// A section of `windrow device-report`: what it measures, within its time, into its part of the file.
#pragma once

#include "cli/bench/vulkan/device_contest.h"
#include "cli/console.h"
#include "fluid/parallel.h"
#include "fluid/vulkan/own_device.h"

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace windrow::cli {

using ReportJson = nlohmann::ordered_json;

/// The time that a section has.
class SectionClock {
  public:
    SectionClock(double seconds, std::function<bool()> stopped)
        : seconds_(seconds), start_(std::chrono::steady_clock::now()), stopped_(std::move(stopped)) {}

    [[nodiscard]] double budget() const { return seconds_; } ///< [s]
    [[nodiscard]] double past() const {                      ///< [s]
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }
    [[nodiscard]] double left() const { return seconds_ - past(); } ///< [s] below 0: over
    [[nodiscard]] bool stopped() const { return stopped_(); }       ///< by a signal
    [[nodiscard]] bool over() const { return stopped() || left() <= 0.0; }

  private:
    double seconds_;
    std::chrono::steady_clock::time_point start_;
    std::function<bool()> stopped_;
};

/// What a section works with. Its figures go into `json` as they come, so that a cut section keeps what it has.
struct SectionRun {
    vulkan::OwnDevice& own;
    bool own_draws = false; ///< its queue does; else the device draws nothing
    int device = -1;        ///< its place in the list of `windrow info`; -1: the best
    SectionClock clock;
    bool quick = false;           ///< the smallest set that uses each path once
    std::filesystem::path folder; ///< of the report
    ParallelFor parallel_for{};   ///< of winds on the CPU
    const ReportJson& sections;   ///< those before it
    ReportJson& json;

    /// What the time did not allow, or the device; a sentence.
    void leave_out(const std::string& what) { json["left_out"].push_back(what); }
};

struct ReportSection {
    const char* name;
    const char* text; ///< one line
    double share;     ///< of the report's time
    /// The error is a failure of the device; what its time or the device does not allow is left out instead.
    Result<void> (*run)(SectionRun& run);
};

/// In order.
[[nodiscard]] const std::vector<ReportSection>& report_sections();

/// {median, p99, samples} in microseconds, times `factor`.
[[nodiscard]] ReportJson spread_json(const DeviceSpread& us, double factor = 1.0);
/// As the figures of a table are printed: four digits.
[[nodiscard]] double four_digits(double value);

Result<void> report_facts(SectionRun& run);
Result<void> report_costs(SectionRun& run);
Result<void> report_times(SectionRun& run);
Result<void> report_parity(SectionRun& run);
Result<void> report_queries(SectionRun& run);
Result<void> report_pipelines(SectionRun& run);
Result<void> report_meadow(SectionRun& run);
Result<void> report_pictures(SectionRun& run);

} // namespace windrow::cli
