#include "cli/verify/verify_json.h"

#include "cli/table.h"

#include <nlohmann/json.hpp>

namespace windrow::cli {

std::string verify_json(const VerifyRequest& request, const std::string& device, std::span<const VerifiedCase> verified) {
    using Json = nlohmann::ordered_json;
    Json entries = Json::array();
    for (std::size_t n = 0; n < verified.size(); ++n)
        for (const VerifiedRow& one : verified[n].rows) {
            const double least_order = request.cases[n].least_order;
            entries.push_back({{"name", verified[n].name},
                               {"label", one.row.label.empty() ? Json() : Json(one.row.label)},
                               {"backend", request.backend.kind == BackendKind::cpu ? "cpu" : "vulkan"},
                               {"device", device.empty() ? Json() : Json(device)},
                               {"grid", grid_name(one.row.cells)},
                               {"cfl", one.row.cfl},
                               {"error", one.row.error}, // what is not finite becomes null
                               {"order", one.order ? Json(*one.order) : Json()},
                               {"bound", one.row.bound},
                               {"least_order", one.order && least_order > 0.0 ? Json(least_order) : Json()},
                               {"pass", one.pass},
                               {"verdict", one.verdict()}});
        }
    return Json{{"cases", entries}}.dump(2) + "\n";
}

} // namespace windrow::cli
