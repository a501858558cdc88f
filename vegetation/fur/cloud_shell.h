// A cloud of shells: cover, heaps, and fading before the edge of its plane. The equations are in
// vegetation/shaders/numerics/cloud_shells.glsl; the layers lie above and below a plane.
#pragma once

#include "../../coupling/drag.h"
#include "strand_numerics.h"

#include <glm/vec2.hpp>

namespace windrow::vegetation::fur {

struct CloudShellSettings {
    float cover = 0.45f;
    float size = 40.0f;
    float base = 0.25f;
    float billow = 0.3f;
    float soft = 0.15f;
    int octaves = 4;
    int seed = 0;
    glm::vec2 half_size{100.0f};
    float fading = 40.0f;
    bool round_rim = true;
    float height = 12.0f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("cover", &CloudShellSettings::cover, {.min = 0.0, .max = 1.0, .zero = "none"},
                    "Fraction of the plane that is covered, roughly; 0.45 is fair weather."),
            Setting("size", &CloudShellSettings::size, {0.01, 1e5, "m"}, "Of a heap."),
            Setting("base", &CloudShellSettings::base, {0.01, 1.0},
                    "How far a heap hangs below its plane over how far it stands above: a flat base; 1 mirrors."),
            Setting("billow", &CloudShellSettings::billow, k_fraction_range,
                    "Strength of the finer noise in the form of the heaps."),
            Setting("soft", &CloudShellSettings::soft, {.min = 0.0, .max = 1.0, .zero = "a hard edge"},
                    "Depth of the edge over half of the cloud's height: light shines through it, and one sees into it."),
            Setting("octaves", &CloudShellSettings::octaves, {1.0, 8.0},
                    "Of the heaps' noise. Each costs four hashes a fragment."),
            Setting("seed", &CloudShellSettings::seed, {0.0, 1e6}, "Another number, another sky."),
            Setting("half_size", &CloudShellSettings::half_size,
                    "Half sizes [m] of the plane along x and z, 0.01 to 1e6. Of a coat, those of the mesh.", k_not_stored),
            Setting("fading", &CloudShellSettings::fading, {0.01, 1e6, "m"},
                    "Width over which clouds thin out toward the plane's edge. More than a half size thins the whole cloud."),
            Setting("round_rim", &CloudShellSettings::round_rim,
                    "Whether the edge is an ellipse; else it is the rectangle itself."),
            Setting("height", &CloudShellSettings::height,
                    "Half of the cloud's height [m], 1e-3 to 1e5: the height of the layer h = 1 above the plane. Of a coat, the "
                    "layers' length.",
                    k_not_stored),
        };
    }
};

/// WindrowCloudShells of vegetation/shaders/numerics/cloud_shells.glsl says what each component is; std140.
using CloudShellBlock = numerics::WindrowCloudShells;
static_assert(sizeof(CloudShellBlock) == 4 * 16);

/// Rejects what is out of range; every reason.
[[nodiscard]] windrow::Result<void> validate(const CloudShellSettings& settings);
void check_rules(windrow::detail::Reasons& reasons, const windrow::detail::FieldPath& path, const CloudShellSettings& settings);

/// Shader block of valid settings. `drift` [m] is the distance that the air has gone, summed in double, since floats resolve only
/// a hundredth of a metre at 1e5 m. `evolved` counts in sizes of a heap: the heaps change wholly within about
/// one.
[[nodiscard]] CloudShellBlock block(const CloudShellSettings& settings, glm::dvec2 drift = glm::dvec2(0.0), double evolved = 0.0);

} // namespace windrow::vegetation::fur
