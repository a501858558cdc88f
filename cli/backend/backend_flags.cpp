#include "cli/backend/backend_flags.h"

#include "cli/number_text.h"
#include "fluid/message.h"

#include <CLI/CLI.hpp>

namespace windrow::cli {

using detail::message;

void add_backend(CLI::App& command, BackendFlags& flags) {
    command.add_option("--backend", flags.backend, "What runs the air: cpu, the default, or vulkan")->type_name("B");
    command
        .add_option("--device", flags.device,
                    "Vulkan device, its number in windrow info; default the first that is no software, else the first")
        ->type_name("N");
}

std::optional<BackendRequest> read_backend(const BackendFlags& flags, const CLI::App& command, const Console& console) {
    BackendRequest request;
    if (command.count("--backend") > 0) {
        if (flags.backend == "vulkan")
            request.kind = BackendKind::vulkan;
        else if (flags.backend != "cpu") {
            console.complain(message("--backend is ", flags.backend.empty() ? "empty" : flags.backend, ": give cpu or vulkan."));
            return std::nullopt;
        }
    }
    if (command.count("--device") == 0)
        return request;
    constexpr std::int64_t k_most_devices = 64;
    const auto device = parse_whole_number(flags.device);
    if (!device || *device < 0 || *device >= k_most_devices) {
        console.complain(message("--device is ", flags.device.empty() ? "empty" : flags.device,
                                 ": give a number that windrow info tells, from 0."));
        return std::nullopt;
    }
    if (request.kind == BackendKind::cpu) {
        console.complain(message("--device is ", *device, " for a run on the CPU: add --backend vulkan, or drop it."));
        return std::nullopt;
    }
    request.device = static_cast<int>(*device);
    return request;
}

} // namespace windrow::cli
