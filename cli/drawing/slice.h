// A plane through the box: the picture of the air on it and the arrows on that picture.
//
// A picture reads the air through the same function as a plant does, so that it shows what plants see, not what cells hold.
// On the page: level (normal y), seen from above: x to the right, z down. Upright (normal z), seen from high z: x to the right,
// y up. Sideways (normal x), seen from low x: z to the right, y up.
//
// The map of speeds runs from ink blue (calm) over blue, teal and green to pale straw (fast). It is drawn in OKLab: lightness
// rises in equal steps, so that equal steps of speed look equal, a grey print keeps the order, and an eye that does not tell
// red from green loses nothing.
// Based on: Ottosson 2020, "A perceptual color space for image processing" (the matrices of OKLab).
#pragma once

#include "cli/drawing/canvas.h"
#include "cli/pictures.h"
#include "fluid/box.h"

#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace windrow::cli {

/// The air as a picture reads it: a Wind, or a formula in a test.
struct SlicedAir {
    Box box;
    glm::dvec3 origin{0.0};  ///< [m] world, low corner of the box
    glm::vec3 ambient{0.0f}; ///< [m/s]
    /// [m] Height at which the ambient wind is that, 0 where it is the same at all heights.
    float profile_height = 0.0f;
    float gust_intensity = 0.0f; ///< standard deviation over the mean speed; 0: no gusts
    /// [m/s] Wind at world points; both spans have one length.
    std::function<void(std::span<const glm::dvec3> positions, std::span<glm::vec3> velocities)> velocity;
    std::vector<NamedObstacle> obstacles{};
    /// [m] World height of the ground under a place (x, z), of air read above it; else empty.
    std::function<double(glm::dvec2 place)> ground{};

    /// [m] Edge lengths of the box.
    [[nodiscard]] glm::dvec3 extent() const {
        const glm::dvec3 equal = glm::dvec3(box.cells) * static_cast<double>(box.cell_size);
        return box.rows ? glm::dvec3(equal.x, box.rows->top(), equal.z) : equal;
    }
};

/// The air as a level slice reads it that follows the ground: what is h [m] above the ground is at h above the box's low face. Bodies
/// on the ground are moved with their positions; the ground itself is none of them. Grounds stand upright. Air
/// without a Ground comes back as it is.
[[nodiscard]] SlicedAir above_ground(const SlicedAir& air);

/// The axis across a plane: x sideways, y level, z upright.
enum class Normal : std::uint8_t { x, y, z };

struct Plane {
    Normal normal = Normal::y;
    double position = 0.0; ///< [m] world, along the normal

    /// World axis (0 x, 1 y, 2 z) that runs to the right of the page, along its height, and across it.
    [[nodiscard]] int right() const { return normal == Normal::x ? 2 : 0; }
    [[nodiscard]] int along_height() const { return normal == Normal::y ? 2 : 1; }
    [[nodiscard]] int across() const { return static_cast<int>(normal); }
    /// True where the axis along the height grows toward the top of the page.
    [[nodiscard]] bool grows_upward() const { return normal != Normal::y; }

    /// The two coordinates of a world point in the plane: (right, along the height).
    template <class Vector>
    [[nodiscard]] auto in_plane(const Vector& world) const {
        return glm::vec<2, typename Vector::value_type>(world[right()], world[along_height()]);
    }
    [[nodiscard]] glm::dvec3 to_world(glm::dvec2 in_plane_position) const;
};

/// The plane moved into the box where it lies beyond it; through the middle where its position is no number.
[[nodiscard]] Plane held_inside(Plane plane, const SlicedAir& air);

struct SlicePicture {
    Image image;
    float largest = 0.0f;           ///< [m/s] largest speed of any pixel outside of bodies
    std::int64_t broken_pixels = 0; ///< pixels whose wind is no number, drawn in k_broken_colour
};

/// The plane as width x height pixels, over the whole box: pixel (c, r) shows the wind at its own centre, coloured by
/// speed_colour(speed / scale), scale [m/s] > 0, or the section of an obstacle; with lines of equal height of the ground, if the air
/// has one.
[[nodiscard]] SlicePicture render_slice(const SlicedAir& air, const Plane& plane, float scale, int width, int height);

/// [m] Between lines of equal height: 1, 2 or 5 times a power of ten, a tenth to a fourth of the ground's relief under the box. 0: it is level.
[[nodiscard]] double contour_step(const SlicedAir& air);

struct WindArrow {
    glm::dvec2 middle{0.0};    ///< [m] in the plane's coordinates
    glm::dvec2 direction{0.0}; ///< of length 1, or 0 where the air stands still in the plane
    float share = 0.0f;        ///< in-plane speed over the scale, at most 1
};

/// [m] Spacing of arrows: a power of two of the cell's edge, so that they keep their cells, at least `smallest` metres apart.
[[nodiscard]] double arrow_spacing(float cell_size, double smallest);

/// In-plane velocity on a lattice that is fixed to the world, so that arrows stand still as the box moves over them. Points
/// whose wind is no number are left out. A box too thin for the lattice gets its middle line.
[[nodiscard]] std::vector<WindArrow> slice_arrows(const SlicedAir& air, const Plane& plane, double spacing, float scale);

/// Colour of a share of the scale, 0 calm to 1 fast; below and above it is held.
[[nodiscard]] Rgb8 speed_colour(float share);

/// Colour of what is no number: far from every colour of either map.
inline constexpr Rgb8 k_broken_colour{255, 0, 170};

/// OKLab lightness (0 black, 1 white) and the two colour axes of an sRGB colour.
[[nodiscard]] glm::dvec3 to_oklab(Rgb8 colour);

} // namespace windrow::cli
