// The wind on a device as a contestant: keeps its flow alive and gathers what its recordings tell.
#pragma once

#include "cli/bench/vulkan/device_bench.h"
#include "fluid/vulkan/wind.h"

#include <glm/vec4.hpp>
#include <map>
#include <span>
#include <string>

namespace windrow::cli {

class WindRecordings {
  public:
    /// `flow` outlives it. The wind has two frames in flight: a turn records both.
    WindRecordings(vulkan::Wind wind, std::span<const glm::vec4> flow);

    /// Steps this object, which then stays where it is.
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
    std::span<const glm::vec4> flow_;
    int age_; ///< steps since the flow was set
    std::uint64_t all_steps_ = 0;
    int dispatches_ = 0, barriers_ = 0, max_substeps_ = 0;
    bool slept_ = false;
    struct Samples {
        std::vector<float> us{};
        int dispatches = 0;
    };
    std::map<std::string, Samples> passes_;
    std::vector<float> timed_, between_;
};

} // namespace windrow::cli
