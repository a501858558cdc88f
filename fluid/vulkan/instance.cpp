#include "fluid/vulkan/instance.h"

#include "fluid/message.h"
#include "fluid/vulkan/functions.h"
#include "fluid/vulkan/own_device.h"

#include <algorithm>
#include <cstring>
#include <dlfcn.h>
#include <utility>
#include <vector>

namespace windrow::vulkan {
namespace {

// By the system's own search, then where a program that was linked elsewhere, or a container, does not search.
constexpr const char* k_libraries[] = {"libvulkan.so.1",
                                       "libvulkan.so",
                                       "/usr/lib/x86_64-linux-gnu/libvulkan.so.1",
                                       "/usr/lib64/libvulkan.so.1",
                                       "/usr/lib/libvulkan.so.1",
                                       "/usr/local/lib/libvulkan.so.1",
                                       "/run/opengl-driver/lib/libvulkan.so.1",
                                       "/usr/local/nvidia/lib64/libvulkan.so.1"};
constexpr const char* k_layer = "VK_LAYER_KHRONOS_validation";

bool has_layer(PFN_vkEnumerateInstanceLayerProperties enumerate) {
    std::uint32_t count = 0;
    if (enumerate(&count, nullptr) != VK_SUCCESS)
        return false;
    std::vector<VkLayerProperties> layers(count);
    if (enumerate(&count, layers.data()) != VK_SUCCESS)
        return false;
    return std::any_of(layers.begin(), layers.end(),
                       [](const VkLayerProperties& layer) { return std::strcmp(layer.layerName, k_layer) == 0; });
}

/// A copy to or from an image in the layout GENERAL, which a compute renderer keeps its images in, is reported as slow. Errors of
/// layout carry the same name, but are no performance warnings.
bool is_harmless(VkDebugUtilsMessageSeverityFlagBitsEXT severity, VkDebugUtilsMessageTypeFlagsEXT kind, const char* name) {
    return severity == VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT &&
           kind == VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT && name != nullptr &&
           std::strcmp(name, "UNASSIGNED-CoreValidation-DrawState-InvalidImageLayout") == 0;
}

} // namespace

Result<std::unique_ptr<Instance>> Instance::create(const Checks& checks, std::function<void(const std::string&)> on_message) {
    std::unique_ptr<Instance> instance(new Instance);
    instance->on_message_ = std::move(on_message);
    if (auto opened = instance->open_loader(); !opened)
        return Error{opened.error()};
    if (auto made = instance->make(checks); !made)
        return Error{made.error()};
    return instance;
}

bool Instance::has_validation() {
    Instance instance;
    if (!instance.open_loader())
        return false;
    const auto layers = instance.load<PFN_vkEnumerateInstanceLayerProperties>("vkEnumerateInstanceLayerProperties");
    return layers != nullptr && has_layer(layers);
}

Instance::~Instance() {
    if (messenger_ != VK_NULL_HANDLE)
        load<PFN_vkDestroyDebugUtilsMessengerEXT>("vkDestroyDebugUtilsMessengerEXT")(instance_, messenger_, nullptr);
    if (instance_ != VK_NULL_HANDLE)
        load<PFN_vkDestroyInstance>("vkDestroyInstance")(instance_, nullptr);
    if (library_ != nullptr)
        dlclose(library_);
}

std::span<const char* const> loader_names() {
    return k_libraries;
}

Result<void> Instance::open_loader() {
    std::string tried;
    for (const char* const name : k_libraries) {
        tried += (tried.empty() ? "" : ", ") + std::string(name);
        library_ = dlopen(name, RTLD_NOW | RTLD_LOCAL);
        if (library_ == nullptr)
            continue;
        get_instance_proc_addr_ = reinterpret_cast<PFN_vkGetInstanceProcAddr>(dlsym(library_, "vkGetInstanceProcAddr"));
        if (get_instance_proc_addr_ != nullptr)
            return {};
        dlclose(std::exchange(library_, nullptr));
    }
    return Error{detail::message("no Vulkan loader (", tried, "): install it (Debian: libvulkan1).")};
}

Result<void> Instance::make(const Checks& checks) {
    const auto version = load<PFN_vkEnumerateInstanceVersion>("vkEnumerateInstanceVersion");
    const auto layers = load<PFN_vkEnumerateInstanceLayerProperties>("vkEnumerateInstanceLayerProperties");
    const auto create = load<PFN_vkCreateInstance>("vkCreateInstance");
    std::uint32_t has = 0;
    if (version == nullptr || layers == nullptr || create == nullptr || version(&has) != VK_SUCCESS || has < VK_API_VERSION_1_2)
        return Error{"the Vulkan loader is older than 1.2: update it (Debian: libvulkan1)."};
    if (checks.validation && !has_layer(layers))
        return Error{detail::message(
            k_layer, " is not installed: install it (Debian: vulkan-validationlayers), or leave validation off.")};

    VkApplicationInfo application{};
    application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
    application.pApplicationName = "windrow";
    application.apiVersion = requirements().api_version;

    VkDebugUtilsMessengerCreateInfoEXT messenger{};
    messenger.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
    messenger.messageSeverity = VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    messenger.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
    messenger.pfnUserCallback = &Instance::hear;
    messenger.pUserData = this;

    std::vector<VkValidationFeatureEnableEXT> enabled{VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
    if (checks.gpu_validation) {
        enabled.push_back(VK_VALIDATION_FEATURE_ENABLE_GPU_ASSISTED_EXT);
        enabled.push_back(VK_VALIDATION_FEATURE_ENABLE_GPU_ASSISTED_RESERVE_BINDING_SLOT_EXT);
    }
    VkValidationFeaturesEXT features{};
    features.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT;
    features.pNext = &messenger; // receives messages while the instance is created and destroyed
    features.enabledValidationFeatureCount = static_cast<std::uint32_t>(enabled.size());
    features.pEnabledValidationFeatures = enabled.data();

    const char* const layer_names[] = {k_layer};
    const char* const extension_names[] = {VK_EXT_DEBUG_UTILS_EXTENSION_NAME, VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME};
    VkInstanceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    info.pApplicationInfo = &application;
    if (checks.validation) {
        info.pNext = &features;
        info.enabledLayerCount = 1;
        info.ppEnabledLayerNames = layer_names;
        info.enabledExtensionCount = 2;
        info.ppEnabledExtensionNames = extension_names;
    }
    VkResult result = create(&info, nullptr, &instance_);
    if (result != VK_SUCCESS)
        instance_ = VK_NULL_HANDLE;
    if (result == VK_ERROR_INCOMPATIBLE_DRIVER)
        return Error{"no Vulkan driver is installed: install your GPU's, or a software one (Debian: mesa-vulkan-drivers)."};
    if (result != VK_SUCCESS)
        return call_error("vkCreateInstance", "the loader", result);
    if (checks.validation) {
        const auto hear_it = load<PFN_vkCreateDebugUtilsMessengerEXT>("vkCreateDebugUtilsMessengerEXT");
        result = hear_it == nullptr ? VK_ERROR_EXTENSION_NOT_PRESENT : hear_it(instance_, &messenger, nullptr, &messenger_);
        if (result != VK_SUCCESS)
            return call_error("vkCreateDebugUtilsMessengerEXT", "the validation layer", result);
    }
    return {};
}

VkBool32 Instance::hear(VkDebugUtilsMessageSeverityFlagBitsEXT severity, VkDebugUtilsMessageTypeFlagsEXT kind,
                        const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
    if (is_harmless(severity, kind, data->pMessageIdName))
        return VK_FALSE;
    auto& instance = *static_cast<Instance*>(user);
    ++instance.messages_;
    if (instance.on_message_)
        instance.on_message_(data->pMessage == nullptr ? "" : data->pMessage);
    return VK_FALSE; // the call continues
}

} // namespace windrow::vulkan
