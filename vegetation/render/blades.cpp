#include "vegetation/render/blades.h"

#include "shader_words/blade_bend.h"
#include "shader_words/blade_shadow_vert.h"
#include "shader_words/blade_vert.h"
#include "shader_words/plant_frag.h"
#include "vegetation/render/plant_look_block.h"
#include "vegetation/vulkan/descriptors.h"

#include <array>
#include <cstring>
#include <vulkan/vulkan.h>

namespace windrow::vegetation::render {
namespace {

namespace words = windrow::vulkan::shader_words;

// As the shaders count them: rows of two vertices, and the tip.
constexpr std::uint32_t k_vertices = 11, k_shadow_vertices = 7;
constexpr std::uint32_t k_group = 64;

constexpr VkShaderStageFlags k_graphics = VK_SHADER_STAGE_ALL_GRAPHICS;
constexpr VkShaderStageFlags k_both = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_COMPUTE_BIT;
constexpr std::array k_bindings{engine::Binding{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, k_graphics | VK_SHADER_STAGE_COMPUTE_BIT},
                                engine::Binding{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, k_both},
                                engine::Binding{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, k_both},
                                engine::Binding{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, k_both}};

} // namespace

Result<std::unique_ptr<BladeGrid>> BladeGrid::create(engine::Device& device, const DrawTargets& targets,
                                                     const windrow::BladeSettings& plants, const PlantLook& look,
                                                     std::span<const BladePlace> places) {
    return engine::guarded([&] {
        const windrow::Blades blades = engine::must(windrow::Blades::create(plants));
        return std::unique_ptr<BladeGrid>(new BladeGrid(device, targets, blades, look, places));
    });
}

BladeGrid::BladeGrid(engine::Device& device, const DrawTargets& targets, const windrow::Blades& plants, const PlantLook& look,
                     std::span<const BladePlace> places)
    : objects_(device), count_(static_cast<std::uint32_t>(places.size())) {
    const VkDescriptorSetLayout own = make_layout(objects_, k_bindings);
    const std::array sets{targets.frame, targets.wind, own};
    layout_ = make_pipeline_layout(objects_, sets);
    bend_ = make_compute_pipeline(objects_, layout_, words::blade_bend);
    constexpr VkPrimitiveTopology strip = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP;
    colour_ = make_pipeline(objects_, {.vertex = words::blade_vert,
                                       .fragment = words::plant_frag,
                                       .layout = layout_,
                                       .target = targets.colour,
                                       .topology = strip});
    shadow_ = make_pipeline(
        objects_,
        {.vertex = words::blade_shadow_vert, .layout = layout_, .target = targets.shadow, .topology = strip, .bias = true});

    constexpr VkBufferUsageFlags uniform = VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    const engine::Buffer look_buffer = filled_block(objects_, PlantLookBlock(look), uniform);
    const engine::Buffer blade_buffer = filled_block(objects_, plants.block(), uniform);
    const engine::Buffer place_buffer = filled(objects_, places, storage);
    bends_ = objects_.buffer(engine::Use::work, sizeof(glm::vec4) * places.size(), storage | VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
    make_sets(objects_, own, k_bindings, std::span(&set_, 1));
    point(device, set_, 0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, look_buffer.buffer);
    point(device, set_, 1, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, blade_buffer.buffer);
    point(device, set_, 2, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, place_buffer.buffer);
    point(device, set_, 3, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, bends_.buffer);
}

Result<void> BladeGrid::prepare(const PassContext& context) {
    const std::array sets{context.frame, context.wind, set_};
    vkCmdBindDescriptorSets(context.commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout_, 0, 3, sets.data(), 0, nullptr);
    vkCmdPushConstants(context.commands, layout_, VK_SHADER_STAGE_ALL, 0, sizeof count_, &count_);
    vkCmdBindPipeline(context.commands, VK_PIPELINE_BIND_POINT_COMPUTE, bend_);
    // The frame before has read its bends.
    vkCmdPipelineBarrier(context.commands, VK_PIPELINE_STAGE_VERTEX_SHADER_BIT, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, 0, 0,
                         nullptr, 0, nullptr, 0, nullptr);
    vkCmdDispatch(context.commands, (count_ + k_group - 1) / k_group, 1, 1);
    VkMemoryBarrier barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
    barrier.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_SHADER_READ_BIT;
    vkCmdPipelineBarrier(context.commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_VERTEX_SHADER_BIT, 0, 1,
                         &barrier, 0, nullptr, 0, nullptr);
    return {};
}

void BladeGrid::draw(const PassContext& context) {
    const std::array sets{context.frame, context.wind, set_};
    vkCmdBindDescriptorSets(context.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_, 0, 3, sets.data(), 0, nullptr);
    const bool shadow = context.pass == Pass::shadow;
    if (shadow)
        vkCmdPushConstants(context.commands, layout_, VK_SHADER_STAGE_ALL, 0, sizeof context.cascade, &context.cascade);
    vkCmdBindPipeline(context.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, shadow ? shadow_ : colour_);
    vkCmdDraw(context.commands, shadow ? k_shadow_vertices : k_vertices, count_, 0, 0);
}

Result<std::vector<glm::vec4>> BladeGrid::bends() const {
    return objects_.device().read<glm::vec4>(bends_.buffer, 0, count_);
}

} // namespace windrow::vegetation::render
