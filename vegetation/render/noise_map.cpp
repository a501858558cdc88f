#include "vegetation/render/noise_map.h"

#include "vegetation/vulkan/calls.h"
#include "vegetation/vulkan/descriptors.h"
#include "vegetation/vulkan/pipeline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

namespace windrow::vegetation::render {
namespace {

constexpr std::uint32_t k_fill_group = 8; // noise_map.glsl: invocations along a side
constexpr std::array k_fill_bindings{engine::Binding{VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, VK_SHADER_STAGE_COMPUTE_BIT}};

TexelRectangle common(const TexelRectangle& a, const TexelRectangle& b) {
    return {glm::max(a.first, b.first), glm::min(a.end, b.end)};
}

} // namespace

void append_unfilled(const TexelRectangle& wanted, const TexelRectangle& filled, std::vector<TexelRectangle>& to) {
    const TexelRectangle both = common(wanted, filled);
    const auto add = [&](const TexelRectangle& part) {
        if (!part.empty())
            to.push_back(part);
    };
    if (both.empty())
        return add(wanted);
    add({wanted.first, {wanted.end.x, both.first.y}});
    add({{wanted.first.x, both.end.y}, wanted.end});
    add({{wanted.first.x, both.first.y}, {both.first.x, both.end.y}});
    add({{both.end.x, both.first.y}, {wanted.end.x, both.end.y}});
}

NoiseMap::NoiseMap(engine::Objects& objects, const NoiseMapRecipe& recipe) : recipe_(recipe) {
    const auto side = static_cast<std::uint32_t>(std::max(recipe.texels, 1));
    image_ = objects.image(
        {.format = recipe.format, .extent = {side, side}, .usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT});
    VkSamplerCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
    info.magFilter = info.minFilter = VK_FILTER_LINEAR; // the address modes of zeros repeat
    sampler_ = objects.sampler(info);
    const VkDescriptorSetLayout own = make_layout(objects, k_fill_bindings);
    make_sets(objects, own, k_fill_bindings, std::span(&set_, 1));
    point(objects.device(), set_, 0, image_.view);
    layout_ = make_pipeline_layout(objects, std::span(&own, 1));
    pipeline_ = make_compute_pipeline(objects, layout_, recipe.fill);
}

void NoiseMap::record(VkCommandBuffer commands, glm::vec2 middle) {
    const glm::ivec2 first = glm::ivec2(glm::floor(middle / recipe_.texel)) - recipe_.texels / 2;
    const TexelRectangle wanted = common({first, first + recipe_.texels}, recipe_.bounds);
    rest_.clear();
    if (recipe_.texels > 0 && !wanted.empty())
        append_unfilled(wanted, filled_, rest_);
    if (rest_.empty() && !fresh_)
        return;
    // Frames before read the texels that are filled anew.
    VkImageMemoryBarrier turn{};
    turn.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER;
    turn.dstAccessMask = VK_ACCESS_SHADER_WRITE_BIT;
    turn.oldLayout = fresh_ ? VK_IMAGE_LAYOUT_UNDEFINED : VK_IMAGE_LAYOUT_GENERAL;
    turn.newLayout = VK_IMAGE_LAYOUT_GENERAL;
    turn.srcQueueFamilyIndex = turn.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    turn.image = image_.image;
    turn.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    constexpr VkPipelineStageFlags reads = VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT, fills = VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT;
    vkCmdPipelineBarrier(commands, reads, fills, 0, 0, nullptr, 0, nullptr, 1, &turn);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline_);
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout_, 0, 1, &set_, 0, nullptr);
    for (const TexelRectangle& part : rest_) {
        const std::array<glm::ivec2, 2> rectangle{part.first, part.end - part.first};
        const auto groups = [](int texels) { return (static_cast<std::uint32_t>(texels) + k_fill_group - 1) / k_fill_group; };
        vkCmdPushConstants(commands, layout_, VK_SHADER_STAGE_ALL, 0, sizeof rectangle, rectangle.data());
        vkCmdDispatch(commands, groups(rectangle[1].x), groups(rectangle[1].y), 1);
    }
    turn.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT;
    turn.dstAccessMask = VK_ACCESS_SHADER_READ_BIT;
    turn.oldLayout = VK_IMAGE_LAYOUT_GENERAL;
    vkCmdPipelineBarrier(commands, fills, reads, 0, 0, nullptr, 0, nullptr, 1, &turn);
    filled_ = wanted;
    fresh_ = false;
}

} // namespace windrow::vegetation::render
