// A compute pipeline with the layout of its bindings.
#pragma once

#include "fluid/vulkan/handle.h"

#include <cstdint>
#include <span>
#include <vector>

namespace windrow::vulkan {

class Device;

/// Move-only. A compute pipeline with its one descriptor set layout: set 0, bindings 0, 1, 2 ... of the kinds given, and one
/// range of push constants.
class Pipeline {
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
    /// Rejects more push constants or bindings than the device takes. The error names the pass, the call and its VkResult.
    [[nodiscard]] static Result<Pipeline> create(Device& device, const Description& description);
    [[nodiscard]] VkPipeline handle() const { return pipeline_.get(); }
    [[nodiscard]] VkPipelineLayout layout() const { return layout_.get(); }
    [[nodiscard]] VkDescriptorSetLayout set_layout() const { return set_layout_.get(); }
    /// As described.
    [[nodiscard]] std::span<const VkDescriptorType> bindings() const { return bindings_; }

  private:
    std::vector<VkDescriptorType> bindings_;
    Handle<VkDescriptorSetLayout, &Functions::vkDestroyDescriptorSetLayout> set_layout_;
    Handle<VkPipelineLayout, &Functions::vkDestroyPipelineLayout> layout_;
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
