// What any engine has already: an instance, a device, a queue, memory. Nothing here is of the wind.
//
// An example may end where an engine would try again: a call that fails ends the program with a sentence.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>
#include <vulkan/vulkan_core.h>

namespace windrow::vegetation::engine {

/// Ends the program: 1 something failed, 2 wrong use, 3 the machine lacks something.
[[noreturn]] void give_up(const std::string& sentence, int code);
/// Ends the program unless a call succeeded.
void must(VkResult result, const char* call);

struct Buffer {
    VkBuffer buffer = VK_NULL_HANDLE;
    void* mapped = nullptr;
};

struct Image {
    VkImage image = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE;
};

class Device {
  public:
    /// Why a physical device will not do; empty where it will.
    using Judge = std::function<std::string(VkInstance, VkPhysicalDevice)>;

    /// Takes the first device that draws and computes on one queue and that the judge does not object to, a GPU before software.
    Device(std::uint32_t api_version, const VkPhysicalDeviceFeatures& features, const Judge& judge);
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;
    /// Waits for all work, and destroys what was made.
    ~Device();

    VkInstance instance = VK_NULL_HANDLE;
    VkPhysicalDevice physical = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    VkQueue queue = VK_NULL_HANDLE;
    std::uint32_t family = 0;
    std::string name{};
    /// pipelineStatisticsQuery, which is on where the device has it.
    bool counts_vertices = false;

    /// Memory that the host sees, mapped.
    [[nodiscard]] Buffer make_buffer(VkDeviceSize bytes, VkBufferUsageFlags usage);
    /// A 2D image to draw to.
    [[nodiscard]] Image make_image(VkFormat format, VkExtent2D extent, VkSampleCountFlagBits samples, VkImageUsageFlags usage,
                                   VkImageAspectFlags aspect);
    /// [bytes] Memory that was allocated here so far.
    [[nodiscard]] VkDeviceSize memory_bytes() const { return memory_bytes_; }
    /// Destroyed with the device, the last first.
    void at_end(std::function<void()> destroy) { destroy_.push_back(std::move(destroy)); }

  private:
    [[nodiscard]] VkDeviceMemory allocate(const VkMemoryRequirements& needs, VkMemoryPropertyFlags wanted);

    VkDeviceSize memory_bytes_ = 0;
    std::vector<std::function<void()>> destroy_{};
};

} // namespace windrow::vegetation::engine
