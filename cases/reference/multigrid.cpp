// Levels and cycles of Multigrid; the passes themselves lie in multigrid_planes.inl.
//
// Memory a cycle on the finest level: 64 B a cell, where 40 Jacobi sweeps move 480.
#include "cases/reference/multigrid.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace windrow::reference {
namespace {

static_assert(k_longest_row == k_max_axis_cells);

constexpr std::ptrdiff_t k_line = 16;         // [floats] rows begin on cache lines, with a ghost before
constexpr double k_finest = 1.0;              // width of the cells of the finest grid
constexpr std::size_t k_cells_for_all = 4096; // of fewer, a pass takes less than threads need to meet

std::size_t count_of(const int (&cells)[3]) {
    return static_cast<std::size_t>(cells[0]) * static_cast<std::size_t>(cells[1]) * static_cast<std::size_t>(cells[2]);
}

// Nothing differs along such an axis.
bool idle(std::size_t cells, const Boundaries& boundaries, int axis) {
    return cells == 1 && !boundaries.has_open(axis);
}

// 1 / roots of the Chebyshev polynomial of degree 2 on [1/d, 2].
std::array<float, 2> smoothing_weights(int dimensions) {
    const double low = 1.0 / std::max(dimensions, 1), high = 2.0;
    const double middle = 0.5 * (high + low), reach = 0.5 * (high - low) / std::numbers::sqrt2;
    return {static_cast<float>(1.0 / (middle - reach)), static_cast<float>(1.0 / (middle + reach))};
}

// As multigrid_planes.inl has it.
std::size_t parent_of(std::size_t cell, std::size_t coarse_count) {
    return std::min(cell / 2, coarse_count - 1);
}

ParallelFor loop_for(const int (&cells)[3], const ParallelFor& parallel_for) {
    return count_of(cells) < k_cells_for_all ? ParallelFor{} : parallel_for;
}

} // namespace

// A second difference in finite volumes: flux between two centres over their distance, divided by the cell's width. Beyond an
// open boundary the value 0 is at the centre of a cell of the finest grid.
Multigrid::Axis Multigrid::make_axis(std::vector<double> width, const Boundaries& boundaries, int axis) {
    Axis result;
    result.width = std::move(width);
    const std::size_t n = result.width.size();
    for (std::size_t i = 0; i < n; ++i) {
        const double here = result.width[i];
        double diagonal = 0.0;
        const auto weight_of = [&](int end) {
            const bool inside = end == 0 ? i > 0 : i + 1 < n;
            if (idle(n, boundaries, axis) || (!inside && boundaries.at(axis, end).solid()))
                return 0.0f;
            if (!inside && !boundaries.periodic(axis)) {
                diagonal += 2.0 / (here * (here + k_finest));
                return 0.0f;
            }
            const std::size_t beside = end == 0 ? (i + n - 1) % n : (i + 1) % n;
            const double weight = 2.0 / (here * (here + result.width[beside]));
            diagonal += weight;
            return static_cast<float>(weight);
        };
        result.low.push_back(weight_of(0));
        result.high.push_back(weight_of(1));
        const auto known = std::find(result.diagonal_parts.begin(), result.diagonal_parts.end(), diagonal);
        result.kind.push_back(static_cast<int>(known - result.diagonal_parts.begin()));
        if (known == result.diagonal_parts.end())
            result.diagonal_parts.push_back(diagonal);
    }
    return result;
}

