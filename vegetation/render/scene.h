// The scene of a picture: camera, sun, haze, ground, look of the plants, wind.
// Right-handed, y up, metres; places are double, since shaders work relative to the anchor. `validate` returns every reason why a
// scene cannot be drawn, one per line, with field, value and fix.
#pragma once

#include "../../coupling/blade.h"
#include "../../fluid/motor.h"
#include "../../fluid/shapes/height_map.h"
#include "../../fluid/wind.h"
#include "../grass/placement_mask.h"

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

namespace windrow::vegetation::render {

/// Of a place in a scene: beyond it a double has less than a micrometre.
inline constexpr Range k_place_range{-1e9, 1e9, "m"};

struct Camera {
    glm::dvec3 position{0.0, 1.7, 0.0};
    glm::dvec3 target{0.0, 1.2, -10.0};
    float view_deg = 45.0f;
    float near = 0.1f;
    float far = 2000.0f;
    float exposure = 1.0f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("position", &Camera::position, k_place_range, "Its position."),
            Setting("target", &Camera::target, k_place_range, "Point that it looks at; not straight above or below."),
            Setting("view_deg", &Camera::view_deg, {1.0, 150.0, "deg"}, "Height of the picture as an angle; 45 is a calm lens."),
            Setting("near", &Camera::near, {1e-3, 1e3, "m"}, "Near plane: nearer objects are not drawn."),
            Setting("far", &Camera::far, {1.01e-3, 1e9, "m"},
                    "Nor what is farther; 1.01 to 1e6 times near, since depth is float."),
            Setting("exposure", &Camera::exposure, {1e-6, 1e6}, "Factor on light before the film's curve."),
        };
    }
};

/// The sun and the air that it shines through: vegetation/shaders/numerics/sky.glsl.
struct Sun {
    float elevation_deg = 26.0f;
    float azimuth_deg = 222.0f;
    float irradiance = 10.0f;
    float haze = 0.06f;
    float radius_deg = 0.2666f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("elevation_deg", &Sun::elevation_deg, {1.0, 90.0, "deg"},
                    "Above the horizon. 26 gives long shadows and a warm light."),
            Setting("azimuth_deg", &Sun::azimuth_deg, {-360.0, 360.0, "deg"}, "Azimuth, from x (0) toward z (90)."),
            Setting("irradiance", &Sun::irradiance, {1e-6, 100.0}, "Above the air, in units of the picture."),
            Setting("haze", &Sun::haze, {0.0, 0.5}, "Angstrom's turbidity. 0.06 is a clear summer's day."),
            Setting("radius_deg", &Sun::radius_deg, {0.05, 5.0, "deg"}, "Of the disk, as seen from the earth."),
        };
    }
};

struct Fog {
    float density = 0.0015f;
    float fall = 0.02f;
    double base = 0.0;

    static constexpr auto settings() {
        return std::tuple{
            Setting("density", &Fog::density, {0.0, 1.0, "1/m", "none"}, "At height base. 0.0015 leaves 1/e at 670 m."),
            Setting("fall", &Fog::fall, {0.0, 1.0, "1/m"}, "It thins as exp(-fall * height)."),
            Setting("base", &Fog::base, k_place_range, "Height."),
        };
    }
};

/// A level sheet of clouds that drifts: vegetation/shaders/numerics/cloud_layer.glsl.
struct Clouds {
    float cover = 0.0f;
    double height = 900.0;
    float size = 700.0f;
    float depth = 3.0f;
    glm::vec2 drift{6.0f, -2.0f};

    static constexpr auto settings() {
        return std::tuple{
            Setting("cover", &Clouds::cover, {.min = 0.0, .max = 1.0, .zero = "none, and nothing is computed"},
                    "Fraction of the sky."),
            Setting("height", &Clouds::height, k_place_range, "Of the sheet, in the world: cumulus on a summer's day."),
            Setting("size", &Clouds::size, {1.0, 1e5, "m"}, "Of the largest lumps."),
            Setting("depth", &Clouds::depth, {0.0, 100.0}, "Optical depth of the thickest: 3 leaves a pale disk of the sun."),
            Setting("drift", &Clouds::drift, {-200.0, 200.0, "m/s"}, "Along x and z: the wind up there."),
        };
    }
};

