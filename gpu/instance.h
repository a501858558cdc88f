// An instance, made with the system's Vulkan loader or with another's calls.
#pragma once

#include "fluid/api.h"
#include "fluid/result.h"
#include "gpu/loader.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace windrow::vulkan {

/// Validation checks of an instance.
struct Checks {
    bool validation = false;     ///< core and synchronisation
    bool gpu_validation = false; ///< GPU-assisted
    /// Of the instance, rejected where the loader lacks one: those of a window's surface.
    std::vector<const char*> extensions{};
};

/// Whether `enumerate(&count, properties)`, one of Vulkan's enumerations, lists a name.
template <class Properties, std::size_t length, class Enumerate>
[[nodiscard]] bool lists(const Enumerate& enumerate, char (Properties::*field)[length], const char* name) {
    std::uint32_t count = 0;
    if (enumerate(&count, nullptr) != VK_SUCCESS)
        return false;
    std::vector<Properties> listed(count);
    if (enumerate(&count, listed.data()) != VK_SUCCESS)
        return false;
    return std::any_of(listed.begin(), listed.begin() + count,
                       [&](const Properties& each) { return std::strcmp(each.*field, name) == 0; });
}

class WINDROW_INTERNAL Instance {
  public:
    /// `on_message` is called for each message of the validation layer, from whatever thread made the faulty call. All calls come
    /// from `calls`; null: the system's loader is opened. Drivers over another API (VK_KHR_portability_enumeration) are listed.
    [[nodiscard]] static Result<std::unique_ptr<Instance>>
    create(const Checks& checks, std::function<void(const std::string&)> on_message, PFN_vkGetInstanceProcAddr calls = nullptr);
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

    Loader loader_{}; // closed last
    PFN_vkGetInstanceProcAddr get_instance_proc_addr_ = nullptr;
    VkInstance instance_ = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
    std::function<void(const std::string&)> on_message_;
    std::atomic<int> messages_ = 0;
};

} // namespace windrow::vulkan
