// The square cavity whose lid slides: no-slip walls and viscosity until the air is steady, beside published centre lines.
//
// A lid of speed 1 over a square of width 1, from rest, in N x N cells; Re = 1 / nu. Steady: within a unit of time no component
// of any cell changes by more than 1e-5 of the lid's speed. The runs of smaller dt start where the larger dt came to rest. Values
// on the centre lines are read by cubic weights, beyond walls from the mirrored ghosts that the solver itself assumes.
//
// The steady state is not the same for every dt: diffusion, advection and pressure act one after the other, and in the steady
// state they must undo each other's changes of a step, which leaves an error of order dt beside the h^2 of the walls. So three
// steps are told.
#include "cases/cavity_tables.h"
#include "cases/cubic_factor.h"
#include "cases/whole_step.h"
#include "fluid/core/message.h"

#include <algorithm>
#include <limits>

namespace windrow::cases {
namespace {

constexpr double k_steady = 1e-5;    ///< [1/s] change of a speed, the lid's being 1
constexpr double k_max_time = 200.0; ///< [s] Re 1000 needs 75

std::unique_ptr<BackendWind> cavity_of(const VerifySetting& setting, int size, double reynolds) {
    Box box = periodic_box({size, size, 1}, 1.0 / size);
    for (Boundary* const side : {&box.boundaries.x_low, &box.boundaries.x_high, &box.boundaries.y_low, &box.boundaries.y_high})
        side->kind = BoundaryKind::no_slip;
    box.boundaries.y_high.wall_velocity = {1.0f, 0.0f, 0.0f};
    return wind_of(raw_config(box, 1.0 / reynolds, setting), setting);
}

// Steps until the air is steady; returns the largest CFL number, or a NaN where it never becomes so.
double settle(BackendWind& wind, int steps_a_second) {
    double cfl = 0.0, change = std::numeric_limits<double>::infinity();
    for (double time = 0.0; time < k_max_time && change > k_steady; time += 1.0) {
        const std::span<const glm::vec4> start = wind.field();
        const CellVelocities before(start.begin(), start.end());
        for (int step = 0; step < steps_a_second; ++step)
            cfl = std::max(cfl, static_cast<double>(wind.step(1.0 / steps_a_second).cfl));
        change = 0.0;
        const std::span<const glm::vec4> now = wind.field();
        for (std::size_t n = 0; n < before.size(); ++n)
            for (int axis = 0; axis < 3; ++axis)
                change = worse(change, std::abs(static_cast<double>(now[n][axis]) - before[n][axis]));
    }
    return change <= k_steady ? cfl : std::numeric_limits<double>::quiet_NaN();
}

// Between the centres of a line of cells that ends at walls of the velocities `low` and `high`.
double between(const std::vector<double>& line, double low, double high, double place) {
    const int size = static_cast<int>(line.size());
    const auto at = [&](int n) {
        if (n < 0)
            return 2.0 * low - line[static_cast<std::size_t>(-1 - n)];
        if (n >= size)
            return 2.0 * high - line[static_cast<std::size_t>(2 * size - 1 - n)];
        return line[static_cast<std::size_t>(n)];
    };
    const double cell = place * size - 0.5, below = std::floor(cell);
    double sum = 0.0;
    for (int j = 0; const double weight : cubic_weights(cell - below))
        sum += weight * at(static_cast<int>(below) + j++ - 1);
    return sum;
}

// The largest error of both centre lines.
double centre_line_error(const BackendWind& wind, const CavityTable& table) {
    const WindView view = wind.view();
    const Box& box = view.box();
    const int size = box.cells.x;
    std::vector<double> across(static_cast<std::size_t>(size)), vertical(across.size()), horizontal(across.size());
    for (int n = 0; n < size; ++n) {
        const auto place = static_cast<std::size_t>(n);
        for (int m = 0; m < size; ++m)
            across[static_cast<std::size_t>(m)] = view.field()[box.index(m, n, 0)].x;
        vertical[place] = between(across, 0.0, 0.0, 0.5);
        for (int m = 0; m < size; ++m)
            across[static_cast<std::size_t>(m)] = view.field()[box.index(n, m, 0)].y;
        horizontal[place] = between(across, 0.0, 0.0, 0.5);
    }
    double worst = 0.0;
    for (const LinePoint& point : table.vertical)
        worst = worse(worst, std::abs(between(vertical, 0.0, 1.0, point.place) - point.speed));
    for (const LinePoint& point : table.horizontal)
        worst = worse(worst, std::abs(between(horizontal, 0.0, 0.0, point.place) - point.speed));
    return worst;
}

struct Cavity {
    double reynolds;
    const CavityTable& common;  ///< the table that everyone compares with
    const CavityTable& precise; ///< a later and better one
    double bound_at_64;
};

VerifyRows run_cavity(const VerifySetting& setting, int size, const Cavity& cavity) {
    const auto wind = cavity_of(setting, size, cavity.reynolds);
    std::vector<VerifyRow> rows;
    for (const int part : {1, 2, 4}) {
        const double cfl = settle(*wind, part * size);
        for (const CavityTable& table : {cavity.common, cavity.precise})
            rows.push_back(
                {.cells = wind->box().cells,
                 .cfl = cfl,
                 .error = std::isnan(cfl) ? cfl : centre_line_error(*wind, table),
                 .bound = falling_bound(cavity.bound_at_64, 64, 1.5, size),
                 .label = detail::message("dt = h", part > 1 ? detail::message(" / ", part) : "", ", ", table.author)});
    }
    return rows;
}

} // namespace

std::vector<VerifyCase> cavity_cases() {
    return {
        {.name = "lid_cavity_100",
         .what = "A square cavity whose lid slides, Re 100, until it is steady; largest error of the published points of both "
                 "centre lines, over the lid's speed.",
         .source = "Ghia, Ghia & Shin 1982, J. Comput. Phys. 48; Marchi, Suero & Araki 2009, J. Braz. Soc. Mech. Sci. Eng. 31",
         .reason =
             "1 % of the lid's speed at 64 cells, falling as h^1.5, between the h^2 of the walls and the dt of the parts of "
             "a step; the older table is itself 0.8 % off, which is what small steps leave of it",
         .sizes = {32, 64},
         .run =
             [](const VerifySetting& setting, int size) {
                 return run_cavity(setting, size, {100.0, k_ghia_100, k_marchi_100, 0.01});
             }},
        {.name = "lid_cavity_1000",
         .what = "A square cavity whose lid slides, Re 1000, until it is steady; largest error of the published points of both "
                 "centre lines, over the lid's speed.",
         .source = "Ghia, Ghia & Shin 1982, J. Comput. Phys. 48; Botella & Peyret 1998, Comput. Fluids 27",
         .reason = "the layers along the walls are two cells thick at 64 cells; measured are 0.055 there, of which a fifth more "
                   "is admitted, falling as h^1.5, between the h^2 of the walls and the dt of the parts of a step",
         .guards = true,
         .sizes = {64, 128},
         .run =
             [](const VerifySetting& setting, int size) {
                 return run_cavity(setting, size, {1000.0, k_ghia_1000, k_botella_1000, 0.066});
             }},
    };
}

} // namespace windrow::cases
