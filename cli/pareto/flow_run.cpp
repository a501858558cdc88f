#include "cli/pareto/flow_run.h"

#include "cli/pareto/flow_truth.h"
#include "cli/pareto/flow_wind.h"
#include "cli/pareto/step_times.h"
#include "cli/table.h"
#include "cli/verify/cell_values.h"
#include "fluid/message.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace windrow::cli {
namespace {

using detail::message;

/// Errors of one grid, by step and then method.
using GridErrors = std::vector<std::vector<double>>;

Result<std::optional<GridErrors>> find_errors(const ParetoFlow& flow, glm::ivec3 cells, const std::vector<Method>& methods,
                                              const ParetoRequest& request, const FlowTruth& truth,
                                              const ParallelFor& parallel_for, const Backend& backend,
                                              const std::function<bool()>& stopped) {
    std::optional<reference::ComposedStep> composed;
    if (solves_of(flow, backend.kind()) == Solves::all) {
        auto made = composed_step(flow, cells, request.simd, parallel_for);
        if (!made)
            return Error{made.error()};
        composed.emplace(*std::move(made));
    }
    const CellVelocities start = flow.start ? velocities_of(box_of(flow, cells), flow.start) : CellVelocities();
    const CellTruth end = truth.at_centres(cells);
    GridErrors errors(request.cfls.size());
    for (std::size_t c = 0; c < errors.size(); ++c)
        for (const Method& method : methods) {
            if (stopped())
                return std::optional<GridErrors>();
            const int steps = steps_of(flow, cells, request.cfls[c]);
            const double dt = flow.end / steps;
            if (composed) {
                if (const auto fits = composed->start(start); !fits)
                    return Error{fits.error()};
                for (int n = 0; n < steps; ++n)
                    composed->step(method, dt);
                errors[c].push_back(flow_error(composed->velocity(), end));
                continue;
            }
            auto wind =
                FlowWind::create(flow, cells, {.method = method, .simd = request.simd, .parallel_for = parallel_for}, backend);
            if (!wind)
                return Error{wind.error()};
            for (int n = 0; n < steps; ++n)
                wind->step(dt);
            errors[c].push_back(flow_error(wind->field(), end));
        }
    return std::optional(std::move(errors));
}

std::optional<double> order_between(double coarse, double fine, int coarse_cells, int cells) {
    const double order = std::log(coarse / fine) / std::log(static_cast<double>(cells) / coarse_cells);
    return std::isfinite(order) ? std::optional(order) : std::nullopt;
}

} // namespace

std::uint64_t flow_run_bytes(const ParetoFlow& flow) {
    // The composed step, a wind and Stam's on the largest grid, or the composed step alone and a copy on the reference.
    constexpr std::uint64_t k_bytes_a_cell = 600, k_bytes_a_reference_cell = 260;
    std::uint64_t cells = 0;
    for (const glm::ivec3 grid : flow.grids)
        cells = std::max<std::uint64_t>(cells, Box{.cells = grid + 5}.cell_count());
    const std::uint64_t reference = flow.exact ? 0 : Box{.cells = flow.reference + 5}.cell_count();
    return std::max(k_bytes_a_cell * cells, k_bytes_a_reference_cell * reference);
}

Result<std::optional<FlowResult>> run_flow(const ParetoFlow& flow, const ParetoRequest& request, int threads,
                                           const ParallelFor& parallel_for, const Backend& backend, const Console& console,
                                           const std::function<bool()>& stopped) {
    const ParallelFor loop = threads > 1 ? parallel_for : ParallelFor{}; // one thread needs no loop of a pool
    const auto truth = FlowTruth::find(flow, request.simd, loop, stopped);
    if (!truth)
        return Error{truth.error()};
    if (!*truth)
        return std::optional<FlowResult>();

    FlowResult result{.name = flow.name, .title = flow.title, .rows = {}};
    std::optional<GridErrors> coarser;
    glm::ivec3 coarser_cells(0);
    const auto methods = pareto_methods(solves_of(flow, backend.kind()));
    for (const glm::ivec3 cells : flow.grids) {
        auto errors = find_errors(flow, cells, methods, request, **truth, loop, backend, stopped);
        if (!errors)
            return Error{errors.error()};
        if (!*errors)
            return std::optional<FlowResult>();
        for (const int count : {1, threads}) {
            // A device's time does not depend on the threads.
            if (count == 1 && threads > 1 && (!request.one_thread_too || !backend.is_cpu()))
                continue;
            const auto times =
                measure_steps(flow, cells, request.seconds, request.simd, count > 1 ? loop : ParallelFor{}, backend, stopped);
            if (!times)
                return Error{times.error()};
            if (!*times)
                return std::optional<FlowResult>();
            for (std::size_t c = 0; c < request.cfls.size(); ++c)
                for (std::size_t m = 0; m < methods.size(); ++m) {
                    const StepTime& time = (*times)->methods[m];
                    const int steps = steps_of(flow, cells, request.cfls[c]);
                    ParetoRow row{.method = methods[m], .cells = cells, .cfl = request.cfls[c], .error = (**errors)[c][m]};
                    if (coarser)
                        row.order = order_between((*coarser)[c][m], row.error, coarser_cells.x, cells.x);
                    row.step_ms = time.step_ms;
                    row.vs_stam40 = time.vs_stam40;
                    row.threads = count;
                    row.ms_per_second = time.step_ms * steps / flow.end;
                    result.rows.push_back(row);
                }
            console.out << "  " << grid_name(cells)
                        << message(", ", count, count == 1 ? " thread: " : " threads: ", (*times)->rounds)
                        << " rounds, Stam's step " << to_fixed((*times)->stam_ms, 3) << " ms";
            if ((*times)->wind_vs_method)
                console.out << (backend.is_cpu() ? ", Wind's own step " : ", the CPU's step ")
                            << to_fixed(*(*times)->wind_vs_method, 2)
                            << (backend.is_cpu() ? " of the composed one" : " of the device's");
            console.out << "\n";
            console.out.flush();
            if (threads == 1)
                break;
        }
        coarser = std::move(*errors);
        coarser_cells = cells;
    }
    return std::optional(std::move(result));
}

} // namespace windrow::cli
