// What the C interface fills for vkCreate calls is what the C++ one gives, and handles travel whole.
#include "fluid/vulkan/host.h"
#include "fluid/vulkan/textures.h"

#include <array>
#include <cstring>
#include <gtest/gtest.h>
#include <windrow/windrow.h>

namespace {

using namespace windrow;

TEST(CApiVulkan, BindingsAndSamplersAreThoseOfCpp) {
    for (const auto set : {vulkan::TextureSet::vectors, vulkan::TextureSet::axes}) {
        std::array<VkDescriptorSetLayoutBinding, WINDROW_VULKAN_MAX_BINDINGS> bindings{};
        const auto wanted = vulkan::set_bindings(set, VK_SHADER_STAGE_VERTEX_BIT, 3);
        ASSERT_EQ(windrow_vulkan_set_bindings(static_cast<int>(set), VK_SHADER_STAGE_VERTEX_BIT, 3, bindings.data()),
                  wanted.size());
        for (std::uint32_t n = 0; n < wanted.size(); ++n) {
            EXPECT_EQ(bindings[n].binding, wanted.data()[n].binding);
            EXPECT_EQ(bindings[n].descriptorType, wanted.data()[n].descriptorType);
            EXPECT_EQ(bindings[n].stageFlags, wanted.data()[n].stageFlags);
        }
    }
    std::array<VkDescriptorSetLayoutBinding, WINDROW_VULKAN_MAX_BINDINGS> none{};
    EXPECT_EQ(windrow_vulkan_set_bindings(9, 0, 0, none.data()), 0u);
    auto boundaries = windrow_boundaries_open_over_floor();
    boundaries.x_low.kind = boundaries.x_high.kind = WINDROW_BOUNDARY_PERIODIC;
    VkSamplerCreateInfo info{};
    ASSERT_EQ(windrow_vulkan_sampler_info(&boundaries, &info), WINDROW_OK);
    EXPECT_EQ(info.addressModeU, VK_SAMPLER_ADDRESS_MODE_REPEAT);
    EXPECT_EQ(info.addressModeV, VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE);
}

TEST(CApiVulkan, WritesHoldTheHandles) {
    windrow_vulkan_set_content content{};
    content.now.vectors = {11, 12};
    content.before.vectors = {21, 22};
    content.sampler = 31;
    content.block = 41;
    content.block_offset = 256;
    content.tile = 51;
    windrow_vulkan_set_writes* writes = nullptr;
    ASSERT_EQ(windrow_vulkan_set_writes_create(7, &content, WINDROW_VULKAN_VECTORS, 2, &writes), WINDROW_OK);
    const auto* const list = static_cast<const VkWriteDescriptorSet*>(windrow_vulkan_set_writes_data(writes));
    const std::uint32_t count = windrow_vulkan_set_writes_count(writes);
    ASSERT_EQ(count, vulkan::set_bindings(vulkan::TextureSet::vectors, 0, 2).size());
    bool view = false, block = false;
    for (std::uint32_t n = 0; n < count; ++n) {
        EXPECT_EQ(list[n].dstSet, reinterpret_cast<VkDescriptorSet>(std::uintptr_t{7}));
        EXPECT_GE(list[n].dstBinding, 2u);
        if (list[n].pImageInfo != nullptr)
            view = view || list[n].pImageInfo->imageView == reinterpret_cast<VkImageView>(std::uintptr_t{12});
        if (list[n].pBufferInfo != nullptr && list[n].pBufferInfo->buffer == reinterpret_cast<VkBuffer>(std::uintptr_t{41}))
            block = list[n].pBufferInfo->offset == 256 && list[n].pBufferInfo->range == sizeof(windrow_frame_block);
    }
    EXPECT_TRUE(view);
    EXPECT_TRUE(block);
    windrow_vulkan_set_writes_destroy(writes);
}

TEST(CApiVulkan, RequiredFeaturesAreAddedToTheHosts) {
    VkPhysicalDeviceFeatures features{};
    features.geometryShader = VK_TRUE;
    ASSERT_EQ(windrow_vulkan_require_features(&features), WINDROW_OK);
    EXPECT_EQ(features.shaderStorageImageExtendedFormats, VK_TRUE);
    EXPECT_EQ(features.geometryShader, VK_TRUE);
    EXPECT_EQ(features.tessellationShader, VK_FALSE);
}

} // namespace
