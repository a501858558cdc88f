#include "vegetation/render/terrain.h"

#include "shader_words/ground_map.h"
#include "shader_words/terrain_frag.h"
#include "shader_words/terrain_shadow_vert.h"
#include "shader_words/terrain_vert.h"
#include "vegetation/render/plant_look_block.h"
#include "vegetation/vulkan/calls.h"
#include "vegetation/vulkan/descriptors.h"

#include <array>
#include <cstring>
#include <glm/common.hpp>

namespace windrow::vegetation::render {

namespace words = windrow::vulkan::shader_words;

namespace {

// Of the ground's noise: a texel more than the ground has on each side, to filter by.
NoiseMapRecipe map_of(const Ground& ground, int texels) {
    constexpr float texel = 0.25f; // [m] k_ground_texel of noise_map.glsl
    const glm::ivec2 end = glm::ivec2(glm::ceil(ground.heights.extent() / texel)) + 1;
    return {.texels = texels,
            .texel = texel,
            .bounds = {glm::ivec2(-1), end},
            .format = VK_FORMAT_R8G8B8A8_UNORM, // every device stores to it and filters it
            .fill = words::ground_map};
}

} // namespace

engine::Buffer Terrain::heights(engine::Objects& objects, const Ground& ground) {
    return filled(objects, ground.heights.heights(), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
}

Terrain::Terrain(engine::Objects& objects, const DrawTargets& targets, const Scene& scene, int map_texels, bool front_first)
    : tiles_(scene.ground.heights), map_(objects, map_of(scene.ground, map_texels)), front_first_(front_first) {
    const Ground& ground = scene.ground;
    const std::array bindings{engine::Binding{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, VK_SHADER_STAGE_ALL_GRAPHICS},
                              engine::Binding{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_SHADER_STAGE_FRAGMENT_BIT},
                              engine::Binding{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, VK_SHADER_STAGE_FRAGMENT_BIT},
                              engine::Binding{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, VK_SHADER_STAGE_FRAGMENT_BIT}};
    const VkDescriptorSetLayout own = make_layout(objects, bindings);
    const std::array sets{targets.frame, targets.wind, own};
    layout_ = make_pipeline_layout(objects, sets);
    constexpr VkPrimitiveTopology strip = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP;
    colour_ = make_pipeline(objects, {.vertex = words::terrain_vert,
                                      .fragment = words::terrain_frag,
                                      .layout = layout_,
                                      .target = targets.colour,
                                      .topology = strip});
    shadow_ = make_pipeline(
        objects,
        {.vertex = words::terrain_shadow_vert, .layout = layout_, .target = targets.shadow, .topology = strip, .bias = true});
    make_sets(objects, own, bindings, std::span(&set_, 1));
    const engine::Buffer block = filled_block(objects, PlantLookBlock(scene.look), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
    point(objects.device(), set_, 0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, block.buffer);
    const std::vector<float> everywhere(4, 1.0f);
    std::span<const float> grown = everywhere;
    if (ground.grown) {
        grown = ground.grown->values();
        mask_corners_ = ground.grown->grid().corners;
    }
    const engine::Buffer mask = filled(objects, grown, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    point(objects.device(), set_, 1, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, mask.buffer);
    const auto blades = windrow::Blades::create(scene.plants); // was validated
    const engine::Buffer grass = filled_block(objects, blades->block(), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
    point(objects.device(), set_, 2, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, grass.buffer);
    point(objects.device(), set_, 3, map_.view(), map_.sampler(), VK_IMAGE_LAYOUT_GENERAL);
}

Result<void> Terrain::prepare(const PassContext& context) {
    const ViewBlock& block = *context.block;
    const glm::vec3 corner(block.terrain.x, block.terrain.w, block.terrain.y);
    const std::array views{block.view_projection, block.shadow[0], block.shadow[1]};
    for (std::size_t n = 0; n < views.size(); ++n)
        tiles_.find_seen(views[n], corner, draws_[n]);
    if (front_first_)
        tiles_.sort_strips(glm::vec2(block.eye.x, block.eye.z) - glm::vec2(corner.x, corner.z), draws_[0]);
    map_.record(context.commands, glm::vec2(block.eye.x, block.eye.z) - glm::vec2(corner.x, corner.z));
    return {};
}

void Terrain::draw(const PassContext& context) {
    const bool shadow = context.pass == Pass::shadow;
    const std::array sets{context.frame, context.wind, set_};
    vkCmdBindDescriptorSets(context.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_, 0, 3, sets.data(), 0, nullptr);
    if (shadow)
        vkCmdPushConstants(context.commands, layout_, VK_SHADER_STAGE_ALL, 0, sizeof context.cascade, &context.cascade);
    else
        vkCmdPushConstants(context.commands, layout_, VK_SHADER_STAGE_ALL, 8, sizeof mask_corners_, &mask_corners_);
    vkCmdBindPipeline(context.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, shadow ? shadow_ : colour_);
    const TerrainTiles::Draws& seen = draws_[shadow ? 1 + static_cast<std::size_t>(context.cascade) : 0];
    const auto record = [&](std::span<const TerrainDraw> draws, std::int32_t level_side) {
        vkCmdPushConstants(context.commands, layout_, VK_SHADER_STAGE_ALL, 4, sizeof level_side, &level_side);
        for (const TerrainDraw& draw : draws)
            vkCmdDraw(context.commands, draw.vertices, draw.instances, draw.first_vertex, draw.first_instance);
    };
    record(seen.strips, 0);
    record(seen.level, TerrainTiles::k_side);
}

} // namespace windrow::vegetation::render
