// The ambient wind as a function of place and time: mean wind, log profile over height, gusts.
//
// It is the wind outside of the box of a Wind, and enters the box through its open boundaries. It also works without a Wind, as
// the cheapest wind of this library:
//
//     auto wind = windrow::AmbientWind::create({.mean = {6.0f, 0.0f, 0.0f}, .gusts = {.intensity = 0.3f}});
//     wind->advance(1.0 / 60.0);
//     glm::vec3 at_leaf = wind->velocity(leaf_position);          // [m/s]
//     windrow::AmbientBlock block = wind->block(camera_position); // the same on the GPU, by the same text
//
// Gusts are a frozen pattern (gust_tile.h), advected by the horizontal mean wind: u(x, t) = u(x - V d, t - d). The distance that
// it was carried is the phase, stored in double and wrapped at the tile, so that neither time nor distance costs digits. The
// formulas are in shaders/numerics/ambient.glsl, one text for C++ and GLSL.
#pragma once

#include "api.h"
#include "gust_tile.h"
#include "result.h"
#include "setting.h"

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <span>
#include <tuple>

namespace windrow {

/// Wind over open ground: log((z + z0) / z0), 0 at the ground and below, the mean wind at the reference height, more above.
struct LogProfile {
    /// [m] 1e-6 to 100, default 0.03. z0: about a tenth of the height of what is on the ground. 0.0002 water, 0.03 short grass, 1
    /// wood.
    float roughness_length = 0.03f;
    /// [m] 0.01 to 10000, default 10. Height at which the wind is the mean. 10 is where weather services measure.
    float reference_height = 10.0f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("roughness_length", &LogProfile::roughness_length, {1e-6, 100.0, "m"},
                    "z0: about a tenth of the height of what is on the ground. 0.0002 water, 0.03 short grass, 1 wood."),
            Setting("reference_height", &LogProfile::reference_height, {0.01, 1e4, "m"},
                    "Height at which the wind is the mean. 10 is where weather services measure."),
        };
    }
};

/// Gusts: a frozen pattern that the mean wind carries along. Over a profile they fade to 0 at the ground with the mean and do not
/// grow above the reference height.
struct Gusts {
    /// 0 (none) to 1, default 0. Standard deviation of each horizontal component over the mean horizontal speed. 0 costs nothing,
    /// 0.15 is open country, 0.3 a gusty day.
    float intensity = 0.0f;
    /// [m] 0.01 to 1e6, default 24. Distance from one gust to the next. A texel is a twelfth of it, the pattern repeats after 128
    /// texels; 24 makes texels of 2 m, which cells of 1 m resolve, and 256 m until it repeats.
    float length = 24.0f;
    /// 0 to 4294967295, default 1. Seed of the pattern.
    std::uint32_t seed = 1;
    /// The pattern itself, for many winds to use one; null: made from the seed.
    std::shared_ptr<const GustTile> tile{};

    static constexpr auto settings() {
        return std::tuple{
            Setting(
                "intensity", &Gusts::intensity, {.min = 0.0, .max = 1.0, .zero = "none"},
                "Standard deviation of each horizontal component over the mean horizontal speed. 0 costs nothing, 0.15 is open "
                "country, 0.3 a gusty day."),
            Setting("length", &Gusts::length, {0.01, 1e6, "m"},
                    "Distance from one gust to the next. A texel is a twelfth of it, the pattern repeats after 128 texels; 24 "
                    "makes texels of "
                    "2 m, which cells of 1 m resolve, and 256 m until it repeats."),
            Setting("seed", &Gusts::seed, k_seed_range, "Seed of the pattern."),
            Setting("tile", &Gusts::tile, "The pattern itself, for many winds to use one; null: made from the seed.",
                    k_not_stored),
        };
    }
};

/// Conversion of the wind, from the fluid or from here, to the wind that acts on a plant.
struct Sampling {
    /// 0 to 1000, default 1. Factor on the wind; 0: no wind acts.
    float strength = 1.0f;
    /// [m/s] 0 to 1e6, default 60. Upper bound of the speed, after the strength. 60 is the strongest storm.
    float limit = 60.0f;
    /// 0 (none) to 1, default 0. Small-scale detail over the local speed; a bound, typical detail is a quarter of it. Needs a
    /// tile (AmbientWind::tile): without gusts, give Gusts::tile.
    float detail = 0.0f;
    /// [m] 0.001 to 1e6, default 1. Distance from one ripple to the next, rounded so that a whole number of ripples fits a gust
    /// (at most its length): then one phase moves both. 1 is what cells of 1 m leave out.
    float detail_length = 1.0f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("strength", &Sampling::strength, {0.0, 1000.0}, "Factor on the wind; 0: no wind acts."),
            Setting("limit", &Sampling::limit, {0.0, 1e6, "m/s"},
                    "Upper bound of the speed, after the strength. 60 is the strongest storm."),
            Setting("detail", &Sampling::detail, {.min = 0.0, .max = 1.0, .zero = "none"},
                    "Small-scale detail over the local speed; a bound, typical detail is a quarter of it. Needs a tile "
                    "(AmbientWind::tile): without gusts, give Gusts::tile."),
            Setting("detail_length", &Sampling::detail_length, {1e-3, 1e6, "m"},
                    "Distance from one ripple to the next, rounded so that a whole number of ripples fits a gust (at most its "
                    "length): then "
                    "one phase moves both. 1 is what cells of 1 m leave out."),
        };
    }
};

