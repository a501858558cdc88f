#include "vegetation/render/motion_blur.h"

#include "shader_words/blur_gather_frag.h"
#include "shader_words/blur_longest_frag.h"
#include "shader_words/blur_streak_frag.h"
#include "shader_words/blur_streak_samples_frag.h"
#include "shader_words/full_screen_vert.h"
#include "vegetation/vulkan/calls.h"
#include "vegetation/vulkan/descriptors.h"

#include <algorithm>

namespace windrow::vegetation::render {
namespace {

namespace words = windrow::vulkan::shader_words;

constexpr engine::Binding k_map{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, VK_SHADER_STAGE_FRAGMENT_BIT};
constexpr std::array k_inputs{k_map, k_map, k_map};
// Motion is short on most pictures, and a reach of 40 px at 640 x 360 takes a runner at arm's length.
constexpr int k_tiles = 18, k_least_tile = 8;

std::uint32_t tiles(std::uint32_t pixels, int tile) {
    const auto across = static_cast<std::uint32_t>(tile);
    return (pixels + across - 1) / across;
}

} // namespace

MotionBlur::MotionBlur(engine::Objects& objects, const Targets& images, VkDescriptorSetLayout frame, float shutter_deg)
    : most_(std::max(k_least_tile, static_cast<int>(images.extent().height) / k_tiles)) {
    const VkExtent2D whole = images.extent();
    const VkExtent2D small{tiles(whole.width, most_), tiles(whole.height, most_)};
    const std::array extents{whole, VkExtent2D{small.width, whole.height}, small, small};
    for (std::size_t n = 0; n < maps_.size(); ++n) {
        const VkFormat format = n == 0 ? VK_FORMAT_R16G16B16A16_SFLOAT : VK_FORMAT_R16G16_SFLOAT;
        maps_[n] = objects.image(
            {.format = format, .extent = extents[n], .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT});
        const engine::Attachment drawn{.format = format, .view = maps_[n].view, .end = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
        passes_[n].emplace(objects, extents[n], std::span(&drawn, 1));
    }

    const VkDescriptorSetLayout inputs = make_layout(objects, k_inputs);
    layout_ = make_pipeline_layout(objects, std::array{frame, inputs}, sizeof(Push));
    engine::make_sets(objects, inputs, k_inputs, inputs_);
    const VkSampler texels = objects.sampler(engine::Sampler::texels);
    const auto read = [&](std::size_t step, std::array<VkImageView, 3> views) {
        for (std::uint32_t n = 0; n < views.size(); ++n)
            point(objects.device(), inputs_[step], n, views[n], texels,
                  views[n] == images.depth() ? VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL
                                             : VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    };
    // A binding that a pass does not read points to what it reads.
    read(0, {images.motion(), images.depth(), images.motion()});
    for (std::size_t n = 1; n < 4; ++n)
        read(n, {maps_[n - 1].view, maps_[n - 1].view, maps_[n - 1].view});
    read(4, {images.drawn_light(), maps_[0].view, maps_[3].view});

    const auto pipeline = [&](std::span<const std::uint32_t> fragment, const engine::RenderPass& pass,
                              std::span<const std::uint32_t> constants = {}) {
        return make_pipeline(objects, {.vertex = words::full_screen_vert,
                                       .fragment = fragment,
                                       .constants = constants,
                                       .layout = layout_,
                                       .target = {pass.handle(), VK_SAMPLE_COUNT_1_BIT, 1, false}});
    };
    const bool one = images.samples() == VK_SAMPLE_COUNT_1_BIT;
    const auto samples = static_cast<std::uint32_t>(images.samples());
    const auto streak = one ? std::span<const std::uint32_t>(words::blur_streak_frag) : words::blur_streak_samples_frag;
    const Push all{.open = shutter_deg / 360.0f, .most = static_cast<float>(most_)};
    Push row = all, column = all, around = all;
    row.stride.x = row.count.x = most_;
    column.stride.y = column.count.y = most_;
    around.count = {3, 3};
    steps_[0] = {&*passes_[0], pipeline(streak, *passes_[0], std::span(&samples, one ? 0 : 1)), inputs_[0], all};
    for (std::size_t n = 1; n < 4; ++n)
        steps_[n] = {&*passes_[n], pipeline(words::blur_longest_frag, *passes_[n]), inputs_[n],
                     std::array{row, column, around}[n - 1]};
    steps_[4] = {&images.blurred(), pipeline(words::blur_gather_frag, images.blurred()), inputs_[4], all};
}

void MotionBlur::record(VkCommandBuffer commands, VkDescriptorSet frame) const {
    for (const Step& step : steps_) {
        step.pass->begin(commands);
        const std::array sets{frame, step.inputs};
        vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_, 0, 2, sets.data(), 0, nullptr);
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, step.pipeline);
        vkCmdPushConstants(commands, layout_, VK_SHADER_STAGE_ALL, 0, sizeof(Push), &step.push);
        vkCmdDraw(commands, 3, 1, 0, 0);
        vkCmdEndRenderPass(commands);
    }
}

} // namespace windrow::vegetation::render
