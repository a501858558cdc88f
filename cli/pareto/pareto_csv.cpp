#include "cli/pareto/pareto_csv.h"

#include "fluid/message.h"

#include <charconv>

namespace windrow::cli {
namespace {

// Figures in double hold more digits than they mean.
std::string rounded(double value) {
    char text[64];
    return std::string(text, std::to_chars(text, text + sizeof text, value, std::chars_format::general, 6).ptr);
}

} // namespace

std::string pareto_csv(const ParetoResult& result) {
    std::string text = "backend,scheme,advection,pressure,grid,cfl,case,error,order,step_ms,cost_vs_stam40,threads\n";
    for (const FlowResult& flow : result.flows)
        for (const ParetoRow& row : flow.rows)
            text += detail::message(result.backend == BackendKind::cpu ? "cpu," : "vulkan,", name_of(row.method.scheme), ",",
                                    name_of(row.method.interpolation), ",", name_of(row.method.pressure), ",",
                                    grid_name(row.cells), ",", rounded(row.cfl), ",", flow.name, ",", rounded(row.error), ",",
                                    row.order ? rounded(*row.order) : "", ",", rounded(row.step_ms), ",", rounded(row.vs_stam40),
                                    ",", row.threads, "\n");
    return text;
}

} // namespace windrow::cli
