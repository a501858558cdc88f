#include "fluid/vulkan/device.h"

#include "fluid/message.h"

#include <algorithm>
#include <vector>

namespace windrow::vulkan {
namespace {

void check_queue_family(const Host& host, const Functions& functions, detail::Reasons& reasons) {
    std::uint32_t count = 0;
    functions.vkGetPhysicalDeviceQueueFamilyProperties(host.physical_device, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    functions.vkGetPhysicalDeviceQueueFamilyProperties(host.physical_device, &count, families.data());
    if (host.queue_family >= count)
        reasons.add("queue_family is ", host.queue_family, " and the device has ", count, ": give one of those, from 0.");
    else if ((families[host.queue_family].queueFlags & VK_QUEUE_COMPUTE_BIT) == 0)
        reasons.add("queue_family ", host.queue_family, " cannot compute: give one with VK_QUEUE_COMPUTE_BIT.");
}

} // namespace

Result<std::unique_ptr<Device>> Device::create(const Host& host) {
    auto functions = load_functions(host);
    if (!functions)
        return Error{functions.error()};
    return create(host, *functions);
}

Result<std::unique_ptr<Device>> Device::create(const Host& host, const Functions& functions) {
    detail::Reasons reasons;
    if (host.device == VK_NULL_HANDLE)
        reasons.add("device is null: give the VkDevice.");
    if (static_cast<bool>(host.memory.allocate) != static_cast<bool>(host.memory.release))
        reasons.add("memory has one of allocate and release: give both or neither.");
    if (auto checked = vulkan::check(host.instance, host.physical_device, host.get_instance_proc_addr); !checked)
        reasons.add(checked.error());
    else
        check_queue_family(host, functions, reasons);
    if (!reasons.empty())
        return Error{reasons.take()};
    return std::unique_ptr<Device>(new Device(host, functions));
}

Device::Device(const Host& host, const Functions& functions) : host_(host), functions_(functions), memory_(host, functions) {
    VkPhysicalDeviceProperties properties{};
    functions_.vkGetPhysicalDeviceProperties(host_.physical_device, &properties);
    limits_ = properties.limits;
    if (host_.shared_bytes > 0)
        limits_.maxComputeSharedMemorySize = std::min(limits_.maxComputeSharedMemorySize, host_.shared_bytes);
}

Result<void> Device::check(const Dispatch& dispatch) const {
    detail::Reasons reasons;
    std::uint64_t invocations = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (dispatch.groups[axis] > limits_.maxComputeWorkGroupCount[axis])
            reasons.add("the pass ", dispatch.name, " has ", dispatch.groups[axis], " groups along ", std::string(1, "xyz"[axis]),
                        " where the device takes ", limits_.maxComputeWorkGroupCount[axis],
                        " (maxComputeWorkGroupCount): use a smaller box.");
        if (dispatch.local_size[axis] > limits_.maxComputeWorkGroupSize[axis])
            reasons.add("the pass ", dispatch.name, " has groups of ", dispatch.local_size[axis], " along ",
                        std::string(1, "xyz"[axis]), " where the device takes ", limits_.maxComputeWorkGroupSize[axis],
                        " (maxComputeWorkGroupSize): use another device or the CPU.");
        invocations *= dispatch.local_size[axis];
    }
    if (invocations > limits_.maxComputeWorkGroupInvocations)
        reasons.add("the pass ", dispatch.name, " has groups of ", invocations, " where the device takes ",
                    limits_.maxComputeWorkGroupInvocations, " (maxComputeWorkGroupInvocations): use another device or the CPU.");
    if (dispatch.shared_bytes > limits_.maxComputeSharedMemorySize)
        reasons.add("the pass ", dispatch.name, " uses ", dispatch.shared_bytes,
                    " bytes of shared memory in a group where the device takes ", limits_.maxComputeSharedMemorySize,
                    " (maxComputeSharedMemorySize): use another device or the CPU.");
    if (!reasons.empty())
        return Error{reasons.take()};
    return {};
}

} // namespace windrow::vulkan
