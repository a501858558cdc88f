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
    /// The same in a table: a row with its names alone and "left out: time".
    void leave_out_row(const char* table, ReportJson names, const char* why) {
        names["left_out"] = std::string("left out: ") + why;
        json[table].push_back(std::move(names));
    }
};

struct ReportSection {
    const char* name;
    const char* text; ///< one line
    double share;     ///< of the report's time
    /// The error is a failure of the device; what its time or the device does not allow is left out instead.
    Result<void> (*run)(SectionRun& run);
};

// --- Text: printed as each section ends, and as Markdown at the end (report_text.cpp) ----------------------------------------

/// {median, p99, samples} in microseconds, times `factor`.
[[nodiscard]] ReportJson spread_json(const DeviceSpread& us, double factor = 1.0);
/// As the figures of a table are printed: four digits.
[[nodiscard]] double four_digits(double value);
/// The figures of a section: a line for each value, a table for each list of objects, whose keys are the columns.
[[nodiscard]] std::string section_text(const ReportJson& section);
/// The page of a whole report: the device, times beside the copy floor, parity, pictures. Sections that did not run are named.
[[nodiscard]] std::string report_page(const ReportJson& report);
/// One row a grid for a README; a software device's figures are called so.
[[nodiscard]] std::string readme_table(const ReportJson& report);

// --- Drivers: where Vulkan's loader and drivers are looked for on this machine (driver_search.cpp) -------------------------------

/// Names the drivers of folders that a loader does not search by itself in VK_ADD_DRIVER_FILES, unless the environment names
/// drivers already.
void add_drivers();
/// For a loader that is older than that variable, after no device was found: the same in VK_DRIVER_FILES. False where there is
/// nothing to add.
[[nodiscard]] bool name_drivers_only();
/// What was tried and what is there, a place each: the loader's names, the variables that name drivers, folders with their files.
[[nodiscard]] ReportJson places_tried();

// --- Sections -------------------------------------------------------------------------------------------------------------------

/// In order.
[[nodiscard]] const std::vector<ReportSection>& report_sections();

Result<void> report_facts(SectionRun& run);
Result<void> report_costs(SectionRun& run);
Result<void> report_times(SectionRun& run);
Result<void> report_parity(SectionRun& run);
Result<void> report_queries(SectionRun& run);
Result<void> report_pipelines(SectionRun& run);
Result<void> report_meadow(SectionRun& run);
Result<void> report_pictures(SectionRun& run);

} // namespace windrow::cli