// Interpolation is linear between the centres of coarse cells, between centre and 0 beyond an open boundary, constant to a wall.
void Multigrid::connect(Axis& fine, const Axis& coarse, const Boundaries& boundaries, int axis) {
    const std::size_t n = fine.width.size(), coarse_n = coarse.width.size();
    double low = 0.0, coarse_low = 0.0; // where the cells begin
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t parent = parent_of(i, coarse_n);
        if (i > 0 && parent != parent_of(i - 1, coarse_n))
            coarse_low += coarse.width[parent - 1];
        const double off = (low + 0.5 * fine.width[i]) - (coarse_low + 0.5 * coarse.width[parent]);
        low += fine.width[i];
        const int end = off < 0.0 ? 0 : 1;
        const bool inside = end == 0 ? parent > 0 : parent + 1 < coarse_n;
        double own = 1.0, other = 0.0;
        std::size_t beside = parent;
        if (off != 0.0 && (inside || boundaries.periodic(axis))) {
            beside = end == 0 ? (parent + coarse_n - 1) % coarse_n : (parent + 1) % coarse_n;
            other = std::abs(off) / (0.5 * (coarse.width[parent] + coarse.width[beside]));
            own = 1.0 - other;
        } else if (off != 0.0 && !boundaries.at(axis, end).solid()) {
            own = 1.0 - std::abs(off) / (0.5 * (coarse.width[parent] + k_finest));
        }
        fine.share.push_back(static_cast<float>(fine.width[i] / coarse.width[parent]));
        fine.parent.push_back(static_cast<float>(own));
        fine.neighbour.push_back(static_cast<float>(other));
        fine.neighbour_cell.push_back(static_cast<int>(beside));
    }
}

Multigrid::Level Multigrid::make_level(std::array<Axis, 3> axes, const Boundaries& boundaries) {
    Level level;
    level.axes = std::move(axes);
    int live = 0;
    for (int axis = 0; axis < 3; ++axis) {
        level.cells[axis] = static_cast<int>(level.axes[axis].width.size());
        level.periodic[axis] = boundaries.periodic(axis);
        live += level.cells[axis] > 1 ? 1 : 0;
    }
    level.weights = smoothing_weights(live);
    level.pitch = (level.cells[0] + 2 + k_line - 1) / k_line * k_line;
    const std::size_t floats = static_cast<std::size_t>(k_line + level.pitch * level.cells[1] * level.cells[2]);
    level.source = cpu::Buffer<float>(floats);
    level.now = cpu::Buffer<float>(floats);
    level.next = cpu::Buffer<float>(floats);
    const auto& [x, y, z] = level.axes;
    for (const double part_y : y.diagonal_parts)
        for (const double part_z : z.diagonal_parts)
            for (const int kind : x.kind) {
                const double sum = x.diagonal_parts[kind] + part_y + part_z;
                level.diagonal.push_back(static_cast<float>(sum));
                level.inverse.push_back(sum > 0.0 ? static_cast<float>(1.0 / sum) : 0.0f);
            }
    return level;
}

Multigrid::Multigrid(const Box& box, Simd simd) : kernels_(kernels_for(simd)) {
    std::array<Axis, 3> axes;
    for (int axis = 0; axis < 3; ++axis)
        axes[axis] = make_axis(std::vector<double>(box.cells[axis], k_finest), box.boundaries, axis);
    levels_.push_back(make_level(std::move(axes), box.boundaries));
    while (count_of(levels_.back().cells) > 1) {
        Level& fine = levels_.back();
        for (int axis = 0; axis < 3; ++axis) {
            const std::vector<double>& width = fine.axes[axis].width;
            std::vector<double> coarse(std::max<std::size_t>(width.size() / 2, 1), 0.0);
            for (std::size_t i = 0; i < width.size(); ++i)
                coarse[parent_of(i, coarse.size())] += width[i];
            axes[axis] = make_axis(std::move(coarse), box.boundaries, axis);
            connect(fine.axes[axis], axes[axis], box.boundaries, axis);
        }
        Level coarse = make_level(std::move(axes), box.boundaries);
        levels_.push_back(std::move(coarse));
    }
}

std::size_t Multigrid::place(int j, int k) const {
    const Level& finest = levels_[0];
    return static_cast<std::size_t>(k_line + (static_cast<std::ptrdiff_t>(k) * finest.cells[1] + j) * finest.pitch);
}

