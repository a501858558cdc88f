// Diffusion, du/dt = nu L u, away from walls; r = nu dt / h^2.
//
//   modes       of angles theta come out of a step times 1 - 4 r S (one pass, r <= 1/12) or 1 / (1 + 4 r S) (implicit),
//               S = sum over the axes of sin^2(theta / 2)
//   Gaussian    of variance s^2 has s^2 + 2 nu t later, its peak lower as the third power of s. Its waves have the factors above
//               where the truth has exp(-nu k^2 dt): order 2 in h at a fixed r
#include "cases/one_stage.h"

namespace windrow::cases {
namespace {

double mode_factor(double ratio, double s, DiffusionMethod method) {
    return method == DiffusionMethod::one_pass ? 1.0 - 4.0 * ratio * s : 1.0 / (1.0 + 4.0 * ratio * s);
}

// The ghost of a periodic boundary is the far side, so that these waves are the operator's own.
VerifyRow diffusion_modes(const VerifySetting& setting, int size) {
    constexpr double k_ratios[] = {1e-3, 1e-2, 0.08, 0.09, 1.0, 30.0, 1e3, 1e4};
    const Box box = periodic_box({size, size / 2 + 1, size + 2}); // one odd axis
    VerifyRow row{.cells = box.cells, .bound = 2e-6};
    const glm::ivec3 half = box.cells / 2;
    const glm::ivec3 modes[][3] = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                                   {{0, 0, 1}, {1, 1, 1}, {2, 3, 1}},
                                   {{half.x, 0, 0}, {0, half.y, 0}, {0, 0, half.z}},
                                   {half, {half.x, 1, half.z}, {half.x / 2, half.y / 2, half.z / 2}}};
    for (const double r : k_ratios) {
        OneStage diffusion = OneStage::diffusion(box, r, setting);
        for (const auto& mode : modes) { // one a component
            glm::dvec3 theta[3], factor;
            for (int c = 0; c < 3; ++c) {
                theta[c] = 2.0 * k_pi * glm::dvec3(mode[c]) / glm::dvec3(box.cells);
                const glm::dvec3 s = glm::sin(0.5 * theta[c]);
                factor[c] =
                    mode_factor(r, glm::dot(s, s), r <= 1.0 / 12.0 ? DiffusionMethod::one_pass : DiffusionMethod::implicit);
            }
            const auto wave = [&](glm::dvec3 x) {
                return glm::dvec3(std::cos(glm::dot(theta[0], x - 0.5)), std::cos(glm::dot(theta[1], x - 0.5)),
                                  std::cos(glm::dot(theta[2], x - 0.5)));
            };
            CellVelocities after = velocities_of(box, wave);
            diffusion.run(after, 1.0f);
            visit_cells(box, [&](std::size_t n, glm::dvec3 x) {
                const glm::dvec3 off = glm::abs(glm::dvec3(after[n]) - factor * wave(x));
                row.error = worse(row.error, worse(off.x, worse(off.y, off.z)));
            });
        }
    }
    return row;
}

// The time is a whole number of steps at every size.
constexpr double k_variance = 0.49, k_time = 0.64 / 3.0, k_viscosity = 1.0, k_width = 8.0;
int spreading_steps(int size, double ratio) {
    const double h = k_width / size;
    return static_cast<int>(std::lround(k_time * k_viscosity / (ratio * h * h)));
}

// What a method leaves of the Gaussian's waves; those of more than 16 turns in the box have no weight.
double spreading_closed_form(int size, double ratio, DiffusionMethod method) {
    constexpr int k_most = 16;
    const int steps = spreading_steps(size, ratio), most = std::min(k_most, size / 2 - 1);
    const double h = k_width / size, r = k_viscosity * k_time / steps / (h * h);
    double off = 0.0, all = 0.0;
    for (int x = -most; x <= most; ++x)
        for (int y = -most; y <= most; ++y)
            for (int z = -most; z <= most; ++z) {
                const glm::dvec3 k = 2.0 * k_pi / k_width * glm::dvec3(x, y, z), s = glm::sin(0.5 * h * k);
                const double square = glm::dot(k, k), weight = std::exp(-k_variance * square);
                const double truth = std::exp(-k_viscosity * square * k_time);
                off += weight * std::pow(std::pow(mode_factor(r, glm::dot(s, s), method), steps) - truth, 2.0);
                all += weight * truth * truth;
            }
    return std::sqrt(off / all);
}

// A ball of air that moves, in a periodic box.
VerifyRow gaussian_spreading(const VerifySetting& setting, int size, double ratio, DiffusionMethod method) {
    const double h = k_width / size;
    const int steps = spreading_steps(size, ratio);
    const Box box = periodic_box(glm::ivec3(size), h);
    OneStage diffusion = OneStage::diffusion(box, k_viscosity, setting);
    const auto ball = [&](glm::dvec3 x, double t) {
        const double variance = k_variance + 2.0 * k_viscosity * t;
        const glm::dvec3 off = x - glm::dvec3(4.0, 4.1, 3.9);
        double value = std::pow(k_variance / variance, 1.5);
        for (int axis = 0; axis < 3; ++axis) { // with its images in the boxes beside
            double sum = 0.0;
            for (int image = -1; image <= 1; ++image)
                sum += std::exp(-0.5 * std::pow(off[axis] - image * k_width, 2.0) / variance);
            value *= sum;
        }
        return value * glm::dvec3(1.0, -2.0, 0.5);
    };
    CellVelocities now = velocities_of(box, [&](glm::dvec3 x) { return ball(x, 0.0); });
    for (int step = 0; step < steps; ++step)
        diffusion.run(now, static_cast<float>(k_time / steps));
    return {.cells = box.cells,
            .error = velocity_error(box, now, [&](glm::dvec3 x) { return ball(x, k_time); }),
            .bound = 1.01 * spreading_closed_form(size, ratio, method) + 1e-6};
}

} // namespace

std::vector<VerifyCase> diffusion_cases() {
    return {
        {.name = "diffusion_modes",
         .what = "Waves long and short over one step of r = 1e-3, 0.01, 0.08, 0.09, 1, 30, 1e3 and 1e4; worst difference from "
                 "the wave times the factor of the method that r asks for.",
         .source = "1 - 4 r S in one pass to r = 1/12, 1 / (1 + 4 r S) implicitly above, S = sum of sin^2(theta / 2)",
         .reason = "the factor is what is computed; rounding alone is left, which over sums of 66 terms stays below 2e-6",
         .sizes = {16, 32, 64},
         .run = diffusion_modes},
        {.name = "gaussian_spreading_one_pass",
         .what = "A Gaussian ball of air spreads in one-pass steps of r = 0.04; error of the velocity.",
         .source = "the heat kernel: variance + 2 nu t",
         .reason = "the error that the factors of its waves give, and a hundredth more; of order 2",
         .min_order = 1.9,
         .sizes = {24, 48, 96},
         .run = [](const VerifySetting& setting,
                   int size) { return gaussian_spreading(setting, size, 0.04, DiffusionMethod::one_pass); }},
        {.name = "gaussian_spreading_implicit",
         .what = "A Gaussian ball of air spreads in implicit steps of r = 0.32; error of the velocity.",
         .source = "the heat kernel: variance + 2 nu t",
         .reason = "the error that the factors of its waves give, and a hundredth more; of order 2",
         .min_order = 1.9,
         .sizes = {24, 48, 96},
         .run = [](const VerifySetting& setting,
                   int size) { return gaussian_spreading(setting, size, 0.32, DiffusionMethod::implicit); }},
    };
}

} // namespace windrow::cases
