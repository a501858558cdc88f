// The device as its driver describes it: properties, limits, queues, memory, extensions, and its clock rates where the system has
// them in files.
#include "cli/device_report/report_section.h"
#include "cli/info_command.h"
#include "fluid/core/message.h"

#include <algorithm>
#include <fstream>
#include <utility>

namespace windrow::cli {
namespace {

using detail::message;

template <class Function>
Function load(const vulkan::Host& host, const char* name) {
    return reinterpret_cast<Function>(host.get_instance_proc_addr(host.instance, name));
}

const char* name_of(VkPhysicalDeviceType type) {
    constexpr const char* k_names[] = {"other", "integrated GPU", "discrete GPU", "virtual GPU", "CPU"};
    return static_cast<std::size_t>(type) < std::size(k_names) ? k_names[type] : "unknown";
}

// The set bits by name: "graphics, compute".
std::string names_of(std::uint32_t bits, std::initializer_list<std::pair<std::uint32_t, const char*>> names) {
    std::string text;
    for (const auto& [bit, name] : names)
        if ((bits & bit) != 0)
            text += (text.empty() ? "" : ", ") + std::string(name);
    return text;
}

void add_properties(const vulkan::Host& host, ReportJson& json) {
    VkPhysicalDeviceSubgroupProperties subgroup{};
    subgroup.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_PROPERTIES;
    VkPhysicalDeviceDriverProperties driver{};
    driver.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES;
    driver.pNext = &subgroup;
    VkPhysicalDeviceProperties2 all{};
    all.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
    all.pNext = &driver;
    load<PFN_vkGetPhysicalDeviceProperties2>(host, "vkGetPhysicalDeviceProperties2")(host.physical_device, &all);
    const VkPhysicalDeviceProperties& device = all.properties;
    json["type"] = name_of(device.deviceType);
    json["vendor"] = device.vendorID;
    json["device_id"] = device.deviceID;
    json["driver_id"] = static_cast<int>(driver.driverID);
    json["driver_version"] = device.driverVersion;
    json["conformance"] = message(driver.conformanceVersion.major, ".", driver.conformanceVersion.minor, ".",
                                  driver.conformanceVersion.subminor, ".", driver.conformanceVersion.patch);
    json["subgroup_size"] = subgroup.subgroupSize;
    json["subgroup_operations"] = names_of(subgroup.supportedOperations, {{VK_SUBGROUP_FEATURE_BASIC_BIT, "basic"},
                                                                          {VK_SUBGROUP_FEATURE_VOTE_BIT, "vote"},
                                                                          {VK_SUBGROUP_FEATURE_ARITHMETIC_BIT, "arithmetic"},
                                                                          {VK_SUBGROUP_FEATURE_BALLOT_BIT, "ballot"},
                                                                          {VK_SUBGROUP_FEATURE_SHUFFLE_BIT, "shuffle"},
                                                                          {VK_SUBGROUP_FEATURE_QUAD_BIT, "quad"}});
    const VkPhysicalDeviceLimits& limits = device.limits;
    json["limits"] = {{"maxComputeSharedMemorySize", limits.maxComputeSharedMemorySize},
                      {"maxComputeWorkGroupInvocations", limits.maxComputeWorkGroupInvocations},
                      {"maxComputeWorkGroupCount[0]", limits.maxComputeWorkGroupCount[0]},
                      {"maxPerStageDescriptorStorageBuffers", limits.maxPerStageDescriptorStorageBuffers},
                      {"maxPerStageDescriptorStorageImages", limits.maxPerStageDescriptorStorageImages},
                      {"maxStorageBufferRange", limits.maxStorageBufferRange},
                      {"maxPushConstantsSize", limits.maxPushConstantsSize},
                      {"maxImageDimension3D", limits.maxImageDimension3D},
                      {"maxMemoryAllocationCount", limits.maxMemoryAllocationCount},
                      {"nonCoherentAtomSize", limits.nonCoherentAtomSize},
                      {"bufferImageGranularity", limits.bufferImageGranularity},
                      {"timestampPeriod", limits.timestampPeriod}};
}

void add_queues(const vulkan::Host& host, ReportJson& json) {
    const auto query = load<PFN_vkGetPhysicalDeviceQueueFamilyProperties>(host, "vkGetPhysicalDeviceQueueFamilyProperties");
    std::uint32_t count = 0;
    query(host.physical_device, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    query(host.physical_device, &count, families.data());
    for (const VkQueueFamilyProperties& family : families)
        json["queue_families"].push_back({{"can", names_of(family.queueFlags, {{VK_QUEUE_GRAPHICS_BIT, "graphics"},
                                                                               {VK_QUEUE_COMPUTE_BIT, "compute"},
                                                                               {VK_QUEUE_TRANSFER_BIT, "transfer"},
                                                                               {VK_QUEUE_SPARSE_BINDING_BIT, "sparse"}})},
                                          {"queues", family.queueCount},
                                          {"timestamp_bits", family.timestampValidBits}});
}

void add_memory(const vulkan::Host& host, ReportJson& json) {
    VkPhysicalDeviceMemoryProperties memory{};
    load<PFN_vkGetPhysicalDeviceMemoryProperties>(host, "vkGetPhysicalDeviceMemoryProperties")(host.physical_device, &memory);
    for (std::uint32_t n = 0; n < memory.memoryHeapCount; ++n)
        json["memory_heaps"].push_back(
            {{"heap", n},
             {"bytes", memory.memoryHeaps[n].size},
             {"is", names_of(memory.memoryHeaps[n].flags, {{VK_MEMORY_HEAP_DEVICE_LOCAL_BIT, "device local"}})}});
    for (std::uint32_t n = 0; n < memory.memoryTypeCount; ++n)
        json["memory_types"].push_back(
            {{"heap", memory.memoryTypes[n].heapIndex},
             {"is", names_of(memory.memoryTypes[n].propertyFlags, {{VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, "device local"},
                                                                   {VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT, "host visible"},
                                                                   {VK_MEMORY_PROPERTY_HOST_COHERENT_BIT, "coherent"},
                                                                   {VK_MEMORY_PROPERTY_HOST_CACHED_BIT, "cached"}})}});
}

void add_extensions(const vulkan::Host& host, ReportJson& json) {
    const auto query = load<PFN_vkEnumerateDeviceExtensionProperties>(host, "vkEnumerateDeviceExtensionProperties");
    std::uint32_t count = 0;
    std::vector<VkExtensionProperties> extensions;
    if (query(host.physical_device, nullptr, &count, nullptr) == VK_SUCCESS) {
        extensions.resize(count);
        if (query(host.physical_device, nullptr, &count, extensions.data()) != VK_SUCCESS)
            extensions.clear();
    }
    std::string names;
    for (const VkExtensionProperties& extension : extensions)
        names += (names.empty() ? "" : " ") + std::string(extension.extensionName);
    json["extensions"] = names;
}

// The lines of a small file of the system; empty where it cannot be read.
std::string content_of(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::string text;
    for (std::string line; text.size() < 1000 && std::getline(in, line);)
        text += (text.empty() ? "" : "; ") + line;
    return text;
}

// Drivers of AMD and Intel have clock rates in files, a card each, whichever of them is measured.
void add_clocks(ReportJson& json) {
    namespace fs = std::filesystem;
    constexpr const char* k_files[] = {"device/pp_dpm_sclk", "device/pp_dpm_mclk", "gt_max_freq_mhz", "gt_act_freq_mhz"};
    std::error_code fault;
    for (const fs::directory_entry& card : fs::directory_iterator("/sys/class/drm", fault))
        for (const char* const name : k_files)
            if (const std::string text = content_of(card.path() / name); !text.empty())
                json["clocks"].push_back({{"file", (card.path() / name).string()}, {"content", text}});
    for (const fs::directory_entry& gpu : fs::directory_iterator("/proc/driver/nvidia/gpus", fault))
        if (const std::string text = content_of(gpu.path() / "information"); !text.empty())
            json["clocks"].push_back({{"file", (gpu.path() / "information").string()}, {"content", text}});
    if (!json.contains("clocks"))
        json["clocks"] = "not readable";
}

} // namespace

Result<void> report_facts(SectionRun& run) {
    const vulkan::DeviceFacts& facts = run.own.facts();
    ReportJson& json = run.json;
    json = {{"device", facts.name},
            {"driver", facts.driver},
            {"vulkan", facts.api_version},
            {"software", facts.software},
            {"host", device_name()}};
    const vulkan::Host host = run.own.host();
    json["queue_family"] = host.queue_family;
    add_properties(host, json);
    add_queues(host, json);
    add_memory(host, json);
    add_clocks(json);
    json["places_tried"] = places_tried();
    add_extensions(host, json);
    return {};
}

} // namespace windrow::cli
