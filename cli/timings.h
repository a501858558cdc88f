// What the steps of a run cost and what they report, gathered over the run.
#pragma once

#include "fluid/diagnostics.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace windrow::cli {

/// Stages of the step: the rows of StageTimes without the last, the whole step.
inline constexpr std::size_t k_stage_count = StageTimes::rows().size() - 1;

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
    /// Motors that reached no air, at least so many in every step.
    [[nodiscard]] int motors_lost() const { return motors_lost_.value_or(0); }
    [[nodiscard]] std::int64_t jumps() const { return jumps_; }
    [[nodiscard]] std::int64_t fast_turns() const { return fast_turns_; } ///< steps with one
    [[nodiscard]] std::int64_t filled() const { return filled_; }         ///< steps with an obstacle that fills the box
    [[nodiscard]] std::int64_t sealed() const { return sealed_; }         ///< steps with a sealed room that changes
    [[nodiscard]] double first_repair_time() const { return first_repair_time_.value_or(0.0); } ///< [s]
    /// [s] Wall-clock time of all steps.
    [[nodiscard]] double solver_seconds() const;

    /// Smallest, median, 99 % quantile [ms] and share of every stage, a line each: of the steps that were awake, and one line for
    /// those asleep.
    [[nodiscard]] std::string table() const;

    /// All figures, into an archive or out of one (fluid/core/archive.h).
    static void pass(auto& archive, auto& timings);

  private:
    std::array<std::vector<float>, k_stage_count + 1> stage_ms_; ///< of steps that were awake; the last: whole steps
    std::vector<float> asleep_ms_;                               ///< whole steps
    std::int64_t substeps_ = 0;
    float largest_cfl_ = 0.0f;
    float largest_speed_ = 0.0f;
    std::int64_t limited_cells_ = 0;
    std::int64_t limited_steps_ = 0;
    std::int64_t repaired_cells_ = 0;
    std::int64_t jumps_ = 0, fast_turns_ = 0, filled_ = 0, sealed_ = 0;
    std::optional<int> motors_lost_{};
    std::optional<double> first_repair_time_;
};

void Timings::pass(auto& archive, auto& timings) {
    for (auto& stage : timings.stage_ms_)
        archive(stage);
    archive(timings.asleep_ms_, timings.substeps_, timings.largest_cfl_, timings.largest_speed_, timings.limited_cells_,
            timings.limited_steps_, timings.repaired_cells_, timings.jumps_, timings.fast_turns_, timings.filled_,
            timings.sealed_, timings.motors_lost_, timings.first_repair_time_);
}

/// The value that a share `q` of the values lies at or below: the nearest rank. 0 without values.
[[nodiscard]] float quantile(std::vector<float> values, double q);

/// The columns, ended by a line break: step, time_s and each figure of the report, named with its unit (max_speed_m_s).
[[nodiscard]] std::string timings_header();
/// One row, ended by a line break; figures in their shortest exact form, flags as 0 and 1.
[[nodiscard]] std::string timings_row(std::int64_t step, double time, const Diagnostics& diagnostics);

} // namespace windrow::cli
