// Blades of grass on the CPU: bend in the wind, and vertices. Shaders use the same source
// (shaders/coupling/windrow_plants.glsl).
//
//     auto grass = windrow::Blades::create({});                                    // or {.stalk = windrow::wheat()}
//     if (!grass)
//         return std::fprintf(stderr, "%s\n", grass.error().c_str()), 1;
//     const windrow::PlantKey key = windrow::place_key(3.0f, 4.0f);
//     const glm::vec3 load = grass->load(key, {5.0f, 0.0f, 0.0f});                  // [rad] in a wind of 5 m/s along x
//     const windrow::PlantVertex tip = grass->vertex(key, load, 1.0f, 0.0f);        // [m] from the root
//
// The load is the bend in a steady wind. A spring may follow it; its state is then the load. The equations are
// in shaders/numerics/blade.glsl, stem.glsl and plant_drag.glsl; docs/plants.md draws them.
#pragma once

#include "../fluid/api.h"
#include "../fluid/parallel.h"
#include "../fluid/result.h"
#include "drag.h"
#include "plant_vertex.h"

#include <glm/vec4.hpp>
#include <span>

namespace windrow {

/// Form and stiffness of a blade of grass.
struct BladeSettings {
    /// Properties of the stalk that the class does not set. The defaults are those of meadow grass.
    Drag stalk{};
    /// 0 to 0.9, default 0.3. Fraction by which lengths vary. A blade bends by its own length: in a light wind as its cube, 0.34
    /// to 2.2 times as far as the class at 0.3.
    float length_spread = 0.3f;
    /// [m] 0 to 10, default 0.006. Width of the drawn strip at its root. 0.006 is a blade of 4 mm, drawn wider since only a few
    /// are drawn.
    float width = 0.006f;
    /// 0 to 1, default 0.1. The tip's width over the root's.
    float tip_width = 0.1f;
    /// A number above 0, at most 10, default 2. Exponent of the width over height: width (1 - (1 - tip_width) h^taper). 2 is wide
    /// for long and pointed at the end.
    float taper = 2.0f;
    /// 0 to 1, default 1. Fraction of the load that bends the blade along the wind; the rest bends it about its own wide axis
    /// only. 1 is for stems and twisted blades.
    float along_wind = 1.0f;
    /// 0 to 0.9, default 0.3. Fraction by which stiffness varies, so that blades move differently.
    float stiffness_spread = 0.3f;
    /// [rad] -3 to 3, default 0.5. Bend of the tip at rest, toward the face. 0 is straight.
    float rest_bend = 0.5f;
    /// [rad] 0 to 3, default 0.3. Spread of the rest bend.
    float rest_bend_spread = 0.3f;
    /// 0 to 1, default 0.5. Shape of the rest bend: 0 a uniform arc, 1 all at the tip.
    float rest_curve = 0.5f;
    /// [rad] 0 to 3, default 0. Added to the own bend when seen from straight above; 0.5 covers ground that would show between
    /// upright blades.
    float view_bend = 0.0f;
    /// 0 to 2, default 0.3. Turn of the tip toward a wind that blows against its corner, over its bend, by wind, walkers or a
    /// spring. 0: none, as for stems; so a scene has it for classes of stems. A strip has 3/4 of its width over its length times
    /// the ratio of its stiffnesses, bending over twisting: 0.3 for 4 mm on 0.3 m and a ratio of 30. Stems of tulips and
    /// daffodils have 8 and 13 (Etnier & Vogel 2000, Am. J. Bot. 87, 29); that of a channelled blade is ours.
    float twist = 0.3f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("stalk", &BladeSettings::stalk,
                    "Properties of the stalk that the class does not set. The defaults are those of meadow grass."),
            Setting(
                "length_spread", &BladeSettings::length_spread, {0.0, 0.9},
                "Fraction by which lengths vary. A blade bends by its own length: in a light wind as its cube, 0.34 to 2.2 times "
                "as far as the class at 0.3."),
            Setting("width", &BladeSettings::width, {0.0, 10.0, "m"},
                    "Width of the drawn strip at its root. 0.006 is a blade of 4 mm, drawn wider since only a few are drawn."),
            Setting("tip_width", &BladeSettings::tip_width, k_fraction_range, "The tip's width over the root's."),
            Setting("taper", &BladeSettings::taper, Range::above(0.0, 10.0),
                    "Exponent of the width over height: width (1 - (1 - tip_width) h^taper). 2 is wide for long and pointed at "
                    "the end."),
            Setting(
                "along_wind", &BladeSettings::along_wind, k_fraction_range,
                "Fraction of the load that bends the blade along the wind; the rest bends it about its own wide axis only. 1 is "
                "for stems and twisted blades."),
            Setting("stiffness_spread", &BladeSettings::stiffness_spread, {0.0, 0.9},
                    "Fraction by which stiffness varies, so that blades move differently."),
            Setting("rest_bend", &BladeSettings::rest_bend, {-3.0, 3.0, "rad"},
                    "Bend of the tip at rest, toward the face. 0 is straight."),
            Setting("rest_bend_spread", &BladeSettings::rest_bend_spread, {0.0, 3.0, "rad"}, "Spread of the rest bend."),
            Setting("rest_curve", &BladeSettings::rest_curve, k_fraction_range,
                    "Shape of the rest bend: 0 a uniform arc, 1 all at the tip."),
            Setting(
                "view_bend", &BladeSettings::view_bend, {0.0, 3.0, "rad"},
                "Added to the own bend when seen from straight above; 0.5 covers ground that would show between upright blades."),
            Setting(
                "twist", &BladeSettings::twist, {0.0, 2.0},
                "Turn of the tip toward a wind that blows against its corner, over its bend, by wind, walkers or a spring. 0: "
                "none, as for "
                "stems; so a scene has it for classes of stems. A "
                "strip has 3/4 of its width over its length times the ratio of its stiffnesses, bending over twisting: 0.3 for "
                "4 mm on 0.3 m and a ratio of 30. Stems of tulips and daffodils have 8 and 13 (Etnier & Vogel 2000, Am. J. Bot. "
                "87, 29); that of a channelled blade is ours."),
        };
    }
};

