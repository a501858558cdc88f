// The wind on a device as a contestant: keeps its flow alive and gathers what its recordings tell.
#pragma once

#include "cases/jets.h"
#include "cli/bench/vulkan/device_bench.h"
#include "fluid/vulkan/wind.h"

#include <functional>
#include <glm/vec4.hpp>
#include <map>
#include <span>
#include <string>

namespace windrow::cli {

/// What a turn records: two steps, of which the second is timed, and its read-back apart.
struct RecordingPlan {
    std::span<const glm::vec4> flow{};          ///< set at the start and after every `steps_of_flow`; empty: never
    int steps_of_flow = cases::k_steps_of_flow; ///< an even number
    double dt = cases::k_bench_dt;              ///< [s]
    std::function<void(vulkan::Wind&, double time)> before_step{}; ///< at the time [s] that the step ends with
};

class WindRecordings {
  public:
    /// The flow outlives it. The wind has two frames in flight: a turn records both.
    WindRecordings(vulkan::Wind wind, RecordingPlan plan);

    /// Steps this object, which then stays where it is. Interval 0 is the step, interval 1 its read-back.
    [[nodiscard]] DeviceContestant contestant();
    [[nodiscard]] DeviceStepResult result(const char* name) const;
    /// Of a wind with Settings::timestamps: its passes, in the order of a step.
    void add_passes(DeviceGridResult& result) const;
    /// Reads the last step back and compares it with the CPU's, stepped as often from the same flow.
    [[nodiscard]] Result<void> compare(vulkan::OwnDevice& own, windrow::Wind& cpu, DeviceGridResult& result);

    [[nodiscard]] int max_substeps() const { return max_substeps_; }
    [[nodiscard]] bool slept() const { return slept_; }
    [[nodiscard]] vulkan::Wind& wind() { return wind_; }

  private:
    void record(VkCommandBuffer commands, int slot);
    void note();

    vulkan::Wind wind_;
    RecordingPlan plan_;
    int age_; ///< steps since the flow was set
    std::uint64_t all_steps_ = 0;
    Result<void> recorded_; ///< first reason why a step was not recorded
    int dispatches_ = 0, barriers_ = 0, max_substeps_ = 0;
    bool slept_ = false;
    struct Samples {
        std::vector<float> us{};
        int dispatches = 0;
    };
    std::map<std::string, Samples> passes_;
    std::vector<float> timed_, between_, read_back_;
};

} // namespace windrow::cli