std::size_t Multigrid::memory_bytes() const {
    std::size_t bytes = 0;
    for (const Level& level : levels_)
        bytes += level.source.bytes() + level.now.bytes() + level.next.bytes();
    return bytes;
}

MultigridLevel Multigrid::Level::task() const {
    MultigridLevel result{};
    for (int axis = 0; axis < 3; ++axis) {
        result.cells[axis] = cells[axis];
        result.periodic[axis] = periodic[axis];
        result.low[axis] = axes[axis].low.data();
        result.high[axis] = axes[axis].high.data();
    }
    result.pitch = pitch;
    result.source = source.data() + k_line;
    result.diagonal = diagonal.data();
    result.inverse = inverse.data();
    result.kind[0] = axes[1].kind.data();
    result.kind[1] = axes[2].kind.data();
    result.kinds_of_z = static_cast<int>(axes[2].diagonal_parts.size());
    result.row_pitch = cells[0];
    return result;
}

void Multigrid::solve(int cycles, const ParallelFor& parallel_for) {
    for (int n = 0; n < cycles; ++n)
        cycle(0, n == 0, parallel_for);
}

void Multigrid::cycle(std::size_t number, bool from_zero, const ParallelFor& parallel_for) {
    Level& level = levels_[number];
    if (number + 1 == levels_.size()) {
        sweep(level, true, 1.0f, parallel_for); // a single cell: solved
        return;
    }
    Level& coarse = levels_[number + 1];
    sweep(level, from_zero, level.weights[0], parallel_for);
    sweep(level, false, level.weights[1], parallel_for);
    restrict_residual(level, coarse, parallel_for);
    cycle(number + 1, true, parallel_for);
    add_correction(level, coarse, parallel_for);
    sweep(level, false, level.weights[1], parallel_for);
    sweep(level, false, level.weights[0], parallel_for);
}

void Multigrid::sweep(Level& level, bool from_zero, float weight, const ParallelFor& parallel_for) {
    const MultigridSmooth task{.level = level.task(),
                               .now = from_zero ? nullptr : level.now.data() + k_line,
                               .next = level.next.data() + k_line,
                               .weight = weight};
    loop_for(level.cells, parallel_for)(level.cells[2], [&](int k) { kernels_.multigrid_smooth(task, k); });
    std::swap(level.now, level.next);
}

void Multigrid::restrict_residual(const Level& fine, Level& coarse, const ParallelFor& parallel_for) {
    MultigridRestrict task{};
    task.fine = fine.task();
    task.now = fine.now.data() + k_line;
    for (int axis = 0; axis < 3; ++axis) {
        task.coarse_cells[axis] = coarse.cells[axis];
        task.share[axis] = fine.axes[axis].share.data();
    }
    task.coarse_pitch = coarse.pitch;
    task.coarse = coarse.source.data() + k_line;
    loop_for(fine.cells, parallel_for)(coarse.cells[2], [&](int k) { kernels_.multigrid_restrict(task, k); });
}

void Multigrid::add_correction(Level& fine, const Level& coarse, const ParallelFor& parallel_for) {
    MultigridProlong task{};
    for (int axis = 0; axis < 3; ++axis) {
        task.cells[axis] = fine.cells[axis];
        task.coarse_cells[axis] = coarse.cells[axis];
        task.parent[axis] = fine.axes[axis].parent.data();
        task.neighbour[axis] = fine.axes[axis].neighbour.data();
        task.neighbour_cell[axis] = fine.axes[axis].neighbour_cell.data();
    }
    task.periodic_x = fine.periodic[0];
    task.pitch = fine.pitch;
    task.now = fine.now.data() + k_line;
    task.coarse_pitch = coarse.pitch;
    task.coarse = coarse.now.data() + k_line;
    loop_for(fine.cells, parallel_for)(fine.cells[2], [&](int k) { kernels_.multigrid_prolong(task, k); });
}

} // namespace windrow::reference
