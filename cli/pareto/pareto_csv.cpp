#include "cli/pareto/pareto_csv.h"

#include "cli/table.h"
#include "fluid/message.h"

namespace windrow::cli {
std::string pareto_csv(const ParetoResult& result) {
    std::string text =
        "backend,scheme,advection,pressure,grid,cfl,case,error,order,step_ms,cost_vs_stam40,threads,ms_per_second,machine\n";
    const auto rounded = [](double value) { return to_digits(value, 6); }; // they hold more digits than they mean
    const std::string machine = "\"" + result.device + ", " + result.simd + "\"";
    for (const FlowResult& flow : result.flows)
        for (const ParetoRow& row : flow.rows)
            text += detail::message(result.backend == BackendKind::cpu ? "cpu," : "vulkan,", name_of(row.method.scheme), ",",
                                    name_of(row.method.interpolation), ",", name_of(row.method.pressure), ",",
                                    grid_name(row.cells), ",", rounded(row.cfl), ",", flow.name, ",", rounded(row.error), ",",
                                    row.order ? rounded(*row.order) : "", ",", rounded(row.step_ms), ",", rounded(row.vs_stam40),
                                    ",", row.threads, ",", rounded(row.ms_per_second), ",", machine, "\n");
    return text;
}

} // namespace windrow::cli
