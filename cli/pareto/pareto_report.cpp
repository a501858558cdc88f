#include "cli/output_file.h"
#include "cli/pareto/pareto_command.h"
#include "cli/table.h"
#include "fluid/core/message.h"
#include "fluid/files/input_file.h"
#include "scene/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

namespace windrow::cli {

using namespace cases;

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

bool finite(const CostError& point) {
    return std::isfinite(point.cost) && std::isfinite(point.error);
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

int join_pareto(const ParetoRequest& request, const Console& console) {
    const auto rejected = [&](const std::string& sentence) {
        console.complain(sentence);
        return k_exit_wrong_use;
    };
    constexpr std::size_t k_case_column = 6;
    std::string header;
    std::map<std::string, std::pair<std::size_t, std::string>> found; // the part and the rows of a flow
    const auto file_of = [&](std::size_t part) { return (request.join[part] / "pareto.csv").string(); };
    for (std::size_t part = 0; part < request.join.size(); ++part) {
        const std::string file = file_of(part);
        const auto text = detail::read_input(file, {.max_bytes = std::size_t{64} << 20});
        if (!text)
            return rejected(text.error());
        std::istringstream lines(*text);
        std::string row;
        std::getline(lines, row);
        if (row != pareto_csv({}).substr(0, row.size()) || row.empty())
            return rejected(message(file, ": is not what windrow pareto writes: give the folders of the parts."));
        header = row;
        while (std::getline(lines, row)) {
            std::size_t begin = 0;
            for (std::size_t column = 0; column < k_case_column; ++column)
                begin = std::min(row.find(',', begin), row.size() - 1) + 1;
            const std::string flow = row.substr(begin, row.find(',', begin) - begin);
            auto& [from, rows] = found.try_emplace(flow, part, "").first->second;
            if (from != part)
                return rejected(message(file, ": has the flow ", flow, ", as ", file_of(from), " has: give each part once."));
            rows += row + "\n";
        }
    }
    std::string text = header + "\n";
    for (const ParetoFlow& flow : request.flows) {
        const auto rows = found.find(flow.name);
        if (rows == found.end())
            return rejected(
                message("--join has no folder with the flow ", flow.name, ": run its part, or name the flows with --flow."));
        text += rows->second.second;
    }
    OutputFolder output;
    if (const Fault fault = output.open(request.out))
        return complain_of(fault, console);
    OutputFile csv(request.out / "pareto.csv");
    csv.write(text);
    if (const Fault fault = csv.publish())
        return complain_of(fault, console);
    console.out << "In " << request.out.string() << ": pareto.csv of " << message(request.join.size()) << " parts.\n";
    return k_exit_well;
}

bool beats(const CostError& a, const CostError& b) {
    if (!finite(a) || !finite(b))
        return finite(a);
    return a.cost <= b.cost && a.error <= b.error && (a.cost < b.cost || a.error < b.error);
}

std::vector<std::size_t> front_of(std::span<const CostError> points) {
    std::vector<std::size_t> order;
    for (std::size_t n = 0; n < points.size(); ++n)
        if (finite(points[n]))
            order.push_back(n);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::pair(points[a].cost, points[a].error) < std::pair(points[b].cost, points[b].error);
    });
    std::vector<std::size_t> front;
    double least = std::numeric_limits<double>::infinity(); // error of all that is cheaper
    for (std::size_t n = 0; n < order.size();) {
        // Of one cost, the best and its equals.
        const double best = points[order[n]].error, cost = points[order[n]].cost;
        for (; n < order.size() && points[order[n]].cost == cost; ++n)
            if (best < least && points[order[n]].error == best)
                front.push_back(order[n]);
        least = std::min(least, best);
    }
    return front;
}

std::optional<std::size_t> beaten_by(std::span<const CostError> points, std::size_t point) {
    std::optional<std::size_t> found;
    for (std::size_t n = 0; n < points.size(); ++n) {
        if (!beats(points[n], points[point]))
            continue;
        if (!found || std::pair(points[n].error, points[n].cost) < std::pair(points[*found].error, points[*found].cost))
            found = n;
    }
    return found;
}

} // namespace windrow::cli