/// All reasons why they are invalid, one per line.
[[nodiscard]] WINDROW_API Result<void> validate(const LogProfile& profile);
[[nodiscard]] WINDROW_API Result<void> validate(const Gusts& gusts);
[[nodiscard]] WINDROW_API Result<void> validate(const Sampling& sampling);

/// Shader parameters of the ambient wind beside the tile, as a uniform block of std140 layout (seven vec4): WindrowAmbient of
/// shaders/numerics/ambient.glsl. Positions are relative to an anchor that the host chooses near its camera.
struct AmbientBlock {
    glm::vec3 mean{0.0f};            ///< [m/s] at the reference height
    float gust_strength = 0.0f;      ///< [m/s] standard deviation of the gusts; 0: none
    float roughness_length = 0.0f;   ///< [m] 0: no profile
    float reference_height = 0.0f;   ///< [m]
    float anchor_height = 0.0f;      ///< [m] of the anchor over the ground
    float felt_strength = 0.0f;      ///< factor on the felt wind
    glm::vec3 gust_texel{0.0f};      ///< texel below the anchor, whole numbers
    float gust_texels = 0.0f;        ///< [1/m] texels a metre
    glm::vec3 gust_fraction{0.0f};   ///< distance of the anchor from that texel's centre in texels, 0 to 1
    float longest_gust = 0.0f;       ///< longest vector of the tile; 1 without a tile
    glm::vec3 gust_axes{1.0f};       ///< 1, or 0 where gusts have no such component
    float felt_limit = 1.0f;         ///< [m/s] of the felt wind
    glm::vec3 detail_texel{0.0f};    ///< as gust_texel, for the detail
    float detail_texels = 0.0f;      ///< [1/m] as gust_texels
    glm::vec3 detail_fraction{0.0f}; ///< as gust_fraction
    float detail_amount = 0.0f;      ///< detail as a fraction of the local speed; 0: none
};
static_assert(sizeof(AmbientBlock) == 112);

/// A spatially uniform gust by a closed formula, for a scene that needs motion and no fluid.
struct WINDROW_API UniformGust {
    /// [m/s] Mean over a period, exactly. Default 4: leaves move.
    float mean = 4.0f;
    /// [m/s] Peak over the mean; the lull is 0.58 of it below. Default 2: never calm, never a storm.
    float amplitude = 2.0f;
    /// [s] From peak to peak, above 0; otherwise the mean blows. Default 8: as trees sway.
    float period = 8.0f;
    /// Multiplies the speed; normally of length 1. Default along x.
    glm::vec3 direction{1.0f, 0.0f, 0.0f};

    /// [m/s] At a time [s], reduced to the period in double; at a time that is not finite, the mean.
    [[nodiscard]] glm::vec3 velocity(double time) const;
};

class WINDROW_API AmbientWind {
  public:
    struct Settings {
        /// [m/s] Each component -10000 to 10000, default (0, 0, 0). Mean wind, at the reference height if there is a profile. 0
        /// is still air, which has no gusts either.
        glm::vec3 mean{0.0f};
        /// Default none: the same wind at all heights.
        std::optional<LogProfile> profile{};
        /// Default none.
        Gusts gusts{};
        /// [m] -1e12 to 1e12, default 0. World height of the ground: where the profile begins and gusts are mirrored.
        double ground = 0.0;

        static constexpr auto settings() {
            return std::tuple{
                Setting("mean", &Settings::mean, k_speed_range,
                        "Mean wind, at the reference height if there is a profile. 0 is still air, which has no gusts either."),
                Setting("profile", &Settings::profile, "Default none: the same wind at all heights."),
                Setting("gusts", &Settings::gusts, "Default none."),
                Setting("ground", &Settings::ground, k_world_range,
                        "World height of the ground: where the profile begins and gusts are mirrored."),
            };
        }
    };

