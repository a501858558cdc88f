// Textures that leave the device: another device imports their memory and finds the same texels.
#include "fluid/vulkan/wind.h"
#include "tests/parity/gpu.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace windrow::vulkan {
namespace {

constexpr VkExternalMemoryHandleTypeFlagBits k_fd = VK_EXTERNAL_MEMORY_HANDLE_TYPE_OPAQUE_FD_BIT;

class Exports : public Gpu {
  protected:
    void SetUp() override { make_own({.validation = true, .extensions = {VK_KHR_EXTERNAL_MEMORY_FD_EXTENSION_NAME}}); }

    [[nodiscard]] static Settings exporting() {
        return {.texel = Texel::single, .textures = TextureSet::axes, .export_textures = k_fd};
    }

    // The texels of an image that shaders read; VK_QUEUE_FAMILY_EXTERNAL: taken over from another device.
    [[nodiscard]] static std::vector<float> texels(OwnDevice& on, Device& device, VkImage image, VkExtent3D extent,
                                                   std::uint32_t from_family) {
        const std::size_t count = std::size_t{extent.width} * extent.height * extent.depth;
        const Buffer back = *Buffer::create(device, count * sizeof(float), MemoryUse::readback);
        const auto ran = on.run([&](VkCommandBuffer commands) {
            VkImageMemoryBarrier change{};
            change.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER;
            change.dstAccessMask = VK_ACCESS_TRANSFER_READ_BIT;
            change.oldLayout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
            change.newLayout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
            change.srcQueueFamilyIndex = from_family;
            change.dstQueueFamilyIndex = from_family == VK_QUEUE_FAMILY_IGNORED ? from_family : device.host().queue_family;
            change.image = image;
            change.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
            device.functions().vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
                                                    VK_PIPELINE_STAGE_TRANSFER_BIT, 0, 0, nullptr, 0, nullptr, 1, &change);
            VkBufferImageCopy whole{};
            whole.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
            whole.imageExtent = extent;
            device.functions().vkCmdCopyImageToBuffer(commands, image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, back.handle(), 1,
                                                      &whole);
        });
        EXPECT_TRUE(ran) << ran.error();
        EXPECT_EQ(back.invalidate(), VK_SUCCESS);
        std::vector<float> values(count);
        std::memcpy(values.data(), back.mapped(), count * sizeof(float));
        return values;
    }
};