/// The ground: heights on a grid, and where they lie. The default is flat, 100 m x 100 m about the origin.
struct Ground {
    glm::dvec3 corner{-50.0, 0.0, -50.0}; ///< [m] place of the first corner; y is added to all heights
    HeightMap heights = HeightMap::level();
    /// Density of plants, 0 to 1, over the heights' extent: there the ground has their roots' colour near the eye and their own
    /// colour afar; elsewhere it is bare. Default: everywhere.
    std::optional<grass::PlacementMask> grown{};

    /// [m] World height of the triangles that are drawn; beyond the edge that of the edge.
    [[nodiscard]] double height(double x, double z) const;
};

/// Colours are linear albedo, 0 to 1. What comes back and what shines through, the latter times 1 + against_light / 10, add up to
/// at most 0.6: leaves of all directions then give no more light than they get.
struct PlantLook {
    glm::vec3 root{0.032f, 0.052f, 0.014f};
    glm::vec3 tip{0.120f, 0.170f, 0.045f};
    glm::vec3 dry{0.280f, 0.230f, 0.110f};
    glm::vec3 through{0.125f, 0.170f, 0.030f};
    float variation = 0.18f;
    float root_light = 0.35f;
    float gloss = 24.0f;
    float against_light = 2.5f;
    glm::vec3 second{0.085f, 0.160f, 0.050f};
    float dryness = 1.0f;
    float fold = 0.5f;
    float midrib = 0.2f;
    float soften = 0.35f;
    float self_shade = 1.3f;
    glm::vec3 head{0.240f, 0.190f, 0.100f};
    float head_from = 1.0f;
    float head_width = 0.012f;
    glm::vec3 soil{0.044f, 0.046f, 0.020f};
    float even_from = 45.0f;
    float wave = 0.6f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("root", &PlantLook::root, k_fraction_range, "Colour at the root."),
            Setting("tip", &PlantLook::tip, k_fraction_range, "Of a fresh one."),
            Setting("dry", &PlantLook::dry, k_fraction_range, "The driest tips."),
            Setting("through", &PlantLook::through, k_fraction_range, "Light that shines through it."),
            Setting("variation", &PlantLook::variation, {0.0, 0.9}, "Fraction by which single plants are lighter or darker."),
            Setting("root_light", &PlantLook::root_light, k_fraction_range,
                    "Fraction of the sky's light that reaches the root between its neighbours."),
            Setting("gloss", &PlantLook::gloss, {1.0, 1000.0}, "Exponent of the shine."),
            Setting("against_light", &PlantLook::against_light, {0.0, 20.0},
                    "Additional light that shines through against the sun."),
            Setting("second", &PlantLook::second, k_fraction_range,
                    "Fresh tips of other clumps: the colour of each clump is between tip and this."),
            Setting("dryness", &PlantLook::dryness, k_fraction_range, "Visibility of dry patches and single dry blades."),
            Setting("fold", &PlantLook::fold, {0.0, 1.2, "rad"},
                    "Angle of both halves of a blade to its plane, which makes a crease of light."),
            Setting("midrib", &PlantLook::midrib, k_fraction_range, "Fraction by which the crease is lighter."),
            Setting("soften", &PlantLook::soften, k_fraction_range,
                    "Fraction of the ground's normal in a near blade's: 0 shows each blade, 1 an even meadow."),
            Setting("self_shade", &PlantLook::self_shade, {0.0, 5.0},
                    "Optical depth of the neighbours along the sun's beam, from tip to root."),
            Setting("head", &PlantLook::head, k_fraction_range, "Of seed heads and flowers."),
            Setting("head_from", &PlantLook::head_from, {0.3, 1.0}, "Fraction of the length at which they begin; 1: none."),
            Setting("head_width", &PlantLook::head_width, {0.0, 0.5, "m"}, "Their width."),
            Setting("soil", &PlantLook::soil, k_fraction_range,
                    "Of the ground between the roots and where the first layer does not grow."),
            Setting("even_from", &PlantLook::even_from, {1e-3, 1e6, "m"},
                    "Distance at which normals are the ground's and the ground has the plants' colour."),
            Setting(
                "wave", &PlantLook::wave, {.min = 0.0, .max = 2.0, .zero = "still"},
                "How far the wind turns the normal of what is seen afar, blades and ground alike: a meadow's waves. 0 samples "
                "no wind for the ground."),
        };
    }
};

/// The wind. Motors are those at the start; a host moves them.
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
void check_rules(windrow::detail::Reasons& reasons, const windrow::detail::FieldPath& path, const Camera& camera);
void check_rules(windrow::detail::Reasons& reasons, const windrow::detail::FieldPath& path, const PlantLook& look);

} // namespace windrow::vegetation::render
