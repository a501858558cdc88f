// What a shader stores in a 3D image, and what a copy writes there, is what is copied back, in both formats of the wind's
// textures.
#include "fluid/textures.h"
#include "shader_words/fill_r16f.h"
#include "shader_words/fill_r32f.h"
#include "tests/parity/gpu.h"

#include <cstdint>
#include <cstring>

namespace windrow::vulkan {
namespace {

constexpr VkExtent3D k_extent{17, 9, 23};
constexpr std::size_t k_texels = std::size_t{17} * 9 * 23;

class Images : public Gpu {
  protected:
    void transition(VkCommandBuffer commands, VkImage image, VkImageLayout from, VkImageLayout to) const {
        constexpr VkPipelineStageFlags work = VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_TRANSFER_BIT;
        VkImageMemoryBarrier change{};
        change.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER;
        change.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_WRITE_BIT;
        change.dstAccessMask = VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_READ_BIT | VK_ACCESS_TRANSFER_WRITE_BIT;
        change.oldLayout = from;
        change.newLayout = to;
        change.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
        change.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
        change.image = image;
        change.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
        device->functions().vkCmdPipelineBarrier(commands, work, work, 0, 0, nullptr, 0, nullptr, 1, &change);
    }

    static VkBufferImageCopy whole_image() {
        VkBufferImageCopy whole{};
        whole.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
        whole.imageExtent = k_extent;
        return whole;
    }

    /// The bytes of an image that a shader has filled.
    std::vector<std::uint8_t> filled(std::span<const std::uint32_t> code, VkFormat format, std::size_t texel_bytes) {
        const VkDescriptorType one_image[] = {VK_DESCRIPTOR_TYPE_STORAGE_IMAGE};
        auto pipeline =
            Pipeline::create(*device, {.code = code, .bindings = one_image, .constants = {}, .push_bytes = 0, .name = "fill"});
        auto image = Image3D::create(*device, k_extent, format);
        if (!pipeline || !image) {
            ADD_FAILURE() << (pipeline ? image.error() : pipeline.error());
            return {};
        }
        const Sets::Content contents[] = {{&*pipeline, {{.type = VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, .view = image->view()}}}};
        auto sets = Sets::create(*device, contents);
        if (!sets) {
            ADD_FAILURE() << sets.error();
            return {};
        }
        const Buffer back = buffer(k_texels * texel_bytes, MemoryUse::readback);
        run([&](VkCommandBuffer commands) {
            const Functions& functions = device->functions();
            const VkBufferImageCopy whole = whole_image();
            transition(commands, image->handle(), VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_GENERAL);
            pipeline->bind(functions, commands, sets->at(0));
            functions.vkCmdDispatch(commands, (k_extent.width + 3) / 4, (k_extent.height + 3) / 4, (k_extent.depth + 3) / 4);
            barrier(commands);
            // In GENERAL, as a renderer does that keeps its images there: the layer's word on speed is no fault.
            functions.vkCmdCopyImageToBuffer(commands, image->handle(), VK_IMAGE_LAYOUT_GENERAL, back.handle(), 1, &whole);
            barrier(commands);
        });
        return read<std::uint8_t>(back, k_texels * texel_bytes);
    }

    /// The bytes that come back after an upload of `values`.
    std::vector<std::uint8_t> carried(const std::vector<std::uint8_t>& values, VkFormat format) {
        auto image = Image3D::create(*device, k_extent, format);
        if (!image) {
            ADD_FAILURE() << image.error();
            return {};
        }
        const Buffer up = buffer(values.size(), MemoryUse::upload);
        const Buffer back = buffer(values.size(), MemoryUse::readback);
        std::memcpy(up.mapped(), values.data(), values.size());
        EXPECT_EQ(up.flush(), VK_SUCCESS);
        run([&](VkCommandBuffer commands) {
            const Functions& functions = device->functions();
            const VkBufferImageCopy whole = whole_image();
            transition(commands, image->handle(), VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
            functions.vkCmdCopyBufferToImage(commands, up.handle(), image->handle(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1,
                                             &whole);
            transition(commands, image->handle(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
            functions.vkCmdCopyImageToBuffer(commands, image->handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, back.handle(), 1,
                                             &whole);
            barrier(commands);
        });
        return read<std::uint8_t>(back, values.size());
    }

    /// What fill.glsl writes.
    static std::vector<float> expected() {
        std::vector<float> values;
        for (std::uint32_t z = 0; z < k_extent.depth; ++z)
            for (std::uint32_t y = 0; y < k_extent.height; ++y)
                for (std::uint32_t x = 0; x < k_extent.width; ++x)
                    values.push_back(static_cast<float>(x + 10 * y + 100 * z) - 0.25f);
        return values;
    }
};

template <class Texel>
std::vector<std::uint8_t> bytes_of(const std::vector<Texel>& texels) {
    std::vector<std::uint8_t> bytes(texels.size() * sizeof(Texel));
    std::memcpy(bytes.data(), texels.data(), bytes.size());
    return bytes;
}

TEST_F(Images, HoldFloats) {
    const std::vector<std::uint8_t> wanted = bytes_of(expected());
    EXPECT_EQ(filled(shader_words::fill_r32f, VK_FORMAT_R32_SFLOAT, 4), wanted);
    EXPECT_EQ(carried(wanted, VK_FORMAT_R32_SFLOAT), wanted);
}

// A half has 11 bits: values up to 512 come back whole, the rest within its last bit, since a device may round either way.
TEST_F(Images, HoldHalves) {
    const std::vector<float> wanted = expected();
    const std::vector<std::uint8_t> bytes = filled(shader_words::fill_r16f, VK_FORMAT_R16_SFLOAT, 2);
    ASSERT_EQ(bytes.size(), 2 * k_texels);
    for (std::size_t n = 0; n < k_texels; ++n) {
        std::uint16_t half = 0;
        std::memcpy(&half, &bytes[2 * n], 2);
        const float value = from_half(half);
        if (wanted[n] < 512.0f)
            ASSERT_EQ(value, wanted[n]) << n;
        else
            ASSERT_NEAR(value, wanted[n], wanted[n] * 0x1p-10f) << n;
    }
    EXPECT_EQ(carried(bytes, VK_FORMAT_R16_SFLOAT), bytes);
}

} // namespace
} // namespace windrow::vulkan
