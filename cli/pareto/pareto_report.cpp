#include "cli/pareto/pareto_report.h"

#include "cli/table.h"
#include "fluid/message.h"
#include "scene/number_text.h"

#include <algorithm>
#include <string>
#include <string_view>

namespace windrow::cli {
namespace {

using detail::message;

std::string line(std::string_view time, std::string_view error, std::string_view grid, std::string_view cfl,
                 std::string_view cost, std::string_view method) {
    return right(time, 14) + right(error, 12) + right(grid, 13) + right(cfl, 6) + right(cost, 9) + "   " + std::string(method) +
           "\n";
}

// "64x32x64, second_order cubic multigrid, CFL 2"
std::string place_of(const ParetoRow& row) {
    return message(name_of(row.method), " on ", grid_name(row.cells), " at CFL ", scene::figure(row.cfl));
}

std::string standing(const std::vector<ParetoRow>& rows, const std::vector<CostError>& points, glm::ivec3 cells) {
    std::string on, beaten;
    for (std::size_t n = 0; n < rows.size(); ++n) {
        if (rows[n].cells != cells || rows[n].method != k_default_method)
            continue;
        const std::string cfl = scene::figure(rows[n].cfl);
        if (const auto by = beaten_by(points, n)) {
            const ParetoRow& better = rows[*by];
            beaten += message("; no at CFL ", cfl, ": ", place_of(better), " has ", to_digits(better.error / rows[n].error, 3),
                              " of its error in ", to_digits(better.ms_per_second / rows[n].ms_per_second, 3), " of its time");
        } else {
            on += (on.empty() ? "" : ", ") + cfl;
        }
    }
    const std::string yes = on.empty() ? "" : "; yes at CFL " + on;
    return "  on the front on " + grid_name(cells) +
           (on.empty() && beaten.empty() ? ": not run" : ": " + (yes + beaten).substr(2)) + ".\n";
}

} // namespace

void report_pareto_start(const ParetoResult& result, const Console& console) {
    console.out
        << result.device << (result.backend == BackendKind::vulkan ? "; Stam's step on " : "; ")
        << message(result.threads, result.threads == 1 ? " thread" : " threads", " (", result.simd, ")")
        << "\nErrors at the end of a flow against the time for a second of it; all methods of a grid are timed in turns.\n";
    console.out.flush();
}

void report_front(const FlowResult& flow, int threads, const Console& console) {
    const std::vector<ParetoRow> rows = flow.rows_with(threads);
    const std::vector<CostError> points = points_of(rows);
    console.out << "\n  front of " << message(rows.size()) << " runs: nothing else is as good in the time\n"
                << line("ms/s of flow", "error", "grid", "CFL", "/ Stam", "method");
    for (const std::size_t n : front_of(points)) {
        const ParetoRow& row = rows[n];
        console.out << line(to_digits(row.ms_per_second, 3), to_digits(row.error, 3), grid_name(row.cells),
                            scene::figure(row.cfl), to_fixed(row.vs_stam40, 2),
                            name_of(row.method) + (row.method == k_default_method ? "  *" : ""));
    }
    console.out << "  the default, " << name_of(k_default_method) << " (*):\n";
    std::vector<glm::ivec3> grids;
    for (const ParetoRow& row : rows)
        if (grids.empty() || grids.back() != row.cells)
            grids.push_back(row.cells);
    for (const glm::ivec3 cells : grids)
        console.out << standing(rows, points, cells);
    console.out.flush();
}

} // namespace windrow::cli
