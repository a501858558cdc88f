#include "gpu/device.h"

#include "fluid/core/message.h"
#include "fluid/vulkan/pipeline_store.h"

#include <algorithm>
#include <string>

namespace windrow::vulkan {
namespace {

std::vector<VkQueueFamilyProperties> families_of(const Host& host, const Functions& functions) {
    std::uint32_t count = 0;
    functions.vkGetPhysicalDeviceQueueFamilyProperties(host.physical_device, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    functions.vkGetPhysicalDeviceQueueFamilyProperties(host.physical_device, &count, families.data());
    families.resize(count);
    return families;
}

// Stages that may read textures, with what a queue family needs for each.
struct ReaderStage {
    VkPipelineStageFlags stage;
    VkQueueFlags needs;
    const char* name;
};
constexpr ReaderStage k_reader_stages[] = {
    {VK_PIPELINE_STAGE_VERTEX_SHADER_BIT, VK_QUEUE_GRAPHICS_BIT, "VK_PIPELINE_STAGE_VERTEX_SHADER_BIT"},
    {VK_PIPELINE_STAGE_TESSELLATION_CONTROL_SHADER_BIT, VK_QUEUE_GRAPHICS_BIT,
     "VK_PIPELINE_STAGE_TESSELLATION_CONTROL_SHADER_BIT"},
    {VK_PIPELINE_STAGE_TESSELLATION_EVALUATION_SHADER_BIT, VK_QUEUE_GRAPHICS_BIT,
     "VK_PIPELINE_STAGE_TESSELLATION_EVALUATION_SHADER_BIT"},
    {VK_PIPELINE_STAGE_GEOMETRY_SHADER_BIT, VK_QUEUE_GRAPHICS_BIT, "VK_PIPELINE_STAGE_GEOMETRY_SHADER_BIT"},
    {VK_PIPELINE_STAGE_TASK_SHADER_BIT_NV, VK_QUEUE_GRAPHICS_BIT, "VK_PIPELINE_STAGE_TASK_SHADER_BIT_EXT"},
    {VK_PIPELINE_STAGE_MESH_SHADER_BIT_NV, VK_QUEUE_GRAPHICS_BIT, "VK_PIPELINE_STAGE_MESH_SHADER_BIT_EXT"},
    {VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT, VK_QUEUE_GRAPHICS_BIT, "VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT"},
    {VK_PIPELINE_STAGE_ALL_GRAPHICS_BIT, VK_QUEUE_GRAPHICS_BIT, "VK_PIPELINE_STAGE_ALL_GRAPHICS_BIT"},
    {VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_QUEUE_COMPUTE_BIT, "VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT"},
    {VK_PIPELINE_STAGE_RAY_TRACING_SHADER_BIT_KHR, VK_QUEUE_COMPUTE_BIT, "VK_PIPELINE_STAGE_RAY_TRACING_SHADER_BIT_KHR"},
    {VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, "VK_PIPELINE_STAGE_ALL_COMMANDS_BIT"},
};

VkPipelineStageFlags default_stages(VkQueueFlags family) {
    constexpr VkPipelineStageFlags drawing = VK_PIPELINE_STAGE_VERTEX_SHADER_BIT | VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT;
    return VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | ((family & VK_QUEUE_GRAPHICS_BIT) != 0 ? drawing : 0);
}

void check_reader_stages(const Host& host, VkQueueFlags family, detail::Reasons& reasons) {
    VkPipelineStageFlags unknown = host.reader_stages;
    for (const ReaderStage& stage : k_reader_stages) {
        unknown &= ~stage.stage;
        if ((host.reader_stages & stage.stage) != 0 && (family & stage.needs) != stage.needs)
            reasons.add("reader_stages holds ", stage.name, ", which queue family ", host.queue_family,
                        " lacks: name stages of that family; queues of reader_queue_families wait by a semaphore.");
    }
    if (unknown != 0)
        reasons.add("reader_stages holds bits of no shader stage (", unknown, "): name the stages that sample.");
}

void check_queues(const Host& host, const Functions& functions, detail::Reasons& reasons) {
    const std::vector<VkQueueFamilyProperties> families = families_of(host, functions);
    const std::size_t count = families.size();
    if (host.queue_family >= count)
        reasons.add("queue_family is ", host.queue_family, " and the device has ", count, ": give one of those, from 0.");
    else if ((families[host.queue_family].queueFlags & VK_QUEUE_COMPUTE_BIT) == 0)
        reasons.add("queue_family ", host.queue_family, " cannot compute: give one with VK_QUEUE_COMPUTE_BIT.");
    else
        check_reader_stages(host, families[host.queue_family].queueFlags, reasons);
    for (const std::uint32_t family : host.reader_queue_families)
        if (family >= count)
            reasons.add("reader_queue_families holds ", family, " and the device has ", count, ": give some of those, from 0.");
}

} // namespace

Result<std::unique_ptr<Device>> Device::create(const Host& host) {
    auto functions = load_functions(host);
    if (!functions)
        return functions.failure();
    return create(host, *functions);
}

Result<std::unique_ptr<Device>> Device::create(const Host& host, const Functions& functions) {
    detail::Reasons reasons;
    if (host.device == VK_NULL_HANDLE)
        reasons.add("device is null: give the VkDevice.");
    if (static_cast<bool>(host.memory.allocate) != static_cast<bool>(host.memory.release))
        reasons.add("memory has one of allocate and release: give both or neither.");
    if (host.pipeline_store && host.pipeline_store->device() != host.device)
        reasons.add("pipeline_store is of another VkDevice: create a PipelineStore from this host.");
    if (auto checked = vulkan::check(host.instance, host.physical_device, host.get_instance_proc_addr); !checked)
        reasons.add(checked.error());
    else
        check_queues(host, functions, reasons);
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
    reader_stages_ = host_.reader_stages;
    if (reader_stages_ == 0)
        reader_stages_ = default_stages(families_of(host_, functions_)[host_.queue_family].queueFlags);
    families_ = {host_.queue_family};
    for (const std::uint32_t family : host_.reader_queue_families)
        if (std::find(families_.begin(), families_.end(), family) == families_.end())
            families_.push_back(family);
}

// A name that cannot be kept is no loss.
void Device::set_name(VkObjectType type, std::uint64_t object, std::string_view text) const {
    const std::string name = detail::message("windrow ", text);
    const VkDebugUtilsObjectNameInfoEXT info{.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT,
                                             .pNext = nullptr,
                                             .objectType = type,
                                             .objectHandle = object,
                                             .pObjectName = name.c_str()};
    (void)functions_.vkSetDebugUtilsObjectNameEXT(host_.device, &info);
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
