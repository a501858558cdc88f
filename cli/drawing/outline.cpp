#include "cli/drawing/outline.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace windrow::cli {
namespace {

bool finite_place(glm::dvec2 v) {
    return std::isfinite(v.x) && std::isfinite(v.y);
}
bool finite_place(glm::dvec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Shortens from..to to the part within the rectangle; false where none is (Liang & Barsky 1984).
bool cut_segment(glm::dvec2& from, glm::dvec2& to, const Rect& rect) {
    const glm::dvec2 start = from, way = to - from;
    const double low[] = {rect.x, rect.y}, high[] = {rect.right(), rect.bottom()};
    double enter = 0.0, leave = 1.0;
    for (int axis = 0; axis < 2; ++axis) {
        if (way[axis] == 0.0) {
            if (start[axis] < low[axis] || start[axis] > high[axis])
                return false;
            continue;
        }
        const double a = (low[axis] - start[axis]) / way[axis], b = (high[axis] - start[axis]) / way[axis];
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    if (!(enter <= leave))
        return false;
    from = start + enter * way;
    to = start + leave * way;
    return true;
}

/// Appends the arc about a centre from an angle through `turn`, in the plane.
void add_arc(std::vector<glm::dvec2>& points, glm::dvec2 centre, double radius, double start, double turn, const Panel& panel) {
    // A chord strays from its arc by about 0.1 page units.
    const double radius_on_page = radius * std::max(panel.scale.x, panel.scale.y);
    const double chords = std::sqrt(std::max(radius_on_page, 1.0)) * 3.5 * turn;
    if (!std::isfinite(chords))
        return;
    const int count = static_cast<int>(std::clamp(chords, 12.0, 8192.0));
    for (int index = 0; index <= count; ++index) {
        const double angle = start + turn * index / count;
        points.push_back(panel.to_page(centre + radius * glm::dvec2(std::cos(angle), std::sin(angle))));
    }
}

/// The convex hull, in order (Andrew 1979); points that are no numbers are left out.
std::vector<glm::dvec2> hull(std::vector<glm::dvec2> points) {
    std::erase_if(points, [](glm::dvec2 point) { return !finite_place(point); });
    std::sort(points.begin(), points.end(), [](glm::dvec2 a, glm::dvec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    std::vector<glm::dvec2> corners;
    const auto add = [&](glm::dvec2 point, std::size_t kept) {
        const auto bends = [&] {
            const glm::dvec2 a = corners[corners.size() - 1] - corners[corners.size() - 2], b = point - corners.back();
            return a.x * b.y - a.y * b.x > 0.0;
        };
        while (corners.size() > kept && !bends())
            corners.pop_back();
        corners.push_back(point);
    };
    for (const glm::dvec2 point : points)
        add(point, 1);
    const std::size_t lower = corners.size();
    for (auto point = points.rbegin(); point != points.rend(); ++point)
        if (*point != corners.back())
            add(*point, lower);
    if (corners.size() > 1)
        corners.pop_back(); // the first again
    return corners;
}

/// A cone's two end rings; what they span is the cone as it looks.
std::vector<glm::dvec2> rings_of(const Cone& cone, const glm::dvec3& start, const Panel& panel) {
    const glm::dvec3 axis(cone.axis);
    const auto [a, b] = frame_across(axis);
    std::vector<glm::dvec2> points;
    constexpr int k_corners = 96;
    for (int index = 0; index < k_corners; ++index) {
        const double angle = 2.0 * std::numbers::pi * index / k_corners;
        const glm::dvec3 out = std::cos(angle) * a + std::sin(angle) * b;
        points.push_back(panel.to_page(start + static_cast<double>(cone.start_radius) * out));
        points.push_back(panel.to_page(start + axis + static_cast<double>(cone.end_radius) * out));
    }
    return points;
}

} // namespace

std::pair<glm::dvec3, glm::dvec3> frame_across(const glm::dvec3& axis) {
    const double length = glm::length(axis);
    const glm::dvec3 way = length > 0.0 ? axis / length : glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 other = std::abs(way.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0);
    const glm::dvec3 a = glm::normalize(glm::cross(other, way));
    return {a, glm::cross(way, a)};
}

Runs cut(std::span<const glm::dvec2> points, const Rect& rect) {
    Runs runs;
    bool joined = false; // the last run ends where the next segment begins
    for (std::size_t index = 1; index < points.size(); ++index) {
        glm::dvec2 from = points[index - 1], to = points[index];
        if (!finite_place(from) || !finite_place(to) || !cut_segment(from, to, rect)) {
            joined = false;
            continue;
        }
        if (!joined || from != points[index - 1])
            runs.push_back({from});
        runs.back().push_back(to);
        joined = to == points[index];
    }
    return runs;
}

Rect bounds_of(const Runs& runs, const Rect& rect) {
    glm::dvec2 low(std::numeric_limits<double>::max()), high(std::numeric_limits<double>::lowest());
    for (const auto& run : runs) {
        for (const glm::dvec2 point : run) {
            low = glm::min(low, point);
            high = glm::max(high, point);
        }
    }
    if (low.x > high.x)
        return {};
    low = glm::clamp(low, glm::dvec2(rect.x, rect.y), glm::dvec2(rect.right(), rect.bottom()));
    high = glm::clamp(high, glm::dvec2(rect.x, rect.y), glm::dvec2(rect.right(), rect.bottom()));
    return {low.x, low.y, high.x - low.x, high.y - low.y};
}

std::vector<glm::dvec2> outline_of(const Region& region, const glm::dvec3& centre, const Panel& panel) {
    const glm::dvec2 middle = panel.plane.in_plane(centre);
    const double full = 2.0 * std::numbers::pi;
    std::vector<glm::dvec2> points;
    if (const auto* sphere = std::get_if<Sphere>(&region)) {
        add_arc(points, middle, sphere->radius, 0.0, full, panel);
    } else if (const auto* capsule = std::get_if<Capsule>(&region)) {
        const glm::dvec2 half = panel.plane.in_plane(glm::dvec3(capsule->half_axis));
        const double angle = std::atan2(half.y, half.x);
        add_arc(points, middle + half, capsule->radius, angle - 0.25 * full, 0.5 * full, panel);
        add_arc(points, middle - half, capsule->radius, angle + 0.25 * full, 0.5 * full, panel);
    } else if (const auto* box = std::get_if<AlignedBox>(&region)) {
        const glm::dvec2 half = panel.plane.in_plane(glm::dvec3(box->half_size));
        for (const glm::dvec2 corner : {glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(1, 1), glm::dvec2(-1, 1)})
            points.push_back(panel.to_page(middle + corner * half));
    } else if (const auto* cone = std::get_if<Cone>(&region)) {
        points = hull(rings_of(*cone, centre, panel));
    }
    if (!points.empty())
        points.push_back(points.front());
    return points;
}

bool cuts(const Panel& panel, const Region& region, const glm::dvec3& centre) {
    const int across = panel.plane.across();
    double reach = 0.0;
    if (const auto* cone = std::get_if<Cone>(&region)) {
        const glm::dvec3 axis(cone->axis);
        const double share = glm::length(axis) > 0.0 ? axis[across] / glm::length(axis) : 0.0;
        const double tilt = std::sqrt(std::max(1.0 - share * share, 0.0)); // how far a ring reaches across the plane
        const double start = centre[across], end = start + axis[across];
        return panel.plane.position > std::min(start - tilt * cone->start_radius, end - tilt * cone->end_radius) &&
               panel.plane.position < std::max(start + tilt * cone->start_radius, end + tilt * cone->end_radius);
    }
    if (const auto* sphere = std::get_if<Sphere>(&region))
        reach = sphere->radius;
    else if (const auto* capsule = std::get_if<Capsule>(&region))
        reach = std::abs(capsule->half_axis[across]) + capsule->radius;
    else if (const auto* box = std::get_if<AlignedBox>(&region))
        reach = box->half_size[across];
    return std::abs(centre[across] - panel.plane.position) < reach;
}

PathParts split_path(std::span<const glm::dvec3> points, const glm::dvec3& now, const Panel& panel) {
    // Nearest point of the path to `now`, as a segment and a share of it.
    std::size_t best_segment = 0;
    double best_fraction = 1.0, best_distance = std::numeric_limits<double>::infinity();
    for (std::size_t index = 1; index < points.size(); ++index) {
        const glm::dvec3 way = points[index] - points[index - 1];
        const double length2 = glm::dot(way, way);
        const double share = length2 > 0.0 ? glm::clamp(glm::dot(now - points[index - 1], way) / length2, 0.0, 1.0) : 0.0;
        const glm::dvec3 gap = points[index - 1] + share * way - now;
        if (const double distance = glm::dot(gap, gap); distance < best_distance) {
            best_distance = distance;
            best_segment = index;
            best_fraction = share;
        }
    }

    PathParts parts;
    // Steps shorter than a line is wide show nothing and make long recordings slow.
    const auto add = [](std::vector<glm::dvec2>& run, glm::dvec2 point) {
        if (run.empty() || !finite_place(point) || !finite_place(run.back()) || glm::distance(run.back(), point) > 0.75)
            run.push_back(point);
    };
    if (best_segment == 0) { // one point, or none that is a number
        for (const glm::dvec3& point : points)
            add(parts.past, panel.to_page(point));
        return parts;
    }
    for (std::size_t index = 0; index < best_segment; ++index)
        add(parts.past, panel.to_page(points[index]));
    const glm::dvec3 split = points[best_segment - 1] + best_fraction * (points[best_segment] - points[best_segment - 1]);
    if (finite_place(split)) {
        parts.past.push_back(panel.to_page(split));
        parts.future.push_back(panel.to_page(split));
    }
    for (std::size_t index = best_segment; index < points.size(); ++index)
        add(parts.future, panel.to_page(points[index]));
    if (!parts.future.empty() && !points.empty() && finite_place(points.back()))
        parts.future.push_back(panel.to_page(points.back()));
    return parts;
}

} // namespace windrow::cli
