#include "cli/drawing/slice.h"

#include "cli/drawing/colour_map.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace windrow::cli {
namespace {

bool finite(glm::vec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

float value_of(glm::vec3 velocity, Quantity quantity) {
    // hypot, since a speed near the largest float would overflow as a sum of squares.
    return quantity == Quantity::speed ? std::hypot(velocity.x, velocity.y, velocity.z)
                                       : velocity[static_cast<int>(quantity) - 1];
}

/// Places of the lattice on one axis of the box.
std::vector<double> lattice(double low, double extent, double cell_size, double spacing) {
    // The box moves by whole cells: what its corner has beyond whole cells stays, and so does the lattice. The quarter keeps
    // round-off from throwing a corner that lies on a cell or on half a cell to the other side.
    const double phase = low - cell_size * std::floor(low / cell_size + 0.25);
    std::vector<double> places;
    const double first = std::ceil((low - phase) / spacing - 0.5 - 1e-6);
    for (double step = first; step < first + 1e4; ++step) {
        const double place = phase + (step + 0.5) * spacing;
        if (place > low + extent * (1.0 + 1e-6))
            break;
        // An arrow on the very edge would be cut in half.
        if (place > low + 0.25 * std::min(spacing, extent) && place < low + extent - 0.25 * std::min(spacing, extent))
            places.push_back(place);
    }
    if (places.empty())
        places.push_back(low + 0.5 * extent);
    return places;
}

} // namespace

glm::dvec3 Plane::to_world(glm::dvec2 in_plane_position) const {
    glm::dvec3 world(position);
    world[right()] = in_plane_position.x;
    world[along_height()] = in_plane_position.y;
    return world;
}

Plane held_inside(Plane plane, const Air& air) {
    const double low = air.origin[plane.across()];
    const double extent = air.extent()[plane.across()];
    plane.position = std::isfinite(plane.position) ? glm::clamp(plane.position, low, low + extent) : low + 0.5 * extent;
    return plane;
}

SlicePicture render_slice(const Air& air, const Plane& plane, Quantity quantity, float scale, int width, int height) {
    SlicePicture picture{.image = Image(width, height)};
    const glm::dvec2 low = plane.in_plane(air.origin);
    const glm::dvec2 extent = plane.in_plane(air.extent());
    std::vector<glm::dvec3> positions(static_cast<std::size_t>(width));
    std::vector<glm::vec3> velocities(static_cast<std::size_t>(width));
    for (int row = 0; row < height; ++row) {
        const double down = (row + 0.5) / height;
        const double along = low.y + extent.y * (plane.grows_upward() ? 1.0 - down : down);
        for (int column = 0; column < width; ++column)
            positions[column] = plane.to_world({low.x + extent.x * (column + 0.5) / width, along});
        air.velocity(positions, velocities);
        for (int column = 0; column < width; ++column) {
            if (!finite(velocities[column])) {
                picture.image.set(column, row, k_broken_colour);
                ++picture.broken_pixels;
                continue;
            }
            const float value = value_of(velocities[column], quantity);
            const float share = value / scale;
            picture.largest = std::max(picture.largest, std::abs(value));
            picture.image.set(column, row, quantity == Quantity::speed ? speed_colour(share) : signed_colour(share));
        }
    }
    return picture;
}

double arrow_spacing(float cell_size, double smallest) {
    // Bounded: a spacing that is no sensible number must not spin.
    double spacing = cell_size;
    for (int doubling = 0; doubling < 64 && spacing < smallest; ++doubling)
        spacing *= 2.0;
    for (int halving = 0; halving < 64 && spacing >= 2.0 * smallest; ++halving)
        spacing *= 0.5;
    return spacing;
}

std::vector<WindArrow> slice_arrows(const Air& air, const Plane& plane, double spacing, float scale) {
    const glm::dvec2 low = plane.in_plane(air.origin);
    const glm::dvec2 extent = plane.in_plane(air.extent());
    const double cell_size = air.box.cell_size;
    std::vector<glm::dvec2> places;
    std::vector<glm::dvec3> positions;
    for (const double along : lattice(low.y, extent.y, cell_size, spacing)) {
        for (const double right : lattice(low.x, extent.x, cell_size, spacing)) {
            places.push_back({right, along});
            positions.push_back(plane.to_world(places.back()));
        }
    }
    std::vector<glm::vec3> velocities(positions.size());
    air.velocity(positions, velocities);

    std::vector<WindArrow> arrows;
    arrows.reserve(places.size());
    for (std::size_t index = 0; index < places.size(); ++index) {
        if (!finite(velocities[index]))
            continue;
        const glm::dvec2 flow = plane.in_plane(glm::dvec3(velocities[index]));
        const double speed = std::hypot(flow.x, flow.y);
        arrows.push_back({.middle = places[index],
                          .direction = speed > 0.0 ? flow / speed : glm::dvec2(0.0),
                          .share = static_cast<float>(std::min(1.0, speed / scale))});
    }
    return arrows;
}

} // namespace windrow::cli
