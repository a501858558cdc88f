#include "cli/console.h"

#include <array>
#include <csignal>

namespace windrow::cli {
namespace {

// Ctrl-C, a polite end, a terminal that closes.
constexpr std::array k_signals = {SIGINT, SIGTERM, SIGHUP};

volatile std::sig_atomic_t g_signal = 0;

extern "C" void note_signal(int number) {
    g_signal = number;
    // Whoever asks twice does not want to wait.
    std::signal(number, SIG_DFL);
}

} // namespace

void Console::complain(std::string_view sentences) const {
    out.flush();
    while (!sentences.empty()) {
        const std::size_t end = sentences.find('\n');
        err << "windrow: " << sentences.substr(0, end) << '\n';
        sentences.remove_prefix(end == sentences.npos ? sentences.size() : end + 1);
    }
    err.flush();
}

void Console::warn(std::string_view sentence) const {
    out.flush();
    err << "windrow: warning: " << sentence << '\n';
    err.flush();
}

int complain_of(const Fault& fault, const Console& console) {
    console.complain(fault.sentence);
    return fault.machine ? k_exit_machine : k_exit_wrong_use;
}

InterruptGuard::InterruptGuard() {
    g_signal = 0;
    for (const int number : k_signals)
        // A caller that started us with the signal ignored (nohup, a background job) wants it so.
        if (std::signal(number, &note_signal) == SIG_IGN)
            std::signal(number, SIG_IGN);
}

InterruptGuard::~InterruptGuard() {
    for (const int number : k_signals)
        if (std::signal(number, SIG_DFL) == SIG_IGN)
            std::signal(number, SIG_IGN);
}

int InterruptGuard::signal() {
    return g_signal;
}

} // namespace windrow::cli
