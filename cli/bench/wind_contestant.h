// The library's own step as a contestant: keeps its flow alive and gathers what its steps report.
#pragma once

#include "cases/backend_wind.h"
#include "cli/bench/bench_command.h"

#include <array>
#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <vector>

namespace windrow::cli {

/// The config of all measurements: a default wind, but for box, mean wind and scheme.
[[nodiscard]] Config bench_config(glm::ivec3 cells, Scheme scheme, Simd simd, const ParallelFor& parallel_for);

class WindContestant {
  public:
    /// `flow` outlives the contestant.
    WindContestant(std::unique_ptr<cases::BackendWind> wind, std::span<const glm::vec4> flow);

    /// Steps this object, which then stays where it is.
    [[nodiscard]] Contestant contestant();
    /// All but the times of whole steps and the ratios, which the contest knows, and the loops.
    [[nodiscard]] SchemeResult result(const char* name) const;

    /// Sets the flow again where it has lived for long enough. A first step has no history and costs less, so one is made.
    void refresh();
    void step();

    [[nodiscard]] const cases::BackendWind& wind() const { return *wind_; }
    [[nodiscard]] double stages_at_obstacles() const; ///< median of their time over that of the step
    [[nodiscard]] int most_solves() const { return most_solves_; }

  private:
    void note();

    std::unique_ptr<cases::BackendWind> wind_;
    std::span<const glm::vec4> flow_;
    int age_; ///< steps since the flow was set
    Diagnostics last_;
    std::array<std::vector<float>, k_stage_count> stage_ms_;
    float largest_cfl_ = 0.0f;
    std::vector<float> at_obstacles_{}; ///< time over that of the step
    int max_substeps_ = 0, most_solves_ = 0;
    bool slept_ = false;
};

/// Parallel loops in one step.
[[nodiscard]] int count_loops(const Config& config, std::span<const glm::vec4> flow);

} // namespace windrow::cli
