// A Vulkan device owned by the library, for the command, the tests and small hosts. An engine brings its own (host.h).
//
// The loader (libvulkan.so.1, vulkan-1.dll) is opened at run time, so that a program starts without it and reports an error.
// Drivers over another API, such as MoltenVK, are listed too. This is the library windrow::vulkan_loader.
#pragma once

#include "../api.h"
#include "../result.h"
#include "host.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace windrow::vulkan {

struct DeviceFacts {
    std::string name;
    std::string driver;      ///< name and version
    std::string api_version; ///< "1.3.230"
    bool software = false;   ///< VK_PHYSICAL_DEVICE_TYPE_CPU
    std::string trouble;     ///< why it cannot run the wind; empty: it can
};

/// The devices of this machine, in the driver's order; an error where there is no loader, no driver or no device.
[[nodiscard]] WINDROW_API Result<std::vector<DeviceFacts>> list_devices();

/// True if this machine has the validation layer of OwnDevice::Settings::validation.
[[nodiscard]] WINDROW_API bool has_validation_layer();

class WINDROW_API OwnDevice {
  public:
    struct Settings {
        int device = -1;         ///< index in list_devices(); -1: the first hardware device, else the first
        bool validation = false; ///< core and synchronisation checks of VK_LAYER_KHRONOS_validation, rejected where it is absent
        bool gpu_validation = false; ///< and GPU-assisted ones
        /// Called for each message of the layer (warnings and errors). Default: counted alone.
        std::function<void(const std::string& text)> on_message{};
        VkQueueFlags queue = VK_QUEUE_COMPUTE_BIT; ///< what the queue can do; for a host that draws, VK_QUEUE_GRAPHICS_BIT too
        VkQueueFlags queue_without = 0;            ///< what it cannot: VK_QUEUE_GRAPHICS_BIT for a queue that computes alone
        VkPhysicalDeviceFeatures wished{};         ///< features that are enabled where the device has them
        /// Of the device; a device without one is rejected. VK_KHR_portability_subset is added where the device lists it.
        std::vector<const char*> extensions{};
        std::vector<const char*> instance_extensions{}; ///< of the instance: those of a window's surface
        const void* next = nullptr;                     ///< chained to VkDeviceCreateInfo: features of the extensions
        /// A second queue for the wind beside the first: of a family that computes and cannot draw; where there is none, one more
        /// of the first family; where that has one queue, the first queue itself. Default: none.
        bool compute_queue = false;
        /// Where all calls come from, for a program that links a loader or, as on iOS, MoltenVK. Default null: the system's loader
        /// is opened.
        PFN_vkGetInstanceProcAddr get_instance_proc_addr = nullptr;
    };
    [[nodiscard]] static Result<std::unique_ptr<OwnDevice>> create(const Settings& settings);
    ~OwnDevice();
    OwnDevice(const OwnDevice&) = delete;
    OwnDevice& operator=(const OwnDevice&) = delete;

    [[nodiscard]] Host host() const;
    [[nodiscard]] VkQueue queue() const;
    /// Of a wind on Settings::compute_queue, whose readers are on the first queue; without it `host` and `queue`.
    [[nodiscard]] Host compute_host() const;
    [[nodiscard]] VkQueue compute_queue() const;
    [[nodiscard]] const DeviceFacts& facts() const;
    /// Features that are enabled.
    [[nodiscard]] const VkPhysicalDeviceFeatures& features() const;
    /// Messages of the validation layer so far.
    [[nodiscard]] int messages() const;

    /// Records with `record`, submits, and waits: for tools. A result other than VK_SUCCESS is returned.
    [[nodiscard]] Result<void> run(const std::function<void(VkCommandBuffer)>& record);
    /// Records and submits without waiting. Each slot, from 0, has a command buffer of its own; what was submitted in it before is
    /// waited for first.
    [[nodiscard]] Result<void> submit(int slot, const std::function<void(VkCommandBuffer)>& record);
    /// Until nothing that was submitted is in flight.
    [[nodiscard]] Result<void> wait();

  private:
    struct State;
    explicit OwnDevice(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace windrow::vulkan
