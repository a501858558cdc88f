// What the driver's compiler makes of each pipeline of the library, where the device has VK_KHR_pipeline_executable_properties: its
// statistics by their own names, such as registers, spills, instructions, shared memory. Nothing runs on the device, so that a driver
// without one does too (Mesa: RADV_FORCE_FAMILY).
#include "cli/bench/bench_command.h"
#include "cli/device_report/report_section.h"
#include "cli/table.h"
#include "coupling/vulkan/ground_memory.h"
#include "fluid/core/message.h"
#include "fluid/vulkan/wind.h"
#include "gpu/device.h"
#include "gpu/pipeline.h"
#include "shader_words/place_nothing.h"
#include "shader_words/sample_equal_rows.h"
#include "shader_words/sample_wind.h"

#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <utility>

namespace windrow::cli {
namespace {

using detail::message;

// --- A host whose pipelines are compiled by the driver and whose memory is none of the device's ---------------------------------
// For a driver without a device, which has no memory types.

// Calls of Vulkan have no room for an object of ours.
PFN_vkGetInstanceProcAddr g_of_instance = nullptr;
PFN_vkGetDeviceProcAddr g_of_device = nullptr;

template <class Handle>
Handle no_object() {
    return reinterpret_cast<Handle>(std::uintptr_t{1});
}

void VKAPI_CALL memory_properties(VkPhysicalDevice, VkPhysicalDeviceMemoryProperties* properties) {
    *properties = {};
    properties->memoryHeapCount = properties->memoryTypeCount = 1;
    properties->memoryHeaps[0] = {.size = VkDeviceSize{1} << 40, .flags = VK_MEMORY_HEAP_DEVICE_LOCAL_BIT};
    properties->memoryTypes[0] = {.propertyFlags = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT | VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT |
                                                   VK_MEMORY_PROPERTY_HOST_COHERENT_BIT | VK_MEMORY_PROPERTY_HOST_CACHED_BIT,
                                  .heapIndex = 0};
}

// Pages that nobody writes cost nothing.
VkResult VKAPI_CALL allocate(VkDevice, const VkMemoryAllocateInfo* info, const VkAllocationCallbacks*, VkDeviceMemory* memory) {
    void* const block = std::malloc(info->allocationSize);
    *memory = reinterpret_cast<VkDeviceMemory>(block);
    return block == nullptr ? VK_ERROR_OUT_OF_HOST_MEMORY : VK_SUCCESS;
}
void VKAPI_CALL release(VkDevice, VkDeviceMemory memory, const VkAllocationCallbacks*) {
    std::free(reinterpret_cast<void*>(memory));
}
VkResult VKAPI_CALL map(VkDevice, VkDeviceMemory memory, VkDeviceSize, VkDeviceSize, VkMemoryMapFlags, void** address) {
    *address = reinterpret_cast<void*>(memory);
    return VK_SUCCESS;
}
VkResult VKAPI_CALL make_visible(VkDevice, std::uint32_t, const VkMappedMemoryRange*) {
    return VK_SUCCESS;
}
void VKAPI_CALL buffer_requirements(VkDevice device, VkBuffer buffer, VkMemoryRequirements* requirements) {
    reinterpret_cast<PFN_vkGetBufferMemoryRequirements>(g_of_device(device, "vkGetBufferMemoryRequirements"))(device, buffer,
                                                                                                              requirements);
    requirements->memoryTypeBits = 1;
}
VkResult VKAPI_CALL create_image(VkDevice, const VkImageCreateInfo*, const VkAllocationCallbacks*, VkImage* image) {
    *image = no_object<VkImage>();
    return VK_SUCCESS;
}
void VKAPI_CALL destroy_image(VkDevice, VkImage, const VkAllocationCallbacks*) {}
void VKAPI_CALL image_requirements(VkDevice, VkImage, VkMemoryRequirements* requirements) {
    *requirements = {.size = 4096, .alignment = 4096, .memoryTypeBits = 1};
}
VkResult VKAPI_CALL bind_buffer(VkDevice, VkBuffer, VkDeviceMemory, VkDeviceSize) {
    return VK_SUCCESS;
}
VkResult VKAPI_CALL bind_image(VkDevice, VkImage, VkDeviceMemory, VkDeviceSize) {
    return VK_SUCCESS;
}
VkResult VKAPI_CALL create_view(VkDevice, const VkImageViewCreateInfo*, const VkAllocationCallbacks*, VkImageView* view) {
    *view = no_object<VkImageView>();
    return VK_SUCCESS;
}
void VKAPI_CALL destroy_view(VkDevice, VkImageView, const VkAllocationCallbacks*) {}
VkResult VKAPI_CALL create_pool(VkDevice, const VkDescriptorPoolCreateInfo*, const VkAllocationCallbacks*,
                                VkDescriptorPool* pool) {
    *pool = no_object<VkDescriptorPool>();
    return VK_SUCCESS;
}
void VKAPI_CALL destroy_pool(VkDevice, VkDescriptorPool, const VkAllocationCallbacks*) {}
VkResult VKAPI_CALL allocate_sets(VkDevice, const VkDescriptorSetAllocateInfo* info, VkDescriptorSet* sets) {
    for (std::uint32_t n = 0; n < info->descriptorSetCount; ++n)
        sets[n] = no_object<VkDescriptorSet>();
    return VK_SUCCESS;
}
void VKAPI_CALL update_sets(VkDevice, std::uint32_t, const VkWriteDescriptorSet*, std::uint32_t, const VkCopyDescriptorSet*) {}

PFN_vkVoidFunction VKAPI_CALL of_device(VkDevice device, const char* name) {
    struct Replaced {
        std::string_view name;
        PFN_vkVoidFunction call;
    };
    const auto replaced = [](std::string_view what, auto call) {
        return Replaced{what, reinterpret_cast<PFN_vkVoidFunction>(call)};
    };
    static const Replaced all[] = {replaced("vkAllocateMemory", &allocate),
                                   replaced("vkFreeMemory", &release),
                                   replaced("vkMapMemory", &map),
                                   replaced("vkFlushMappedMemoryRanges", &make_visible),
                                   replaced("vkInvalidateMappedMemoryRanges", &make_visible),
                                   replaced("vkGetBufferMemoryRequirements", &buffer_requirements),
                                   replaced("vkGetImageMemoryRequirements", &image_requirements),
                                   replaced("vkBindBufferMemory", &bind_buffer),
                                   replaced("vkBindImageMemory", &bind_image),
                                   replaced("vkCreateImage", &create_image),
                                   replaced("vkDestroyImage", &destroy_image),
                                   replaced("vkCreateImageView", &create_view),
                                   replaced("vkDestroyImageView", &destroy_view),
                                   replaced("vkCreateDescriptorPool", &create_pool),
                                   replaced("vkDestroyDescriptorPool", &destroy_pool),
                                   replaced("vkAllocateDescriptorSets", &allocate_sets),
                                   replaced("vkUpdateDescriptorSets", &update_sets)};
    for (const Replaced& one : all)
        if (one.name == name)
            return one.call;
    return g_of_device(device, name);
}

PFN_vkVoidFunction VKAPI_CALL of_instance(VkInstance instance, const char* name) {
    if (std::string_view(name) == "vkGetDeviceProcAddr")
        return reinterpret_cast<PFN_vkVoidFunction>(&of_device);
    if (std::string_view(name) == "vkGetPhysicalDeviceMemoryProperties")
        return reinterpret_cast<PFN_vkVoidFunction>(&memory_properties);
    return g_of_instance(instance, name);
}

// `host` with calls that make no memory, images or descriptor sets. Objects made with it can be created and destroyed; what they record
// must not be submitted. One host at a time.
vulkan::Host compile_only(const vulkan::Host& host) {
    g_of_instance = host.get_instance_proc_addr;
    g_of_device = reinterpret_cast<PFN_vkGetDeviceProcAddr>(host.get_instance_proc_addr(host.instance, "vkGetDeviceProcAddr"));
    vulkan::Host made = host;
    made.get_instance_proc_addr = &of_instance;
    return made;
}

// --- Statistics -----------------------------------------------------------------------------------------------------------------

class Statistics {
  public:
    explicit Statistics(const vulkan::Host& host) : device_(host.device) {
        const auto load = [&](const char* name) { return host.get_instance_proc_addr(host.instance, name); };
        properties_ = reinterpret_cast<PFN_vkGetPipelineExecutablePropertiesKHR>(load("vkGetPipelineExecutablePropertiesKHR"));
        statistics_ = reinterpret_cast<PFN_vkGetPipelineExecutableStatisticsKHR>(load("vkGetPipelineExecutableStatisticsKHR"));
    }
    [[nodiscard]] bool complete() const { return properties_ != nullptr && statistics_ != nullptr; }

