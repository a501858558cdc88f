// The pressure: a Poisson equation whose solution is known.
//
// L phi = lap(f), f a product of waves that obey each axis' pair of ends: 0 at the ghosts beyond open boundaries, of slope 0 at walls.
// Such ghosts make these waves the grid's own, so that a wave k of f comes out times k^2 / sum (2 / h sin(k h / 2))^2: phi - f has a closed
// form and falls as h^2.
// Based on: Roache 2002, Journal of Fluids Engineering 124 (manufactured solutions).
#include "cases/cell_values.h"

#include <array>

namespace windrow::cases {
namespace {

constexpr BoundaryKind k_open = BoundaryKind::open, k_slip = BoundaryKind::free_slip, k_rough = BoundaryKind::no_slip;
constexpr Ends k_periodic{BoundaryKind::periodic, BoundaryKind::periodic};

struct Mix {
    const char* name;
    const char* words;
    std::array<Ends, 3> ends;
};
constexpr Mix k_mixes[] = {
    {"poisson_open", "all boundaries open", {{{k_open, k_open}, {k_open, k_open}, {k_open, k_open}}}},
    {"poisson_closed", "walls all round", {{{k_slip, k_rough}, {k_slip, k_slip}, {k_rough, k_rough}}}},
    {"poisson_periodic", "all boundaries periodic", {{k_periodic, k_periodic, k_periodic}}},
    {"poisson_over_floor", "boundaries open over a floor", {{{k_open, k_open}, {k_slip, k_open}, {k_open, k_open}}}},
    {"poisson_mixed",
     "wall and open boundary on x, periodic y, open boundary and wall on z",
     {{{k_slip, k_open}, k_periodic, {k_open, k_rough}}}}};

// Along an axis f has two waves, on [0, 1] from where it is 0 or of slope 0 to where it is again.
std::array<double, 2> wave_numbers(Ends ends) {
    if (ends == k_periodic)
        return {2.0 * k_pi, 4.0 * k_pi};
    const double first = (ends.first == k_open) == (ends.second == k_open) ? k_pi : 0.5 * k_pi;
    return {first, first + k_pi};
}
constexpr double k_sizes[2] = {1.0, 0.4};

std::array<double, 2> waves_at(Ends ends, double x) {
    std::array<double, 2> waves{};
    for (std::size_t n = 0; n < 2; ++n) {
        const double phase = wave_numbers(ends)[n] * x;
        waves[n] = k_sizes[n] * (ends == k_periodic     ? std::sin(phase) + std::cos(phase)
                                 : ends.first == k_open ? std::sin(phase)
                                                        : std::cos(phase));
    }
    return waves;
}

// `size` cells of each metre: with odd sizes every axis has an odd number of cells.
constexpr glm::ivec3 k_metres(9, 5, 11);
Box poisson_box(const Mix& mix, int size) {
    return {.cells = size * k_metres,
            .cell_size = static_cast<float>(1.0 / size),
            .boundaries = sides_of(mix.ends[0], mix.ends[1], mix.ends[2])};
}

// Where an axis' waves begin and how long they are [m]: beyond an open boundary they reach half a cell out of the box.
struct Span {
    double begin, length;
    Span(const Mix& mix, int axis, int size) {
        const Ends& ends = mix.ends[static_cast<std::size_t>(axis)];
        begin = ends.first == k_open ? -0.5 / size : 0.0;
        length = k_metres[axis] - begin + (ends.second == k_open ? 0.5 / size : 0.0);
    }
};

/// A number for each of the eight products of waves: bit n of the index tells which wave along axis n.
using Products = std::array<double, 8>;

Products squares_of(const Mix& mix, int size) {
    Products squares{};
    for (std::size_t which = 0; which < 8; ++which)
        for (int axis = 0; axis < 3; ++axis)
            squares[which] += std::pow(
                wave_numbers(mix.ends[static_cast<std::size_t>(axis)])[(which >> axis) & 1] / Span(mix, axis, size).length, 2.0);
    return squares;
}

// What the grid makes of a product of size 1.
Products factors_on_grid(const Mix& mix, int size) {
    Products factors = squares_of(mix, size);
    const double h = 1.0 / size;
    for (std::size_t which = 0; which < 8; ++which) {
        double on_grid = 0.0;
        for (int axis = 0; axis < 3; ++axis) {
            const double k =
                wave_numbers(mix.ends[static_cast<std::size_t>(axis)])[(which >> axis) & 1] / Span(mix, axis, size).length;
            on_grid += std::pow(2.0 / h * std::sin(0.5 * k * h), 2.0);
        }
        factors[which] /= on_grid;
    }
    return factors;
}

// The sum of the products at a point, each times its factor.
double sum_at(const Mix& mix, int size, const Products& factors, glm::dvec3 x) {
    const auto along = [&](int axis) {
        const Span span(mix, axis, size);
        return waves_at(mix.ends[static_cast<std::size_t>(axis)], (x[axis] - span.begin) / span.length);
    };
    const auto a = along(0), b = along(1), c = along(2);
    double sum = 0.0;
    for (std::size_t which = 0; which < 8; ++which)
        sum += factors[which] * a[which & 1] * b[(which >> 1) & 1] * c[which >> 2];
    return sum;
}

// |phi - truth| / |truth|, where the truth is the sum of the products with `factors`.
double poisson_error(const VerifySetting& setting, const Mix& mix, int size, const Products& factors) {
    const Box box = poisson_box(mix, size);
    Workspace work = workspace_of(box, setting);
    Products right_side = squares_of(mix, size);
    for (double& value : right_side)
        value = -value;
    CellScalars phi = scalars_of(box, [&](glm::dvec3 x) { return sum_at(mix, size, right_side, x); });
    solve_poisson(work, phi);
    return scalar_error(box, phi, [&](glm::dvec3 x) { return sum_at(mix, size, factors, x); });
}

VerifyRow manufactured(const VerifySetting& setting, const Mix& mix, int size) {
    Products ones{};
    ones.fill(1.0);
    const Products factors = factors_on_grid(mix, size);
    double off = 0.0, all = 0.0; // all products of size 1 have the same mean square
    for (std::size_t which = 0; which < 8; ++which) {
        const double weight = std::pow(k_sizes[which & 1] * k_sizes[(which >> 1) & 1] * k_sizes[which >> 2], 2.0);
        off += weight * std::pow(factors[which] - 1.0, 2.0);
        all += weight;
    }
    return {
        .cells = size * k_metres, .error = poisson_error(setting, mix, size, ones), .bound = 1.001 * std::sqrt(off / all) + 1e-6};
}

VerifyRow on_grid(const VerifySetting& setting, int size) {
    VerifyRow row{.cells = size * k_metres, .bound = 4.4e-6};
    for (const Mix& mix : k_mixes)
        row.error = worse(row.error, poisson_error(setting, mix, size, factors_on_grid(mix, size)));
    return row;
}

} // namespace

std::vector<VerifyCase> poisson_cases() {
    std::vector<VerifyCase> cases;
    for (const Mix& mix : k_mixes)
        cases.push_back(
            {.name = mix.name,
             .what = std::string("The pressure of a known right side, ") + mix.words +
                     ", odd numbers of cells; error of the pressure.",
             .source = "a product of waves that obey the boundaries: manufactured as in Roache 2002, J. Fluids Eng. 124",
             .reason = "the error that the waves' closed form gives, and a thousandth more; of order 2 in cells over "
                       "the waves' length, which is up to a cell more than the box's: 1.78 from 5 cells to 15",
             .min_order = Span(mix, 0, 1).length + Span(mix, 2, 1).length > k_metres.x + k_metres.z ? 1.75 : 1.9,
             .runs_on = RunsOn::cpu,
             .sizes = {1, 3, 9},
             .run = [mix](const VerifySetting& setting, int size) { return manufactured(setting, mix, size); }});
    cases.push_back({.name = "poisson_on_grid",
                     .what = "The pressures of the other Poisson cases beside the grid's own solutions; worst error of the "
                             "pressure over all boundaries.",
                     .source = "k^2 / sum (2 / h sin(k h / 2))^2 times each wave, written out",
                     .reason = "a direct solve is exact up to rounding, which the longest waves amplify: 2.2e-6 is measured, "
                               "twice as much is admitted",
                     .runs_on = RunsOn::cpu,
                     .sizes = {1, 3, 9},
                     .run = on_grid});
    return cases;
}

} // namespace windrow::cases
