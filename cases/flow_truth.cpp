#include "cases/flow_truth.h"

#include "cases/cell_values.h"
#include "cases/cubic_factor.h"
#include "cases/flow_wind.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace windrow::cases {
namespace {

/// Four neighbouring cells along an axis and their weights.
struct NodeWeights {
    int first = 0;
    int count = 1;
    std::array<double, 4> weights{1.0};
};

// Lagrange's polynomial through the four cells around a place, moved inside at the ends of the axis.
NodeWeights stencil_at(double place, int cells) {
    constexpr int k_nodes = 4;
    if (cells < k_nodes)
        return {.first = std::clamp(static_cast<int>(std::lround(place)), 0, cells - 1)};
    NodeWeights stencil{.first = std::clamp(static_cast<int>(std::floor(place)) - 1, 0, cells - k_nodes), .count = k_nodes};
    stencil.weights = cubic_weights(place - stencil.first - 1);
    return stencil;
}

} // namespace

Result<std::optional<FlowTruth>> FlowTruth::find(const ParetoFlow& flow, Simd simd, const ParallelFor& parallel_for,
                                                 const std::function<bool()>& stopped) {
    const auto still = FlowWind::create(flow, flow.grids.front(), {});
    if (!still)
        return still.failure();
    AmbientWind ambient = still->ambient();
    ambient.advance(flow.end);
    FlowTruth truth(flow, ambient);
    if (flow.exact)
        return std::optional(std::move(truth));
    auto wind = FlowWind::create(flow, flow.reference, {.simd = simd, .parallel_for = parallel_for});
    if (!wind)
        return wind.failure();
    const int steps = steps_of(flow, flow.reference, 1.0);
    for (int n = 0; n < steps; ++n) {
        if (stopped())
            return std::optional<FlowTruth>();
        wind->step(flow.end / steps);
    }
    truth.reference_.assign(wind->field().begin(), wind->field().end());
    return std::optional(std::move(truth));
}

CellTruth FlowTruth::at_centres(glm::ivec3 cells) const {
    const Box box = box_of(*flow_, cells);
    CellTruth truth{.velocity = std::vector<glm::dvec3>(box.cell_count()),
                    .counted = std::vector<std::uint8_t>(box.cell_count())};
    const glm::dvec3 ratio = glm::dvec3(flow_->reference) / glm::dvec3(cells);
    double squares = 0.0;
    visit_cells(box, [&](std::size_t n, glm::dvec3 x) {
        if (!counts(*flow_, x))
            return;
        truth.counted[n] = 1;
        truth.velocity[n] = flow_->exact ? flow_->exact(x) : sample(x / static_cast<double>(box.cell_size) * ratio - 0.5);
        const glm::dvec3 perturbation = truth.velocity[n] - glm::dvec3(ambient_.velocity(x));
        squares += glm::dot(perturbation, perturbation);
    });
    truth.perturbation = std::sqrt(squares);
    return truth;
}

glm::dvec3 FlowTruth::sample(glm::dvec3 cell) const {
    const Box box = box_of(*flow_, flow_->reference);
    const NodeWeights x = stencil_at(cell.x, box.cells.x), y = stencil_at(cell.y, box.cells.y),
                      z = stencil_at(cell.z, box.cells.z);
    glm::dvec3 sum(0.0);
    for (int k = 0; k < z.count; ++k)
        for (int j = 0; j < y.count; ++j)
            for (int i = 0; i < x.count; ++i)
                sum += x.weights[i] * y.weights[j] * z.weights[k] *
                       glm::dvec3(reference_[box.index(x.first + i, y.first + j, z.first + k)]);
    return sum;
}

double flow_error(std::span<const glm::vec4> u, const CellTruth& truth) {
    double squares = 0.0;
    for (std::size_t n = 0; n < u.size(); ++n) {
        if (truth.counted[n] == 0)
            continue;
        const glm::dvec3 off = glm::dvec3(u[n]) - truth.velocity[n];
        squares += glm::dot(off, off);
    }
    return std::sqrt(squares) / truth.perturbation;
}

} // namespace windrow::cases
