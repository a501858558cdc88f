#include "cli/bench/grid_bench.h"

#include "cases/jets.h"
#include "cases/reference/copy.h"
#include "cases/reference/fftw_projection.h"
#include "cases/reference/jacobi.h"
#include "cases/reference/residual.h"
#include "cases/reference/stam.h"
#include "cli/bench/obstacle_scenes.h"
#include "cli/bench/wind_contestant.h"
#include "cli/info_command.h"
#include "cli/table.h"
#include "fluid/allocator.h"
#include "fluid/core/message.h"
#include "fluid/operators.h"
#if WINDROW_CASES_OPENVDB
#include "cases/reference/vdb_poisson.h"
#endif

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace windrow::cli {

using namespace cases;
namespace {

constexpr int k_sweeps = 40;

/// A solve in place: the right-hand side is laid in before each run, which therefore cannot be repeated.
class DirectContestant {
  public:
    DirectContestant(Workspace work, std::span<const float> rhs) : work_(std::move(work)), rhs_(rhs), phi_(rhs.size()) {}

    [[nodiscard]] Contestant contestant() {
        return {.run = [this] { solve_poisson(work_, phi_); },
                .prepare = [this] { std::copy(rhs_.begin(), rhs_.end(), phi_.begin()); },
                .note = [] {},
                .repeats = false};
    }
    [[nodiscard]] std::span<const float> phi() const { return phi_; }
    [[nodiscard]] Workspace& work() { return work_; }

  private:
    Workspace work_;
    std::span<const float> rhs_;
    std::vector<float> phi_;
};

reference::PressureAt dense(const Box& box, std::span<const float> phi) {
    return [&box, phi](int i, int j, int k) { return static_cast<double>(phi[box.index(i, j, k)]); };
}

// --- OpenVDB takes so long that it does not run among the others: the least of three runs ------------------------------

#if WINDROW_CASES_OPENVDB

constexpr int k_runs = 3;
constexpr double k_longest_run = 2.0; // [s]

// [s] What a run will take: the iterations grow with the cells along an axis. One microsecond a cell on 32^3 is a common
// machine's.
double expected_seconds(const Box& box) {
    const double cells = static_cast<double>(box.cell_count());
    return 1e-6 * cells * std::cbrt(cells / 32768.0);
}

// Nothing where OpenVDB would take too long, which `left_out` then holds. `rhs` with h = 1.
std::optional<SolverResult> measure_vdb(const Box& box, std::span<const float> rhs, int threads, double seconds,
                                        const std::function<bool()>& stopped, std::string& left_out) {
    const double most = std::max(k_longest_run, seconds / k_runs);
    if (const double expected = expected_seconds(box); expected > most) {
        left_out += detail::message("OpenVDB's solver would take about ", to_fixed(expected, 0), " s a run. ");
        return std::nullopt;
    }
    reference::VdbPoisson solver(box.cells, box.cell_size, threads);
    std::vector<float> phi(rhs.size()), milliseconds;
    for (int run = 0; run < k_runs && !stopped(); ++run)
        milliseconds.push_back(
            static_cast<float>(1000.0 * solver.solve(rhs, phi, reference::VdbOutside::open_and_floor).seconds));
    const auto at = [&](int i, int j, int k) { return static_cast<double>(phi[box.index(i, j, k)]); };
    return SolverResult{spread_of(milliseconds), reference::relative_residual(box, rhs, at)};
}

#else

std::optional<SolverResult> measure_vdb(const Box&, std::span<const float>, int, double, const std::function<bool()>&,
                                        std::string& left_out) {
    left_out += "This windrow was built without OpenVDB. ";
    return std::nullopt;
}

#endif

// --- Obstacles -----------------------------------------------------------------------------------------------------------

constexpr int k_outside = 10'000; // obstacles
constexpr int k_walk_steps = 100, k_walk_runs = 5;
constexpr double k_walk_speed = 12.0; // [m/s] of the box: a fifth of a cell a step

// Fraction of the cells that have a neighbour on the other side of a wall.
double surface_of(const BackendWind& wind) {
    const Box box = wind.box();
    std::vector<float> inside(box.cell_count());
    if (!wind.reader().write_obstacles(inside))
        return 0.0;
    std::size_t found = 0;
    for (int k = 0; k < box.cells.z; ++k)
        for (int j = 0; j < box.cells.y; ++j)
            for (int i = 0; i < box.cells.x; ++i) {
                bool surface = false;
                for (int axis = 0; axis < 3; ++axis)
                    for (const int side : {-1, 1}) {
                        glm::ivec3 next(i, j, k);
                        next[axis] += side;
                        surface = surface || (next[axis] >= 0 && next[axis] < box.cells[axis] &&
                                              inside[box.index(next.x, next.y, next.z)] != inside[box.index(i, j, k)]);
                    }
                found += surface ? 1 : 0;
            }
    return static_cast<double>(found) / static_cast<double>(inside.size());
}

// A walk through a town, several times: each of its steps has the least of its times.
bool walk(const Config& config, const Backend& backend, ObstaclesResult::Walk& result, const std::function<bool()>& stopped) {
    std::vector<float> least(k_walk_steps, std::numeric_limits<float>::infinity());
    for (int run = 0; run < k_walk_runs; ++run) {
        auto made = BackendWind::create(config, backend);
        if (!made || !build_town(place_of(**made), 2.0))
            return false;
        const auto& wind = *made;
        for (int step = -10; step < k_walk_steps; ++step) { // the first steps of a flow are others
            if (stopped())
                return false;
            glm::dvec3 to(0.0);
            to.x = k_walk_speed * k_bench_dt * std::max(step, 0);
            if (!wind->follow(to))
                return false;
            const auto ms = static_cast<float>(wind->step(k_bench_dt).times_ms.total);
            if (step >= 0)
                least[static_cast<std::size_t>(step)] = std::min(least[static_cast<std::size_t>(step)], ms);
        }
    }
    result.median_ms = static_cast<double>(quantile(least, 0.5));
    result.slowest_over_median = static_cast<double>(quantile(least, 1.0)) / result.median_ms;
    return true;
}

} // namespace

Result<std::optional<ObstaclesResult>> measure_obstacles(glm::ivec3 cells, const BenchRequest& request, const Backend& backend,
                                                         int threads, const ParallelFor& parallel_for,
                                                         const std::function<bool()>& stopped) {
    const std::vector<glm::vec4> flow = jets(bench_box(cells));
    const ParallelFor loop = threads > 1 ? parallel_for : ParallelFor{};
    const auto nothing = [](const BuildingPlace&) { return true; };
    const auto town = [](const BuildingPlace& place) { return build_town(place, 1.0); };
    const auto outside = [](const BuildingPlace& place) {
        const double near = 2.0 * place.box.cells.x;
        bool built = true;
        for (int n = 0; n < k_outside; ++n)
            built = built && build_block(place, {near + 8.0 * (n / 100), 3.0, 8.0 * (n % 100)}, glm::vec3(3.0f));
        return built;
    };
    const struct {
        const char* name;
        std::function<bool(const BuildingPlace&)> build;
        int solves = 1;
        bool rough = false, rows = false;
    } k_scenes[] = {{"empty", nothing},
                    {"one cube", build_cube},
                    {"town", town},
                    {"town, two solves", town, 2},
                    {"hills", build_hills},
                    {"outside", outside},
                    {"rough ground", nothing, 1, true},
                    {"uneven rows", nothing, 1, false, true}};

    Contest contest;
    ObstaclesResult result{.cells = cells};
    std::vector<std::unique_ptr<WindContestant>> winds;
    Config config = bench_config(cells, Scheme::second_order, request.simd, loop);
    for (const auto& [name, build, solves, rough, rows] : k_scenes) {
        config.pressure_solves = solves;
        config.roughness = rough ? std::optional<Roughness>(Roughness{}) : std::nullopt;
        config.rows = rows ? std::optional<Rows>(Rows{.first = 0.5f, .uniform = cells.y / 4, .top = static_cast<float>(cells.y)})
                           : std::nullopt;
        auto made = BackendWind::create(config, backend, BackendClock::on);
        if (!made)
            return made.failure();
        BackendWind& wind = **made;
        if (!build(place_of(wind)))
            return Error{detail::message("the scene ", name, " has no room for its obstacles: give a larger grid.")};
        const int count = static_cast<int>(wind.obstacles().count());
        winds.push_back(std::make_unique<WindContestant>(*std::move(made), flow));
        (void)contest.add(winds.back()->contestant());
        result.scenes.push_back({.name = name, .obstacles = count});
    }
    if (!contest.hold(request.seconds, stopped))
        return std::optional<ObstaclesResult>();
    result.rounds = contest.rounds();
    for (std::size_t n = 0; n < result.scenes.size(); ++n) {
        ObstacleScene& scene = result.scenes[n];
        scene.surface = surface_of(winds[n]->wind());
        scene.step_ms = contest.milliseconds(n);
        scene.stages_over_step = winds[n]->stages_at_obstacles();
        scene.over_empty = contest.ratio(n, 0);
        scene.solves = winds[n]->most_solves();
    }
    constexpr std::size_t k_town = 2;
    result.second_solve = contest.ratio(k_town + 1, k_town) - 1.0;
    config.pressure_solves = 0; // and in the uneven rows of the last scene
    Config equal = config;
    equal.rows.reset();
    if (!walk(equal, backend, result.walk, stopped) || !walk(config, backend, result.walk_in_rows, stopped))
        return std::optional<ObstaclesResult>();
    return std::optional(std::move(result));
}

std::uint64_t grid_bench_bytes(glm::ivec3 cells) {
    // Two winds, Stam's arrays, what is copied, FFTW's arrays; OpenVDB's matrix, which takes the most, on small grids only.
    // Beside them the padded fields of two winds, two workspaces and Stam, whose halo is most of a flat box.
    constexpr std::uint64_t k_bytes_a_cell = 512, k_bytes_a_padded_cell = 5 * 32;
    return k_bytes_a_cell * Box{.cells = cells}.cell_count() + k_bytes_a_padded_cell * Box{.cells = cells + 5}.cell_count();
}

Result<std::optional<GridResult>> measure_grid(glm::ivec3 cells, const BenchRequest& request, int threads,
                                               const ParallelFor& parallel_for, const std::function<bool()>& stopped) {
    const Box box = bench_box(cells);
    const std::vector<glm::vec4> flow = jets(box);
    // One thread needs no loop of a pool.
    const ParallelFor loop = threads > 1 ? parallel_for : ParallelFor{};

    Contest contest;
    struct Own {
        const char* name;
        int loops;
        std::unique_ptr<WindContestant> wind;
        std::size_t number;
    };
    std::vector<Own> own;
    for (const auto& [name, scheme] :
         {std::pair("second_order", Scheme::second_order), std::pair("stable_fluids", Scheme::stable_fluids)}) {
        const Config config = bench_config(cells, scheme, request.simd, loop);
        const int loops = count_loops(config, flow);
        auto wind = BackendWind::create(config);
        if (!wind)
            return wind.failure();
        auto contestant = std::make_unique<WindContestant>(*std::move(wind), flow);
        const std::size_t number = contest.add(contestant->contestant());
        own.push_back({name, loops, std::move(contestant), number});
    }

    // In memory like the fields'.
    detail::HostVector<glm::vec4> original(flow.size()), copied(flow.size());
    std::copy(flow.begin(), flow.end(), original.data());
    const std::size_t copy = contest.add({.run = [&] { reference::copy_cells(cells, original, copied, loop); }});

    reference::StamStep stam(cells, box.cell_size, k_sweeps, loop, request.simd);
    stam.set_ambient(k_bench_ambient);
    int stam_age = k_steps_of_flow;
    const std::size_t stam_number = contest.add({.run =
                                                     [&] {
                                                         stam.step(static_cast<float>(k_bench_dt));
                                                         ++stam_age;
                                                     },
                                                 .prepare =
                                                     [&] {
                                                         if (stam_age < k_steps_of_flow)
                                                             return;
                                                         std::copy(flow.begin(), flow.end(), stam.velocity().begin());
                                                         stam.step(static_cast<float>(k_bench_dt)); // packs the field
                                                         stam_age = 1;
                                                     }});

    auto work = Workspace::create({.box = box, .ambient = k_bench_ambient, .simd = request.simd, .parallel_for = loop});
    if (!work)
        return work.failure();
    std::vector<float> rhs(box.cell_count());
    divergence(*work, flow, rhs);
    reference::Jacobi jacobi(cells, request.simd);
    const std::size_t jacobi_number = contest.add({.run = [&] { jacobi.solve(rhs, k_sweeps, loop); }});
    DirectContestant direct(std::move(*work), rhs);
    const std::size_t direct_number = contest.add(direct.contestant());

    GridResult result{.cells = cells};
    auto serial_work = Workspace::create({.box = box, .ambient = k_bench_ambient, .simd = request.simd});
    if (!serial_work)
        return serial_work.failure();
    DirectContestant serial(std::move(*serial_work), rhs);
    std::size_t serial_number = 0, fftw_number = 0;
    const auto fftw = reference::FftwProjection::create(cells, box.cell_size);
    if (fftw) {
        serial_number = contest.add(serial.contestant());
        fftw_number = contest.add({.run = [&] { fftw->solve(); },
                                   .prepare = [&] { std::copy(rhs.begin(), rhs.end(), fftw->values().begin()); },
                                   .note = [] {},
                                   .repeats = false});
    } else {
        result.left_out += detail::message("FFTW's solve is in ", k_where_fftw_is, ". ");
    }

    if (!contest.hold(request.seconds, stopped))
        return std::optional<GridResult>();

    result.rounds = contest.rounds();
    for (const Own& one : own) {
        SchemeResult scheme = one.wind->result(one.name);
        scheme.step_ms = contest.milliseconds(one.number);
        scheme.loops = one.loops;
        scheme.vs_copy16 = contest.ratio(one.number, copy);
        scheme.vs_stam40 = contest.ratio(one.number, stam_number);
        result.schemes.push_back(scheme);
    }
    result.copy16_ms = contest.milliseconds(copy);
    result.stam40_ms = contest.milliseconds(stam_number);

    const reference::PressureAt exact = dense(box, direct.phi());
    const reference::PressureAt iterated = [&](int i, int j, int k) { return static_cast<double>(jacobi.row(j, k)[i]); };
    result.direct = {contest.milliseconds(direct_number), reference::relative_residual(box, rhs, exact)};
    result.jacobi40 = {contest.milliseconds(jacobi_number), reference::relative_residual(box, rhs, iterated)};
    result.jacobi40_gradient_error = reference::relative_gradient_error(box, iterated, exact);
    result.direct_vs_jacobi40 = contest.ratio(direct_number, jacobi_number);
    if (fftw) {
        result.direct_one_thread =
            SolverResult{contest.milliseconds(serial_number), reference::relative_residual(box, rhs, dense(box, serial.phi()))};
        result.fftw =
            SolverResult{contest.milliseconds(fftw_number), reference::relative_residual(box, rhs, dense(box, fftw->values()))};
        result.direct_vs_fftw = contest.ratio(serial_number, fftw_number);
    }
    result.vdb = measure_vdb(box, rhs, threads, request.seconds, stopped, result.left_out);
    if (stopped())
        return std::optional<GridResult>();
    return std::optional(std::move(result));
}

std::uint64_t volume_bench_bytes(int volumes) {
    constexpr std::uint64_t k_bytes_a_cell = 192; // as `run` counts
    return k_bytes_a_cell * bench_box(k_volume_cells).cell_count() * static_cast<std::uint64_t>(volumes);
}

Result<std::optional<VolumesResult>> measure_volumes(const VolumesRequest& request, const ParallelFor& parallel_for,
                                                     const std::function<bool()>& stopped) {
    const std::vector<glm::vec4> flow = jets(bench_box(k_volume_cells));
    const Config config = bench_config(k_volume_cells, Scheme::second_order, request.simd, {});
    std::vector<WindContestant> winds;
    winds.reserve(static_cast<std::size_t>(request.volumes));
    std::size_t bytes = 0;
    for (int n = 0; n < request.volumes; ++n) {
        if (stopped())
            return std::optional<VolumesResult>();
        auto wind = BackendWind::create(config);
        if (!wind)
            return wind.failure();
        bytes = (*wind)->reader().memory_bytes();
        winds.emplace_back(*std::move(wind), flow);
    }

    Contest contest;
    const std::size_t all = contest.add(
        {.run = [&] { parallel_for(request.volumes, [&](int n) { winds[static_cast<std::size_t>(n)].step(); }); },
         .prepare = [&] { parallel_for(request.volumes, [&](int n) { winds[static_cast<std::size_t>(n)].refresh(); }); }});
    if (!contest.hold(request.seconds, stopped))
        return std::optional<VolumesResult>();

    VolumesResult result{.volumes = request.volumes, .round_ms = contest.milliseconds(all), .bytes_per_volume = bytes};
    result.volumes_per_s = 1000.0 * request.volumes / result.round_ms.median;
    result.volumes_per_s_core = result.volumes_per_s / std::min({request.threads, request.volumes, usable_cores()});
    return std::optional(result);
}

} // namespace windrow::cli
