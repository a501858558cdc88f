// Plants that slow the wind.
//
//   law     a uniform wind among plants alone: u = u0 / (1 + c t |u0|), the exact solution of du/dt = -c |u| u
//   waves   a sheared wind over a field: the inflection at the plants' tops rolls up, and waves run over the field. Over real
//           canopies of all kinds they are Lambda = 8.1 L apart, L = U / (dU/dy) at the tops, as eddies of a mixing layer are.
//           Here: a field of plants `h` high under a wind that is held to 3 m/s three heights up; 16 h long, 4 h wide and high,
//           periodic; after 40 s for 80 s. Lambda is 2 pi over the mean wave number of the vertical wind at the tops, weighted
//           by its energy. A cell is h / size.
// Based on: Raupach, Finnigan & Brunet 1996, Boundary-Layer Meteorology 78.
#include "cases/whole_step.h"

#include <complex>

namespace windrow::cases {
namespace {

Boundaries over_floor() {
    return sides_of({BoundaryKind::periodic, BoundaryKind::periodic}, {BoundaryKind::free_slip, BoundaryKind::free_slip},
                    {BoundaryKind::periodic, BoundaryKind::periodic});
}

VerifyRows canopy_law(const VerifySetting& setting, int size) {
    Box box{.cells = {size, 4, size}, .cell_size = 0.5f, .boundaries = over_floor()};
    Config config = raw_config(box, 0.0, setting);
    config.canopy = Canopy{.height = 1.25f, .drag = 0.7f}; // two rows, and half of one
    config.stages = {.sources = true, .relaxation = false, .diffusion = false, .advection = false, .projection = false};
    const glm::dvec3 start(6.0, -2.0, 3.0);
    VerifyRow row{.cells = box.cells, .bound = 2e-6};
    for (const int steps : {1, 7, 100}) {
        const auto wind = wind_of(config, setting);
        wind->set_velocity([&](glm::dvec3) { return glm::vec3(start); });
        for (int step = 0; step < steps; ++step)
            row.cfl = worse(row.cfl, wind->step(2.0 / steps).cfl);
        const std::span<const glm::vec4> field = wind->field();
        visit_cells(box, [&](std::size_t n, glm::dvec3 x) {
            const double share = x.y < 1.0 ? 1.0 : x.y < 1.5 ? 0.5 : 0.0;
            const glm::dvec3 truth = start / (1.0 + 0.7 * 2.0 * share * glm::length(start));
            row.error = worse(row.error, glm::length(glm::dvec3(field[n]) - truth) / glm::length(start));
        });
    }
    return row;
}

// Energy of a row of the vertical wind by waves in its length, added to `energy`.
void add_spectrum(const std::vector<double>& line, std::vector<double>& energy) {
    const auto count = static_cast<int>(line.size());
    for (int waves = 1; waves < static_cast<int>(energy.size()); ++waves) {
        std::complex<double> sum = 0.0;
        for (int i = 0; i < count; ++i)
            sum += line[static_cast<std::size_t>(i)] * std::polar(1.0, -2.0 * k_pi * waves * i / count);
        energy[static_cast<std::size_t>(waves)] += std::norm(sum);
    }
}

// Stirred at the start by waves of `first` to `last` in the window's length, none of which is the answer.
VerifyRow canopy_waves(const VerifySetting& setting, int size, int first_wave, int last_wave) {
    constexpr double k_height = 0.8, k_wind = 3.0, k_published = 8.1, k_begin = 40.0, k_end = 120.0;
    const double h = k_height / size;
    Box box{.cells = {16 * size, 4 * size, 4 * size}, .cell_size = static_cast<float>(h), .boundaries = over_floor()};
    Config config = raw_config(box, 0.0, setting);
    config.canopy = Canopy{.height = static_cast<float>(k_height)};
    const auto wind = wind_of(config, setting);
    // Holds the upper air; wide enough that its weight is the same all along.
    static_cast<void>(
        wind->motors().add(DirectionalMotor{.position = {0.5 * 16.0 * k_height, 4.0 * k_height, 0.5 * 4.0 * k_height},
                                            .direction = {1.0f, 0.0f, 0.0f},
                                            .region = AlignedBox{{400.0f, static_cast<float>(1.2 * k_height), 400.0f}},
                                            .law = Drive{.speed = static_cast<float>(k_wind), .rate = 2.0f},
                                            .turbulence = {.intensity = 0.0f}}));
    wind->set_velocity([&](glm::dvec3 x) {
        const double shear = std::tanh((x.y - k_height) / (0.5 * k_height));
        const double stir = 0.05 * std::exp(-std::abs(x.y / k_height - 1.0));
        double up = 0.0;
        for (int n = first_wave; n <= last_wave; ++n) // no two in step
            up += std::sin(2.0 * k_pi * (n * x.x / 16.0 + (n % 4) * x.z / 4.0) / k_height + 1.7 * n * n);
        return glm::vec3(0.5 * k_wind * (1.0 + shear), stir * up, 0.3 * stir * up);
    });
    const double dt = h / k_wind;
    const int steps = static_cast<int>(k_end / dt), first = static_cast<int>(k_begin / dt);
    VerifyRow row{.cells = box.cells};
    std::vector<double> profile(static_cast<std::size_t>(box.cells.y)), energy(static_cast<std::size_t>(box.cells.x / 2)),
        line(static_cast<std::size_t>(box.cells.x));
    for (int step = 0; step < steps; ++step) {
        row.cfl = worse(row.cfl, wind->step(dt).cfl);
        if (step < first || step % (2 * size) != 0)
            continue;
        const std::span<const glm::vec4> field = wind->field();
        visit_cells(box, [&](std::size_t n, glm::dvec3 x) { profile[static_cast<std::size_t>(x.y / h)] += field[n].x; });
        for (int k = 0; k < box.cells.z; ++k) {
            for (int i = 0; i < box.cells.x; ++i) // at the tops: between two rows
                line[static_cast<std::size_t>(i)] = 0.5 * (field[box.index(i, size - 1, k)].y + field[box.index(i, size, k)].y);
            add_spectrum(line, energy);
        }
    }
    double mean = 0.0, all = 0.0;
    for (std::size_t n = 1; n < energy.size(); ++n) {
        mean += static_cast<double>(n) * energy[n];
        all += energy[n];
    }
    const double apart = 16.0 * k_height * all / mean;
    const double below = profile[static_cast<std::size_t>(size - 1)], above = profile[static_cast<std::size_t>(size)];
    const double shear_length = 0.5 * (above + below) * h / (above - below);
    row.error = std::abs(std::log(apart / shear_length / k_published));
    row.bound = size >= 8 ? 0.25 : size >= 4 ? 0.65 : 1.2;
    return row;
}

} // namespace

std::vector<VerifyCase> canopy_cases() {
    return {
        {.name = "canopy_law",
         .what = "A uniform wind among plants for two seconds in 1, 7 and 100 steps, nothing else acting; error over its speed.",
         .source = "du/dt = -c |u| u: u0 / (1 + c t |u0|)",
         .reason = "the law is what is computed: rounding alone is left, of a hundred steps",
         .sizes = {4, 8},
         .run = canopy_law},
        {.name = "canopy_waves",
         .what = "Waves that nobody keyed over a field of plants under a sheared wind, a cell 1/2, 1/4 and 1/8 of the plants' "
                 "height; |ln| of their distance over 8.1 shear lengths at the tops.",
         .source = "Raupach, Finnigan & Brunet 1996, Boundary-Layer Meteorol. 78: 8.1 shear lengths over canopies of all kinds",
         .reason =
             "measured are 0.70 and 0.90, 0.40 and 0.37, 0.09 and 0.09, and room for a chaotic flow: with 8 cells a height the "
             "waves are those of fields, with 2 they are half as many",
         .guards = true,
         .sizes = {2, 4, 8},
         .run =
             [](const VerifySetting& setting, int size) {
                 VerifyRow by_long = canopy_waves(setting, size, 1, 2),
                           by_short = canopy_waves(setting, size, 3 * size / 2, 3 * size);
                 by_long.label = "stirred by long waves";
                 by_short.label = "stirred by short waves";
                 return VerifyRows(std::vector{by_long, by_short});
             }},
    };
}

} // namespace windrow::cases
