#include "cli/drawing/slice.h"

#include "cli/drawing/sections.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <span>
#include <variant>

namespace windrow::cli {
namespace {

bool finite(glm::vec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
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

/// One anchor of a map: lightness, colourfulness and hue of OKLab in polar form.
struct Anchor {
    double lightness, chroma, hue_deg;
};

// Equal steps of lightness; chroma stays inside sRGB all the way, so that no channel is cut and no band appears.
constexpr std::array k_anchors{
    Anchor{0.170, 0.050, 272.0}, // ink
    Anchor{0.329, 0.110, 266.0}, // blue
    Anchor{0.488, 0.108, 243.0}, // sea blue
    Anchor{0.647, 0.109, 190.0}, // teal
    Anchor{0.806, 0.140, 145.0}, // leaf
    Anchor{0.965, 0.105, 108.0}, // straw
};

glm::dvec3 lab_of(const Anchor& anchor) {
    const double hue = glm::radians(anchor.hue_deg);
    return {anchor.lightness, anchor.chroma * std::cos(hue), anchor.chroma * std::sin(hue)};
}

glm::dvec3 to_linear_rgb(glm::dvec3 lab) {
    const double l = std::pow(lab.x + 0.3963377774 * lab.y + 0.2158037573 * lab.z, 3.0);
    const double m = std::pow(lab.x - 0.1055613458 * lab.y - 0.0638541728 * lab.z, 3.0);
    const double s = std::pow(lab.x - 0.0894841775 * lab.y - 1.2914855480 * lab.z, 3.0);
    return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s, //
            -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s, -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

std::uint8_t encode(double linear) {
    const double held = glm::clamp(linear, 0.0, 1.0);
    const double coded = held <= 0.0031308 ? 12.92 * held : 1.055 * std::pow(held, 1.0 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(coded * 255.0));
}

double decode(std::uint8_t coded) {
    const double value = coded / 255.0;
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

/// The anchors joined in OKLab by a Catmull-Rom curve: no kink at an anchor, which the eye would read as an edge in the air.
glm::dvec3 lab_at(double share) {
    const int last = static_cast<int>(k_anchors.size()) - 1;
    const double place = glm::clamp(share, 0.0, 1.0) * last;
    const int from = glm::clamp(static_cast<int>(place), 0, last - 1);
    const double t = place - from;
    const auto anchor = [&](int index) {
        if (index < 0)
            return 2.0 * lab_of(k_anchors[0]) - lab_of(k_anchors[1]);
        if (index > last)
            return 2.0 * lab_of(k_anchors[last]) - lab_of(k_anchors[last - 1]);
        return lab_of(k_anchors[index]);
    };
    const glm::dvec3 a = anchor(from - 1), b = anchor(from), c = anchor(from + 1), d = anchor(from + 2);
    return b + 0.5 * t * (c - a + t * (2.0 * a - 5.0 * b + 4.0 * c - d + t * (3.0 * (b - c) + d - a)));
}

/// Fine enough that the nearest entry is the exact colour.
constexpr int k_entries = 2048;
using Table = std::array<Rgb8, k_entries>;

Table make_table() {
    Table table;
    for (int entry = 0; entry < k_entries; ++entry) {
        const glm::dvec3 rgb = to_linear_rgb(lab_at(entry / (k_entries - 1.0)));
        table[entry] = {encode(rgb.x), encode(rgb.y), encode(rgb.z)};
    }
    return table;
}

/// Lines where the ground passes whole multiples of the step.
void paint_contours(Image& image, const SlicedAir& air, glm::dvec2 low, glm::dvec2 extent) {
    const double step = contour_step(air);
    if (step == 0.0)
        return;
    std::vector<double> above(static_cast<std::size_t>(image.width) + 1), here(above);
    for (int row = 0; row <= image.height; ++row) {
        for (int column = 0; column <= image.width; ++column)
            here[column] =
                std::floor(air.ground(low + extent * glm::dvec2(column, row) / glm::dvec2(image.width, image.height)) / step);
        for (int column = 0; row > 0 && column < image.width; ++column)
            if (here[column] != here[column + 1] || here[column] != above[column]) {
                const Rgb8 below = image.at(column, row - 1);
                Rgb8 mixed;
                for (std::size_t channel = 0; channel < 3; ++channel)
                    mixed[channel] = static_cast<std::uint8_t>((below[channel] * 9 + 255 * 7) / 16);
                image.set(column, row - 1, mixed);
            }
        above.swap(here);
    }
}

} // namespace

SlicedAir above_ground(const SlicedAir& air) {
    std::vector<Obstacle> grounds;
    for (const NamedObstacle& named : air.obstacles)
        if (std::holds_alternative<Ground>(named.obstacle.shape))
            grounds.push_back(named.obstacle);
    if (grounds.empty())
        return air;
    SlicedAir over = air;
    over.obstacles.clear();
    over.ground = [grounds, low = air.origin.y](glm::dvec2 place) {
        double height = low;
        for (const Obstacle& ground : grounds) {
            const glm::dvec3 from(place.x - ground.position.x, 0.0, place.y - ground.position.z);
            const glm::vec3 own = glm::inverse(glm::normalize(ground.orientation)) * glm::vec3(from);
            const auto& shape = std::get<Ground>(ground.shape);
            if (detail::holds(shape, {own.x, own.z}))
                height = std::max(height, ground.position.y + static_cast<double>(detail::height_at(shape, own)));
        }
        return height;
    };
    const auto lift = [ground = over.ground, low = air.origin.y](const glm::dvec3& at) { return ground({at.x, at.z}) - low; };
    over.velocity = [velocity = air.velocity, lift](std::span<const glm::dvec3> positions, std::span<glm::vec3> velocities) {
        std::vector<glm::dvec3> places(positions.begin(), positions.end());
        for (glm::dvec3& place : places)
            place.y += lift(place);
        velocity(places, velocities);
    };
    for (const NamedObstacle& named : air.obstacles)
        if (!std::holds_alternative<Ground>(named.obstacle.shape)) {
            over.obstacles.push_back(named);
            over.obstacles.back().obstacle.position.y -= lift(named.obstacle.position);
        }
    return over;
}

double contour_step(const SlicedAir& air) {
    constexpr int k_places = 64;
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    for (int z = 0; z < k_places; ++z)
        for (int x = 0; x < k_places; ++x) {
            const glm::dvec3 share = glm::dvec3(x, 0.0, z) / (k_places - 1.0);
            const glm::dvec3 at = air.origin + air.extent() * share;
            const double height = air.ground({at.x, at.z});
            lowest = std::min(lowest, height);
            highest = std::max(highest, height);
        }
    if (!(highest - lowest > 1e-2))
        return 0.0;
    const double least = 0.1 * (highest - lowest), decade = std::pow(10.0, std::floor(std::log10(least)));
    return decade * (least <= decade ? 1.0 : least <= 2.0 * decade ? 2.0 : least <= 5.0 * decade ? 5.0 : 10.0);
}

glm::dvec3 Plane::to_world(glm::dvec2 in_plane_position) const {
    glm::dvec3 world(position);
    world[right()] = in_plane_position.x;
    world[along_height()] = in_plane_position.y;
    return world;
}

Plane held_inside(Plane plane, const SlicedAir& air) {
    const double low = air.origin[plane.across()];
    const double extent = air.extent()[plane.across()];
    plane.position = std::isfinite(plane.position) ? glm::clamp(plane.position, low, low + extent) : low + 0.5 * extent;
    return plane;
}

SlicePicture render_slice(const SlicedAir& air, const Plane& plane, float scale, int width, int height) {
    SlicePicture picture{.image = Image(width, height)};
    const glm::dvec2 low = plane.in_plane(air.origin);
    const glm::dvec2 extent = plane.in_plane(air.extent());
    const std::vector<CutBody> bodies = bodies_at(air.obstacles, plane, air);
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
            const glm::vec3 u = velocities[column];
            const float speed = std::hypot(u.x, u.y, u.z); // near the largest float a sum of squares would overflow
            if (speed > picture.largest && !inside_body(bodies, positions[column]))
                picture.largest = speed;
            picture.image.set(column, row, speed_colour(speed / scale));
        }
    }
    if (air.ground)
        paint_contours(picture.image, air, low, extent);
    paint_sections(picture.image, bodies, plane, air);
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

std::vector<WindArrow> slice_arrows(const SlicedAir& air, const Plane& plane, double spacing, float scale) {
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

Rgb8 speed_colour(float share) {
    static const Table table = make_table();
    if (!(share > 0.0f)) // NaN too, but callers draw that in k_broken_colour
        return table.front();
    if (share >= 1.0f)
        return table.back();
    return table[static_cast<std::size_t>(share * (k_entries - 1) + 0.5f)];
}

glm::dvec3 to_oklab(Rgb8 colour) {
    const double r = decode(colour[0]), g = decode(colour[1]), b = decode(colour[2]);
    const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s, //
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s, 0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

} // namespace windrow::cli
