// What the steps of a run cost and what they report, gathered over the run.
#pragma once

#include "fluid/diagnostics.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace windrow::cli {

/// A stage of the step, as StageTimes has it. The last is the whole step.
struct StageColumn {
    const char* name;
    double StageTimes::*value;
};
inline constexpr std::array k_stages = {
    StageColumn{"sources", &StageTimes::sources},       StageColumn{"ambient", &StageTimes::ambient},
    StageColumn{"diffusion", &StageTimes::diffusion},   StageColumn{"advection", &StageTimes::advection},
    StageColumn{"projection", &StageTimes::projection}, StageColumn{"report", &StageTimes::report},
    StageColumn{"total", &StageTimes::total},
};

class Timings {
  public:
    void add(double time, const Diagnostics& diagnostics);

    [[nodiscard]] std::int64_t steps() const { return static_cast<std::int64_t>(stage_ms_.back().size() + asleep_ms_.size()); }
    [[nodiscard]] std::int64_t substeps() const { return substeps_; }
    [[nodiscard]] std::int64_t steps_asleep() const { return static_cast<std::int64_t>(asleep_ms_.size()); }
    /// [ms] Median of what a step cost awake and asleep; 0 without such steps.
    [[nodiscard]] float awake_ms() const;
    [[nodiscard]] float asleep_ms() const;
    [[nodiscard]] float largest_cfl() const { return largest_cfl_; }
    [[nodiscard]] float largest_speed() const { return largest_speed_; } ///< [m/s]
    [[nodiscard]] std::int64_t limited_cells() const { return limited_cells_; }
    [[nodiscard]] std::int64_t limited_steps() const { return limited_steps_; }
    [[nodiscard]] std::int64_t repaired_cells() const { return repaired_cells_; }
    [[nodiscard]] double first_repair_time() const { return first_repair_time_.value_or(0.0); } ///< [s]
    /// [s] Wall-clock time of all steps.
    [[nodiscard]] double solver_seconds() const;

    /// Smallest, median, 99 % quantile [ms] and share of every stage, a line each: of the steps that were awake, and one line for
    /// those asleep.
    [[nodiscard]] std::string table() const;

  private:
    std::array<std::vector<float>, k_stages.size()> stage_ms_; ///< of steps that were awake
    std::vector<float> asleep_ms_;                             ///< whole steps
    std::int64_t substeps_ = 0;
    float largest_cfl_ = 0.0f;
    float largest_speed_ = 0.0f;
    std::int64_t limited_cells_ = 0;
    std::int64_t limited_steps_ = 0;
    std::int64_t repaired_cells_ = 0;
    std::optional<double> first_repair_time_;
};

/// The value that a share `q` of the values lies at or below: the nearest rank. 0 without values.
[[nodiscard]] float quantile(std::vector<float> values, double q);

/// The names of the columns, with units, ended by a line break.
[[nodiscard]] std::string timings_header();
/// One row, ended by a line break; figures in their shortest exact form.
[[nodiscard]] std::string timings_row(std::int64_t step, double time, const Diagnostics& diagnostics);

} // namespace windrow::cli
