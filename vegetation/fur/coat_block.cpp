#include "vegetation/fur/coat_block.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace windrow::vegetation::fur {
namespace {

glm::ivec4 form_of(const CoatSettings& settings) {
    return {settings.translated ? 1 : 0, static_cast<int>(settings.wind_at), settings.strands_on == StrandsOn::surface ? 1 : 0,
            settings.bare ? 1 : 0};
}

// Its height and size are the coat's.
CloudShellSettings fitted(const CoatSettings& settings, const Mesh& mesh) {
    CloudShellSettings cloud = *settings.cloud;
    cloud.height = settings.layers.length;
    const glm::vec3 half_size = 0.5f * (mesh.high - mesh.low);
    cloud.half_size = glm::max(glm::vec2(half_size.x, half_size.z), glm::vec2(0.01f));
    return cloud;
}

} // namespace

CloudShellBlock cloud_block(const CoatSettings& settings, const Mesh& mesh, glm::dvec2 drift, double evolved) {
    return settings.cloud ? block(fitted(settings, mesh), drift, evolved) : CloudShellBlock{};
}

windrow::ShellBlock scaled(const windrow::ShellBlock& block, float scale) {
    windrow::ShellBlock made = block;
    made.form.x *= scale;
    made.push.x *= scale;
    made.push.z *= scale;
    return made;
}

CoatBlock coat_block(const CoatSettings& settings, const Mesh& mesh, int samples) {
    const CoatLook& look = settings.look;
    const CoatLevels& levels = settings.levels;
    CoatBlock made;
    made.shells = windrow::Shells::create(settings.layers)->block(); // was validated
    made.field = block(settings.strands);
    made.levels.z = settings.wind_fraction;
    made.layers = {0, levels.outer_first ? 1 : 0, settings.mirrored ? 1 : 0, 0};
    made.form = form_of(settings);
    made.drawing = {levels.march, samples, static_cast<int>(settings.spots.size()), 0};
    made.comb = glm::vec4(glm::normalize(settings.comb.along), settings.comb.bend);
    made.tousle = {settings.comb.tousle, 1.0f / settings.comb.tousle_size, 0.0f, settings.maps.bald_below};
    made.root = glm::vec4(look.root, look.tip_power);
    made.tip = glm::vec4(look.tip, look.variation);
    made.second = glm::vec4(look.second, 1.0f / look.second_size);
    made.skin = glm::vec4(look.skin, look.occlusion_bias);
    made.light = {look.occlusion, look.wrap, look.gloss, look.gloss_power};
    made.sheen = {look.sheen, look.sheen_power, look.through, look.strand_normals};
    made.cel = {static_cast<float>(look.cel_steps), look.square_normals, settings.cloud ? 1.0f : 0.0f, 0.0f};
    made.low = glm::vec4(mesh.low, static_cast<float>(settings.maps.projection));
    made.extent = glm::vec4(1.0f / glm::max(mesh.high - mesh.low, glm::vec3(1e-6f)), settings.maps.noise_tiles);
    made.influence = {settings.maps.influence_a, settings.maps.influence_b, settings.foot_push, look.exact_normals ? 1.0f : 0.0f};
    made.cloud = cloud_block(settings, mesh, glm::dvec2(0.0), 0.0);
    for (std::size_t n = 0; n < std::min(settings.spots.size(), k_max_spots); ++n) {
        const Spot& spot = settings.spots[n];
        made.spots[n] = {.from = glm::vec4(spot.from, spot.radius),
                         .to = glm::vec4(spot.to, spot.soft),
                         .tint = glm::vec4(spot.colour, spot.tint),
                         .more = {spot.length, spot.glow, 0.0f, 0.0f}};
    }
    return made;
}

} // namespace windrow::vegetation::fur
