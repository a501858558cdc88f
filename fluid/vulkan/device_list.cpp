#include "fluid/vulkan/device_list.h"

#include "fluid/message.h"
#include "fluid/vulkan/functions.h"

namespace windrow::vulkan {
namespace {

DeviceFacts facts_of(const Instance& instance, VkPhysicalDevice physical_device) {
    VkPhysicalDeviceProperties properties{};
    instance.load<PFN_vkGetPhysicalDeviceProperties>("vkGetPhysicalDeviceProperties")(physical_device, &properties);
    const std::uint32_t version = properties.apiVersion;
    DeviceFacts facts;
    facts.name = properties.deviceName;
    facts.api_version =
        detail::message(VK_API_VERSION_MAJOR(version), ".", VK_API_VERSION_MINOR(version), ".", VK_API_VERSION_PATCH(version));
    facts.software = properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
    facts.driver = "unknown";
    if (version >= VK_API_VERSION_1_2) {
        VkPhysicalDeviceDriverProperties driver{};
        driver.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES;
        VkPhysicalDeviceProperties2 more{};
        more.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
        more.pNext = &driver;
        instance.load<PFN_vkGetPhysicalDeviceProperties2>("vkGetPhysicalDeviceProperties2")(physical_device, &more);
        facts.driver = detail::message(driver.driverName, " ", driver.driverInfo);
    }
    if (const auto fit = check(instance.handle(), physical_device, instance.get_instance_proc_addr()); !fit)
        facts.trouble = fit.error();
    return facts;
}

} // namespace

Result<std::vector<FoundDevice>> find_devices(const Instance& instance) {
    const auto enumerate = instance.load<PFN_vkEnumeratePhysicalDevices>("vkEnumeratePhysicalDevices");
    std::uint32_t count = 0;
    VkResult result = enumerate(instance.handle(), &count, nullptr);
    std::vector<VkPhysicalDevice> devices(count);
    if (result == VK_SUCCESS && count > 0)
        result = enumerate(instance.handle(), &count, devices.data());
    if (result != VK_SUCCESS && result != VK_INCOMPLETE)
        return call_error("vkEnumeratePhysicalDevices", "the machine", result);
    if (count == 0)
        return Error{"no Vulkan device was found: install your GPU's driver, or a software one (Debian: mesa-vulkan-drivers)."};
    devices.resize(count);
    std::vector<FoundDevice> found;
    for (const VkPhysicalDevice device : devices)
        found.push_back({device, facts_of(instance, device)});
    return found;
}

Result<std::vector<DeviceFacts>> list_devices() {
    auto instance = Instance::create({}, {});
    if (!instance)
        return Error{instance.error()};
    auto found = find_devices(**instance);
    if (!found)
        return Error{found.error()};
    std::vector<DeviceFacts> facts;
    for (const FoundDevice& device : *found)
        facts.push_back(device.facts);
    return facts;
}

} // namespace windrow::vulkan