TEST_F(Exports, AreTheSameTexelsOnAnotherDevice) {
    const Config config{.cells = {12, 8, 10}, .ambient = {2.0f, 0.0f, 1.0f}};
    const auto required = required_bytes(own->host(), config, exporting());
    auto wind = Wind::create(own->host(), config, exporting());
    ASSERT_TRUE(wind) << wind.error();
    EXPECT_EQ(required->memory, wind->memory_bytes());
    EXPECT_EQ(required->reserved, wind->reserved_bytes());
    ASSERT_TRUE(wind->motors().add(VortexMotor{}));
    for (int n = 0; n < 3; ++n)
        run([&](VkCommandBuffer commands) { held(wind->record(commands, {.dt = 1.0 / 30.0})); });
    const std::vector<ExportedImage> images = wind->exported_images();
    ASSERT_EQ(images.size(), 6u);
    const VkImage shown = wind->textures().axes[0].image;
    const auto found = std::find_if(images.begin(), images.end(), [&](const auto& image) { return image.image == shown; });
    ASSERT_NE(found, images.end());
    const auto get_fd =
        reinterpret_cast<PFN_vkGetMemoryFdKHR>(device->functions().vkGetDeviceProcAddr(own->host().device, "vkGetMemoryFdKHR"));
    VkMemoryGetFdInfoKHR get{};
    get.sType = VK_STRUCTURE_TYPE_MEMORY_GET_FD_INFO_KHR;
    get.memory = found->memory;
    get.handleType = found->handle_type;
    int fd = -1;
    ASSERT_EQ(get_fd(own->host().device, &get, &fd), VK_SUCCESS);
    const std::vector<float> here = texels(*own, *device, found->image, found->extent, VK_QUEUE_FAMILY_IGNORED);

    auto other = OwnDevice::create({.extensions = {VK_KHR_EXTERNAL_MEMORY_FD_EXTENSION_NAME}});
    ASSERT_TRUE(other) << other.error();
    const auto lent = Device::create((*other)->host());
    ASSERT_TRUE(lent) << lent.error();
    const Functions& call = (*lent)->functions();
    const VkDevice there = (*other)->host().device;
    const VkExternalMemoryImageCreateInfo external{
        .sType = VK_STRUCTURE_TYPE_EXTERNAL_MEMORY_IMAGE_CREATE_INFO, .pNext = nullptr, .handleTypes = k_fd};
    VkImageCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
    info.pNext = &external;
    info.imageType = VK_IMAGE_TYPE_3D;
    info.format = found->format;
    info.extent = found->extent;
    info.mipLevels = info.arrayLayers = 1;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.tiling = VK_IMAGE_TILING_OPTIMAL;
    info.usage = k_image_usage;
    VkImage image = VK_NULL_HANDLE;
    ASSERT_EQ(call.vkCreateImage(there, &info, nullptr, &image), VK_SUCCESS);
    const VkMemoryDedicatedAllocateInfo alone{
        .sType = VK_STRUCTURE_TYPE_MEMORY_DEDICATED_ALLOCATE_INFO, .pNext = nullptr, .image = image, .buffer = VK_NULL_HANDLE};
    const VkImportMemoryFdInfoKHR import{.sType = VK_STRUCTURE_TYPE_IMPORT_MEMORY_FD_INFO_KHR,
                                         .pNext = &alone,
                                         .handleType = k_fd,
                                         .fd = fd}; // owned from here on
    VkMemoryAllocateInfo allocate{};
    allocate.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    allocate.pNext = &import;
    allocate.allocationSize = found->size;
    VkDeviceMemory memory = VK_NULL_HANDLE;
    ASSERT_EQ(call.vkAllocateMemory(there, &allocate, nullptr, &memory), VK_SUCCESS);
    ASSERT_EQ(call.vkBindImageMemory(there, image, memory, found->offset), VK_SUCCESS);
    const std::vector<float> imported = texels(**other, **lent, image, found->extent, VK_QUEUE_FAMILY_EXTERNAL);
    EXPECT_EQ(here, imported);
    EXPECT_TRUE(std::any_of(here.begin(), here.end(), [](float value) { return std::abs(value) > 0.1f; }));
    call.vkDestroyImage(there, image, nullptr);
    call.vkFreeMemory(there, memory, nullptr);
}

TEST_F(Exports, AreRejectedWhereTheDeviceCannot) {
    Settings settings = exporting();
    settings.export_textures = VK_EXTERNAL_MEMORY_HANDLE_TYPE_OPAQUE_WIN32_BIT;
    expect_error(Wind::create(own->host(), {}, settings), "cannot be exported as VkExternalMemoryHandleTypeFlagBits 2");
    Host host = own->host();
    host.memory.allocate = [](const VkMemoryRequirements&, std::uint32_t, MemoryPiece&) { return VK_ERROR_UNKNOWN; };
    host.memory.release = [](const MemoryPiece&) {};
    expect_error(required_bytes(host, {}, exporting()), "leave one of Host::memory and Settings::export_textures out.");
    auto plain = OwnDevice::create({});
    ASSERT_TRUE(plain) << plain.error();
    expect_error(Wind::create((*plain)->host(), {}, exporting()),
                 "has no vkGetMemoryFdKHR, which exports textures: make it with VK_KHR_external_memory_fd.");
}

TEST_F(Exports, AreNoneUnlessAskedFor) {
    const auto wind = Wind::create(own->host(), {.cells = {8, 8, 8}});
    ASSERT_TRUE(wind) << wind.error();
    EXPECT_TRUE(wind->exported_images().empty());
}

} // namespace
} // namespace windrow::vulkan
