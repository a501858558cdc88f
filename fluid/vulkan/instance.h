// The Vulkan loader, opened while the program runs, and an instance made with it.
#pragma once

#include "fluid/result.h"
#include "fluid/vulkan/host.h"

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vulkan/vulkan_core.h>

namespace windrow::vulkan {

/// Validation checks of an instance.
struct Checks {
    bool validation = false;     ///< core and synchronisation
    bool gpu_validation = false; ///< GPU-assisted
};

class Instance {
  public:
    /// `on_message` is called for each message of the validation layer, from whatever thread made the faulty call.
    [[nodiscard]] static Result<std::unique_ptr<Instance>> create(const Checks& checks,
                                                                  std::function<void(const std::string&)> on_message);
    /// Whether VK_LAYER_KHRONOS_validation is installed; false where there is no loader.
    [[nodiscard]] static bool has_validation();
    ~Instance();
    Instance(const Instance&) = delete;
    Instance& operator=(const Instance&) = delete;

    [[nodiscard]] VkInstance handle() const { return instance_; }
    [[nodiscard]] PFN_vkGetInstanceProcAddr get_instance_proc_addr() const { return get_instance_proc_addr_; }
    /// A call of the instance or the device; null where there is none.
    template <class Function>
    [[nodiscard]] Function load(const char* name) const {
        return reinterpret_cast<Function>(get_instance_proc_addr_(instance_, name));
    }
    [[nodiscard]] int messages() const { return messages_; }

  private:
    Instance() = default;
    [[nodiscard]] Result<void> open_loader();
    [[nodiscard]] Result<void> make(const Checks& checks);
    static VKAPI_ATTR VkBool32 VKAPI_CALL hear(VkDebugUtilsMessageSeverityFlagBitsEXT severity,
                                               VkDebugUtilsMessageTypeFlagsEXT kind,
                                               const VkDebugUtilsMessengerCallbackDataEXT* data, void* user);

    void* library_ = nullptr;
    PFN_vkGetInstanceProcAddr get_instance_proc_addr_ = nullptr;
    VkInstance instance_ = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
    std::function<void(const std::string&)> on_message_;
    std::atomic<int> messages_ = 0;
};

} // namespace windrow::vulkan
