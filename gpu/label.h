// Label around commands, for debuggers and captures.
#pragma once

#include "gpu/device.h"

namespace windrow::vulkan {

/// From its construction to its end; nothing where the host did not enable VK_EXT_debug_utils.
class Label {
  public:
    Label(const Device& device, VkCommandBuffer commands, const char* text)
        : functions_(device.functions()), commands_(commands) {
        if (functions_.vkCmdBeginDebugUtilsLabelEXT == nullptr)
            return;
        const VkDebugUtilsLabelEXT label{
            .sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT, .pNext = nullptr, .pLabelName = text, .color = {}};
        functions_.vkCmdBeginDebugUtilsLabelEXT(commands, &label);
    }
    ~Label() {
        if (functions_.vkCmdEndDebugUtilsLabelEXT != nullptr)
            functions_.vkCmdEndDebugUtilsLabelEXT(commands_);
    }
    Label(const Label&) = delete;
    Label& operator=(const Label&) = delete;

  private:
    const Functions& functions_;
    VkCommandBuffer commands_;
};

} // namespace windrow::vulkan
