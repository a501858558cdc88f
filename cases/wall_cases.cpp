// Diffusion between walls, which lie half a cell beyond the last centres.
//
//   Couette    the high wall starts to slide at t = 0: u / U = y + sum_n 2 (-1)^n / (n pi) sin(n pi y) exp(-n^2 pi^2 t), y in
//              widths, t in width^2 / nu; at the end the straight line, which mirrored ghosts hold exactly. sin(n pi y) at N
//              centres is a mode of the mirrored ghosts: a step has the factor 1 - 4 r s or 1 / (1 + 4 r s) for it,
//              s = sin^2(n pi / 2 N)
//   Stokes     the wall swings as U cos(w t): u = U exp(-y / d) cos(w t - y / d), d = sqrt(2 nu / w). On the grid, once the start
//              has faded, u = Re U A q^(y / h) exp(i w t) with 1 - exp(-i w dt) or exp(i w dt) - 1 = r (q - 2 + 1 / q) and, for
//              the mean of the ghost and the first cell to be the wall's, A = 2 / (q^(1/2) + q^(-1/2))
//
// At a fixed r = nu dt / h^2 the step falls as h^2: order 2.
// Based on: Schlichting & Gersten 2017, Boundary-Layer Theory (unsteady Couette flow; Stokes' second problem).
#include "cases/one_stage.h"

#include <complex>
#include <string>