    /// A row for each executable of the pipeline: a driver may make several of one.
    void add(const std::string& grid, const char* name, VkPipeline pipeline, ReportJson& rows) const {
        VkPipelineInfoKHR info{};
        info.sType = VK_STRUCTURE_TYPE_PIPELINE_INFO_KHR;
        info.pipeline = pipeline;
        std::uint32_t count = 0;
        if (properties_(device_, &info, &count, nullptr) != VK_SUCCESS)
            return;
        for (std::uint32_t n = 0; n < count; ++n) {
            ReportJson row = {{"pipeline", name}, {"grid", grid}};
            VkPipelineExecutableInfoKHR executable{};
            executable.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INFO_KHR;
            executable.pipeline = pipeline;
            executable.executableIndex = n;
            for (const VkPipelineExecutableStatisticKHR& one : statistics_of(executable))
                if (std::string_view(one.name).find("ash") == std::string_view::npos) // hashes measure nothing
                    row[one.name] = value_of(one);
            rows.push_back(std::move(row));
        }
    }

  private:
    [[nodiscard]] std::vector<VkPipelineExecutableStatisticKHR>
    statistics_of(const VkPipelineExecutableInfoKHR& executable) const {
        std::uint32_t count = 0;
        if (statistics_(device_, &executable, &count, nullptr) != VK_SUCCESS)
            return {};
        VkPipelineExecutableStatisticKHR empty{};
        empty.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_STATISTIC_KHR;
        std::vector<VkPipelineExecutableStatisticKHR> all(count, empty);
        if (statistics_(device_, &executable, &count, all.data()) != VK_SUCCESS)
            return {};
        return all;
    }
    static ReportJson value_of(const VkPipelineExecutableStatisticKHR& one) {
        switch (one.format) {
        case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_BOOL32_KHR:
            return one.value.b32 != VK_FALSE;
        case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_INT64_KHR:
            return one.value.i64;
        case VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_UINT64_KHR:
            return one.value.u64;
        default:
            return four_digits(one.value.f64);
        }
    }

