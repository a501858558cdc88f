// Where something is at a time: points that are joined by straight lines.
//
// Straight, not smoothed: between two points the speed is what the points say, nothing overshoots, and a body that stands still
// between two equal points does stand still. Before the first point it waits there, after the last one it stays there.
//
// As a table (CSV): one line a point, `t,x,y,z` in seconds and metres.
//
//     # the player's walk, recorded in the editor
//     t,x,y,z
//     0.0,-30.0,0.0,0.0
//     0.5,-28.5,0.0,0.1
//
// The line of names is optional. Lines that begin with # and empty lines are skipped; spaces around a number do not matter; the
// decimal sign is the point, whatever the locale.
#pragma once

#include "fluid/files/input_budget.h"
#include "fluid/result.h"

#include <filesystem>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace windrow::scene {

/// A place at a time.
struct PathPoint {
    double time = 0.0;        ///< [s]
    glm::dvec3 position{0.0}; ///< [m] world
};

class MotionPath {
  public:
    /// Most points of a path: an hour at 250 a second.
    static constexpr std::size_t k_max_points = 1'000'000;
    /// [m] and [s] Farthest place and time that a path takes.
    static constexpr double k_farthest = 1e9;

    MotionPath() = default;
    /// The caller has checked that there is a point and that times increase.
    explicit MotionPath(std::vector<PathPoint> points) : points_(std::move(points)) {}

    [[nodiscard]] glm::dvec3 at(double time) const;
    [[nodiscard]] const std::vector<PathPoint>& points() const { return points_; }

  private:
    std::vector<PathPoint> points_;
};

/// Parses a table; `name` is the file's, for the sentence, which carries the line: "player.csv:17: ...". Rejects at the first
/// fault.
[[nodiscard]] Result<MotionPath> parse_path_csv(std::string_view text, const std::string& name);

/// Reads a file of at most 64 MiB in `folder`.
[[nodiscard]] Result<MotionPath> read_path_csv(const std::filesystem::path& file, const std::filesystem::path& folder,
                                               detail::InputBudget& budget);

} // namespace windrow::scene
