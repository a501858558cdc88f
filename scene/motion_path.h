// Where something is at a time: points that are joined by straight lines.
//
// Straight, not smoothed: between two points the speed is what the points say, nothing overshoots, and a body that stands still
// between two equal points does stand still. Before the first point it waits there, after the last one it stays there.
#pragma once

#include "fluid/result.h"

#include <glm/vec3.hpp>
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
    static constexpr std::size_t k_most_points = 1'000'000;
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

} // namespace windrow::scene
