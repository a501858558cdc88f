// Scalars that a given wind brings back to where they were: the truth is the start.
//
//   uniform        a Gaussian through a periodic unit square, twice along x and once along y
//   rotation       a cone and a slotted disc, one turn about the middle of the square
//   deformation    u = sin^2(pi x) sin(2 pi y) g, v = -sin^2(pi y) sin(2 pi x) g, g = cos(pi t / T): drawn out, and back
//
// A step takes h^4 s (1 - s) (1 + s) (2 - s) / 24 of the fourth derivative off a smooth scalar, s the part of a cell by which it
// is carried (cubic_factor.h). So in a uniform wind the order is 3 at a fixed CFL number, since the steps grow in number as 1 /
// h; 4 at a fixed dt of many cells, where s is as if at random, or the same at each doubling where it is 1/3 or 2/3; and 3 again
// at a fixed dt that is small, where s is as 1 / h. At a fixed CFL number a scalar with m derivatives (in the norm taken) has m p
// / (p + 1) with p = 3: an edge 3/4 in the sum of errors; in the root of their squares a cone's kink 9/8, a hump whose curvature
// jumps 15/8. Based on: Zalesak 1979, Journal of Computational Physics 31; LeVeque 1996, SIAM Journal on Numerical Analysis 33;
// Brenner, Thomee & Wahlbin 1975, Besov Spaces and Applications to Difference Methods for Initial Value Problems.
#include "cases/cell_values.h"
#include "cases/cubic_factor.h"

#include <algorithm>
#include <new>

