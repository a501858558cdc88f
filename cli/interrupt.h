// Ctrl-C asks a run to stop after the frame it is at; a second one stops it at once.
#pragma once

namespace windrow::cli {

/// While it lives, SIGINT, SIGTERM and SIGHUP are noted instead of killing. One at a time.
class InterruptGuard {
  public:
    InterruptGuard();
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;

    /// Number of the signal that came, 0 without one.
    [[nodiscard]] static int signal();
};

} // namespace windrow::cli
