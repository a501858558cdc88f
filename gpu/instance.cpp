#include "gpu/instance.h"

#include "fluid/core/message.h"
#include "fluid/vulkan/own_device.h"
#include "gpu/functions.h"

#include <utility>
#include <vector>

namespace windrow::vulkan {
namespace {

constexpr const char* k_layer = "VK_LAYER_KHRONOS_validation";

// Of VK_KHR_portability_enumeration; headers before 1.3.207 lack them.
constexpr const char* k_portability = "VK_KHR_portability_enumeration";
constexpr VkInstanceCreateFlags k_enumerate_portability = 1;

bool has_layer(PFN_vkEnumerateInstanceLayerProperties enumerate) {
    return lists(enumerate, &VkLayerProperties::layerName, k_layer);
}

/// A copy to or from an image in the layout GENERAL, which a compute renderer keeps its images in, is reported as slow. Errors of
/// layout carry the same name, but are no performance warnings.
bool is_harmless(VkDebugUtilsMessageSeverityFlagBitsEXT severity, VkDebugUtilsMessageTypeFlagsEXT kind, const char* name) {
    return severity == VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT &&
           kind == VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT && name != nullptr &&
           std::strcmp(name, "UNASSIGNED-CoreValidation-DrawState-InvalidImageLayout") == 0;
}

} // namespace

Result<std::unique_ptr<Instance>> Instance::create(const Checks& checks, std::function<void(const std::string&)> on_message,
                                                   PFN_vkGetInstanceProcAddr calls) {
    std::unique_ptr<Instance> instance(new Instance);
    instance->on_message_ = std::move(on_message);
    instance->get_instance_proc_addr_ = calls;
    if (auto opened = instance->open_loader(); !opened)
        return opened.failure();
    if (auto made = instance->make(checks); !made)
        return made.failure();
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
}

Result<void> Instance::open_loader() {
    if (get_instance_proc_addr_ != nullptr)
        return {};
    auto opened = Loader::open();
    if (!opened)
        return opened.failure();
    loader_ = *std::move(opened);
    get_instance_proc_addr_ = loader_.get_instance_proc_addr();
    return {};
}

Result<void> Instance::make(const Checks& checks) {
    const auto version = load<PFN_vkEnumerateInstanceVersion>("vkEnumerateInstanceVersion");
    const auto layers = load<PFN_vkEnumerateInstanceLayerProperties>("vkEnumerateInstanceLayerProperties");
    const auto enumerate = load<PFN_vkEnumerateInstanceExtensionProperties>("vkEnumerateInstanceExtensionProperties");
    const auto create = load<PFN_vkCreateInstance>("vkCreateInstance");
    std::uint32_t has = 0;
    if (version == nullptr || layers == nullptr || enumerate == nullptr || create == nullptr || version(&has) != VK_SUCCESS ||
        has < VK_API_VERSION_1_2)
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
    std::vector<const char*> extension_names;
    VkInstanceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    info.pApplicationInfo = &application;
    if (checks.validation) {
        info.pNext = &features;
        info.enabledLayerCount = 1;
        info.ppEnabledLayerNames = layer_names;
        extension_names = {VK_EXT_DEBUG_UTILS_EXTENSION_NAME, VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME};
    }
    const auto extensions = [&](std::uint32_t* count, VkExtensionProperties* properties) {
        return enumerate(nullptr, count, properties);
    };
    if (lists(extensions, &VkExtensionProperties::extensionName, k_portability)) {
        info.flags |= k_enumerate_portability;
        extension_names.push_back(k_portability);
    }
    for (const char* const name : checks.extensions) {
        if (!lists(extensions, &VkExtensionProperties::extensionName, name))
            return Error{detail::message("the Vulkan loader lacks ", name,
                                         ": update it (Debian: libvulkan1) and the driver (mesa-vulkan-drivers).")};
        extension_names.push_back(name);
    }
    info.enabledExtensionCount = static_cast<std::uint32_t>(extension_names.size());
    info.ppEnabledExtensionNames = extension_names.data();
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
