// The flags of `windrow check`.
#pragma once

#include "cli/backend/backend_flags.h"
#include "cli/check/check_request.h"
#include "cli/console.h"

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace windrow::cli {

struct CheckFlags {
    BackendFlags device;
    std::string seconds, json;
    bool gpu_validation = false, full = false;
};

void add_check(CLI::App& app, CheckFlags& flags);
/// Nothing after a complaint.
[[nodiscard]] std::optional<CheckRequest> read_check(const CheckFlags& flags, const CLI::App& check, const Console& console);

} // namespace windrow::cli
