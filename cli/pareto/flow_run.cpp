#include "cases/cell_values.h"
#include "cases/flow_truth.h"
#include "cases/flow_wind.h"
#include "cases/reference/stam.h"
#include "cli/bench/contest.h"
#include "cli/pareto/pareto_command.h"
#include "cli/table.h"
#include "fluid/core/message.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <span>
#include <vector>

namespace windrow::cli {

using namespace cases;

namespace {

// --- What a step of each method takes on one grid, beside the tuned step of Stam in the same run -----------------------

struct StepTime {
    double vs_stam40 = 0.0; ///< median of neighbouring turns
    double step_ms = 0.0;   ///< the same times the least of Stam's: what a busy machine adds meets neighbours alike and cancels
};

struct GridTimes {
    std::vector<StepTime> methods{};       ///< in the order of pareto_methods
    double stam_ms = 0.0;                  ///< least
    std::optional<double> cpu_vs_device{}; ///< of the default method; none on the CPU
    std::size_t rounds = 0;
};

constexpr int k_sweeps = 40;
constexpr int k_max_age = 60; // steps before the field is laid in again

/// Steps a field that is laid in again before it grows old. A first step has no history and another cost, so one is made that is not
/// timed.
class Stepper {
  public:
    Stepper(int max_age, std::function<void()> lay_in) : max_age_(max_age), age_(max_age), lay_in_(std::move(lay_in)) {}

    [[nodiscard]] Contestant contestant(std::function<void()> step) {
        return {.run =
                    [this, step] {
                        step();
                        ++age_;
                    },
                .prepare =
                    [this, step] {
                        if (age_ < max_age_)
                            return;
                        lay_in_();
                        step();
                        age_ = 1;
                    }};
    }

