// OpenVDB's part of vdb_poisson.h. The operator is the 7-point one of a staggered grid, as `solve` calls it: the other has its
// neighbours two cells away. Lengths are in cells, so the right-hand side is scaled by h^2.
#include "cases/reference/vdb_poisson.h"

#include <cassert>
#include <chrono>
#include <cstddef>
#include <openvdb/openvdb.h>
#include <openvdb/tools/PoissonSolver.h>
#include <tbb/task_arena.h>

namespace windrow::reference {
namespace {

namespace poisson = openvdb::tools::poisson;

constexpr int k_max_iterations = 10000;

// The term of a neighbour outside: phi = 0 there, or the cell itself below the floor.
struct OpenAndFloor {
    void operator()(const openvdb::Coord& cell, const openvdb::Coord& outside, double&, double& diagonal) const {
        if (outside.y() >= cell.y())
            diagonal -= 1.0;
    }
};

// tree -> dense or dense -> tree, `move` told each cell's value in the tree and its index.
template <class Iterator, class Move>
void for_each_cell(Iterator cell, glm::ivec3 cells, const Move& move) {
    for (; cell; ++cell) {
        const openvdb::Coord at = cell.getCoord();
        move(cell, (static_cast<std::size_t>(at.z()) * cells.y + at.y()) * cells.x + at.x());
    }
}

} // namespace

struct VdbPoisson::State {
    glm::ivec3 cells;
    float cell_size;
    tbb::task_arena arena;
    openvdb::FloatTree source{0.0f};
};

VdbPoisson::VdbPoisson(glm::ivec3 cells, float cell_size, int threads) {
    openvdb::initialize();
    state_ = std::make_unique<State>();
    state_->cells = cells;
    state_->cell_size = cell_size;
    state_->arena.initialize(threads);
    state_->source.denseFill(openvdb::CoordBBox({0, 0, 0}, {cells.x - 1, cells.y - 1, cells.z - 1}), 0.0f, true);
}

VdbPoisson::~VdbPoisson() = default;

VdbOutcome VdbPoisson::solve(std::span<const float> rhs, std::span<float> phi, VdbOutside outside, double tolerance) {
    State& state = *state_;
    assert(rhs.size() == state.source.activeVoxelCount() && phi.size() == rhs.size());
    const float scale = state.cell_size * state.cell_size;
    for_each_cell(state.source.beginValueOn(), state.cells, [&](auto& cell, std::size_t n) { cell.setValue(scale * rhs[n]); });

    auto found = openvdb::math::pcg::terminationDefaults<double>();
    found.iterations = k_max_iterations;
    found.relativeError = tolerance;
    found.absoluteError = 0.0;
    openvdb::util::NullInterrupter never;
    openvdb::FloatTree::Ptr result;
    constexpr bool k_staggered = true;
    VdbOutcome outcome;
    state.arena.execute([&] {
        const auto start = std::chrono::steady_clock::now();
        result = outside == VdbOutside::zero_cells
                     ? poisson::solve(state.source, found, never, k_staggered)
                     : poisson::solveWithBoundaryConditions(state.source, OpenAndFloor{}, found, never, k_staggered);
        outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    });
    outcome.relative_error = found.relativeError;
    outcome.iterations = found.iterations;
    outcome.converged = found.success;

    for_each_cell(result->cbeginValueOn(), state.cells, [&](auto& cell, std::size_t n) { phi[n] = *cell; });
    return outcome;
}

} // namespace windrow::reference
