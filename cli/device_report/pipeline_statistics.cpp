// What the driver's compiler makes of each pipeline of the library, where the device has VK_KHR_pipeline_executable_properties: its
// statistics by their own names, such as registers, spills, instructions, shared memory. Nothing runs on the device, so that a driver
// without one does too (Mesa: RADV_FORCE_FAMILY).
#include "cli/bench/bench_command.h"
#include "cli/device_report/compile_only.h"
#include "cli/device_report/report_section.h"
#include "cli/table.h"
#include "coupling/vulkan/ground_memory.h"
#include "fluid/message.h"
#include "fluid/vulkan/wind.h"

#include <string_view>
#include <utility>

namespace windrow::cli {
namespace {

using detail::message;

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
    grid = "any";
    if (auto ground = vulkan::GroundMemory::create(host, {}); !ground)
        run.leave_out("pipelines of the ground memory: " + ground.error());
    return {};
}

} // namespace windrow::cli
