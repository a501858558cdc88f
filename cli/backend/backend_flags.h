// The flags --backend and --device, which several commands have.
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
/// Nothing where a flag is wrong, which has been told.
[[nodiscard]] std::optional<BackendRequest> read_backend(const BackendFlags& flags, const CLI::App& command,
                                                         const Console& console);

} // namespace windrow::cli
