// FFTW's part of fftw_projection.h: two arrays, a plan there and a plan back, and the reciprocal eigenvalues between them.
#include "tests/bench/reference/fftw_projection.h"

#include "tests/bench/reference/kernels.h"

#include <cmath>
#include <cstddef>
#include <fftw3.h>
#include <numbers>
#include <vector>

namespace windrow::bench {
namespace {

struct Free {
    void operator()(float* data) const { fftwf_free(data); }
};
using Array = std::unique_ptr<float[], Free>;

struct DestroyPlan {
    void operator()(fftwf_plan plan) const { fftwf_destroy_plan(plan); }
};
using Plan = std::unique_ptr<fftwf_plan_s, DestroyPlan>;

Array allocate(std::size_t size) {
    return Array(fftwf_alloc_real(size));
}

// Eigenvalues of the second difference with h = 1: -4 sin^2(pi (k + shift) / 2n); shift 1 for open ends, 1/2 over a floor.
std::vector<double> eigenvalues(int n, double shift) {
    std::vector<double> values(static_cast<std::size_t>(n));
    for (int k = 0; k < n; ++k) {
        const double half_sine = std::sin(std::numbers::pi * (k + shift) / (2.0 * n));
        values[static_cast<std::size_t>(k)] = -4.0 * half_sine * half_sine;
    }
    return values;
}

} // namespace

struct FftwProjection::State {
    std::size_t size;
    Array values, spectrum;
    std::vector<float> factors; ///< 1 / (eigenvalue [1/m^2] * 8 nx ny nz): FFTW does not scale its transforms
    Plan there, back;
};

FftwProjection::FftwProjection(glm::ivec3 cells, float cell_size) : state_(std::make_unique<State>()) {
    State& state = *state_;
    state.size = static_cast<std::size_t>(cells.x) * static_cast<std::size_t>(cells.y) * static_cast<std::size_t>(cells.z);
    state.values = allocate(state.size);
    state.spectrum = allocate(state.size);
    constexpr unsigned k_flags = FFTW_MEASURE | FFTW_DESTROY_INPUT;
    state.there.reset(fftwf_plan_r2r_3d(cells.z, cells.y, cells.x, state.values.get(), state.spectrum.get(), FFTW_RODFT10,
                                        FFTW_REDFT11, FFTW_RODFT10, k_flags));
    state.back.reset(fftwf_plan_r2r_3d(cells.z, cells.y, cells.x, state.spectrum.get(), state.values.get(), FFTW_RODFT01,
                                       FFTW_REDFT11, FFTW_RODFT01, k_flags));

    const std::vector<double> x = eigenvalues(cells.x, 1.0), y = eigenvalues(cells.y, 0.5), z = eigenvalues(cells.z, 1.0);
    const double scale = static_cast<double>(cell_size) * cell_size / (8.0 * static_cast<double>(state.size));
    state.factors.reserve(state.size);
    for (const double c : z)
        for (const double b : y)
            for (const double a : x)
                state.factors.push_back(static_cast<float>(scale / (a + b + c)));
}

FftwProjection::~FftwProjection() = default;

std::span<float> FftwProjection::values() {
    return {state_->values.get(), state_->size};
}

void FftwProjection::solve() {
    fftwf_execute(state_->there.get());
    kernels_for(Simd::best).multiply(state_->spectrum.get(), state_->factors.data(), state_->size);
    fftwf_execute(state_->back.get());
}

} // namespace windrow::bench
