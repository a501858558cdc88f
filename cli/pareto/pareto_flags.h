// The flags of `windrow pareto`.
#pragma once

#include "cli/backend/backend_flags.h"
#include "cli/console.h"
#include "cli/pareto/pareto_request.h"

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace windrow::cli {

struct ParetoFlags {
    BackendFlags backend;
    std::string out, threads, simd;
    bool quick = false;
};

void add_pareto(CLI::App& app, ParetoFlags& flags);
/// Nothing after a complaint.
[[nodiscard]] std::optional<ParetoRequest> read_pareto(const ParetoFlags& flags, const CLI::App& pareto, const Console& console);

} // namespace windrow::cli