namespace windrow::cases {
namespace {

enum class Limiter { none, clamped };
enum class Norm { sum, squares };
enum class Blow { steady, changing };

struct Journey {
    double end = 1.0; ///< [s]
    int steps = 1;
    Limiter limiter = Limiter::none;
    Norm norm = Norm::squares;
    Blow blow = Blow::steady;
};

/// wind(x, t) is taken in the middle of each step, which makes a changing wind second order.
template <class WindAt, class Value>
VerifyRow carry(const VerifySetting& setting, const Box& box, const Journey& journey, WindAt&& wind, Value&& value) {
    Workspace work = workspace_of(box, setting);
    const CellScalars start = scalars_of(box, value);
    CellScalars now = start, next(start.size());
    const double dt = journey.end / journey.steps;
    VerifyRow row{.cells = box.cells};
    CellVelocities blow;
    for (int step = 0; step < journey.steps; ++step) {
        if (step == 0 || journey.blow == Blow::changing) {
            blow = velocities_of(box, [&](glm::dvec3 x) { return wind(x, (step + 0.5) * dt); });
            for (const glm::vec4& u : blow)
                row.cfl = std::max({row.cfl, std::abs(u.x) * dt / box.cell_size, std::abs(u.y) * dt / box.cell_size});
        }
        const ScalarTransport transport{
            .carried = now, .velocity = blow, .dt = static_cast<float>(dt), .clamped = journey.limiter == Limiter::clamped};
        if (!advect(work, transport, next))
            throw std::bad_alloc();
        std::swap(now, next);
    }
    double error = 0.0, size = 0.0;
    const double power = journey.norm == Norm::sum ? 1.0 : 2.0;
    for (std::size_t n = 0; n < start.size(); ++n) {
        error += std::pow(std::abs(static_cast<double>(now[n]) - start[n]), power);
        size += std::pow(std::abs(static_cast<double>(start[n])), power);
    }
    row.error = std::pow(error / size, 1.0 / power);
    return row;
}

Box square(int size, BoundaryKind boundaries) {
    return {.cells = {size, size, 1},
            .cell_size = static_cast<float>(1.0 / size),
            .boundaries =
                sides_of({boundaries, boundaries}, {boundaries, boundaries}, {BoundaryKind::periodic, BoundaryKind::periodic})};
}

double distance(glm::dvec3 x, double to_x, double to_y) {
    return glm::length(glm::dvec2(x.x - to_x, x.y - to_y));
}

constexpr double k_sigma = 0.1;
int gaussian_steps(int size) {
    return static_cast<int>(std::lround(2.0 * size / 0.7));
}

VerifyRow gaussian(const VerifySetting& setting, int size, int steps, Limiter limiter) {
    const Journey journey{.end = 2.0, .steps = steps, .limiter = limiter};
    return carry(
        setting, square(size, BoundaryKind::periodic), journey, [](glm::dvec3, double) { return glm::dvec3(1.0, 0.5, 0.0); },
        [](glm::dvec3 x) { return std::exp(-0.5 * std::pow(distance(x, 0.5, 0.5) / k_sigma, 2.0)); });
}

// What the cubic weights leave of its waves: a wave of k turns a metre has the weight exp(-2 pi^2 sigma^2 k^2), and those above
// 16 turns have none.
double gaussian_closed_form(int size, int steps) {
    constexpr int k_most = 16;
    double off = 0.0, all = 0.0;
    for (int kx = -k_most; kx <= k_most; ++kx)
        for (int ky = -k_most; ky <= k_most; ++ky) {
            const double turn = 2.0 * k_pi / size, weight = std::exp(-4.0 * std::pow(k_pi * k_sigma, 2.0) * (kx * kx + ky * ky));
            const auto factor = cubic_factor(2.0 * size / steps, turn * kx) * cubic_factor(1.0 * size / steps, turn * ky);
            off += weight * std::norm(std::pow(factor, steps) - 1.0);
            all += weight;
        }
    return std::sqrt(off / all);
}

VerifyRow gaussian_in(const VerifySetting& setting, int size, int steps) {
    VerifyRow row = gaussian(setting, size, steps, Limiter::none);
    row.bound = 1.01 * gaussian_closed_form(size, steps) + 1e-6;
    return row;
}

template <class Value>
VerifyRow turn(const VerifySetting& setting, int size, Norm norm, Value&& value) {
    return carry(
        setting, square(size, BoundaryKind::open), {.end = 1.0, .steps = 4 * size, .norm = norm},
        [](glm::dvec3 x, double) { return 2.0 * k_pi * glm::dvec3(0.5 - x.y, x.x - 0.5, 0.0); }, value);
}

VerifyRow rotating_cone(const VerifySetting& setting, int size) {
    return turn(setting, size, Norm::squares, [](glm::dvec3 x) { return std::max(0.0, 1.0 - distance(x, 0.5, 0.25) / 0.15); });
}

VerifyRow slotted_disc(const VerifySetting& setting, int size) {
    return turn(setting, size, Norm::sum, [](glm::dvec3 x) {
        const bool slot = std::abs(x.x - 0.5) < 0.025 && x.y < 0.85;
        return distance(x, 0.5, 0.75) < 0.15 && !slot ? 1.0 : 0.0;
    });
}

VerifyRow deformation(const VerifySetting& setting, int size) {
    constexpr double k_period = 1.5;
    return carry(
        setting, square(size, BoundaryKind::periodic), {.end = k_period, .steps = 2 * size, .blow = Blow::changing},
        [](glm::dvec3 x, double t) {
            const double sx = std::sin(k_pi * x.x), sy = std::sin(k_pi * x.y);
            return std::cos(k_pi * t / k_period) *
                   glm::dvec3(sx * sx * std::sin(2.0 * k_pi * x.y), -sy * sy * std::sin(2.0 * k_pi * x.x), 0.0);
        },
        [](glm::dvec3 x) { return 0.5 * (1.0 + std::cos(k_pi * std::min(1.0, distance(x, 0.25, 0.5) / 0.15))); });
}

} // namespace

std::vector<VerifyCase> tracer_cases() {
    const auto bounded = [](auto&& row_of, double bound, int at, double order) {
        return [=](const VerifySetting& setting, int size) {
            VerifyRow row = row_of(setting, size);
            row.bound = falling_bound(bound, at, order, size);
            return row;
        };
    };
    return {
        {.name = "gaussian_carried",
         .what = "A Gaussian of sigma 0.1 through a periodic unit square by a wind of (1, 0.5), back at its start; error of the "
                 "scalar.",
         .source = "uniform translation: the truth is the start",
         .reason = "the error that the closed form gives for its waves, and a hundredth more; of order 3, as the weights are",
         .min_order = 2.9,
         .runs_on = RunsOn::cpu,
         .sizes = {64, 128, 256},
         .run = [](const VerifySetting& setting, int size) { return gaussian_in(setting, size, gaussian_steps(size)); }},
        {.name = "gaussian_fixed_dt",
         .what = "The Gaussian of gaussian_carried in 192 steps at each resolution, which carry it by 2/3 of a cell and more; "
                 "error of the scalar.",
         .source = "uniform translation: the truth is the start",
         .reason = "the error that the closed form gives for its waves, and a hundredth more and 1e-6 for rounding; of order 4, "
                   "since the steps do not grow in number",
         .min_order = 3.9,
         .runs_on = RunsOn::cpu,
         .sizes = {64, 128, 256},
         .run = [](const VerifySetting& setting, int size) { return gaussian_in(setting, size, 192); }},
        {.name = "gaussian_small_dt",
         .what = "The Gaussian of gaussian_carried in 2048 steps at each resolution, a quarter of a cell and less; error of the "
                 "scalar.",
         .source = "uniform translation: the truth is the start",
         .reason = "the error that the closed form gives for its waves, and a hundredth more and 1e-6 for rounding; of order 3, "
                   "since what a step takes off falls with the part of a cell that it carries",
         .min_order = 2.9,
         .runs_on = RunsOn::cpu,
         .sizes = {64, 128, 256},
         .run = [](const VerifySetting& setting, int size) { return gaussian_in(setting, size, 2048); }},
        {.name = "gaussian_clamped",
         .what = "The Gaussian of gaussian_carried, each value kept within its eight neighbours; error of the scalar.",
         .source = "uniform translation: the truth is the start",
         .reason = "the clamp cuts the crest, which costs some of the order 3; measured are 1.13e-2 at 64 cells, of which a "
                   "fifth more is admitted, falling as h^2.5",
         .guards = true,
         .min_order = 2.5,
         .runs_on = RunsOn::cpu,
         .sizes = {64, 128, 256},
         .run = bounded([](const VerifySetting& setting,
                           int size) { return gaussian(setting, size, gaussian_steps(size), Limiter::clamped); },
                        1.36e-2, 64, 2.5)},
        {.name = "rotating_cone",
         .what = "A cone turned once about the middle of the square; error of the scalar.",
         .source = "solid rotation: the truth is the start",
         .reason = "9/8 is the order of a kink (Brenner, Thomee & Wahlbin 1975); measured are 0.070 at 64 cells, of which a "
                   "fifth more is admitted, falling as h^1.1",
         .guards = true,
         .min_order = 1.1,
         .runs_on = RunsOn::cpu,
         .sizes = {64, 128, 256},
         .run = bounded(rotating_cone, 0.084, 64, 1.1)},
        {.name = "slotted_disc",
         .what = "A disc with a slot turned once about the middle of the square; sum of the errors over the sum of the scalar.",
         .source = "Zalesak 1979, J. Comput. Phys. 31: the truth is the start",
         .reason = "3/4 is the order of a straight edge (Brenner, Thomee & Wahlbin 1975); corners and a slot that is few smeared "
                   "edges wide make it 0.6 to 0.74, measured to 640 cells; 0.56 at 64 cells, of which a fifth more is admitted, "
                   "falling as h^0.6",
         .guards = true,
         .min_order = 0.6,
         .runs_on = RunsOn::cpu,
         .sizes = {64, 128, 256},
         .run = bounded(slotted_disc, 0.67, 64, 0.6)},
        {.name = "reversed_deformation",
         .what = "A hump drawn out by a wind that turns about, and back at its start; error of the scalar.",
         .source = "LeVeque 1996, SIAM J. Numer. Anal. 33 (swirling deformation flow, T = 1.5): the truth is the start",
         .reason = "15/8 is the order of the hump, whose curvature jumps at its edge (Brenner, Thomee & Wahlbin 1975); measured "
                   "are 0.113 at 64 cells, of which a fifth more is admitted, falling as h^1.85",
         .guards = true,
         .min_order = 1.85,
         .runs_on = RunsOn::cpu,
         .sizes = {64, 128, 256},
         .run = bounded(deformation, 0.136, 64, 1.85)},
    };
}

} // namespace windrow::cases
