#include "vegetation/render/bodies.h"

#include "shader_words/solid_frag.h"
#include "shader_words/solid_shadow_vert.h"
#include "shader_words/solid_vert.h"
#include "vegetation/vulkan/calls.h"
#include "vegetation/vulkan/descriptors.h"

#include <cstring>

namespace windrow::vegetation::render {
namespace {

namespace words = windrow::vulkan::shader_words;

constexpr std::array k_bindings{engine::Binding{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_SHADER_STAGE_VERTEX_BIT},
                                engine::Binding{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_SHADER_STAGE_VERTEX_BIT}};

} // namespace

Result<std::unique_ptr<Bodies>> Bodies::create(engine::Device& device, const DrawTargets& targets, std::span<const Solid> shapes,
                                               std::size_t copies) {
    return engine::guarded([&] { return std::unique_ptr<Bodies>(new Bodies(device, targets, shapes, copies)); });
}

Bodies::Bodies(engine::Device& device, const DrawTargets& targets, std::span<const Solid> shapes, std::size_t copies)
    : objects_(device) {
    Solid all;
    for (const Solid& shape : shapes) {
        for (std::size_t copy = 0; copy < copies; ++copy) {
            ranges_.push_back({.first = static_cast<std::uint32_t>(all.size()),
                               .count = static_cast<std::uint32_t>(shape.size()),
                               .first_place = static_cast<std::uint32_t>(places_.size())});
            places_.resize(places_.size() + parts_of(shape));
        }
        all.insert(all.end(), shape.begin(), shape.end());
    }
    placed_.resize(places_.size(), false);
    const VkDescriptorSetLayout own = make_layout(objects_, k_bindings);
    const std::array layouts{targets.frame, targets.wind, own};
    layout_ = make_pipeline_layout(objects_, layouts);
    colour_ = make_pipeline(
        objects_, {.vertex = words::solid_vert, .fragment = words::solid_frag, .layout = layout_, .target = targets.colour});
    shadow_ =
        make_pipeline(objects_, {.vertex = words::solid_shadow_vert, .layout = layout_, .target = targets.shadow, .bias = true});

    const engine::Buffer vertices = filled(objects_, all, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    blocks_ = objects_.frame_buffers(sizeof(Place) * places_.size(), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    make_sets(objects_, own, k_bindings, sets_);
    for (std::size_t slot = 0; slot < sets_.size(); ++slot) {
        point(device, sets_[slot], 0, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, vertices.buffer);
        point(device, sets_[slot], 1, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, blocks_[slot].buffer);
    }
}

void Bodies::place(std::size_t body, std::size_t part, const glm::mat4& placed) {
    const std::size_t index = ranges_[body].first_place + part;
    Place& place = places_[index];
    place.before = placed_[index] ? place.now : placed;
    place.now = placed;
    placed_[index] = true;
}

Result<void> Bodies::prepare(const PassContext& context) {
    std::memcpy(blocks_[static_cast<std::size_t>(context.slot)].mapped, places_.data(), sizeof(Place) * places_.size());
    return {};
}

void Bodies::draw(const PassContext& context) {
    const std::array sets{context.frame, context.wind, sets_[static_cast<std::size_t>(context.slot)]};
    vkCmdBindDescriptorSets(context.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_, 0, 3, sets.data(), 0, nullptr);
    const bool shadow = context.pass == Pass::shadow;
    if (shadow)
        vkCmdPushConstants(context.commands, layout_, VK_SHADER_STAGE_ALL, 0, sizeof context.cascade, &context.cascade);
    vkCmdBindPipeline(context.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, shadow ? shadow_ : colour_);
    for (const Indices& body : ranges_)
        vkCmdDraw(context.commands, body.count, 1, body.first, body.first_place);
}

} // namespace windrow::vegetation::render
