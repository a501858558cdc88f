// The device that the renderer works on: made here, or a host's own; its memory, and the way of data to it and back.
//
//     auto device = engine::Device::create();                         // an instance, a device and a queue of our own
//     auto device = engine::Device::adopt(host, queue);               // those of a host engine
//     auto wind = vulkan::Wind::create((*device)->host(), config, {.frames_in_flight = engine::k_frames_in_flight});
//
// Data that is made once goes through staging buffers: what was made since the last frame is copied by one batch of commands at
// the start of the next (Frames::begin, or `begin_frame` in a host's own command buffer), and nothing waits for it.
#pragma once

#include "calls.h"
#include "failure.h"
#include "shared_objects.h"

#include <array>
#include <cstddef>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <vector>
#include <vulkan/vulkan_core.h>

namespace windrow::vegetation::engine {

inline constexpr int k_frames_in_flight = 2;

/// Usage of a buffer.
enum class Use {
    fixed,    ///< filled once: vertices, indices, heights, texels, tables
    work,     ///< written and read by the device alone
    frame,    ///< written by the host in each frame, read by the device
    staging,  ///< written by the host, copied by the device
    readback, ///< written by the device, read by the host
};

class BufferMemory;

struct DeviceSettings {
    int device = -1;         ///< place in vulkan::list_devices(); -1: the first that is no software, else the first
    bool validation = false; ///< core and synchronisation checks of the validation layer
    /// Called for each message of the layer. Default: none.
    std::function<void(const std::string& text)> on_message{};
    /// As if the host saw no memory of the device's own: all data is staged. For tests.
    bool staged = false;
    /// As vulkan::OwnDevice::Settings has it: null opens the system's loader.
    PFN_vkGetInstanceProcAddr get_instance_proc_addr = nullptr;
    /// Of a device that draws to a window: VK_KHR_swapchain, and of the instance those of the window's surface.
    std::vector<const char*> extensions{}, instance_extensions{};
};

struct Buffer {
    VkBuffer buffer = VK_NULL_HANDLE;
    /// Address at which the host writes a frame's buffer until the frame is submitted, or reads a read-back; else null.
    void* mapped = nullptr;
    VkDeviceMemory memory = VK_NULL_HANDLE;
    VkDeviceSize offset = 0, bytes = 0; ///< [bytes]
};

class Device {
  public:
    /// Opens the loader, and makes an instance and a device with a queue that draws and computes. Errors: no driver, no device
    /// that can run the wind.
    [[nodiscard]] static Result<std::unique_ptr<Device>> create(const DeviceSettings& settings = {});
    /// A host's device and a queue of its family `host.queue_family`, which draws and computes. Both outlive what is made here;
    /// the host keeps other threads from the queue while functions of this library run. One thread at a time makes and ends things on
    /// a device.
    [[nodiscard]] static Result<std::unique_ptr<Device>> adopt(const vulkan::Host& host, VkQueue queue,
                                                               const DeviceSettings& settings = {});
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;
    /// Nothing made on it is left. A device of our own is waited for; a host waits for its own before.
    ~Device();

    [[nodiscard]] const vulkan::Host& host() const;
    [[nodiscard]] VkDevice handle() const { return host().device; }
    [[nodiscard]] VkQueue queue() const;
    [[nodiscard]] const std::string& name() const;
    [[nodiscard]] const VkPhysicalDeviceLimits& limits() const;
    /// Whether the device is the CPU itself.
    [[nodiscard]] bool software() const;
    /// Whether pipelineStatisticsQuery is enabled; false of a host's device.
    [[nodiscard]] bool counts_vertices() const;

    /// Records, at the start of a frame and outside of a render pass, the copies of all that was made since the last frame and,
    /// where it is staged, of what the host writes in this frame. What was recorded for the slot before is done. Frames::begin
    /// calls it; a host with command buffers of its own calls it once in each frame, before all of this library's.
    void begin_frame(VkCommandBuffer commands, int slot);

    /// Reads back `count` values of a buffer with VK_BUFFER_USAGE_TRANSFER_SRC_BIT, from the first on.
    /// Submits a copy and waits for it: for tools and tests.
    template <class Value>
    [[nodiscard]] Result<std::vector<Value>> read(VkBuffer from, std::size_t first, std::size_t count) {
        std::vector<Value> values(count);
        if (auto done = read_bytes(from, first * sizeof(Value), count * sizeof(Value), values.data()); !done)
            return done.failure();
        return values;
    }
    /// Makes what the device has written to a read-back visible to the host, once the frame is done.
    [[nodiscard]] const void* read_back(const Buffer& buffer) const;

    /// Layouts, render passes and pipelines of all objects.
    [[nodiscard]] SharedObjects& shared_objects();

    /// [bytes] Device memory of all objects, and what the blocks hold that it is cut from.
    [[nodiscard]] VkDeviceSize memory_bytes() const;
    [[nodiscard]] VkDeviceSize reserved_bytes() const;

  private:
    friend class Objects;
    struct State;
    explicit Device(std::unique_ptr<State> state);
    [[nodiscard]] Result<void> read_bytes(VkBuffer from, VkDeviceSize offset, VkDeviceSize bytes, void* to);
    [[nodiscard]] BufferMemory& memory() const;
    /// Copies the bytes to the buffer at the start of the next frame.
    void upload(const Buffer& to, const void* from);
    /// Copies `from` to `to` at the start of each frame of the slot.
    void copy_each_frame(int slot, const Buffer& from, const Buffer& to);
    /// Drops what is still to be copied to a buffer that ends.
    void forget(VkBuffer to);

    std::unique_ptr<State> state_;
};

} // namespace windrow::vegetation::engine
