// The command as a shell sees it: its arguments, results on `out`, faults and progress on `err`, an exit code at the end.
#pragma once

#include <cstdio>
#include <functional>
#include <ostream>
#include <string>
#include <string_view>
#include <variant>

namespace windrow::cli {

enum ExitCode : int {
    k_exit_well = 0,
    k_exit_out_of_bounds = 1, ///< the run worked, its result did not: a figure that is not finite, an error above its bound
    k_exit_wrong_use = 2,     ///< wrong flags, bad input, a folder that cannot be written, a part that was not built in
    k_exit_machine = 3,       ///< the machine lacks something: disk space, memory
    k_exit_signal = 128,      ///< plus the number of the signal that stopped the run, as shells count
};

struct Console {
    std::ostream& out;
    std::ostream& err;
    std::FILE* progress; ///< null: no progress

    /// One fault a line of `sentences`, each begun with the command's name, so that a log of many commands tells whose it is.
    void complain(std::string_view sentences) const;
    void warn(std::string_view sentence) const;
};

/// What ends a command early: a sentence, and whether the machine is to blame, which chooses the exit code.
struct Fault {
    std::string sentence; ///< empty: no fault
    bool machine = false; ///< it lacks something: a full disk, no driver; else what was asked for is wrong

    [[nodiscard]] explicit operator bool() const { return !sentence.empty(); }
};

/// Prints the fault; its exit code.
[[nodiscard]] int complain_of(const Fault& fault, const Console& console);

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

/// A command whose flags were read and checked; running it returns the exit code. Or an exit code at once: help, wrong use.
using ReadCommand = std::variant<int, std::function<int()>>;

/// Reads the arguments (the program's name first) and runs nothing. `console` must outlive the command.
[[nodiscard]] ReadCommand read_command_line(int count, const char* const* arguments, const Console& console);

/// Runs `windrow` with these arguments (the program's name first) and returns its exit code.
[[nodiscard]] int run_command_line(int count, const char* const* arguments, const Console& console);

} // namespace windrow::cli
