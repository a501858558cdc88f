// The flags of `windrow verify`.
#pragma once

#include "cli/backend/backend_flags.h"
#include "cli/console.h"
#include "cli/verify/verify_request.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace windrow::cli {

struct VerifyFlags {
    std::vector<std::string> cases;
    BackendFlags backend;
    std::string threads, simd, json, plots;
    bool list = false;
};

void add_verify(CLI::App& app, VerifyFlags& flags);
/// Nothing after a complaint. `known` are the cases to choose from; where none is named, all that the backend can run.
[[nodiscard]] std::optional<VerifyRequest> read_verify(const VerifyFlags& flags, const CLI::App& verify,
                                                       std::span<const VerifyCase> known, const Console& console);

} // namespace windrow::cli
