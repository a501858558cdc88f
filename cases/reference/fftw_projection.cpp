// FFTW's part of fftw_projection.h: two arrays, a plan there and a plan back, and the columns between them.
#include "cases/reference/fftw_projection.h"

#include "cases/reference/kernels.h"

#include <cmath>
#include <cstddef>
#include <fftw3.h>
#include <numbers>
#include <vector>

namespace windrow::reference {
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

// An eigenvalue of the second difference with h = 1.
double eigenvalue(int n, int k) {
    const double half_sine = std::sin(std::numbers::pi * (k + 1) / (2.0 * (n + 1)));
    return -4.0 * half_sine * half_sine;
}

struct State {
    glm::ivec3 cells;
    std::size_t size;
    float scale; ///< h^2, and what FFTW leaves in a transform there and back
    Array values, spectrum;
    std::vector<float> pivots; ///< of the columns, laid out as the cells
    Plan there, back;
};

class PlannedProjection final : public FftwProjection {
  public:
    PlannedProjection(glm::ivec3 cells, float cell_size);
    std::span<float> values() override { return {state_.values.get(), state_.size}; }
    void solve() override;

  private:
    State state_;
};

PlannedProjection::PlannedProjection(glm::ivec3 cells, float cell_size) {
    State& state = state_;
    state.cells = cells;
    state.size = static_cast<std::size_t>(cells.x) * static_cast<std::size_t>(cells.y) * static_cast<std::size_t>(cells.z);
    state.scale = cell_size * cell_size / (4.0f * static_cast<float>(cells.x + 1) * static_cast<float>(cells.z + 1));
    state.values = allocate(state.size);
    state.spectrum = allocate(state.size);
    const int plane = cells.x * cells.y;
    const fftwf_iodim planes{cells.z, plane, plane}, row{cells.x, 1, 1}, rows{cells.y, cells.x, cells.x};
    const fftwf_iodim axes[] = {planes, row};
    constexpr fftwf_r2r_kind k_kinds[] = {FFTW_RODFT00, FFTW_RODFT00};
    const auto plan = [&](float* from, float* to) {
        return fftwf_plan_guru_r2r(2, axes, 1, &rows, from, to, k_kinds, FFTW_MEASURE | FFTW_DESTROY_INPUT);
    };
    state.there.reset(plan(state.values.get(), state.spectrum.get()));
    state.back.reset(plan(state.spectrum.get(), state.values.get()));
    state.pivots.resize(state.size);
    for (int k = 0; k < cells.z; ++k)
        for (int i = 0; i < cells.x; ++i) {
            const double base = eigenvalue(cells.x, i) + eigenvalue(cells.z, k) - 2.0;
            double pivot = 0.0;
            for (int j = 0; j < cells.y; ++j) {
                pivot = 1.0 / (base + (j == 0 ? 1.0 : 0.0) - pivot);
                state.pivots[static_cast<std::size_t>(k) * plane + static_cast<std::size_t>(j) * cells.x + i] =
                    static_cast<float>(pivot);
            }
        }
}

void PlannedProjection::solve() {
    fftwf_execute(state_.there.get());
    const glm::ivec3 cells = state_.cells;
    const auto plane = static_cast<std::size_t>(cells.x) * static_cast<std::size_t>(cells.y);
    for (std::size_t first = 0; first < state_.size; first += plane)
        kernels_for(Simd::best)
            .solve_columns(state_.spectrum.get() + first, state_.pivots.data() + first, state_.scale, cells.x, cells.y);
    fftwf_execute(state_.back.get());
}

} // namespace

std::unique_ptr<FftwProjection> FftwProjection::create(glm::ivec3 cells, float cell_size) {
    return std::make_unique<PlannedProjection>(cells, cell_size);
}

} // namespace windrow::reference
