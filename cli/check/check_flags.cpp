#include "cli/check/check_flags.h"

#include "cli/flags.h"

#include <CLI/CLI.hpp>

namespace windrow::cli {

void add_check(CLI::App& app, CheckFlags& flags) {
    CLI::App* const check = app.add_subcommand(
        "check",
        "Hold a Vulkan device against the CPU, under validation where it is installed, and time it; exit 1 where it fails");
    add_device(*check, flags.device);
    check->add_option("--seconds", flags.seconds, "Time a grid of the benchmark, default 5; on a GPU at least 1000 samples")
        ->type_name("S");
    check->add_flag("--gpu-validation", flags.gpu_validation, "The stories once more, under GPU-assisted validation");
    check->add_flag("--full", flags.full, "All steps of all stories on a software device too: many minutes");
    check->add_option("--json", flags.json, "File for all figures; written whole or not at all")->type_name("FILE");
}

std::optional<CheckRequest> read_check(const CheckFlags& flags, const CLI::App& check, const Console& console) {
    if (WINDROW_WITH_VULKAN == 0) {
        console.complain("check runs on Vulkan, which is not built in: build with WINDROW_VULKAN=ON.");
        return std::nullopt;
    }
    CheckRequest request{.gpu_validation = flags.gpu_validation, .full = flags.full, .json = {}};
    const auto device = read_device(flags.device, check, console);
    if (!device)
        return std::nullopt;
    request.device = *device;
    if (check.count("--seconds") > 0) {
        const auto seconds = read_seconds(flags.seconds, console);
        if (!seconds)
            return std::nullopt;
        request.seconds = *seconds;
    }
    if (check.count("--json") > 0) {
        if (flags.json.empty()) {
            console.complain("--json is empty: name a file.");
            return std::nullopt;
        }
        request.json = flags.json;
    }
    return request;
}

} // namespace windrow::cli
