// A cloud of shells: what it covers, how it heaps up, how it ends before its plane does. The equations stand in
// vegetation/shaders/numerics/cloud_shells.glsl; the layers lie above and below a plane.
#pragma once

#include "fluid/result.h"
#include "vegetation/fur/strand_numerics.h"

#include <glm/vec2.hpp>

namespace windrow::vegetation::fur {

struct CloudShellSettings {
    /// Share of the plane that is covered, roughly; 0 (none) to 1. Default 0.45: fair weather.
    float cover = 0.45f;
    /// [m] Size of a heap, 0.01 to 1e5. Default 40.
    float size = 40.0f;
    /// How far a heap hangs below its plane over how far it stands above, 0.01 to 1. Default 0.25: a flat base; 1 mirrors, as the
    /// source has it.
    float base = 0.25f;
    /// How much a finer noise eats of the heaps' form, 0 (smooth) to 1. Default 0.3.
    float billow = 0.3f;
    /// Octaves of the heaps' noise, 1 to 8. Default 4. Each costs four hashes a fragment.
    int octaves = 4;
    /// Another sky for each, 0 to 1e6. Default 0.
    int seed = 0;
    /// [m] Half sizes of the plane along x and z, 0.01 to 1e6. Default 100 each.
    glm::vec2 half_size{100.0f};
    /// [m] Over which clouds thin out toward the plane's rim, 0.01 to 1e6. Default 40. More than a half size thins the whole
    /// cloud.
    float fading = 40.0f;
    /// Whether the rim is an ellipse or the rectangle itself. Default: an ellipse.
    bool round_rim = true;
    /// [m] Half of the cloud's height: what a layer of h = 1 lies above the plane; 1e-3 to 1e5. Default 12.
    float height = 12.0f;
};

/// WindrowCloudShells of vegetation/shaders/numerics/cloud_shells.glsl says what each component is; std140.
using CloudShellBlock = numerics::WindrowCloudShells;
static_assert(sizeof(CloudShellBlock) == 4 * 16);

/// Refuses what is out of range; every reason.
[[nodiscard]] windrow::Result<void> validate(const CloudShellSettings& settings);

/// What shaders are told, of settings that `validate` takes. `drift` [m] is how far the air has gone: summed up in double, since
/// floats hold it to a hundredth of a metre at 1e5 m. `evolved` counts in sizes of a heap: the heaps change wholly within about
/// one.
[[nodiscard]] CloudShellBlock block(const CloudShellSettings& settings, glm::dvec2 drift = glm::dvec2(0.0), double evolved = 0.0);

} // namespace windrow::vegetation::fur
