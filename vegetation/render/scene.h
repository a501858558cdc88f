// What a picture is of: where the eye is, where the sun stands, what the air holds, the ground, the plants' look, the wind.
// Right-handed, y up, metres; places are double, since shaders work relative to the anchor. `validate` tells every reason why a
// scene cannot be drawn, a line each, field, value and fix.
#pragma once

#include "coupling/blade.h"
#include "fluid/motor.h"
#include "fluid/wind.h"
#include "vegetation/grass/height_map.h"
#include "vegetation/grass/placement_mask.h"

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

namespace windrow::vegetation::render {

struct Camera {
    glm::dvec3 position{0.0, 1.7, 0.0}; ///< [m]
    glm::dvec3 target{0.0, 1.2, -10.0}; ///< [m] what it looks at; not straight above or below
    float view_deg = 45.0f;             ///< height of the picture as an angle, 1 to 150. Default 45: a calm lens
    float near = 0.1f;                  ///< [m] above 0. Default 0.1: a blade before the lens is cut off there
    float far = 2000.0f;                ///< [m] beyond near, at most 1e6 near: depth is float
    float exposure = 1.0f;              ///< factor on light before the film's curve, above 0
};

/// The sun and the air that it shines through: vegetation/shaders/numerics/sky.glsl.
struct Sun {
    float elevation_deg = 26.0f; ///< above the horizon, 1 to 90. Default 26: long shadows and a warm light
    float azimuth_deg = 222.0f;  ///< where it stands, from x (0) toward z (90), -360 to 360
    float irradiance = 10.0f;    ///< above the air, in units of the picture, above 0 to 100
    float haze = 0.06f;          ///< Angstrom's turbidity, 0 to 0.5. Default 0.06: a clear summer's day
    float radius_deg = 0.2666f;  ///< of the disk, 0.05 to 5. Default: as seen from the earth
};

struct Fog {
    float density = 0.0015f; ///< [1/m] at height `base`, 0 (none) to 1. Default 0.0015: e^-1 at 670 m
    float fall = 0.02f;      ///< [1/m] it thins as exp(-fall * height), 0 to 1
    double base = 0.0;       ///< [m] height
};

/// A level sheet of clouds that drifts: vegetation/shaders/numerics/cloud_layer.glsl.
struct Clouds {
    float cover = 0.0f;           ///< share of the sky, 0 (none, and nothing is computed) to 1. Default 0
    double height = 900.0;        ///< [m] in the world, -1e9 to 1e9. Default 900: cumulus on a summer's day
    float size = 700.0f;          ///< [m] of the largest lumps, 1 to 1e5
    float depth = 3.0f;           ///< optical depth of the thickest, 0 to 100. Default 3: the sun is a pale disk behind it
    glm::vec2 drift{6.0f, -2.0f}; ///< [m/s] along x and z, -200 to 200: the wind up there
};

/// The ground: heights on a grid, and where they lie. The default is flat, 100 m x 100 m about the origin.
struct Ground {
    glm::dvec3 corner{-50.0, 0.0, -50.0}; ///< [m] place of the first corner; y is added to all heights
    grass::HeightMap heights = grass::HeightMap::level();
    /// Where plants stand, 0 to 1, over the heights' extent: there the ground has their roots' colour near the eye and their own
    /// colour afar; elsewhere it is bare. Default: everywhere.
    std::optional<grass::PlacementMask> grown{};

    /// [m] In the world, on the triangles that are drawn; beyond the rim that of the rim.
    [[nodiscard]] double height(double x, double z) const;
};

/// Colours are linear albedo, 0 to 1. What comes back and what shines through, the latter times 1 + against_light / 10, add up to
/// at most 0.6: leaves of all directions then give no more light than they get.
struct PlantLook {
    glm::vec3 root{0.032f, 0.052f, 0.014f};    ///< where it leaves the ground
    glm::vec3 tip{0.120f, 0.170f, 0.045f};     ///< of a fresh one
    glm::vec3 dry{0.280f, 0.230f, 0.110f};     ///< the driest tips
    glm::vec3 through{0.125f, 0.170f, 0.030f}; ///< light that shines through it
    float variation = 0.18f;                   ///< share by which single plants are lighter or darker, 0 to 0.9
    float root_light = 0.35f;                  ///< what the neighbours leave of the sky's light at the root, 0 to 1
    float gloss = 24.0f;                       ///< exponent, 1 to 1000
    float against_light = 2.5f;                ///< how much more shines through against the light, 0 to 20
    // What follows only grass fields and the ground under them have.
    glm::vec3 second{0.085f, 0.160f, 0.050f}; ///< fresh tips of other clumps: each clump lies somewhere between `tip` and this
    float dryness = 1.0f;                     ///< how much dry patches and single dry blades show, 0 (none) to 1
    float fold = 0.5f;       ///< [rad] by which both halves of a blade stand out of its plane, 0 to 1.2: a crease of light
    float midrib = 0.2f;     ///< share by which the crease is lighter, 0 to 1
    float soften = 0.35f;    ///< share of the ground's normal in a near blade's, 0 to 1: 0 shows each blade, 1 an even meadow
    float self_shade = 1.3f; ///< optical depth of the neighbours along the sun's beam, from tip to root, 0 (none) to 5
    glm::vec3 head{0.240f, 0.190f, 0.100f}; ///< of seed heads and flowers
    float head_from = 1.0f;                 ///< share of the length at which they begin, 0.3 to 1. Default 1: none
    float head_width = 0.012f;              ///< [m] their width, 0 to 0.5
    glm::vec3 soil{0.044f, 0.046f, 0.020f}; ///< of the ground between the roots and where nothing grows
    float even_from = 45.0f;                ///< [m] where normals have become the ground's and ground the plants' colour, above 0
};

/// What blows. Motors are those at the start; a host moves them.
struct WindScene {
    windrow::Config wind{};
    std::vector<windrow::Motor> motors{};
    windrow::Sampling sampling{};
};

struct Scene {
    Camera camera{};
    Sun sun{};
    Fog fog{};
    Clouds clouds{};
    Ground ground{};
    windrow::BladeSettings plants{};
    PlantLook look{};
    WindScene wind{};
};

[[nodiscard]] windrow::Result<void> validate(const Camera& camera);
[[nodiscard]] windrow::Result<void> validate(const Sun& sun);
[[nodiscard]] windrow::Result<void> validate(const Fog& fog);
[[nodiscard]] windrow::Result<void> validate(const Clouds& clouds);
[[nodiscard]] windrow::Result<void> validate(const Ground& ground);
[[nodiscard]] windrow::Result<void> validate(const PlantLook& look);
[[nodiscard]] windrow::Result<void> validate(const Scene& scene);

} // namespace windrow::vegetation::render
