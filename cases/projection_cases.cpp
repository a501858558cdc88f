// What a projection does to fields that it must take or leave.
//
// Divergence and gradient span two cells, the Laplacian one. Of a wave c cos(k.x + p), angles theta = k h, s = sin(theta), this
// part is taken:
//     s (s . c) / (4 sum sin^2(theta / 2))
// That is all of a gradient c = k and nothing of a c across k, both to order h^2. PlaneWaves do not mix, so that a sum of them has a
// closed form. Based on: Almgren, Bell & Szymczak 1996, SIAM Journal on Scientific Computing 17 (approximate projections).
#include "cases/one_stage.h"

#include <array>

namespace windrow::cases {
namespace {

struct PlaneWave {
    glm::dvec3 k;    ///< [1/m]
    glm::dvec3 size; ///< [m/s]
    double phase;
};
using PlaneWaves = std::array<PlaneWave, 4>;

// No two wave vectors are alike, so that the waves are orthogonal.
constexpr PlaneWaves k_gradients = {
    {{{1, 2, 1}, {1, 2, 1}, 0.3}, {{2, -1, 0}, {2, -1, 0}, 1.1}, {{0, 1, -3}, {0, 1, -3}, -0.7}, {{1, 0, 0}, {1, 0, 0}, 2.0}}};
constexpr PlaneWaves k_solenoidal = {
    {{{1, 2, 1}, {1, 0, -1}, 0.3}, {{2, -1, 0}, {1, 2, 1}, 1.1}, {{0, 1, -3}, {0.5, 3, 1}, -0.7}, {{1, 3, 2}, {-3, 1, 0}, 2.0}}};

PlaneWaves taken_from(const PlaneWaves& waves, double h) {
    PlaneWaves taken = waves;
    for (PlaneWave& wave : taken) {
        const glm::dvec3 s = glm::sin(wave.k * h), half = glm::sin(0.5 * wave.k * h);
        wave.size = s * glm::dot(s, wave.size) / (4.0 * glm::dot(half, half));
    }
    return taken;
}

PlaneWaves difference(const PlaneWaves& a, const PlaneWaves& b) {
    PlaneWaves off = a;
    for (std::size_t n = 0; n < off.size(); ++n)
        off[n].size -= b[n].size;
    return off;
}

double root_square(const PlaneWaves& waves) {
    double sum = 0.0;
    for (const PlaneWave& wave : waves)
        sum += glm::dot(wave.size, wave.size);
    return std::sqrt(sum);
}

glm::dvec3 sum_at(const PlaneWaves& waves, glm::dvec3 x) {
    glm::dvec3 u(0.0);
    for (const PlaneWave& wave : waves)
        u += std::cos(glm::dot(wave.k, x) + wave.phase) * wave.size;
    return u;
}

Box box_of(int size) {
    return periodic_box(glm::ivec3(size), 2.0 * k_pi / size);
}

// rms of (projected waves - truth) over rms of the waves.
double projection_error(const VerifySetting& setting, int size, const PlaneWaves& waves, const PlaneWaves& truth) {
    const Box box = box_of(size);
    CellVelocities u = velocities_of(box, [&](glm::dvec3 x) { return sum_at(waves, x); });
    OneStage::projection(box, setting).run(u);
    double off = 0.0, all = 0.0;
    visit_cells(box, [&](std::size_t n, glm::dvec3 x) {
        const glm::dvec3 wrong = glm::dvec3(u[n]) - sum_at(truth, x), start = sum_at(waves, x);
        off += glm::dot(wrong, wrong);
        all += glm::dot(start, start);
    });
    return std::sqrt(off / all);
}

VerifyRow gradient(const VerifySetting& setting, int size) {
    const PlaneWaves left = difference(k_gradients, taken_from(k_gradients, box_of(size).cell_size));
    return {.cells = glm::ivec3(size),
            .error = projection_error(setting, size, k_gradients, difference(k_gradients, k_gradients)),
            .bound = 1.001 * root_square(left) / root_square(k_gradients) + 1e-6};
}

VerifyRow solenoidal(const VerifySetting& setting, int size) {
    const PlaneWaves taken = taken_from(k_solenoidal, box_of(size).cell_size);
    return {.cells = glm::ivec3(size),
            .error = projection_error(setting, size, k_solenoidal, k_solenoidal),
            .bound = 1.001 * root_square(taken) / root_square(k_solenoidal) + 1e-6};
}

VerifyRow projected_on_grid(const VerifySetting& setting, int size) {
    VerifyRow row{.cells = glm::ivec3(size), .bound = 1.5e-6};
    for (const PlaneWaves& waves : {k_gradients, k_solenoidal})
        row.error = worse(row.error,
                          projection_error(setting, size, waves, difference(waves, taken_from(waves, box_of(size).cell_size))));
    return row;
}

} // namespace

std::vector<VerifyCase> projection_cases() {
    const char* const source =
        "Almgren, Bell & Szymczak 1996, SIAM J. Sci. Comput. 17 (approximate projections); the factor of each wave, written out";
    return {
        {.name = "gradient_vanishes",
         .what = "A projection of a pure gradient, four waves; what is left of it.",
         .source = source,
         .reason = "what the closed form leaves, and a thousandth more; it falls as h^2",
         .min_order = 1.9,
         .sizes = {32, 64, 128},
         .run = gradient},
        {.name = "solenoidal_stays",
         .what = "A projection of a field without divergence, four waves; what is taken of it.",
         .source = source,
         .reason = "what the closed form takes, and a thousandth more; it falls as h^2",
         .min_order = 1.9,
         .sizes = {32, 64, 128},
         .run = solenoidal},
        {.name = "projection_on_grid",
         .what =
             "A gradient and a field without divergence, projected, beside what the grid makes of their waves; the worse error.",
         .source = source,
         .reason = "a direct solve is exact up to rounding: 7.5e-7 is measured, twice as much is admitted",
         .sizes = {32, 64, 128},
         .run = projected_on_grid}};
}

} // namespace windrow::cases
