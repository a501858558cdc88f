// Frame block of all shaders of the renderer (vegetation/shaders/render/frame.glsl), and its conversion from a scene.
#pragma once

#include "scene.h"

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

namespace windrow::vegetation::render {

/// WindrowSky of vegetation/shaders/numerics/sky.glsl.
struct SkyBlock {
    glm::vec4 sun{0.0f, 1.0f, 0.0f, 0.00465f};
    glm::vec4 rayleigh{0.0f};
    glm::vec4 haze{0.0f};
};

/// WindrowClouds of vegetation/shaders/numerics/cloud_layer.glsl.
struct CloudBlock {
    glm::vec4 place{0.0f, 0.0f, 1.0f, 1.0f};
    glm::vec4 form{0.0f};
};

/// Debug view of the grass instead of its colours: vegetation/shaders/render/grass_view.glsl.
enum class GrassView : int {
    plants, ///< its colours
    lean,   ///< how far blades lean, by the colours of speed: straw at 1.5 rad
    levels, ///< near blades green, yellow as they morph; far ones blue
    chunks  ///< each chunk in a colour of its own
};

/// A uniform block of std140 layout.
struct ViewBlock {
    glm::mat4 view_projection{1.0f}, view_projection_before{1.0f}, from_clip{1.0f};
    std::array<glm::mat4, 2> shadow{glm::mat4(1.0f), glm::mat4(1.0f)};
    glm::vec4 eye{0.0f}, eye_before{0.0f};
    SkyBlock sky{};
    glm::vec4 sunlight{0.0f}, skylight{0.0f}, groundlight{0.0f};
    glm::vec4 shadow_texel{0.0f};
    glm::vec4 terrain{0.0f};
    glm::ivec4 terrain_size{0};
    glm::vec4 pixel{0.0f};
    CloudBlock clouds{};
    glm::vec4 cloud_map{0.0f};
};
static_assert(sizeof(ViewBlock) == 560);

/// From world to clip space of Vulkan: y down, depth 0 to 1. `anchor` [m] is where shaders count from.
[[nodiscard]] glm::mat4 view_projection(const Camera& camera, float aspect, glm::dvec3 anchor);

/// The sky under a sun: optical depths at 0.68, 0.55 and 0.44 um, which stand for red, green and blue.
[[nodiscard]] SkyBlock sky_block(const Sun& sun);
/// Irradiance across the sun's beam at the ground.
[[nodiscard]] glm::vec3 sun_irradiance(const SkyBlock& sky);
/// Irradiance that a level face has from the whole sky: an integral over 32 x 64 directions.
[[nodiscard]] glm::vec3 sky_irradiance(const SkyBlock& sky);

/// The clouds at a time [s], relative to an anchor [m].
[[nodiscard]] CloudBlock cloud_block(const Clouds& clouds, glm::dvec3 anchor, double time);

/// One shadow map: an orthographic view along the sun.
struct ShadowView {
    glm::mat4 matrix{1.0f};
    float texel = 0.0f; ///< [m]
};
/// A view around what the camera sees between two distances. Its size does not depend on where the camera looks, and it moves by
/// whole texels of the world (the anchor being one of its corners): edges of shadows stand still while the camera moves or turns.
[[nodiscard]] ShadowView shadow_view(const Camera& camera, float aspect, glm::dvec3 anchor, const SkyBlock& sky, float from,
                                     float to, int texels);

/// Whether a ball may be seen in a view: not wholly beyond one of its planes.
[[nodiscard]] bool sees(const glm::mat4& view, glm::vec3 middle, float radius);

} // namespace windrow::vegetation::render