namespace windrow::cases {
namespace {

// A column of cells across the walls, along any axis; the walls slide along the next one.
struct Channel {
    Box box;
    int across, along;
};

Channel channel_of(int size, double width, int across, BoundaryKind high) {
    Channel channel{.box = periodic_box(glm::ivec3(1), width / size), .across = across, .along = (across + 1) % 3};
    channel.box.cells[across] = size;
    side_of(channel.box.boundaries, across, 0).kind = BoundaryKind::no_slip;
    side_of(channel.box.boundaries, across, 1).kind = high;
    return channel;
}

Boundaries sides_sliding(const Channel& channel, double low, double high) {
    Boundaries boundaries = channel.box.boundaries;
    side_of(boundaries, channel.across, 0).wall_velocity[channel.along] = static_cast<float>(low);
    if (high != 0.0)
        side_of(boundaries, channel.across, 1).wall_velocity[channel.along] = static_cast<float>(high);
    return boundaries;
}

double couette_at(double y, double t) {
    double u = y;
    for (int n = 1; n <= 60; ++n)
        u += 2.0 * (n % 2 == 0 ? 1.0 : -1.0) / (n * k_pi) * std::sin(n * k_pi * y) * std::exp(-n * n * k_pi * k_pi * t);
    return u;
}

int couette_steps(int size, double ratio, double end) {
    return static_cast<int>(std::lround(end * size * size / ratio));
}

// The error of the grid's own solution: its modes after all steps, beside the truth.
double couette_closed_form(int size, double ratio, double end, DiffusionMethod method) {
    const int steps = couette_steps(size, ratio, end);
    const double r = end * size * size / steps;
    const auto centre = [&](int j) { return (j + 0.5) / size; };
    std::vector<double> u(static_cast<std::size_t>(size));
    for (int j = 0; j < size; ++j)
        u[static_cast<std::size_t>(j)] = centre(j);
    for (int n = 1; n <= size; ++n) {
        double share = 0.0; // of the mode in -y, the start without the line
        for (int j = 0; j < size; ++j)
            share -= (n < size ? 2.0 : 1.0) / size * centre(j) * std::sin(n * k_pi * centre(j));
        const double decay = 4.0 * r * std::pow(std::sin(0.5 * n * k_pi / size), 2.0);
        const double left = std::pow(method == DiffusionMethod::one_pass ? 1.0 - decay : 1.0 / (1.0 + decay), steps);
        for (int j = 0; j < size; ++j)
            u[static_cast<std::size_t>(j)] += share * left * std::sin(n * k_pi * centre(j));
    }
    double squares = 0.0;
    for (int j = 0; j < size; ++j)
        squares += std::pow(u[static_cast<std::size_t>(j)] - couette_at(centre(j), end), 2.0);
    return std::sqrt(squares / size);
}

// Root of the mean square off the truth over the three axes, with U = 1 and nu = 1.
VerifyRow couette(const VerifySetting& setting, int size, double ratio, double end) {
    const int steps = couette_steps(size, ratio, end);
    VerifyRow row{.cells = {1, size, 1}};
    double squares = 0.0;
    for (int across = 0; across < 3; ++across) {
        Channel channel = channel_of(size, 1.0, across, BoundaryKind::no_slip);
        channel.box.boundaries = sides_sliding(channel, 0.0, 1.0);
        OneStage diffusion = OneStage::diffusion(channel.box, 1.0, setting);
        CellVelocities now(channel.box.cell_count(), glm::vec4(0.0f));
        for (int step = 0; step < steps; ++step)
            diffusion.run(now, static_cast<float>(end / steps));
        visit_cells(channel.box, [&](std::size_t n, glm::dvec3 x) {
            glm::dvec3 off(now[n]);
            off[channel.along] -= couette_at(x[across], end);
            squares += glm::dot(off, off);
        });
    }
    row.error = std::sqrt(squares / (3.0 * size));
    return row;
}

constexpr double k_width = 8.0, k_frequency = 2.0, k_viscosity = 1.0, k_end = 4.0 * k_pi / k_frequency;
int stokes_steps(int size, double ratio) {
    const double h = k_width / size;
    return static_cast<int>(std::ceil(k_end * k_viscosity / (ratio * h * h)));
}

// The error of the grid's own swing at the end, where w t is a whole number of turns.
double stokes_closed_form(int size, double ratio, DiffusionMethod method) {
    using Complex = std::complex<double>;
    const double h = k_width / size, dt = k_end / stokes_steps(size, ratio), r = k_viscosity * dt / (h * h);
    const Complex change =
        method == DiffusionMethod::one_pass ? std::polar(1.0, k_frequency * dt) - 1.0 : 1.0 - std::polar(1.0, -k_frequency * dt);
    // q + 1 / q = 2 + change / r; the root that fades.
    const Complex half = 1.0 + 0.5 * change / r, root = std::sqrt(half * half - 1.0);
    const Complex q = std::abs(half - root) < 1.0 ? half - root : half + root;
    const Complex share = 2.0 / (std::sqrt(q) + 1.0 / std::sqrt(q));
    double squares = 0.0;
    for (int j = 0; j < size / 2; ++j) {
        const double y = (j + 0.5) * h;
        squares += std::pow((share * std::pow(q, j + 0.5)).real() - std::exp(-y) * std::cos(y), 2.0);
    }
    return std::sqrt(squares / (size / 2));
}

// After two swings, of the flow within 4 d of the wall, over the wall's speed. d = 1 m; the far wall, 8 d away, lets the air
// slip.
VerifyRow stokes(const VerifySetting& setting, int size, double ratio, DiffusionMethod method) {
    const int steps = stokes_steps(size, ratio);
    const double dt = k_end / steps;
    VerifyRow row{.cells = {1, size, 1}};
    double squares = 0.0;
    int count = 0;
    for (int across = 0; across < 3; ++across) {
        const Channel channel = channel_of(size, k_width, across, BoundaryKind::free_slip);
        OneStage diffusion = OneStage::diffusion(channel.box, k_viscosity, setting);
        const auto exact = [&](glm::dvec3 x, double t) {
            glm::dvec3 u(0.0);
            u[channel.along] = std::exp(-x[across]) * std::cos(k_frequency * t - x[across]);
            return u;
        };
        CellVelocities now = velocities_of(channel.box, [&](glm::dvec3 x) { return exact(x, 0.0); });
        for (int step = 0; step < steps; ++step) {
            // The wall as it is at the time whose neighbours the method reads: the old one in one pass, the new one implicitly.
            const double t = (method == DiffusionMethod::one_pass ? step : step + 1) * dt;
            diffusion.set_boundaries(sides_sliding(channel, std::cos(k_frequency * t), 0.0));
            diffusion.run(now, static_cast<float>(dt));
        }
        visit_cells(channel.box, [&](std::size_t n, glm::dvec3 x) {
            if (x[across] > 0.5 * k_width)
                return;
            const glm::dvec3 off = glm::dvec3(now[n]) - exact(x, k_end);
            squares += glm::dot(off, off);
            ++count;
        });
    }
    row.error = std::sqrt(squares / count);
    row.bound = 1.2 * stokes_closed_form(size, ratio, method);
    return row;
}

} // namespace

std::vector<VerifyCase> wall_cases() {
    struct StepCount {
        const char *name, *words;
        double couette_ratio, stokes_ratio;
        DiffusionMethod method;
    };
    std::vector<VerifyCase> couettes, swings;
    for (const StepCount& steps : {StepCount{"one_pass", "one-pass", 0.08, 0.08, DiffusionMethod::one_pass},
                                   StepCount{"implicit", "implicit", 0.32, 0.3, DiffusionMethod::implicit}}) {
        couettes.push_back(
            {.name = std::string("couette_") + steps.name,
             .what = std::string("Air between two walls, one of which starts to slide, across each axis, in ") + steps.words +
                     " steps; error over the wall's speed.",
             .source = "Schlichting & Gersten 2017, Boundary-Layer Theory: unsteady Couette flow as a Fourier series",
             .reason = "the error of the grid's own solution, mode by mode, a hundredth more, and 3e-6 for the rounding of 5,000 "
                       "steps; of order 2",
             .min_order = 1.9,
             .sizes = {16, 32, 64},
             .run = [steps](const VerifySetting& setting, int size) {
                 VerifyRow row = couette(setting, size, steps.couette_ratio, 0.1);
                 row.bound = 1.01 * couette_closed_form(size, steps.couette_ratio, 0.1, steps.method) + 3e-6;
                 return row;
             }});
        swings.push_back(
            {.name = std::string("stokes_second_") + steps.name,
             .what = std::string("Air over a wall that swings, across each axis, in ") + steps.words +
                     " steps; error within four depths over the wall's speed.",
             .source = "Stokes 1851, Trans. Cambridge Philos. Soc. 9 (second problem); Schlichting & Gersten 2017",
             .reason = "the error of the grid's own swing, and a fifth more for what is left of the start; of order 2",
             .min_order = 1.9,
             .sizes = {16, 32, 64},
             .run = [steps](const VerifySetting& setting, int size) {
                 return stokes(setting, size, steps.stokes_ratio, steps.method);
             }});
    }
    couettes.push_back(
        {.name = "couette_steady",
         .what = "Air between two walls, one of which slides, across each axis, when it has become steady, in long implicit "
                 "steps; error over the wall's speed.",
         .source = "Couette's line u = U y, which mirrored ghosts hold exactly",
         .reason = "the line is a solution on the grid too; rounding alone is left, below ten units in a float's last place",
         .sizes = {16, 33, 64},
         .run = [](const VerifySetting& setting, int size) {
             VerifyRow row = couette(setting, size, 0.25 * size * size, 10.0);
             row.bound = 6e-7;
             return row;
         }});
    couettes.insert(couettes.end(), swings.begin(), swings.end());
    return couettes;
}

} // namespace windrow::cases
