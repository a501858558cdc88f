#include "cli/device_report/draw_host.h"

#include "fluid/message.h"

#include <array>
#include <cstring>
#include <map>
#include <utility>

namespace windrow::cli {

using namespace vulkan;

// Calls that draw; the library computes alone and has none of them.
// clang-format off
#define WINDROW_DRAW_CALLS(each) \
    each(vkCreateRenderPass) \
    each(vkDestroyRenderPass) \
    each(vkCreateFramebuffer) \
    each(vkDestroyFramebuffer) \
    each(vkCreateGraphicsPipelines) \
    each(vkCmdBeginRenderPass) \
    each(vkCmdEndRenderPass) \
    each(vkCmdDraw)
// clang-format on

struct DrawHost::Calls {
#define WINDROW_DECLARE(name) PFN_##name name = nullptr;
    WINDROW_DRAW_CALLS(WINDROW_DECLARE)
#undef WINDROW_DECLARE
};

namespace {

constexpr VkFormat k_colour = VK_FORMAT_R8G8B8A8_SRGB, k_depth = VK_FORMAT_D16_UNORM; // which every device draws to

} // namespace

DrawHost::DrawHost(OwnDevice& own, Device& device) : own_(own), device_(device), calls_(std::make_unique<Calls>()) {}

DrawHost::~DrawHost() {
    for (auto last = at_end_.rbegin(); last != at_end_.rend(); ++last)
        (*last)();
}

Result<std::unique_ptr<DrawHost>> DrawHost::create(OwnDevice& own, Device& device, std::span<const VkDescriptorType> kinds) {
    std::unique_ptr<DrawHost> made(new DrawHost(own, device));
    std::string missing;
#define WINDROW_LOAD(name)                                                                                                       \
    made->calls_->name = reinterpret_cast<PFN_##name>(device.functions().vkGetDeviceProcAddr(device.host().device, #name));      \
    if (made->calls_->name == nullptr)                                                                                           \
        missing += (missing.empty() ? "" : ", ") + std::string(#name);
    WINDROW_DRAW_CALLS(WINDROW_LOAD)
#undef WINDROW_LOAD
    if (!missing.empty())
        return Error{detail::message("the driver lacks ", missing, ": update it.")};
    if (auto set = made->make_set(kinds); !set)
        return Error{set.error()};
    return made;
}

template <class Create, class Destroy, class Info, class Object>
Result<void> DrawHost::make(const char* name, Create call, Destroy destroy, const Info& info, Object& object) {
    const VkDevice device = device_.host().device;
    if (const VkResult result = call(device, &info, nullptr, &object); result != VK_SUCCESS)
        return call_error(name, "the report", result);
    at_end_.push_back([=] { destroy(device, object, nullptr); });
    return {};
}

Result<void> DrawHost::make_set(std::span<const VkDescriptorType> kinds) {
    const Functions& call = device_.functions();
    std::vector<VkDescriptorSetLayoutBinding> bindings;
    std::map<VkDescriptorType, std::uint32_t> counts;
    for (const VkDescriptorType kind : kinds) {
        bindings.push_back({.binding = static_cast<std::uint32_t>(bindings.size()),
                            .descriptorType = kind,
                            .descriptorCount = 1,
                            .stageFlags = VK_SHADER_STAGE_ALL_GRAPHICS,
                            .pImmutableSamplers = nullptr});
        ++counts[kind];
    }
    VkDescriptorSetLayoutCreateInfo set{};
    set.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    set.bindingCount = static_cast<std::uint32_t>(bindings.size());
    set.pBindings = bindings.data();
    if (auto made = make("vkCreateDescriptorSetLayout", call.vkCreateDescriptorSetLayout, call.vkDestroyDescriptorSetLayout, set,
                         set_layout_);
        !made)
        return made;
    VkPipelineLayoutCreateInfo layout{};
    layout.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    layout.setLayoutCount = 1;
    layout.pSetLayouts = &set_layout_;
    if (auto made = make("vkCreatePipelineLayout", call.vkCreatePipelineLayout, call.vkDestroyPipelineLayout, layout, layout_);
        !made)
        return made;
    std::vector<VkDescriptorPoolSize> sizes;
    for (const auto& [type, count] : counts)
        sizes.push_back({type, count});
    VkDescriptorPoolCreateInfo pool{};
    pool.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
    pool.maxSets = 1;
    pool.poolSizeCount = static_cast<std::uint32_t>(sizes.size());
    pool.pPoolSizes = sizes.data();
    if (auto made = make("vkCreateDescriptorPool", call.vkCreateDescriptorPool, call.vkDestroyDescriptorPool, pool, pool_); !made)
        return made;
    VkDescriptorSetAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
    info.descriptorPool = pool_;
    info.descriptorSetCount = 1;
    info.pSetLayouts = &set_layout_;
    if (const VkResult result = call.vkAllocateDescriptorSets(device_.host().device, &info, &set_); result != VK_SUCCESS)
        return call_error("vkAllocateDescriptorSets", "the report", result);
    return {};
}

void DrawHost::bind(std::span<const Binding> bindings) {
    std::vector<VkDescriptorBufferInfo> buffers(bindings.size());
    std::vector<VkDescriptorImageInfo> images(bindings.size());
    std::vector<VkWriteDescriptorSet> writes;
    for (std::size_t n = 0; n < bindings.size(); ++n) {
        const Binding& binding = bindings[n];
        buffers[n] = {binding.buffer, 0, VK_WHOLE_SIZE};
        images[n] = {binding.sampler, binding.view, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
        VkWriteDescriptorSet write{};
        write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
        write.dstSet = set_;
        write.dstBinding = static_cast<std::uint32_t>(n);
        write.descriptorCount = 1;
        write.descriptorType = binding.type;
        write.pBufferInfo = &buffers[n];
        write.pImageInfo = &images[n];
        writes.push_back(write);
    }
    device_.functions().vkUpdateDescriptorSets(device_.host().device, static_cast<std::uint32_t>(writes.size()), writes.data(), 0,
                                               nullptr);
}

Result<DrawHost::Attachment> DrawHost::attachment(VkExtent2D extent, VkFormat format, VkSampleCountFlagBits samples,
                                                  VkImageUsageFlags usage) {
    const Functions& call = device_.functions();
    Attachment made;
    VkImageCreateInfo image{};
    image.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
    image.imageType = VK_IMAGE_TYPE_2D;
    image.format = format;
    image.extent = {extent.width, extent.height, 1};
    image.mipLevels = image.arrayLayers = 1;
    image.samples = samples;
    image.tiling = VK_IMAGE_TILING_OPTIMAL;
    image.usage = usage;
    if (auto done = make("vkCreateImage", call.vkCreateImage, call.vkDestroyImage, image, made.image); !done)
        return Error{done.error()};
    VkMemoryRequirements needs{};
    call.vkGetImageMemoryRequirements(device_.host().device, made.image, &needs);
    auto piece = device_.memory().allocate(needs, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, false);
    if (!piece)
        return Error{piece.error()};
    // The memory goes after the image, which is made before it: both ends in one.
    std::function<void()> destroy = std::move(at_end_.back());
    at_end_.back() = [this, destroy = std::move(destroy), given = *piece] {
        destroy();
        device_.memory().release(given);
    };
    if (const VkResult result = call.vkBindImageMemory(device_.host().device, made.image, piece->memory, piece->offset);
        result != VK_SUCCESS)
        return call_error("vkBindImageMemory", "the report", result);
    VkImageViewCreateInfo view{};
    view.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
    view.image = made.image;
    view.viewType = VK_IMAGE_VIEW_TYPE_2D;
    view.format = format;
    const bool depth = format == k_depth;
    view.subresourceRange = {
        depth ? VkImageAspectFlags{VK_IMAGE_ASPECT_DEPTH_BIT} : VkImageAspectFlags{VK_IMAGE_ASPECT_COLOR_BIT}, 0, 1, 0, 1};
    if (auto done = make("vkCreateImageView", call.vkCreateImageView, call.vkDestroyImageView, view, made.view); !done)
        return Error{done.error()};
    return made;
}

Result<DrawHost::Target> DrawHost::target(VkExtent2D extent, VkSampleCountFlagBits samples, bool attached) {
    Target target{.extent = extent, .samples = samples, .attached = attached};
    std::vector<VkAttachmentDescription> attachments;
    std::vector<VkImageView> views;
    const auto add = [&](VkFormat format, VkSampleCountFlagBits each, VkImageUsageFlags usage, VkImageLayout end, bool cleared,
                         bool kept) -> Result<VkImage> {
        auto made = attachment(extent, format, each, usage);
        if (!made)
            return Error{made.error()};
        VkAttachmentDescription one{};
        one.format = format;
        one.samples = each;
        one.loadOp = cleared ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_DONT_CARE;
        one.storeOp = kept ? VK_ATTACHMENT_STORE_OP_STORE : VK_ATTACHMENT_STORE_OP_DONT_CARE;
        one.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
        one.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
        one.finalLayout = end;
        attachments.push_back(one);
        views.push_back(made->view);
        return made->image;
    };
    const bool several = samples != VK_SAMPLE_COUNT_1_BIT;
    constexpr VkImageUsageFlags drawn = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT, copied = drawn | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    constexpr VkImageLayout colour_layout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                            depth_layout = VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL,
                            copy_layout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
    if (attached) {
        auto colour = add(k_colour, samples, several ? drawn : copied, several ? colour_layout : copy_layout, true, !several);
        auto depth = colour ? add(k_depth, samples, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT, depth_layout, true, false)
                            : std::move(colour);
        if (!depth)
            return Error{depth.error()};
        auto picture = several ? add(k_colour, VK_SAMPLE_COUNT_1_BIT, copied, copy_layout, false, true) : std::move(colour);
        if (!picture)
            return Error{picture.error()};
        target.picture = *picture;
    }
    const VkAttachmentReference colour{0, colour_layout}, depth{1, depth_layout}, resolve{2, colour_layout};
    VkSubpassDescription subpass{};
    subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
    subpass.colorAttachmentCount = attached ? 1 : 0;
    subpass.pColorAttachments = &colour;
    subpass.pResolveAttachments = several ? &resolve : nullptr;
    subpass.pDepthStencilAttachment = attached ? &depth : nullptr;
    // What was copied or drawn before is done; what is drawn is there for a copy.
    constexpr VkPipelineStageFlags output = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT |
                                            VK_PIPELINE_STAGE_EARLY_FRAGMENT_TESTS_BIT |
                                            VK_PIPELINE_STAGE_LATE_FRAGMENT_TESTS_BIT;
    constexpr VkAccessFlags writes = VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT | VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT;
    const VkSubpassDependency order[] = {
        {VK_SUBPASS_EXTERNAL, 0, output | VK_PIPELINE_STAGE_TRANSFER_BIT, output, writes,
         writes | VK_ACCESS_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_READ_BIT, 0},
        {0, VK_SUBPASS_EXTERNAL, output, VK_PIPELINE_STAGE_TRANSFER_BIT, writes, VK_ACCESS_TRANSFER_READ_BIT, 0}};
    VkRenderPassCreateInfo pass{};
    pass.sType = VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO;
    pass.attachmentCount = static_cast<std::uint32_t>(attachments.size());
    pass.pAttachments = attachments.data();
    pass.subpassCount = 1;
    pass.pSubpasses = &subpass;
    pass.dependencyCount = attached ? 2 : 0;
    pass.pDependencies = order;
    if (auto made = make("vkCreateRenderPass", calls_->vkCreateRenderPass, calls_->vkDestroyRenderPass, pass, target.pass); !made)
        return Error{made.error()};
    VkFramebufferCreateInfo frame{};
    frame.sType = VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO;
    frame.renderPass = target.pass;
    frame.attachmentCount = static_cast<std::uint32_t>(views.size());
    frame.pAttachments = views.data();
    frame.width = extent.width;
    frame.height = extent.height;
    frame.layers = 1;
    if (auto made =
            make("vkCreateFramebuffer", calls_->vkCreateFramebuffer, calls_->vkDestroyFramebuffer, frame, target.framebuffer);
        !made)
        return Error{made.error()};
    return target;
}

Result<VkPipeline> DrawHost::pipeline(const Target& target, const Recipe& recipe) {
    const Functions& call = device_.functions();
    const bool rasterises = !recipe.fragment.empty();
    std::vector<VkPipelineShaderStageCreateInfo> stages;
    const auto add = [&](VkShaderStageFlagBits stage, std::span<const std::uint32_t> words) {
        VkShaderModuleCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
        info.codeSize = words.size_bytes();
        info.pCode = words.data();
        VkPipelineShaderStageCreateInfo one{};
        one.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
        one.stage = stage;
        one.pName = "main";
        auto made = make("vkCreateShaderModule", call.vkCreateShaderModule, call.vkDestroyShaderModule, info, one.module);
        stages.push_back(one);
        return made;
    };
    if (auto added = add(VK_SHADER_STAGE_VERTEX_BIT, recipe.vertex); !added)
        return Error{added.error()};
    if (rasterises)
        if (auto added = add(VK_SHADER_STAGE_FRAGMENT_BIT, recipe.fragment); !added)
            return Error{added.error()};
    VkPipelineVertexInputStateCreateInfo input{};
    input.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO;
    VkPipelineInputAssemblyStateCreateInfo assembly{};
    assembly.sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO;
    assembly.topology = recipe.topology;
    const VkViewport view{0.0f, 0.0f, static_cast<float>(target.extent.width), static_cast<float>(target.extent.height),
                          0.0f, 1.0f};
    const VkRect2D all{{0, 0}, target.extent};
    VkPipelineViewportStateCreateInfo viewport{};
    viewport.sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO;
    viewport.viewportCount = viewport.scissorCount = 1;
    viewport.pViewports = &view;
    viewport.pScissors = &all;
    VkPipelineRasterizationStateCreateInfo raster{}; // a blade has two faces: none is culled
    raster.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO;
    raster.rasterizerDiscardEnable = rasterises ? VK_FALSE : VK_TRUE;
    raster.lineWidth = 1.0f;
    VkPipelineMultisampleStateCreateInfo samples{};
    samples.sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO;
    samples.rasterizationSamples = target.samples;
    VkPipelineDepthStencilStateCreateInfo depth{};
    depth.sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO;
    depth.depthTestEnable = depth.depthWriteEnable = recipe.depth ? VK_TRUE : VK_FALSE;
    depth.depthCompareOp = VK_COMPARE_OP_LESS_OR_EQUAL;
    VkPipelineColorBlendAttachmentState blend{};
    blend.colorWriteMask =
        VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
    VkPipelineColorBlendStateCreateInfo blends{};
    blends.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO;
    blends.attachmentCount = target.attached ? 1 : 0;
    blends.pAttachments = &blend;
    VkGraphicsPipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO;
    info.stageCount = static_cast<std::uint32_t>(stages.size());
    info.pStages = stages.data();
    info.pVertexInputState = &input;
    info.pInputAssemblyState = &assembly;
    info.pViewportState = &viewport;
    info.pRasterizationState = &raster;
    info.pMultisampleState = &samples;
    info.pDepthStencilState = &depth;
    info.pColorBlendState = &blends;
    info.layout = layout_;
    info.renderPass = target.pass;
    VkPipeline pipeline = VK_NULL_HANDLE;
    const auto create_one = [&](VkDevice device, const auto* what, const VkAllocationCallbacks* callbacks, VkPipeline* made) {
        return calls_->vkCreateGraphicsPipelines(device, VK_NULL_HANDLE, 1, what, callbacks, made);
    };
    if (auto made = make("vkCreateGraphicsPipelines", create_one, call.vkDestroyPipeline, info, pipeline); !made)
        return Error{made.error()};
    return pipeline;
}

void DrawHost::record(VkCommandBuffer commands, const Target& target, std::span<const Draw> draws) const {
    const Functions& call = device_.functions();
    std::array<VkClearValue, 2> clear{};
    clear[1].depthStencil = {1.0f, 0};
    VkRenderPassBeginInfo begin{};
    begin.sType = VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO;
    begin.renderPass = target.pass;
    begin.framebuffer = target.framebuffer;
    begin.renderArea = {{0, 0}, target.extent};
    begin.clearValueCount = target.attached ? 2 : 0;
    begin.pClearValues = clear.data();
    calls_->vkCmdBeginRenderPass(commands, &begin, VK_SUBPASS_CONTENTS_INLINE);
    call.vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_, 0, 1, &set_, 0, nullptr);
    for (const Draw& draw : draws) {
        call.vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, draw.pipeline);
        calls_->vkCmdDraw(commands, draw.vertices, draw.instances, 0, 0);
    }
    calls_->vkCmdEndRenderPass(commands);
}

Result<std::vector<std::byte>> DrawHost::pixels(const Target& target) {
    const VkDeviceSize bytes = VkDeviceSize{4} * target.extent.width * target.extent.height;
    auto buffer = Buffer::create(device_, bytes, MemoryUse::readback);
    if (!buffer)
        return Error{buffer.error()};
    auto ran = own_.run([&](VkCommandBuffer commands) {
        VkBufferImageCopy region{};
        region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
        region.imageExtent = {target.extent.width, target.extent.height, 1};
        const Functions& call = device_.functions();
        call.vkCmdCopyImageToBuffer(commands, target.picture, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, buffer->handle(), 1, &region);
        VkMemoryBarrier read{};
        read.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
        read.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
        read.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
        call.vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &read, 0, nullptr,
                                  0, nullptr);
    });
    if (!ran)
        return Error{ran.error()};
    if (const VkResult result = buffer->invalidate(); result != VK_SUCCESS)
        return call_error("vkInvalidateMappedMemoryRanges", "a picture", result);
    return std::vector<std::byte>(buffer->mapped(), buffer->mapped() + bytes);
}

} // namespace windrow::cli