    /// Rejects what `validate` rejects, and a mean or a ground that is not finite or far too large. Bakes a tile if gusts need
    /// one (5 ms).
    [[nodiscard]] static Result<AmbientWind> create(const Settings& settings);

    /// [m/s] Wind at a world point. A point that is not finite gets the mean.
    [[nodiscard]] glm::vec3 velocity(glm::dvec3 position) const;
    /// The same for many points, at a tenth of the time a point; `velocities` holds as many. The bits of a point are those of the
    /// call above.
    void velocity(std::span<const glm::dvec3> positions, std::span<glm::vec3> velocities) const;
    /// [m/s] Wind that acts on a plant at a world point: a wind from here or from the fluid, with detail, scaled, limited. 0 for
    /// a wind that is not finite; no detail at a point that is not finite.
    [[nodiscard]] glm::vec3 felt(glm::vec3 velocity, glm::dvec3 position, const Sampling& sampling = {}) const;
    /// The same for many points: `velocities` holds the winds there, and then what acts.
    void felt(std::span<const glm::dvec3> positions, const Sampling& sampling, std::span<glm::vec3> velocities) const;
    /// Shader block for the same two functions, relative to `anchor` [m]; one that is not finite counts as 0. A field of
    /// `sampling` that `validate` rejects counts as its default, here and in `felt`.
    [[nodiscard]] AmbientBlock block(glm::dvec3 anchor, const Sampling& sampling = {}) const;

    /// The same wind with no gusts.
    [[nodiscard]] AmbientWind without_gusts() const;

    /// Carries the gusts along for dt [s]; a negative dt runs back. A dt that is not finite does nothing.
    void advance(double dt);
    /// Rejects what is not finite or above 1e4 m/s. Gusts stay where they are, with the strength that the new wind gives them.
    Result<void> set_mean(glm::vec3 mean);
    /// Rejects what is not finite or beyond 1e12 m.
    Result<void> set_ground(double height);
    /// A factor on each component of the gusts: 0 drops it, where a wall closes the axis.
    void set_gust_axes(glm::vec3 axes) { gust_axes_ = axes; }

    /// [m] Phase: the distance that the gusts were carried, each component in [0, period()). With the settings, the whole state.
    [[nodiscard]] glm::dvec3 phase() const { return phase_; }
    /// Wraps; a component that is not finite counts as 0.
    void set_phase(glm::dvec3 phase);
    /// [m] Period of the gusts along x and z: 128 texels.
    [[nodiscard]] double period() const;
    /// Interpolated phase between two ticks, along the shorter way: a at factor 0, b at 1.
    [[nodiscard]] static glm::dvec3 between(glm::dvec3 a, glm::dvec3 b, double factor, double period);

    /// Without profile and gusts: the wind is the mean everywhere, to the bit.
    [[nodiscard]] bool uniform() const { return !settings_.profile && settings_.gusts.intensity == 0.0f; }
    /// With gusts and a horizontal mean wind that carries them: the wind changes in time.
    [[nodiscard]] bool gusting() const { return gust_strength() > 0.0f; }
    [[nodiscard]] glm::vec3 mean() const { return settings_.mean; }
    [[nodiscard]] double ground() const { return settings_.ground; }
    [[nodiscard]] const Settings& settings() const { return settings_; }
    /// [m/s] Standard deviation of each level component of the gusts: intensity times the level mean speed.
    [[nodiscard]] float gust_strength() const;
    [[nodiscard]] glm::vec3 gust_axes() const { return gust_axes_; }
    /// Factor of the mean wind at a world height [m]; 1 without a profile.
    [[nodiscard]] float profile_at(double height) const;
    /// The tile, one for all copies; empty where nothing needs it. For a 3D texture of 128 x 16 x 128.
    [[nodiscard]] const std::shared_ptr<const GustTile>& tile() const { return settings_.gusts.tile; }

    /// Position of a world coordinate [m] in the tile along one axis: the texel below, wrapped (-1 to 127; along y to 31, a whole
    /// period), and the distance from its centre, 0 to 1.
    struct TilePlace {
        int texel = 0;
        float fraction = 0.0f;
    };
    [[nodiscard]] TilePlace gust_place(int axis, double coordinate) const { return place(axis, coordinate, 1); }

  private:
    explicit AmbientWind(const Settings& settings) : settings_(settings) {}
    [[nodiscard]] TilePlace place(int axis, double coordinate, int repeats) const;
    [[nodiscard]] double texel() const { return static_cast<double>(settings_.gusts.length) / GustTile::k_gust_texels; }

    Settings settings_;
    glm::vec3 gust_axes_{1.0f};
    glm::dvec3 phase_{0.0};
};

} // namespace windrow
