#include "cli/interrupt.h"

#include <csignal>
#include <initializer_list>

namespace windrow::cli {
namespace {

volatile std::sig_atomic_t g_signal = 0;

extern "C" void note_signal(int number) {
    g_signal = number;
    // Whoever asks twice does not want to wait.
    std::signal(number, SIG_DFL);
}

} // namespace

InterruptGuard::InterruptGuard() {
    g_signal = 0;
    for (const int number : {SIGINT, SIGTERM})
        // A caller that started us with the signal ignored (nohup, a background job) wants it so.
        if (std::signal(number, &note_signal) == SIG_IGN)
            std::signal(number, SIG_IGN);
}

InterruptGuard::~InterruptGuard() {
    for (const int number : {SIGINT, SIGTERM})
        if (std::signal(number, SIG_DFL) == SIG_IGN)
            std::signal(number, SIG_IGN);
}

int InterruptGuard::signal() {
    return g_signal;
}

} // namespace windrow::cli
