#include "vegetation/render/bodies.h"

#include "vegetation/render/descriptors.h"
#include "shader_words/solid_frag.h"
#include "shader_words/solid_shadow_vert.h"
#include "shader_words/solid_vert.h"

#include <cstring>
#include <vulkan/vulkan.h>

namespace windrow::vegetation::render {
namespace {

namespace words = windrow::vulkan::shader_words;

constexpr std::array k_bindings{Binding{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_SHADER_STAGE_VERTEX_BIT},
                                Binding{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_SHADER_STAGE_VERTEX_BIT}};

} // namespace

Bodies::Bodies(engine::Device& device, const DrawTargets& targets, std::span<const Solid> shapes)
    : places_(shapes.size()), placed_(shapes.size(), false) {
    Solid all;
    for (const Solid& shape : shapes) {
        ranges_.push_back({static_cast<std::uint32_t>(all.size()), static_cast<std::uint32_t>(shape.size())});
        all.insert(all.end(), shape.begin(), shape.end());
    }
    const VkDescriptorSetLayout own = make_layout(device, k_bindings);
    const std::array layouts{targets.frame, targets.wind, own};
    layout_ = make_pipeline_layout(device, layouts);
    colour_ = make_pipeline(
        device, {.vertex = words::solid_vert, .fragment = words::solid_frag, .layout = layout_, .target = targets.colour});
    shadow_ =
        make_pipeline(device, {.vertex = words::solid_shadow_vert, .layout = layout_, .target = targets.shadow, .bias = true});

    const engine::Buffer vertices = device.make_buffer(sizeof(SolidVertex) * all.size(), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    std::memcpy(vertices.mapped, all.data(), sizeof(SolidVertex) * all.size());
    make_sets(device, own, k_bindings, sets_);
    for (std::size_t slot = 0; slot < sets_.size(); ++slot) {
        blocks_[slot] = device.make_buffer(sizeof(Place) * places_.size(), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
        point(device, sets_[slot], 0, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, vertices.buffer);
        point(device, sets_[slot], 1, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, blocks_[slot].buffer);
    }
}

void Bodies::place(std::size_t body, const glm::mat4& placed) {
    Place& place = places_[body];
    place.before = placed_[body] ? place.now : placed;
    place.now = placed;
    placed_[body] = true;
}

void Bodies::prepare(const PassContext& context) {
    std::memcpy(blocks_[static_cast<std::size_t>(context.slot)].mapped, places_.data(), sizeof(Place) * places_.size());
}

void Bodies::draw(const PassContext& context) {
    const std::array sets{context.frame, context.wind, sets_[static_cast<std::size_t>(context.slot)]};
    vkCmdBindDescriptorSets(context.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_, 0, 3, sets.data(), 0, nullptr);
    const bool shadow = context.pass == Pass::shadow;
    if (shadow)
        vkCmdPushConstants(context.commands, layout_, VK_SHADER_STAGE_ALL, 0, sizeof context.cascade, &context.cascade);
    vkCmdBindPipeline(context.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, shadow ? shadow_ : colour_);
    for (std::size_t body = 0; body < ranges_.size(); ++body)
        vkCmdDraw(context.commands, ranges_[body].count, 1, ranges_[body].first, static_cast<std::uint32_t>(body));
}

} // namespace windrow::vegetation::render
