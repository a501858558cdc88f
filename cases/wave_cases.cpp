// Waves in a uniform wind, held against the closed form of a step (cubic_factor.h): the whole of it after some steps, and the
// order with which a wave that crosses a fixed distance comes to the truth.
#include "cases/cell_values.h"
#include "cases/cubic_factor.h"

#include <complex>
#include <new>

namespace windrow::cases {
namespace {

using Complex = std::complex<double>;

enum class Carrier { velocity, scalar };

struct WaveRun {
    Carrier carrier = Carrier::velocity;
    int axis = 0;
    int waves = 1;              ///< in the box
    float carried_cells = 0.0f; ///< in a step
    int steps = 1;
};

// The complex amplitude that a wave of amplitude 1 has after all steps. Two components carry its cosine and its sine; the scalar
// carries them one after the other.
Complex amplitude(Workspace& work, const WaveRun& run) {
    const Box& box = work.box();
    const double theta = 2.0 * k_pi * run.waves / box.cells[run.axis];
    glm::vec4 blow(0.3f, -0.45f, 0.6f, 0.0f);
    blow[run.axis] = run.carried_cells;
    const CellVelocities wind(box.cell_count(), blow);
    const auto phase = [&](glm::dvec3 x) { return theta * (x[run.axis] - 0.5); };
    CellVelocities pair =
        velocities_of(box, [&](glm::dvec3 x) { return glm::dvec3(std::cos(phase(x)), std::sin(phase(x)), 0.0); });
    if (run.carrier == Carrier::velocity) {
        CellVelocities next(pair.size());
        for (int step = 0; step < run.steps; ++step) {
            advect(work, Transport{.carried = pair, .velocity = wind, .dt = 1.0f}, next);
            std::swap(pair, next);
        }
    } else {
        CellScalars values(pair.size()), next(pair.size());
        for (int part = 0; part < 2; ++part) {
            for (std::size_t n = 0; n < values.size(); ++n)
                values[n] = pair[n][part];
            for (int step = 0; step < run.steps; ++step) {
                if (!advect(work, ScalarTransport{.carried = values, .velocity = wind, .dt = 1.0f}, next))
                    throw std::bad_alloc();
                std::swap(values, next);
            }
            for (std::size_t n = 0; n < values.size(); ++n)
                pair[n][part] = values[n];
        }
    }
    Complex sum = 0.0;
    visit_cells(box, [&](std::size_t n, glm::dvec3 x) { sum += Complex(pair[n].x, pair[n].y) * std::polar(1.0, -phase(x)); });
    return sum / static_cast<double>(box.cell_count());
}

// A box that is long along one axis.
Box wave_box(int axis, int size) {
    glm::ivec3 cells(3, 2, 4);
    cells[axis] = size;
    return periodic_box(cells);
}

template <class Measure>
double worst_of_axes(const VerifySetting& setting, int size, Measure&& measure) {
    double worst = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        Workspace work = workspace_of(wave_box(axis, size), setting);
        for (const Carrier carrier : {Carrier::velocity, Carrier::scalar})
            worst = worse(worst, measure(work, axis, carrier));
    }
    return worst;
}

VerifyRow fourier_modes(const VerifySetting& setting, int size) {
    constexpr int k_steps = 8;
    constexpr float k_carried[] = {0.25f, 0.5f, 0.77f, -0.4f, 2.6f};
    VerifyRow row{.cells = {size, 2, 4}, .cfl = 2.6, .bound = 2e-6};
    row.error = worst_of_axes(setting, size, [&](Workspace& work, int axis, Carrier carrier) {
        double worst = 0.0;
        for (const float carried : k_carried)
            for (int waves = 0; waves <= size / 2; ++waves) {
                const Complex measured = amplitude(
                    work, {.carrier = carrier, .axis = axis, .waves = waves, .carried_cells = carried, .steps = k_steps});
                const Complex factor = std::pow(cubic_factor(carried, 2.0 * k_pi * waves / size), k_steps);
                worst = worse(worst, std::abs(measured - factor));
            }
        return worst;
    });
    return row;
}

VerifyRow fourier_transit(const VerifySetting& setting, int size) {
    constexpr float k_cfl = 0.4f;
    constexpr int k_waves = 2;
    const int steps = static_cast<int>(std::lround(size / 0.4));
    VerifyRow row{.cells = {size, 2, 4}, .cfl = k_cfl};
    row.error = worst_of_axes(setting, size, [&](Workspace& work, int axis, Carrier carrier) {
        return std::abs(
            amplitude(work, {.carrier = carrier, .axis = axis, .waves = k_waves, .carried_cells = k_cfl, .steps = steps}) - 1.0);
    });
    row.bound = 1.01 * std::abs(std::pow(cubic_factor(k_cfl, 2.0 * k_pi * k_waves / size), steps) - 1.0) + 1e-6;
    return row;
}

} // namespace

std::vector<VerifyCase> wave_cases() {
    return {
        {.name = "fourier_modes",
         .what = "Every wave along each axis, eight steps of 0.25, 0.5, 0.77, -0.4 and 2.6 cells, as a velocity and as a scalar; "
                 "worst difference of its complex amplitude (damping and phase) from the closed form of the cubic weights.",
         .source = "Staniforth & Cote 1991, Mon. Weather Rev. 119; the factor of the weights, written out",
         .reason = "the closed form is what is computed; rounding alone is left, four units in a float's last place in each of "
                   "eight steps",
         .runs_on = RunsOn::cpu,
         .sizes = {16, 32, 64},
         .run = fourier_modes},
        {.name = "fourier_transit",
         .what = "Two waves that cross the box once, along each axis, as a velocity and as a scalar; worst |amplitude - 1|.",
         .source = "Staniforth & Cote 1991, Mon. Weather Rev. 119; the truth is the wave at its start",
         .reason = "the error that the closed form gives, and a hundredth more; of order 3, as the weights are",
         .min_order = 2.9,
         .runs_on = RunsOn::cpu,
         .sizes = {40, 80, 160},
         .run = fourier_transit},
    };
}

} // namespace windrow::cases
