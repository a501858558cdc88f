// What runs the air of a command: the CPU, or a Vulkan device that is opened once and shared by all its winds.
#pragma once

#include "cli/backend/backend_request.h"
#include "cli/fault.h"

#include <memory>
#include <string>

namespace windrow::vulkan {
class OwnDevice;
}

namespace windrow::cli {

class Backend {
  public:
    /// Opens the device that is asked for; until then, and if none is, it is the CPU.
    [[nodiscard]] Fault open(const BackendRequest& request);

    [[nodiscard]] bool is_cpu() const { return device_ == nullptr; }
    [[nodiscard]] BackendKind kind() const { return is_cpu() ? BackendKind::cpu : BackendKind::vulkan; }
    /// Null: the CPU.
    [[nodiscard]] vulkan::OwnDevice* device() const { return device_.get(); }
    /// The device's name, driver and version; empty: the CPU.
    [[nodiscard]] const std::string& device_words() const { return words_; }

    /// The first thing that went wrong on the device, in a sentence; empty: nothing. A wind of a device that is lost steps no
    /// more.
    [[nodiscard]] const std::string& fault() const { return *fault_; }
    void note_fault(const std::string& sentence) const {
        if (fault_->empty())
            *fault_ = sentence;
    }

  private:
    std::shared_ptr<vulkan::OwnDevice> device_{};
    std::string words_{};
    std::shared_ptr<std::string> fault_ = std::make_shared<std::string>(); ///< all copies know it
};

} // namespace windrow::cli
