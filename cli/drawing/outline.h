// Lines of things in the world, brought to the page and cut at a panel.
//
// Cairo holds coordinates in 24 bits before the point: a motor 10^6 m away or of that size has to be cut here, in double.
#pragma once

#include "cli/drawing/layout.h"
#include "fluid/motors.h"

#include <glm/vec2.hpp>
#include <span>
#include <utility>
#include <vector>

namespace windrow::cli {

/// Runs of points that are joined by straight lines, on the page.
using Runs = std::vector<std::vector<glm::dvec2>>;

/// The parts of a polyline within a rectangle; a point that is no number breaks the line.
[[nodiscard]] Runs cut(std::span<const glm::dvec2> points, const Rect& rect);

/// The smallest rectangle around the runs that lies within `rect`; of no size where there are none.
[[nodiscard]] Rect bounds_of(const Runs& runs, const Rect& rect);

/// Two vectors of length 1 across an axis, so that a, b and the axis are right-handed.
[[nodiscard]] std::pair<glm::dvec3, glm::dvec3> frame_across(const glm::dvec3& axis);

/// A motor's region as it looks along the plane's normal, closed, in page units; beyond the panel too.
[[nodiscard]] std::vector<glm::dvec2> outline_of(const Region& region, const glm::dvec3& centre, const Panel& panel);

/// Whether the panel's plane cuts the region; otherwise it lies before or behind it.
[[nodiscard]] bool cuts(const Panel& panel, const Region& region, const glm::dvec3& centre);

/// A path as far as `now` and from there on, in page units. The split is at the path's point nearest to `now`.
struct PathParts {
    std::vector<glm::dvec2> past, future;
};
[[nodiscard]] PathParts split_path(std::span<const glm::dvec3> points, const glm::dvec3& now, const Panel& panel);

} // namespace windrow::cli
