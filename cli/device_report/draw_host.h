// A small renderer that draws offscreen: one descriptor set, pipelines without vertex buffers, a picture that is read back. For a
// report alone; vegetation/ has the renderer for games.
#pragma once

#include "fluid/vulkan/own_device.h"
#include "fluid/vulkan/wind.h"
#include "gpu/device.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace windrow::cli {

/// The wind's bindings of shaders/coupling/windrow_wind.glsl, for a host that waits for each frame.
class WindBindings {
  public:
    /// Kinds of the bindings, in order.
    [[nodiscard]] static std::vector<VkDescriptorType> kinds();
    /// For winds with these boundaries.
    [[nodiscard]] static Result<WindBindings> create(vulkan::Device& device, const Boundaries& boundaries);
    /// Of the frame last recorded; nothing that uses them is in flight.
    [[nodiscard]] std::vector<vulkan::Binding> of(const vulkan::Wind& wind, glm::dvec3 anchor, const Sampling& sampling = {});

  private:
    vulkan::Buffer block_;
    vulkan::Handle<VkSampler, &vulkan::Functions::vkDestroySampler> sampler_;
};

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
    [[nodiscard]] Result<void> bind(std::vector<vulkan::Binding> bindings);

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
    struct Attachment {
        vulkan::OwnedPiece piece; // above what is bound to it, which goes first
        vulkan::Handle<VkImage, &vulkan::Functions::vkDestroyImage> image;
        vulkan::Handle<VkImageView, &vulkan::Functions::vkDestroyImageView> view;
    };
    [[nodiscard]] Result<Attachment> attachment(VkExtent2D extent, VkFormat format, VkSampleCountFlagBits samples,
                                                VkImageUsageFlags usage);
    /// Of the calls that the library has not; the object ends with this host.
    template <class Create, class Destroy, class Info, class Object>
    [[nodiscard]] Result<void> make(const char* name, Create call, Destroy destroy, const Info& info, Object& object);

    vulkan::OwnDevice& own_;
    vulkan::Device& device_;
    std::unique_ptr<Calls> calls_;
    vulkan::PipelineLayout layout_;
    vulkan::Sets sets_; ///< one
    std::vector<Attachment> attachments_;
    std::vector<vulkan::Handle<VkPipeline, &vulkan::Functions::vkDestroyPipeline>> pipelines_;
    std::vector<std::function<void()>> at_end_; ///< last first
};

} // namespace windrow::cli
