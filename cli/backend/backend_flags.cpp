#include "cli/backend/backend_flags.h"

#include "fluid/message.h"
#include "scene/number_text.h"

#include <CLI/CLI.hpp>

namespace windrow::cli {
namespace {

using detail::message;

constexpr long long k_most_devices = 64;

} // namespace

void add_backend(CLI::App& command, BackendFlags& flags) {
    command.add_option("--backend", flags.backend, "What runs the air: cpu, the default, or vulkan")->type_name("B");
    add_device(command, flags);
}

void add_device(CLI::App& command, BackendFlags& flags) {
    command.add_option("--device", flags.device, "Vulkan device by its number in windrow info; default the first GPU")
        ->type_name("N");
}

std::optional<int> read_device(const BackendFlags& flags, const CLI::App& command, const Console& console) {
    if (command.count("--device") == 0)
        return -1;
    const auto place = scene::parse_whole_number(flags.device);
    if (place && *place >= 0 && *place < k_most_devices)
        return static_cast<int>(*place);
    console.complain(message("--device is ", flags.device.empty() ? "empty" : flags.device,
                             ": give a device's number in windrow info, from 0."));
    return std::nullopt;
}

std::optional<BackendRequest> read_backend(const BackendFlags& flags, const CLI::App& command, const Console& console) {
    BackendRequest backend;
    if (command.count("--backend") > 0) {
        if (flags.backend == name_of(BackendKind::vulkan)) {
            backend.kind = BackendKind::vulkan;
        } else if (flags.backend != name_of(BackendKind::cpu)) {
            console.complain(message("--backend is ", flags.backend.empty() ? "empty" : flags.backend, ": give cpu or vulkan."));
            return std::nullopt;
        }
    }
    if (backend.kind == BackendKind::vulkan && WINDROW_WITH_VULKAN == 0) {
        console.complain("--backend is vulkan, which is not built in: build with WINDROW_VULKAN=ON, or give cpu.");
        return std::nullopt;
    }
    if (backend.kind == BackendKind::cpu && command.count("--device") > 0) {
        console.complain("--device is given, but the air runs on the CPU: add --backend vulkan, or drop it.");
        return std::nullopt;
    }
    const auto device = read_device(flags, command, console);
    if (!device)
        return std::nullopt;
    backend.device = *device;
    return backend;
}

} // namespace windrow::cli
