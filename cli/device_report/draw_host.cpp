#include "cli/device_report/draw_host.h"

#include "fluid/core/message.h"
#include "gpu/pipeline_state.h"

#include <array>
#include <cstring>
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
    each(vkCmdSetViewport) \
    each(vkCmdSetScissor) \
    each(vkCmdDraw)
// clang-format on

struct DrawHost::Calls {
#define WINDROW_DECLARE(name) PFN_##name name = nullptr;
    WINDROW_DRAW_CALLS(WINDROW_DECLARE)
#undef WINDROW_DECLARE
};

namespace {

constexpr VkFormat k_colour = VK_FORMAT_R8G8B8A8_SRGB, k_depth = VK_FORMAT_D16_UNORM; // which every device draws to
constexpr const char* k_what = "the report's renderer";                               // in sentences

} // namespace

std::vector<VkDescriptorType> WindBindings::kinds() {
    std::vector<VkDescriptorType> kinds;
    for (const VkDescriptorSetLayoutBinding& binding : set_bindings(TextureSet::vectors, VK_SHADER_STAGE_ALL))
        kinds.push_back(binding.descriptorType);
    return kinds;
}

Result<WindBindings> WindBindings::create(Device& device, const Boundaries& boundaries) {
    WindBindings made;
    auto block = Buffer::create(device, sizeof(FrameBlock), MemoryUse::upload, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
    if (!block)
        return block.failure();
    made.block_ = *std::move(block);
    const VkSamplerCreateInfo info = sampler_info(boundaries);
    if (const VkResult result = make(device.functions(), device.host(), device.functions().vkCreateSampler, info, made.sampler_);
        result != VK_SUCCESS)
        return call_error("vkCreateSampler", "the wind's textures", result);
    return made;
}

std::vector<Binding> WindBindings::of(const vulkan::Wind& wind, glm::dvec3 anchor, const Sampling& sampling) {
    const FrameBlock content = wind.frame_block(anchor, sampling);
    std::memcpy(block_.mapped(), &content, sizeof content);
    (void)block_.flush(); // memory for uploads is coherent
    const auto texture = [&](const Textures& frame) {
        return Binding{.type = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, .view = frame.vectors.view, .sampler = sampler_.get()};
    };
    return {{.type = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, .buffer = block_.handle()},
            texture(wind.textures()),
            texture(wind.previous_textures()),
            {.type = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, .buffer = wind.gust_buffer()}};
}

DrawHost::DrawHost(OwnDevice& own, Device& device) : own_(own), device_(device), calls_(std::make_unique<Calls>()) {}

DrawHost::~DrawHost() {
    for (auto last = at_end_.rbegin(); last != at_end_.rend(); ++last)
        (*last)();
}

Result<std::unique_ptr<DrawHost>> DrawHost::create(OwnDevice& own, Device& device, std::span<const VkDescriptorType> kinds) {
    std::unique_ptr<DrawHost> made(new DrawHost(own, device));
    std::string missing;
#define WINDROW_LOAD_DRAW(name)                                                                                                  \
    made->calls_->name = reinterpret_cast<PFN_##name>(device.functions().vkGetDeviceProcAddr(device.host().device, #name));      \
    if (made->calls_->name == nullptr)                                                                                           \
        missing += (missing.empty() ? "" : ", ") + std::string(#name);
    WINDROW_DRAW_CALLS(WINDROW_LOAD_DRAW)
#undef WINDROW_LOAD_DRAW
    if (!missing.empty())
        return Error{detail::message("the driver lacks ", missing, ": update it.")};
    auto layout = PipelineLayout::create(device, bindings_of(kinds, VK_SHADER_STAGE_ALL_GRAPHICS), {}, k_what);
    if (!layout)
        return layout.failure();
    made->layout_ = *std::move(layout);
    return made;
}

template <class Create, class Destroy, class Info, class Object>
Result<void> DrawHost::make(const char* name, Create call, Destroy destroy, const Info& info, Object& object) {
    const VkDevice device = device_.host().device;
    if (const VkResult result = call(device, &info, nullptr, &object); result != VK_SUCCESS)
        return call_error(name, k_what, result);
    at_end_.push_back([=] { destroy(device, object, nullptr); });
    return {};
}

Result<void> DrawHost::bind(std::vector<Binding> bindings) {
    const Sets::Content content{&layout_, std::move(bindings)};
    auto sets = Sets::create(device_, {&content, 1});
    if (!sets)
        return sets.failure();
    sets_ = *std::move(sets);
    return {};
}

Result<DrawHost::Attachment> DrawHost::attachment(VkExtent2D extent, VkFormat format, VkSampleCountFlagBits samples,
                                                  VkImageUsageFlags usage) {
    const Functions& call = device_.functions();
    const Host& host = device_.host();
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
    if (const VkResult result = vulkan::make(call, host, call.vkCreateImage, image, made.image); result != VK_SUCCESS)
        return call_error("vkCreateImage", k_what, result);
    VkMemoryRequirements needs{};
    call.vkGetImageMemoryRequirements(host.device, made.image.get(), &needs);
    auto piece = device_.memory().allocate(needs, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, false);
    if (!piece)
        return piece.failure();
    made.piece = OwnedPiece(device_.memory(), *piece);
    if (const VkResult result = call.vkBindImageMemory(host.device, made.image.get(), piece->memory, piece->offset);
        result != VK_SUCCESS)
        return call_error("vkBindImageMemory", k_what, result);
    VkImageViewCreateInfo view{};
    view.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
    view.image = made.image.get();
    view.viewType = VK_IMAGE_VIEW_TYPE_2D;
    view.format = format;
    const bool depth = format == k_depth;
    view.subresourceRange = {
        depth ? VkImageAspectFlags{VK_IMAGE_ASPECT_DEPTH_BIT} : VkImageAspectFlags{VK_IMAGE_ASPECT_COLOR_BIT}, 0, 1, 0, 1};
    if (const VkResult result = vulkan::make(call, host, call.vkCreateImageView, view, made.view); result != VK_SUCCESS)
        return call_error("vkCreateImageView", k_what, result);
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
            return made.failure();
        VkAttachmentDescription one{};
        one.format = format;
        one.samples = each;
        one.loadOp = cleared ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_DONT_CARE;
        one.storeOp = kept ? VK_ATTACHMENT_STORE_OP_STORE : VK_ATTACHMENT_STORE_OP_DONT_CARE;
        one.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
        one.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
        one.finalLayout = end;
        attachments.push_back(one);
        views.push_back(made->view.get());
        attachments_.push_back(*std::move(made));
        return attachments_.back().image.get();
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
            return depth.failure();
        auto picture = several ? add(k_colour, VK_SAMPLE_COUNT_1_BIT, copied, copy_layout, false, true) : std::move(colour);
        if (!picture)
            return picture.failure();
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
        return made.failure();
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
        return made.failure();
    return target;
}

Result<VkPipeline> DrawHost::pipeline(const Target& target, const Recipe& recipe) {
    const Functions& call = device_.functions();
    const Host& host = device_.host();
    std::vector<VkPipelineShaderStageCreateInfo> stages;
    std::array<vulkan::Handle<VkShaderModule, &Functions::vkDestroyShaderModule>, 2> shaders; // end with this function
    const auto add = [&](VkShaderStageFlagBits stage, std::span<const std::uint32_t> words) {
        auto& shader = shaders[stages.size()];
        const VkResult result = vulkan::make(call, host, call.vkCreateShaderModule, module_of(words), shader);
        stages.push_back(stage_of(stage, shader.get()));
        return result;
    };
    const bool rasterises = !recipe.fragment.empty();
    VkResult result = add(VK_SHADER_STAGE_VERTEX_BIT, recipe.vertex);
    if (result == VK_SUCCESS && rasterises)
        result = add(VK_SHADER_STAGE_FRAGMENT_BIT, recipe.fragment);
    if (result != VK_SUCCESS)
        return call_error("vkCreateShaderModule", k_what, result);
    const GraphicsState state({.stages = stages,
                               .layout = layout_.layout(),
                               .render_pass = target.pass,
                               .topology = recipe.topology,
                               .samples = target.samples,
                               .colours = target.attached ? 1u : 0u,
                               .tests_depth = recipe.depth,
                               .rasterises = rasterises});
    VkPipeline made = VK_NULL_HANDLE;
    result = calls_->vkCreateGraphicsPipelines(host.device, VK_NULL_HANDLE, 1, &state.info(), host.allocation_callbacks, &made);
    if (result != VK_SUCCESS)
        return call_error("vkCreateGraphicsPipelines", k_what, result);
    pipelines_.emplace_back(call, host, made);
    return made;
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
    const VkViewport view{.x = 0.0f,
                          .y = 0.0f,
                          .width = static_cast<float>(target.extent.width),
                          .height = static_cast<float>(target.extent.height),
                          .minDepth = 0.0f,
                          .maxDepth = 1.0f};
    calls_->vkCmdSetViewport(commands, 0, 1, &view);
    calls_->vkCmdSetScissor(commands, 0, 1, &begin.renderArea);
    const VkDescriptorSet set = sets_.at(0);
    call.vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_.layout(), 0, 1, &set, 0, nullptr);
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
        return buffer.failure();
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
        return ran.failure();
    if (const VkResult result = buffer->invalidate(); result != VK_SUCCESS)
        return call_error("vkInvalidateMappedMemoryRanges", "a picture", result);
    return std::vector<std::byte>(buffer->mapped(), buffer->mapped() + bytes);
}

} // namespace windrow::cli
