#include "cli/pareto/flow_run.h"

#include "cli/pareto/flow_truth.h"
#include "cli/pareto/flow_wind.h"
#include "cli/pareto/step_times.h"
#include "cli/timings.h"
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

/// The flow run to its end with one method; not finite where a cell broke on the way.
double error_of(const ParetoFlow& flow, bench::ComposedStep& step, const Method& method, std::span<const glm::vec4> start,
                int steps, std::span<const glm::dvec3> truth) {
    static_cast<void>(step.start(start)); // accepted before
    for (int n = 0; n < steps; ++n)
        step.step(method, flow.end / steps);
    return flow_error(flow, step.velocity(), truth);
}

/// The same on a device.
Result<double> error_on(const Backend& backend, const ParetoFlow& flow, glm::ivec3 cells, const Method& method,
                        std::span<const glm::vec4> start, int steps, std::span<const glm::dvec3> truth) {
    auto wind = flow_wind(flow, cells, method, Simd::best, {}, backend);
    if (!wind)
        return Error{wind.error()};
    static_cast<void>((*wind)->set_velocity(start)); // of the box's size
    for (int n = 0; n < steps; ++n)
        (*wind)->step(flow.end / steps);
    return flow_error(flow, (*wind)->field(), truth);
}

Result<std::optional<GridErrors>> find_errors(const ParetoFlow& flow, glm::ivec3 cells, const ParetoRequest& request,
                                              const FlowTruth& truth, const ParallelFor& parallel_for, const Backend& backend,
                                              const std::function<bool()>& stopped) {
    const Box box = box_of(flow, cells);
    auto step = bench::ComposedStep::create(
        {.box = box, .ambient = glm::vec3(flow.mean), .motors = flow.motors, .simd = request.simd, .parallel_for = parallel_for});
    if (!step)
        return Error{step.error()};
    const CellVelocities start = velocities_of(box, flow.start);
    if (const auto fits = step->start(start); !fits)
        return Error{fits.error()};
    const std::vector<glm::dvec3> end = truth.at_centres(cells);
    GridErrors errors(request.cfls.size());
    for (std::size_t c = 0; c < errors.size(); ++c)
        for (const Method& method : pareto_methods(backend.kind())) {
            if (stopped())
                return std::optional<GridErrors>();
            const int steps = steps_of(flow, cells, request.cfls[c]);
            const auto error = backend.is_cpu() ? Result<double>(error_of(flow, *step, method, start, steps, end))
                                                : error_on(backend, flow, cells, method, start, steps, end);
            if (!error)
                return Error{error.error()};
            errors[c].push_back(*error);
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
    const auto methods = pareto_methods(backend.kind());
    for (const glm::ivec3 cells : flow.grids) {
        auto errors = find_errors(flow, cells, request, **truth, loop, backend, stopped);
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
                        << " rounds, Stam's step " << to_fixed((*times)->stam_ms, 3) << " ms, "
                        << (backend.is_cpu() ? "Wind's own step " : "the CPU's step ") << to_fixed((*times)->wind_vs_method, 2)
                        << (backend.is_cpu() ? " of the composed one\n" : " of the device's\n");
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
