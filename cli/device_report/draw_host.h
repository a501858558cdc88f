// A small renderer that draws offscreen: one descriptor set, pipelines without vertex buffers, a picture that is read back. For a
// report alone; vegetation/ has the renderer for games.
#pragma once

#include "fluid/vulkan/device.h"
#include "fluid/vulkan/own_device.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace windrow::cli {

class DrawHost {
  public:
    /// Of a device whose queue draws. The kinds of the bindings of set 0, for all stages that draw.
    [[nodiscard]] static Result<std::unique_ptr<DrawHost>> create(vulkan::OwnDevice& own, vulkan::Device& device,
                                                                  std::span<const VkDescriptorType> kinds);
    ~DrawHost();
    DrawHost(const DrawHost&) = delete;
    DrawHost& operator=(const DrawHost&) = delete;

    /// Where pipelines draw to: colour and depth of `samples` a pixel, resolved to a picture; or nothing, for pipelines that
    /// rasterise nothing.
    struct Target {
        VkExtent2D extent{};
        VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;
        bool attached = true;
        VkRenderPass pass = VK_NULL_HANDLE;
        VkFramebuffer framebuffer = VK_NULL_HANDLE;
        VkImage picture = VK_NULL_HANDLE; ///< R8G8B8A8_SRGB, in TRANSFER_SRC_OPTIMAL after a frame
    };
    [[nodiscard]] Result<Target> target(VkExtent2D extent, VkSampleCountFlagBits samples, bool attached = true);

    struct Recipe {
        std::span<const std::uint32_t> vertex, fragment; ///< no fragment stage: nothing is rasterised
        VkPrimitiveTopology topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
        bool depth = true;
    };
    [[nodiscard]] Result<VkPipeline> pipeline(const Target& target, const Recipe& recipe);

    /// Nothing that uses the set is in flight.
    void bind(std::span<const vulkan::Binding> bindings);

    struct Draw {
        VkPipeline pipeline;
        std::uint32_t vertices, instances;
    };
    void record(VkCommandBuffer commands, const Target& target, std::span<const Draw> draws) const;
    /// Four bytes a pixel, rows from the top, of the frame that was drawn last and is done.
    [[nodiscard]] Result<std::vector<std::byte>> pixels(const Target& target);

  private:
    struct Calls;
    DrawHost(vulkan::OwnDevice& own, vulkan::Device& device);
    [[nodiscard]] Result<void> make_set(std::span<const VkDescriptorType> kinds);
    struct Attachment {
        VkImage image = VK_NULL_HANDLE;
        VkImageView view = VK_NULL_HANDLE;
    };
    [[nodiscard]] Result<Attachment> attachment(VkExtent2D extent, VkFormat format, VkSampleCountFlagBits samples,
                                                VkImageUsageFlags usage);
    /// Calls of the kind vkCreate(device, info, callbacks, object); the object ends with this host.
    template <class Create, class Destroy, class Info, class Object>
    [[nodiscard]] Result<void> make(const char* name, Create call, Destroy destroy, const Info& info, Object& object);

    vulkan::OwnDevice& own_;
    vulkan::Device& device_;
    std::unique_ptr<Calls> calls_;
    std::vector<std::function<void()>> at_end_; ///< last first
    VkDescriptorSetLayout set_layout_ = VK_NULL_HANDLE;
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    VkDescriptorPool pool_ = VK_NULL_HANDLE;
    VkDescriptorSet set_ = VK_NULL_HANDLE;
};

} // namespace windrow::cli
