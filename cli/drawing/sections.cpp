#include "cli/drawing/sections.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

namespace windrow::cli {
namespace {

constexpr double k_outline_width = 2.0; // [px]

/// The pixels of a slice, row by row: where they are, and the distance to the bodies there.
struct PixelGrid {
    const Plane& plane;
    glm::dvec2 low, extent; ///< [m] of the box in the plane
    int width, height;

    [[nodiscard]] glm::dvec2 size() const { return extent / glm::dvec2(width, height); }
    [[nodiscard]] glm::dvec3 world(int column, int row) const {
        const double down = (row + 0.5) / height;
        return plane.to_world(
            {low.x + extent.x * (column + 0.5) / width, low.y + extent.y * (plane.grows_upward() ? 1.0 - down : down)});
    }
    /// First and last pixel along an axis that may be within `reach` of a place.
    [[nodiscard]] std::pair<int, int> span(double place, double reach, bool across) const {
        const int count = across ? width : height, axis = across ? 0 : 1;
        const auto pixel = [&](double at) {
            const double share = (at - low[axis]) / extent[axis];
            return (across || !plane.grows_upward() ? share : 1.0 - share) * count;
        };
        const double a = pixel(place - reach), b = pixel(place + reach);
        constexpr double k_edge = 4.0; // for the outline and its slope
        return {static_cast<int>(std::clamp(std::floor(std::min(a, b)) - k_edge, 0.0, count - 1.0)),
                static_cast<int>(std::clamp(std::ceil(std::max(a, b)) + k_edge, 0.0, count - 1.0))};
    }
};

std::vector<float> distances(std::span<const CutBody> bodies, const PixelGrid& pixels) {
    const std::size_t count = static_cast<std::size_t>(pixels.width) * static_cast<std::size_t>(pixels.height);
    std::vector<float> nearest(count, std::numeric_limits<float>::infinity());
    for (const CutBody& body : bodies) {
        if (body.is_plate())
            continue;
        const glm::dvec2 at = pixels.plane.in_plane(body.named->obstacle.position);
        const auto [left, right] = pixels.span(at.x, body.reach, true);
        const auto [top, bottom] = pixels.span(at.y, body.reach, false);
        for (int row = top; row <= bottom; ++row)
            for (int column = left; column <= right; ++column) {
                float& here = nearest[static_cast<std::size_t>(row) * pixels.width + column];
                here = std::min(here, body.distance(pixels.world(column, row)));
            }
    }
    return nearest;
}

void mix(Image& image, int column, int row, Colour colour, double share) {
    const Rgb8 below = image.at(column, row);
    const std::array above{colour.red, colour.green, colour.blue};
    Rgb8 mixed;
    for (std::size_t channel = 0; channel < 3; ++channel)
        mixed[channel] = static_cast<std::uint8_t>(std::lround((1.0 - share) * below[channel] + share * 255.0 * above[channel]));
    image.set(column, row, mixed);
}

} // namespace

float CutBody::distance(const glm::dvec3& world) const {
    return detail::distance_to(named->obstacle.shape, own(world));
}

bool CutBody::blocks(const glm::dvec3& from, const glm::dvec3& to) const {
    return detail::blocks(named->obstacle.shape, own(from), own(to));
}

std::vector<CutBody> bodies_at(std::span<const NamedObstacle> obstacles, const Plane& plane, const SlicedAir& air) {
    std::vector<CutBody> bodies;
    const glm::dvec3 low = air.origin, high = air.origin + air.extent();
    for (const NamedObstacle& named : obstacles) {
        const Obstacle& obstacle = named.obstacle;
        const double reach = static_cast<double>(glm::length(detail::half_extent(obstacle.shape)));
        const glm::mat3 axes = glm::mat3_cast(glm::normalize(obstacle.orientation));
        // How far the box along its own axes reaches along the normal.
        const glm::vec3 normal(axes[0][plane.across()], axes[1][plane.across()], axes[2][plane.across()]);
        const auto depth = static_cast<double>(glm::dot(glm::abs(normal), detail::half_extent(obstacle.shape)));
        bool near = std::abs(obstacle.position[plane.across()] - plane.position) <= depth;
        for (int axis = 0; axis < 3; ++axis)
            near = near && obstacle.position[axis] >= low[axis] - reach && obstacle.position[axis] <= high[axis] + reach;
        if (near)
            bodies.push_back({&named, glm::transpose(axes), reach});
    }
    return bodies;
}

bool inside_body(std::span<const CutBody> bodies, const glm::dvec3& world) {
    return std::any_of(bodies.begin(), bodies.end(), [&](const CutBody& body) {
        return !body.is_plate() && glm::distance(world, body.named->obstacle.position) <= body.reach &&
               body.distance(world) <= 0.0f;
    });
}

std::optional<std::pair<glm::dvec2, glm::dvec2>> cut_of(const CutBody& plate, const Plane& plane) {
    const auto* const shape = std::get_if<Plate>(&plate.named->obstacle.shape);
    if (shape == nullptr)
        return std::nullopt;
    const glm::mat3 axes = glm::transpose(plate.to_own);
    const auto corner = [&](float x, float y) {
        return plate.named->obstacle.position +
               glm::dvec3(axes * glm::vec3(x * shape->half_size.x, y * shape->half_size.y, 0.0f));
    };
    const std::array corners{corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)};
    std::vector<glm::dvec2> ends;
    for (std::size_t n = 0; n < corners.size(); ++n) {
        const glm::dvec3 &from = corners[n], &to = corners[(n + 1) % corners.size()];
        const double a = from[plane.across()] - plane.position, b = to[plane.across()] - plane.position;
        // A corner in the plane counts as beyond it, so that each cut has two ends.
        if ((a < 0.0) != (b < 0.0))
            ends.push_back(plane.in_plane(from + a / (a - b) * (to - from)));
    }
    return ends.size() == 2 ? std::optional(std::pair(ends[0], ends[1])) : std::nullopt;
}

