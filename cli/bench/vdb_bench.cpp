#include "cli/bench/vdb_bench.h"

#include "cli/bench/residual.h"
#include "cli/table.h"
#include "fluid/message.h"

#if WINDROW_CASES_OPENVDB
#include "cases/reference/vdb_poisson.h"
#endif

#include <algorithm>
#include <cmath>
#include <vector>

namespace windrow::cli {

#if WINDROW_CASES_OPENVDB

namespace {

using detail::message;

constexpr int k_runs = 3;
constexpr double k_longest_run = 2.0; // [s]

// [s] What a run will take: the iterations grow with the cells along an axis. One microsecond a cell on 32^3 is a common
// machine's.
double expected_seconds(const Box& box) {
    const double cells = static_cast<double>(box.cell_count());
    return 1e-6 * cells * std::cbrt(cells / 32768.0);
}

} // namespace

std::optional<SolverResult> measure_vdb(const Box& box, std::span<const float> rhs, int threads, double seconds,
                                        const std::function<bool()>& stopped, std::string& left_out) {
    const double most = std::max(k_longest_run, seconds / k_runs);
    if (const double expected = expected_seconds(box); expected > most) {
        left_out += message("OpenVDB's solver would take about ", to_fixed(expected, 0), " s a run. ");
        return std::nullopt;
    }
    reference::VdbPoisson solver(box.cells, box.cell_size, threads);
    std::vector<float> phi(rhs.size()), milliseconds;
    for (int run = 0; run < k_runs && !stopped(); ++run)
        milliseconds.push_back(
            static_cast<float>(1000.0 * solver.solve(rhs, phi, reference::VdbOutside::open_and_floor).seconds));
    const auto at = [&](int i, int j, int k) { return static_cast<double>(phi[box.index(i, j, k)]); };
    return SolverResult{spread_of(milliseconds), relative_residual(box, rhs, at)};
}

#else

std::optional<SolverResult> measure_vdb(const Box&, std::span<const float>, int, double, const std::function<bool()>&,
                                        std::string& left_out) {
    left_out += "This windrow was built without OpenVDB. ";
    return std::nullopt;
}

#endif

} // namespace windrow::cli
