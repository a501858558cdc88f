// The flags --backend and --device: one text for all commands that offer the choice.
#pragma once

#include "cli/backend/backend_request.h"
#include "cli/console.h"

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace windrow::cli {

struct BackendFlags {
    std::string backend, device;
};

void add_backend(CLI::App& command, BackendFlags& flags);
/// --device alone, for commands that run on Vulkan whatever is asked.
void add_device(CLI::App& command, BackendFlags& flags);

/// Nothing after a complaint: an unknown word, a backend that is not built in, a device without Vulkan.
[[nodiscard]] std::optional<BackendRequest> read_backend(const BackendFlags& flags, const CLI::App& command,
                                                         const Console& console);
/// The same for commands with --device alone.
[[nodiscard]] std::optional<int> read_device(const BackendFlags& flags, const CLI::App& command, const Console& console);

} // namespace windrow::cli