void paint_sections(Image& slice, std::span<const CutBody> bodies, const Plane& plane, const SlicedAir& air) {
    if (std::all_of(bodies.begin(), bodies.end(), [](const CutBody& body) { return body.is_plate(); }))
        return;
    const PixelGrid pixels{plane, plane.in_plane(air.origin), plane.in_plane(air.extent()), slice.width, slice.height};
    const std::vector<float> nearest = distances(bodies, pixels);
    const auto at = [&](int column, int row) {
        return nearest[static_cast<std::size_t>(std::clamp(row, 0, slice.height - 1)) * slice.width +
                       std::clamp(column, 0, slice.width - 1)];
    };
    const double pixel = std::min(pixels.size().x, pixels.size().y);
    for (int row = 0; row < slice.height; ++row)
        for (int column = 0; column < slice.width; ++column) {
            const double here = static_cast<double>(at(column, row));
            if (!std::isfinite(here))
                continue;
            // The distance in space becomes one in the plane, in pixels: a sphere is cut at a slant.
            const double slope = std::hypot(static_cast<double>(at(column + 1, row) - at(column - 1, row)),
                                            static_cast<double>(at(column, row + 1) - at(column, row - 1)));
            const double rise = std::isfinite(slope) ? 0.5 * slope : pixel; // a pixel
            if (rise < 0.02 * pixel) { // the plane touches a face, or runs along the middle of a body
                mix(slice, column, row, k_obstacle, here <= 0.0 ? 1.0 : 0.0);
                continue;
            }
            const double away = here / rise;
            mix(slice, column, row, k_obstacle, std::clamp(0.5 - away, 0.0, 1.0));
            mix(slice, column, row, k_ink, std::clamp(0.5 * k_outline_width + 0.5 - std::abs(away), 0.0, 1.0));
        }
}

} // namespace windrow::cli
