#include "vegetation/render/grass_layer.h"

#include "fluid/core/validation.h"
#include "shader_words/field_blade_frag.h"
#include "shader_words/field_blade_shadow_vert.h"
#include "shader_words/field_blade_vert.h"
#include "shader_words/field_blades.h"
#include "shader_words/field_ground.h"
#include "shader_words/field_swung.h"
#include "vegetation/render/plant_look_block.h"
#include "vegetation/vulkan/calls.h"
#include "vegetation/vulkan/descriptors.h"

#include <algorithm>
#include <cstring>
#include <glm/matrix.hpp>
#include <limits>
#include <utility>

namespace windrow::vegetation::render {
namespace {

namespace words = windrow::vulkan::shader_words;

constexpr std::uint32_t k_parts = 4; // groups that share a list: a list of a near chunk has thousands of blades
constexpr std::uint32_t k_grass_set = 3, k_draw_offset = 8;
constexpr VkShaderStageFlags k_both = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_COMPUTE_BIT;
constexpr std::array k_grass_bindings{engine::Binding{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER},
                                      engine::Binding{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, k_both},
                                      engine::Binding{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, k_both},
                                      engine::Binding{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_SHADER_STAGE_COMPUTE_BIT},
                                      engine::Binding{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, VK_SHADER_STAGE_COMPUTE_BIT},
                                      engine::Binding{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, VK_SHADER_STAGE_COMPUTE_BIT}};
constexpr std::size_t k_plain_bindings = 3; // without the ground's
constexpr std::array k_swing_bindings{k_grass_bindings[0],
                                      k_grass_bindings[1],
                                      k_grass_bindings[2],
                                      engine::Binding{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_SHADER_STAGE_COMPUTE_BIT},
                                      engine::Binding{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_SHADER_STAGE_COMPUTE_BIT},
                                      engine::Binding{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_SHADER_STAGE_COMPUTE_BIT}};

// The block of field_blades.glsl.
struct SwingFrame {
    std::array<windrow::SwingBlock, 4> steps{}; // of its class's bands
    glm::uvec4 frame{0u};
};
static_assert(sizeof(SwingFrame) == 336);
constexpr VkDeviceSize k_swing_bytes = 24; // KeptSwing of field_blades.glsl

// What both shadow maps show: boxes along the same light. The near one's corners, in the far one's clip space, widen the far one.
glm::mat4 around_both(const glm::mat4& near, const glm::mat4& far) {
    const glm::mat4 to_far = far * glm::inverse(near);
    glm::vec3 low(-1.0f, -1.0f, 0.0f), high(1.0f);
    for (const float x : {-1.0f, 1.0f})
        for (const float y : {-1.0f, 1.0f})
            for (const float z : {0.0f, 1.0f}) {
                const glm::vec3 corner(to_far * glm::vec4(x, y, z, 1.0f));
                low = glm::min(low, corner);
                high = glm::max(high, corner);
            }
    glm::mat4 squeeze(1.0f);
    for (int axis = 0; axis < 3; ++axis) {
        const float first = axis == 2 ? 0.0f : -1.0f; // clip space begins here and ends at 1
        squeeze[axis][axis] = (1.0f - first) / (high[axis] - low[axis]);
        squeeze[3][axis] = first - low[axis] * squeeze[axis][axis];
    }
    return squeeze * far;
}

} // namespace

windrow::Result<void> validate(const GrassLayerSettings& settings) {
    return windrow::detail::validate_settings(settings, "grass");
}

GrassLayer::GrassLayer(engine::Device& device, grass::GrassField field, const GrassLayerSettings& settings)
    : device_(device), settings_(settings), field_(std::move(field)), objects_(device) {}

windrow::Result<std::unique_ptr<GrassLayer>> GrassLayer::create(engine::Device& device, const DrawTargets& targets,
                                                                const Ground& ground, const grass::PlacementMask& mask,
                                                                const GrassLayerSettings& settings) {
    windrow::detail::Reasons reasons;
    reasons.add_all_of(validate(settings));
    reasons.add_all_of(validate(ground));
    if (!reasons.empty())
        return windrow::Error{reasons.take()};
    grass::GrassSettings placed_by = settings.field;
    if (settings.look.head_from < 1.0f)
        placed_by.far_vertices = 7;
    auto field = grass::GrassField::create(device, ground.heights, mask, placed_by);
    if (!field)
        return field.failure();
    if (auto placed = field->place(ground.corner); !placed)
        return placed.failure();
    return engine::guarded([&] {
        std::unique_ptr<GrassLayer> made(new GrassLayer(device, *std::move(field), settings));
        made->make(targets);
        return made;
    });
}

void GrassLayer::make(const DrawTargets& targets) {
    constexpr VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    blades_ = objects_.storage("The grass's visible blades", "lower max_blades",
                               sizeof(FieldBlade) * static_cast<VkDeviceSize>(settings_.max_blades),
                               storage | VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
    const VkBuffer bases = objects_.storage("The grass's lists' places", "lower grass.max_chunks",
                                            16 * static_cast<VkDeviceSize>(settings_.field.max_chunks), storage);
    const engine::Buffer look = filled_block(objects_, PlantLookBlock(settings_.look), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);

    const auto pass = [&](std::span<const engine::Binding> bindings, std::span<const std::uint32_t> shader) {
        BladePass made;
        const VkDescriptorSetLayout own = make_layout(objects_, bindings);
        const std::array sets{targets.frame, targets.wind, own, field_.layout()};
        made.layout = make_pipeline_layout(objects_, sets);
        made.pipeline = make_compute_pipeline(objects_, made.layout, shader);
        make_sets(objects_, own, bindings, made.sets);
        for (const VkDescriptorSet set : made.sets) {
            point(device_, set, 0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, look.buffer);
            point(device_, set, 1, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, blades_);
            point(device_, set, 2, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, bases);
        }
        return made;
    };
    if (settings_.springs) {
        plain_ = pass(k_swing_bindings, words::field_swung);
        const auto places = static_cast<VkDeviceSize>(settings_.field.max_chunks) *
                            static_cast<VkDeviceSize>(settings_.field.chunk_cells * settings_.field.chunk_cells);
        const VkBuffer swings = objects_.storage("The grass's springs", "lower max_blades",
                                                 2 * k_swing_bytes * static_cast<VkDeviceSize>(settings_.max_blades), storage);
        listed_ = objects_.storage("The grass's index of springs", "lower grass.max_chunks", 2 * sizeof(std::uint32_t) * places,
                                   storage | VK_BUFFER_USAGE_TRANSFER_DST_BIT);
        swing_blocks_ = objects_.frame_buffers(sizeof(SwingFrame), storage);
        for (std::size_t slot = 0; slot < plain_.sets.size(); ++slot) {
            point(device_, plain_.sets[slot], 3, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, swings);
            point(device_, plain_.sets[slot], 4, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, listed_);
            point(device_, plain_.sets[slot], 5, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, swing_blocks_[slot].buffer);
        }
    } else {
        plain_ = pass(std::span(k_grass_bindings).first(k_plain_bindings), words::field_blades);
    }
    on_ground_ = pass(k_grass_bindings, words::field_ground);
    ground_blocks_ = objects_.frame_buffers(sizeof(windrow::GroundBlock), storage);
    sampler_ = objects_.sampler(engine::Sampler::texels);

    layout_ = plain_.layout; // draws read no ground
    constexpr VkPrimitiveTopology strip = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP;
    colour_ = make_pipeline(objects_, {.vertex = words::field_blade_vert,
                                       .fragment = words::field_blade_frag,
                                       .layout = layout_,
                                       .target = targets.colour,
                                       .topology = strip});
    shadow_ = make_pipeline(
        objects_,
        {.vertex = words::field_blade_shadow_vert, .layout = layout_, .target = targets.shadow, .topology = strip, .bias = true});
}

void GrassLayer::point_at_ground(const PassContext& context) {
    // The frame that used this slot before is done: its block and its set are free to be written.
    const windrow::GroundBlock block = ground_->block(context.anchor);
    std::memcpy(ground_blocks_[context.slot].mapped, &block, sizeof block);
    const VkDescriptorSet set = on_ground_.sets[context.slot];
    point(device_, set, 3, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, ground_blocks_[context.slot].buffer);
    point(device_, set, 4, ground_->texture().view, sampler_, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    point(device_, set, 5, ground_->previous_texture().view, sampler_, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
}

void GrassLayer::begin_swing(const PassContext& context) {
    if (listed_ == VK_NULL_HANDLE)
        return;
    if (++frame_ == 1) // what no frame has listed is at no place beyond the springs
        vkCmdFillBuffer(context.commands, listed_, 0, VK_WHOLE_SIZE, 0);
    SwingFrame frame{.frame = {frame_, 0u, 0u, 0u}};
    if (const auto steps = windrow::swing_steps(settings_.spring, time_step_))
        frame.steps = *steps;
    std::memcpy(swing_blocks_[context.slot].mapped, &frame, sizeof frame);
}

Result<void> GrassLayer::prepare(const PassContext& context) {
    grass::GrassCamera camera{
        .anchor = context.anchor, .view_projection = context.block->view_projection, .eye = glm::vec3(context.block->eye)};
    if (settings_.shadows == 1)
        camera.shadow_view_projection = context.block->shadow[0];
    else if (settings_.shadows == 2)
        camera.shadow_view_projection = around_both(context.block->shadow[0], context.block->shadow[1]);
    begin_swing(context);
    const auto culled = field_.record_cull(context.commands, camera); // waits for what was filled
    if (!culled)
        return culled.failure();
    report_ = *culled;
    const bool remembers = ground_ != nullptr && ground_->texture().view != VK_NULL_HANDLE;
    if (remembers)
        point_at_ground(context);
    if (report_.orders == 0)
        return {};
    const auto pass = [&](const BladePass& over, VkPipelineStageFlags then) {
        const std::array sets{context.frame, context.wind, over.sets[context.slot], field_.set()};
        vkCmdBindDescriptorSets(context.commands, VK_PIPELINE_BIND_POINT_COMPUTE, over.layout, 0, 4, sets.data(), 0, nullptr);
        vkCmdBindPipeline(context.commands, VK_PIPELINE_BIND_POINT_COMPUTE, over.pipeline);
        const auto first = static_cast<std::uint32_t>(report_.first_order);
        vkCmdPushConstants(context.commands, over.layout, VK_SHADER_STAGE_ALL, 0, sizeof first, &first);
        vkCmdDispatch(context.commands, 2 * static_cast<std::uint32_t>(report_.orders), k_parts, 1);
        VkMemoryBarrier barrier{};
        barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
        barrier.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT;
        barrier.dstAccessMask = VK_ACCESS_SHADER_READ_BIT;
        if (then == VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT)
            barrier.dstAccessMask |= VK_ACCESS_SHADER_WRITE_BIT;
        vkCmdPipelineBarrier(context.commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, then, 0, 1, &barrier, 0, nullptr, 0,
                             nullptr);
    };
    // The frame before has drawn what is written here: record_cull waits for its vertices.
    pass(plain_, remembers ? VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT : VK_PIPELINE_STAGE_VERTEX_SHADER_BIT);
    if (remembers)
        pass(on_ground_, VK_PIPELINE_STAGE_VERTEX_SHADER_BIT);
    return {};
}

void GrassLayer::draw(const PassContext& context) {
    const bool shadow = context.pass == Pass::shadow;
    if (shadow && context.cascade >= settings_.shadows)
        return;
    const std::array sets{context.frame, context.wind, plain_.sets[context.slot]};
    vkCmdBindDescriptorSets(context.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_, 0, 3, sets.data(), 0, nullptr);
    vkCmdPushConstants(context.commands, layout_, VK_SHADER_STAGE_ALL, 0, sizeof context.cascade, &context.cascade);
    vkCmdBindPipeline(context.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, shadow ? shadow_ : colour_);
    field_.draw(context.commands, {.layout = layout_,
                                   .set = k_grass_set,
                                   .push_offset = k_draw_offset,
                                   .push_stages = VK_SHADER_STAGE_ALL,
                                   .view = shadow ? grass::View::shadow : grass::View::colour});
}

} // namespace windrow::vegetation::render