  private:
    int max_age_, age_;
    std::function<void()> lay_in_;
};

/// All methods step one field in turns, at CFL 1: without viscosity a step's time depends neither on what the field holds nor, by
/// more than a twentieth, on the CFL number from 0.5 to 4. Nothing inside where
/// `stopped` said so.
Result<std::optional<GridTimes>> measure_steps(const ParetoFlow& flow, glm::ivec3 cells, double seconds, Simd simd,
                                               const ParallelFor& parallel_for, const Backend& backend,
                                               const std::function<bool()>& stopped) {
    const Box box = box_of(flow, cells);
    const int steps = steps_of(flow, cells, 1.0), max_age = std::min(steps, k_max_age);
    const double dt = flow.end / steps;
    const auto methods = pareto_methods(solves_of(flow, backend.kind()));
    const CellVelocities start =
        flow.start ? velocities_of(box, flow.start) : CellVelocities(box.cell_count(), glm::vec4(glm::vec3(flow.mean), 0.0f));

    Contest contest;
    std::deque<FlowWind> winds; // contestants point to these two
    std::deque<Stepper> steppers;
    // On the CPU one wind takes all methods in turns.
    const auto enter = [&](const Method& method, const Backend& on) -> Result<std::size_t> {
        if (winds.empty() || !on.is_cpu() || !backend.is_cpu()) {
            auto made = FlowWind::create(flow, cells, {.method = method, .simd = simd, .parallel_for = parallel_for}, on);
            if (!made)
                return made.failure();
            FlowWind& wind = winds.emplace_back(*std::move(made));
            steppers.emplace_back(max_age, [&wind, dt] {
                wind.set_method(k_default_method);
                wind.begin();
                wind.step(dt); // its first, twice; other schemes leave that to do
            });
        }
        return contest.add(steppers.back().contestant([&wind = winds.back(), method, dt] {
            wind.set_method(method);
            wind.step(dt);
        }));
    };
    // The time of whole cells for obstacles is that of the tuned step without any.
    std::deque<reference::StamStep> stams;
    std::deque<Stepper> stam_steppers;
    const auto enter_stam = [&](int sweeps) {
        reference::StamStep& stam = stams.emplace_back(cells, box.cell_size, sweeps, parallel_for, simd);
        stam.set_ambient(glm::vec3(flow.mean));
        stam_steppers.emplace_back(max_age, [&stam, &start] { std::copy(start.begin(), start.end(), stam.velocity().begin()); });
        return contest.add(stam_steppers.back().contestant([&stam, dt] { stam.step(static_cast<float>(dt)); }));
    };
    std::vector<std::size_t> numbers;
    for (const Method& method : methods) {
        const auto number = has_voxels(flow, method) ? Result<std::size_t>(enter_stam(reference::sweeps_of(method.pressure)))
                                                     : enter(method, backend);
        if (!number)
            return number.failure();
        numbers.push_back(*number);
    }
    const auto cpu_number = backend.is_cpu() ? Result<std::size_t>(0) : enter(k_default_method, {});
    if (!cpu_number)
        return cpu_number.failure();
    const std::size_t stam_number = enter_stam(k_sweeps);
    if (!contest.hold(seconds, stopped))
        return std::optional<GridTimes>();

    GridTimes times{.stam_ms = contest.milliseconds(stam_number).min, .rounds = contest.rounds()};
    for (std::size_t n = 0; n < methods.size(); ++n) {
        const double ratio = contest.ratio(numbers[n], stam_number);
        times.methods.push_back({.vs_stam40 = ratio, .step_ms = ratio * times.stam_ms});
        if (!backend.is_cpu() && methods[n] == k_default_method)
            times.cpu_vs_device = contest.ratio(*cpu_number, numbers[n]);
    }
    return std::optional(std::move(times));
}

// --- Errors ------------------------------------------------------------------------------------------------------------

using detail::message;

/// Errors of one grid, by step and then method.
using GridErrors = std::vector<std::vector<double>>;

Result<std::optional<GridErrors>> find_errors(const ParetoFlow& flow, glm::ivec3 cells, const std::vector<Method>& methods,
                                              const ParetoRequest& request, const FlowTruth& truth,
                                              const ParallelFor& parallel_for, const Backend& backend,
                                              const std::function<bool()>& stopped) {
    const CellTruth end = truth.at_centres(cells);
    GridErrors errors(request.cfls.size());
    for (std::size_t c = 0; c < errors.size(); ++c)
        for (const Method& method : methods) {
            if (stopped())
                return std::optional<GridErrors>();
            const int steps = steps_of(flow, cells, request.cfls[c]);
            const double dt = flow.end / steps;
            auto wind =
                FlowWind::create(flow, cells, {.method = method, .simd = request.simd, .parallel_for = parallel_for}, backend);
            if (!wind)
                return wind.failure();
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
    // A wind with the other solves and Stam's on the largest grid, or a wind alone and a copy on the reference.
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
        return truth.failure();
    if (!*truth)
        return std::optional<FlowResult>();

    FlowResult result{.name = flow.name, .rows = {}};
    std::optional<GridErrors> coarser;
    glm::ivec3 coarser_cells(0);
    const auto methods = pareto_methods(solves_of(flow, backend.kind()));
    for (const glm::ivec3 cells : flow.grids) {
        auto errors = find_errors(flow, cells, methods, request, **truth, loop, backend, stopped);
        if (!errors)
            return errors.failure();
        if (!*errors)
            return std::optional<FlowResult>();
        for (const int count : {1, threads}) {
            // A device's time does not depend on the threads.
            if (count == 1 && threads > 1 && (!request.one_thread_too || !backend.is_cpu()))
                continue;
            const auto times =
                measure_steps(flow, cells, request.seconds, request.simd, count > 1 ? loop : ParallelFor{}, backend, stopped);
            if (!times)
                return times.failure();
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
            if ((*times)->cpu_vs_device)
                console.out << ", the CPU's step " << to_fixed(*(*times)->cpu_vs_device, 2) << " of the device's";
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
