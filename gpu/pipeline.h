// Pipeline layouts of one descriptor set, and compute pipelines.
#pragma once

#include "fluid/api.h"
#include "gpu/handle.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace windrow::vulkan {

class Device;

/// Move-only. The layout of set 0 and of the pipelines that bind it, with one range of push constants.
class WINDROW_INTERNAL PipelineLayout {
  public:
    /// Empty.
    PipelineLayout() = default;
    /// `push` of size 0: no push constants; its size is a multiple of 4. Rejects more push constants or bindings than the device
    /// takes. The error begins with `what` or names it, the call and its VkResult.
    [[nodiscard]] static Result<PipelineLayout> create(Device& device, std::span<const VkDescriptorSetLayoutBinding> bindings,
                                                       const VkPushConstantRange& push, const std::string& what);
    [[nodiscard]] VkPipelineLayout layout() const { return layout_.get(); }
    [[nodiscard]] VkDescriptorSetLayout set_layout() const { return set_layout_.get(); }
    [[nodiscard]] std::span<const VkDescriptorSetLayoutBinding> bindings() const { return bindings_; }

  private:
    std::vector<VkDescriptorSetLayoutBinding> bindings_;
    Handle<VkDescriptorSetLayout, &Functions::vkDestroyDescriptorSetLayout> set_layout_;
    Handle<VkPipelineLayout, &Functions::vkDestroyPipelineLayout> layout_;
};

/// Bindings 0, 1, 2 ... of these kinds, one descriptor each.
[[nodiscard]] WINDROW_INTERNAL std::vector<VkDescriptorSetLayoutBinding> bindings_of(std::span<const VkDescriptorType> kinds,
                                                                                     VkShaderStageFlags stages);

/// Move-only. A compute pipeline and its layout.
class WINDROW_INTERNAL Pipeline : public PipelineLayout {
  public:
    struct Description {
        std::span<const std::uint32_t> code;        ///< SPIR-V, embedded at build time
        std::span<const VkDescriptorType> bindings; ///< of set 0, in order
        std::span<const std::uint32_t> constants;   ///< specialisation constants 0, 1, 2 ... (32 bits each)
        std::uint32_t push_bytes = 0;               ///< of push constants, a multiple of 4; 0: none
        const char* name = "";                      ///< of the pass, for sentences
    };
    /// Empty.
    Pipeline() = default;
    /// Rejects what PipelineLayout::create rejects. The error names the pass, the call and its VkResult.
    [[nodiscard]] static Result<Pipeline> create(Device& device, const Description& description);
    /// With a layout of the caller's; `bindings` and `push_bytes` of the description are not read.
    [[nodiscard]] static Result<Pipeline> create(Device& device, PipelineLayout layout, const Description& description);
    [[nodiscard]] VkPipeline handle() const { return pipeline_.get(); }
    /// For the dispatches that follow. `offsets`: of the dynamic bindings, in order.
    void bind(const Functions& functions, VkCommandBuffer commands, VkDescriptorSet set,
              std::span<const std::uint32_t> offsets = {}) const;

  private:
    Handle<VkPipeline, &Functions::vkDestroyPipeline> pipeline_;
};

/// What a shader does with one binding of set 0, as its own decorations tell. Both where the shader's text says neither readonly
/// nor writeonly.
struct Access {
    bool reads = true, writes = true;
};

/// For bindings 0 to `bindings` - 1; one that the shader does not declare is neither read nor written.
[[nodiscard]] std::vector<Access> access_of(std::span<const std::uint32_t> spirv, std::size_t bindings);

} // namespace windrow::vulkan