    VkDevice device_;
    PFN_vkGetPipelineExecutablePropertiesKHR properties_ = nullptr;
    PFN_vkGetPipelineExecutableStatisticsKHR statistics_ = nullptr;
};

/// A shader that samples the wind, and the same without the sample: their difference is what one costs.
Result<void> compile_samples(const vulkan::Host& host) {
    auto device = vulkan::Device::create(host);
    if (!device)
        return device.failure();
    std::vector<VkDescriptorType> bindings(2, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER); // places and winds
    for (const auto& binding : vulkan::set_bindings(vulkan::TextureSet::vectors, VK_SHADER_STAGE_COMPUTE_BIT))
        bindings.push_back(binding.descriptorType);
    for (const auto& [name, code] :
         {std::pair<const char*, std::span<const std::uint32_t>>("sample", vulkan::shader_words::sample_wind),
          {"sample, equal rows", vulkan::shader_words::sample_equal_rows},
          {"the same shader without it", vulkan::shader_words::place_nothing}})
        if (auto made = vulkan::Pipeline::create(**device, {.code = code, .bindings = bindings, .constants = {}, .name = name});
            !made)
            return made.failure();
    return {};
}

} // namespace

Result<void> report_pipelines(SectionRun& run) {
    VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR feature{};
    feature.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PIPELINE_EXECUTABLE_PROPERTIES_FEATURES_KHR;
    feature.pipelineExecutableInfo = VK_TRUE;
    auto own = vulkan::OwnDevice::create(
        {.device = run.device, .extensions = {VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME}, .next = &feature});
    if (!own) {
        run.leave_out("statistics of pipelines: " + own.error());
        return {};
    }
    vulkan::Host host = compile_only((*own)->host());
    const Statistics statistics(host);
    if (!statistics.complete()) {
        run.leave_out("statistics of pipelines: the driver lacks the functions of VK_KHR_pipeline_executable_properties.");
        return {};
    }
    std::string grid;
    ReportJson& rows = run.json["pipelines"];
    host.pipelines.flags = VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR;
    host.pipelines.created = [&](const char* name, VkPipeline pipeline) { statistics.add(grid, name, pipeline, rows); };
    for (const glm::ivec3 cells : k_bench_grids) {
        grid = grid_name(cells);
        if (auto wind = vulkan::Wind::create(host, {.cells = cells}); !wind)
            run.leave_out(message("pipelines at ", grid, ": ", wind.error()));
        if (run.clock.stopped())
            return {};
    }
    const glm::ivec3 smallest = k_bench_grids[0];
    Config full;
    full.cells = smallest;
    full.roughness.emplace();
    for (const bool own_rows : {false, true}) {
        if (own_rows)
            full.rows.emplace();
        grid = grid_name(smallest) + " with obstacles on rough ground" + (own_rows ? ", in rows" : "");
        if (auto wind = vulkan::Wind::create(host, full, {.obstacles = true}); !wind)
            run.leave_out(message("pipelines at ", grid, ": ", wind.error()));
    }
    grid = "any";
    if (auto ground = vulkan::GroundMemory::create(host, {}); !ground)
        run.leave_out("pipelines of the ground memory: " + ground.error());
    if (auto samples = compile_samples(host); !samples)
        run.leave_out("pipelines that sample: " + samples.error());
    return {};
}

} // namespace windrow::cli
