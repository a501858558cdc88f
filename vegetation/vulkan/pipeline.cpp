#include "vegetation/vulkan/pipeline.h"

#include "gpu/pipeline_state.h"
#include "vegetation/vulkan/calls.h"

#include <vector>

namespace windrow::vegetation::engine {
namespace {

VkShaderModule make_module(Objects& objects, std::span<const std::uint32_t> words) {
    return objects.make(vkCreateShaderModule, vkDestroyShaderModule, vulkan::module_of(words), "vkCreateShaderModule");
}

// Pipelines are made by the list.
template <class Create, class Info>
VkPipeline keep(Objects& objects, Create create, const Info& info, const char* call) {
    const VkDevice device = objects.device().handle();
    const VkAllocationCallbacks* const callbacks = objects.device().host().allocation_callbacks;
    VkPipeline made = VK_NULL_HANDLE;
    must(create(device, VK_NULL_HANDLE, 1, &info, callbacks, &made), call);
    objects.at_end([device, made, callbacks] { vkDestroyPipeline(device, made, callbacks); });
    return made;
}

VkPipeline make_alone(Objects& objects, const PipelineRecipe& recipe) {
    Objects shaders(objects.device()); // end with this function
    std::vector<VkPipelineShaderStageCreateInfo> stages;
    stages.push_back(vulkan::stage_of(VK_SHADER_STAGE_VERTEX_BIT, make_module(shaders, recipe.vertex)));
    if (!recipe.fragment.empty())
        stages.push_back(vulkan::stage_of(VK_SHADER_STAGE_FRAGMENT_BIT, make_module(shaders, recipe.fragment)));
    std::vector<VkSpecializationMapEntry> entries;
    for (std::uint32_t n = 0; n < recipe.constants.size(); ++n)
        entries.push_back({n, n * 4u, 4});
    const VkSpecializationInfo constants{static_cast<std::uint32_t>(entries.size()), entries.data(),
                                         recipe.constants.size_bytes(), recipe.constants.data()};
    if (!entries.empty())
        stages.back().pSpecializationInfo = &constants;
    const vulkan::GraphicsState state({.stages = stages,
                                       .layout = recipe.layout,
                                       .render_pass = recipe.target.render_pass,
                                       .topology = recipe.topology,
                                       .samples = recipe.target.samples,
                                       .colours = recipe.target.colours,
                                       .tests_depth = recipe.target.depth,
                                       .writes_depth = recipe.writes_depth,
                                       .writes_colour = recipe.writes_colour,
                                       .blends = recipe.blends,
                                       .bias = recipe.bias});
    return keep(objects, vkCreateGraphicsPipelines, state.info(), "vkCreateGraphicsPipelines");
}

} // namespace

VkPipelineLayout make_pipeline_layout(Objects& objects, std::span<const VkDescriptorSetLayout> sets, std::uint32_t push_bytes) {
    const VkPushConstantRange range{VK_SHADER_STAGE_ALL, 0, push_bytes};
    VkPipelineLayoutCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    info.setLayoutCount = static_cast<std::uint32_t>(sets.size());
    info.pSetLayouts = sets.data();
    info.pushConstantRangeCount = 1;
    info.pPushConstantRanges = &range;
    SharedKey key(SharedKind::pipeline_layout);
    key.add(push_bytes);
    for (const VkDescriptorSetLayout set : sets)
        key.add_part(SharedKind::set_layout, set);
    return objects.shared(key, [&](Objects& owner) {
        return owner.make(vkCreatePipelineLayout, vkDestroyPipelineLayout, info, "vkCreatePipelineLayout");
    });
}

VkPipeline make_pipeline(Objects& objects, const PipelineRecipe& recipe) {
    SharedKey key(SharedKind::pipeline);
    key.add_words(recipe.vertex).add_words(recipe.fragment).add_words(recipe.constants);
    key.add_part(SharedKind::pipeline_layout, recipe.layout).add_part(SharedKind::render_pass, recipe.target.render_pass);
    key.add(recipe.target.samples).add(recipe.target.colours).add(recipe.target.depth);
    key.add(recipe.topology).add(recipe.writes_depth).add(recipe.writes_colour).add(recipe.blends).add(recipe.bias);
    return objects.shared(key, [&](Objects& owner) { return make_alone(owner, recipe); });
}

VkPipeline make_compute_pipeline(Objects& objects, VkPipelineLayout layout, std::span<const std::uint32_t> words) {
    SharedKey key(SharedKind::pipeline);
    key.add_words(words).add_part(SharedKind::pipeline_layout, layout);
    return objects.shared(key, [&](Objects& owner) {
        Objects shaders(owner.device());
        VkComputePipelineCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
        info.stage = vulkan::stage_of(VK_SHADER_STAGE_COMPUTE_BIT, make_module(shaders, words));
        info.layout = layout;
        return keep(owner, vkCreateComputePipelines, info, "vkCreateComputePipelines");
    });
}

} // namespace windrow::vegetation::engine