/// Shader block: WindrowBlade of shaders/numerics/blade.glsl, a std140 block of four vec4.
struct BladeBlock {
    glm::vec4 size{0.0f}; ///< x [m] length, y its spread; z [m] half of the root's width, w the tip's width over the root's
    glm::vec4 form{0.0f}; ///< x taper; y fraction along the wind; z spread of the stiffness; w curve of the own bend
    glm::vec4 own{0.0f};  ///< x [rad] own bend, y its spread, z view bend; w twist
    DragBlock drag{};
};
static_assert(sizeof(BladeBlock) == 64);

[[nodiscard]] WINDROW_API Result<void> validate(const BladeSettings& settings);

/// A class of blades. Small; copy it.
class WINDROW_API Blades {
  public:
    /// Rejects what `validate` rejects, with every reason.
    [[nodiscard]] static Result<Blades> create(const BladeSettings& settings);

    [[nodiscard]] const BladeSettings& settings() const { return settings_; }
    [[nodiscard]] const BladeBlock& block() const { return block_; }
    /// [m] Length of one blade.
    [[nodiscard]] float length(PlantKey key) const;

    /// [rad] Direction of lean times angle of the tip that a wind [m/s] holds, level. 0 for a wind that is not finite. Give the
    /// wind less the plant's own velocity, if it has one.
    [[nodiscard]] glm::vec3 load(PlantKey key, glm::vec3 wind) const;
    /// A vertex at height h, 0 to 1, and side -1 to 1. `view` is the unit vector from the eye to the blade, for view_bend.
    [[nodiscard]] PlantVertex vertex(PlantKey key, glm::vec3 load, float h, float side,
                                     glm::vec3 view = {0.0f, 0.0f, 1.0f}) const;

    /// `load` for many: keys, winds and loads have one entry a blade; of vec4 the first three count. The result does not depend
    /// on the number of threads. Rejects spans of different sizes and touches nothing then.
    Result<void> loads(std::span<const PlantKey> keys, std::span<const glm::vec4> winds, std::span<glm::vec4> loads,
                       const ParallelFor& parallel_for = {}) const;

    /// Output of `vertices`.
    struct Vertices {
        std::span<glm::vec4> positions; ///< [m] xyz roots + the blade's, w h; blade by blade, row by row, left then right
        std::span<glm::vec4> normals;   ///< xyz unit vectors, w 0; empty: not wanted
    };
    /// Vertices of many blades: `heights` of the rows, 0 to 1, two vertices each. `roots` [m], `loads` [rad] and keys have one
    /// entry a blade; positions (and normals) have blades * rows * 2. Rejects sizes that do not fit and heights outside 0 to 1.
    Result<void> vertices(std::span<const PlantKey> keys, std::span<const glm::vec4> roots, std::span<const glm::vec4> loads,
                          std::span<const float> heights, const Vertices& out, glm::vec3 view = {0.0f, 0.0f, 1.0f},
                          const ParallelFor& parallel_for = {}) const;

  private:
    explicit Blades(const BladeSettings& settings);

    BladeSettings settings_;
    BladeBlock block_;
};

} // namespace windrow
