// What the stages of frames took on the device: mean, median and 99 %, and each frame as CSV.
#pragma once

#include "scene/part.h"
#include "vegetation/program/scene_renderer.h"

#include <filesystem>
#include <string>
#include <vector>

namespace windrow::vegetation::program {

/// Over the frames that were added.
struct StageFigures {
    std::string name;
    double mean = 0.0, median = 0.0, max = 0.0; ///< [ms]; `max`: 99 % of the frames took no more
};

class StageTable {
  public:
    StageTable() = default;
    /// Notes what memory the figures belong to.
    explicit StageTable(const SceneRenderer& scene_renderer);

    /// Keeps the rows of frames from `begun` on, before `end`, of the table of a run that goes on here; no such file: none. Rows of
    /// other stages are not kept.
    [[nodiscard]] windrow::Result<void> keep(const std::filesystem::path& file, std::int64_t begun, std::int64_t end);
    void add(std::int64_t frame, const std::vector<render::StageTime>& times);
    /// Stage by stage in the order of their first frame, then "frame", their sum; empty where the device counts no time.
    [[nodiscard]] std::vector<StageFigures> figures() const;
    /// As a table for a terminal.
    [[nodiscard]] std::string text() const;
    /// A line a frame: frame, then each stage in ms.
    [[nodiscard]] windrow::Result<void> write(const std::filesystem::path& file) const;
    /// "times.csv", and of a part "times.2-of-8.csv".
    [[nodiscard]] static std::string name(const windrow::scene::Part& part);
    /// Makes one table of those of all parts in a folder, by the frames, and removes them; none: nothing.
    [[nodiscard]] static windrow::Result<void> join(const std::filesystem::path& folder);

  private:
    std::string what_{};
    std::string kept_head_{}, kept_rows_{}; ///< lines as they were written
    std::vector<std::string> names_{};
    std::vector<std::int64_t> frames_{};
    std::vector<std::vector<double>> rows_{}; ///< [ms]
};

} // namespace windrow::vegetation::program
