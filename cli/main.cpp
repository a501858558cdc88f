#include "cli/console.h"

#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <string_view>
#include <unistd.h>

namespace {

#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
// A library that OpenVDB brings starts threads while it is loaded, and ends the process where the system gives none. --version is
// answered before any library is initialised. What cannot be written is left to main, which reports it.
void answer_early(int count, char** arguments, char**) {
    if (count != 2 || std::string_view(arguments[1]) != "--version")
        return;
    constexpr std::string_view k_line = WINDROW_VERSION_LINE "\n";
    std::signal(SIGPIPE, SIG_IGN);
    if (::write(STDOUT_FILENO, k_line.data(), k_line.size()) == static_cast<ssize_t>(k_line.size()))
        ::_exit(windrow::cli::k_exit_well);
}
[[gnu::section(".preinit_array"), gnu::used]] void (*before_libraries)(int, char**, char**) = &answer_early;
#endif

int run(int count, char** arguments, const windrow::cli::Console& console) {
    using namespace windrow::cli;
    try {
        const int code = run_command_line(count, arguments, console);
        console.out.flush();
        if (console.out.good() || code != k_exit_well)
            return code;
        console.complain("the output could not be written: is the disk full, or the pipe closed?");
        return k_exit_machine;
    } catch (const std::bad_alloc&) {
        console.complain("the memory ran out: give fewer air.cells, or close other programs.");
    } catch (const std::exception& fault) {
        console.complain(fault.what());
    }
    return k_exit_machine;
}

} // namespace

int main(int count, char** arguments) {
    // A closed pipe and a file size limit shall come back as errors of the write that met them, not end the process in the midst
    // of a file.
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    return run(count, arguments, {.out = std::cout, .err = std::cerr, .progress = stderr});
}
