// Time of a stage of the step.
#pragma once

#include "fluid/core/zone.h"

#include <chrono>

namespace windrow::cpu {

/// Adds the time of a scope to a stage's figure [ms]; a zone of that name in a host's profiler.
class Stopwatch {
  public:
    Stopwatch(const char* name, double& milliseconds)
        : zone_(name), milliseconds_(milliseconds), start_(std::chrono::steady_clock::now()) {}
    ~Stopwatch() {
        milliseconds_ += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
    }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

  private:
    detail::Zone zone_;
    double& milliseconds_;
    std::chrono::steady_clock::time_point start_;
};

/// The same, less what another stage takes within the scope.
class OuterStopwatch {
  public:
    OuterStopwatch(const char* name, double& milliseconds, const double& inner)
        : milliseconds_(milliseconds), inner_(inner), inner_before_(inner), watch_(name, milliseconds) {}
    ~OuterStopwatch() { milliseconds_ -= inner_ - inner_before_; }
    OuterStopwatch(const OuterStopwatch&) = delete;
    OuterStopwatch& operator=(const OuterStopwatch&) = delete;

  private:
    double& milliseconds_;
    const double& inner_;
    double inner_before_;
    Stopwatch watch_;
};

} // namespace windrow::cpu
