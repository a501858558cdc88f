#include "fluid/cpu/separable_solver.h"

#include "fluid/box.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace windrow::cpu {
namespace {

constexpr int round_up(int value) {
    return (value + k_lanes - 1) / k_lanes * k_lanes;
}

// The one column of a singular box whose tridiagonal system has no inverse: solved in double for mean 0.
// x[j+1] - x[j] = flux + d[0] + .. + d[j]; walls give flux 0, a periodic axis the flux that closes the ring.
// In rows of unequal thickness d counts by thickness, and a flux makes a difference of its own.
void solve_singular_column(const double* d, int rows, bool periodic, const ColumnRows& law, float* column) {
    if (!law.empty()) {
        double mean = 0.0, whole = 0.0, x_mean = 0.0, flux = 0.0;
        for (std::size_t j = 0; j < law.thickness.size(); ++j)
            mean += law.thickness[j] * d[j], whole += law.thickness[j];
        mean /= whole;
        double x[k_max_axis_cells] = {};
        for (std::size_t j = 0; j + 1 < law.thickness.size(); ++j) {
            flux += law.thickness[j] * (d[j] - mean);
            x[j + 1] = x[j] + flux / law.links[j + 1];
            x_mean += law.thickness[j + 1] * x[j + 1] / whole;
        }
        for (int j = 0; j < rows; ++j)
            column[j * k_lanes] = static_cast<float>(x[j] - x_mean);
        return;
    }
    double mean = 0.0;
    for (int j = 0; j < rows; ++j)
        mean += d[j] / rows;
    double running = 0.0, flux = 0.0;
    if (periodic) {
        double total = 0.0;
        for (int j = 0; j < rows; ++j)
            total += running += d[j] - mean;
        flux = -total / rows;
    }
    double x[k_max_axis_cells];
    double x_mean = 0.0;
    running = x[0] = 0.0;
    for (int j = 0; j + 1 < rows; ++j) {
        running += d[j] - mean;
        x[j + 1] = x[j] + flux + running;
        x_mean += x[j + 1] / rows;
    }
    for (int j = 0; j < rows; ++j)
        column[j * k_lanes] = static_cast<float>(x[j] - x_mean);
}

} // namespace

SeparableSolver::Matrix::Matrix(const std::vector<double>& values, int n)
    : forward(static_cast<std::size_t>(n) * round_up(n)), backward(static_cast<std::size_t>(n) * round_up(n)), size(n),
      stride(round_up(n)) {
    for (int mode = 0; mode < n; ++mode)
        for (int cell = 0; cell < n; ++cell) {
            const auto value = static_cast<float>(values[static_cast<std::size_t>(mode) * n + cell]);
            forward[static_cast<std::size_t>(cell) * stride + mode] = value;
            backward[static_cast<std::size_t>(mode) * stride + cell] = value;
        }
}

SeparableSolver::SeparableSolver(glm::ivec3 cells, const Ends& ends, const Kernels& kernels, ColumnRows rows)
    : cells_(cells), ends_(ends), kernels_(&kernels), basis_x_(cells.x, ends[0][0], ends[0][1]),
      basis_z_(cells.z, ends[2][0], ends[2][1]), x_even_(basis_x_.even, basis_x_.even_size),
      x_odd_(basis_x_.odd, basis_x_.odd_size), z_even_(basis_z_.even, basis_z_.even_size),
      z_odd_(basis_z_.odd, basis_z_.odd_size), rows_(std::move(rows)) {
    for (std::size_t j = 0; j < rows_.scales.size(); ++j) {
        scale_in_.push_back(static_cast<float>(rows_.scales[j] * rows_.thickness[j]));
        scale_out_.push_back(static_cast<float>(rows_.scales[j]));
    }
    for (AxisBasis* const basis : {&basis_x_, &basis_z_}) { // copied to the matrices
        basis->even = std::vector<double>();
        basis->odd = std::vector<double>();
    }
    odd_offset_ = round_up(basis_x_.even_size);
    pitch_ = std::max(round_up(cells.x), odd_offset_ + round_up(basis_x_.odd_size));
    cyclic_ = is_cyclic(ends[1], cells.y);
    singular_ = true;
    for (const auto& axis : ends)
        for (const EndRule rule : axis)
            singular_ = singular_ && (rule == EndRule::even_at_face || rule == EndRule::periodic);
    pivots_ = Buffer<float>(buffer_size());
    if (cyclic_) {
        cyclic_vectors_ = Buffer<float>(buffer_size());
        cyclic_factors_ = Buffer<float>(static_cast<std::size_t>(pitch_) * cells.z * 2);
    }
}

std::size_t SeparableSolver::buffer_size() const {
    return static_cast<std::size_t>(pitch_) * static_cast<std::size_t>(cells_.y) * static_cast<std::size_t>(cells_.z);
}

// One line more than the rows, so that the modes' lines of a row do not meet in the same sets of a cache.
std::ptrdiff_t SeparableSolver::mode_stride() const {
    return (static_cast<std::ptrdiff_t>(cells_.y) + 1) * k_lanes;
}

std::ptrdiff_t SeparableSolver::block_size() const {
    return (mode_stride() + k_lanes) * cells_.z;
}

std::size_t SeparableSolver::scratch_size() const {
    return static_cast<std::size_t>(block_size()) * static_cast<std::size_t>(pitch_ / k_lanes);
}

std::size_t SeparableSolver::memory_bytes() const {
    std::size_t bytes = pivots_.bytes() + cyclic_vectors_.bytes() + cyclic_factors_.bytes();
    for (const Matrix* matrix : {&x_even_, &x_odd_, &z_even_, &z_odd_})
        bytes += matrix->forward.bytes() + matrix->backward.bytes();
    for (const AxisBasis* basis : {&basis_x_, &basis_z_})
        bytes += basis->eigenvalues.capacity() * sizeof(double);
    return bytes;
}

double SeparableSolver::eigenvalue_x(int lane) const {
    if (lane < basis_x_.even_size)
        return basis_x_.eigenvalues[lane];
    const int odd = lane - odd_offset_;
    if (odd >= 0 && odd < basis_x_.odd_size)
        return basis_x_.eigenvalues[basis_x_.even_size + odd];
    return 1.0; // padding: marked by 1, which is no mode's eigenvalue
}

void SeparableSolver::set_shift(double shift, const ParallelFor& parallel_for) {
    if (shift == shift_)
        return;
    shift_ = shift;
    parallel_for(pitch_ / k_lanes, [this](int block) { factor_block(block); });
}

void SeparableSolver::factor_block(int block) {
    const int rows = cells_.y;
    const std::size_t mode_stride = static_cast<std::size_t>(rows) * k_lanes;
    const std::size_t block_stride = mode_stride * cells_.z;
    double pivot[k_max_axis_cells], vector[k_max_axis_cells];
    for (int mode = 0; mode < cells_.z; ++mode)
        for (int lane = 0; lane < k_lanes; ++lane) {
            const std::size_t at = block * block_stride + mode * mode_stride + lane;
            const double lambda_x = eigenvalue_x(block * k_lanes + lane);
            const double base = -2.0 + lambda_x + basis_z_.eigenvalues[mode] - shift_;
            const bool no_system = lambda_x > 0.0 || (base == -2.0 && singular_);
            if (no_system) {
                for (int j = 0; j < rows; ++j)
                    pivots_[at + j * k_lanes] = 0.0f;
                if (cyclic_)
                    for (int j = 0; j < rows; ++j)
                        cyclic_vectors_[at + j * k_lanes] = 0.0f;
                continue;
            }
            std::array<double, 2> factors{};
            factor_column(base, ends_[1], rows_, {pivot, static_cast<std::size_t>(rows)},
                          {vector, static_cast<std::size_t>(rows)}, factors);
            for (int j = 0; j < rows; ++j)
                pivots_[at + j * k_lanes] = static_cast<float>(pivot[j]);
            if (!cyclic_)
                continue;
            for (int j = 0; j < rows; ++j)
                cyclic_vectors_[at + j * k_lanes] = static_cast<float>(vector[j]);
            float* const stored =
                cyclic_factors_.data() + (static_cast<std::size_t>(block) * cells_.z + mode) * 2 * k_lanes + lane;
            stored[0] = static_cast<float>(factors[0]);
            stored[k_lanes] = static_cast<float>(factors[1]);
        }
}

void SeparableSolver::rows_to_modes(int plane, float* data, float* scratch) const {
    const std::ptrdiff_t pitch = pitch_;
    float* const rows = data + plane * cells_.y * pitch;
    float* const folded = scratch + plane * cells_.y * pitch;
    const int even = basis_x_.even_size, odd = basis_x_.odd_size;
    for (int j = 0; j < cells_.y; ++j)
        kernels_->fold_row({cells_.x, odd}, rows + j * pitch, odd_offset_, folded + j * pitch);
    kernels_->multiply({folded, pitch, x_even_.forward.data(), x_even_.stride, rows, pitch, cells_.y, x_even_.stride, even});
    if (odd > 0)
        kernels_->multiply({folded + odd_offset_, pitch, x_odd_.forward.data(), x_odd_.stride, rows + odd_offset_, pitch,
                            cells_.y, x_odd_.stride, odd});
}

void SeparableSolver::modes_to_rows(int plane, float* data, float* scratch) const {
    const std::ptrdiff_t pitch = pitch_;
    float* const rows = data + plane * cells_.y * pitch;
    float* const folded = scratch + plane * cells_.y * pitch;
    const int even = basis_x_.even_size, odd = basis_x_.odd_size;
    kernels_->multiply({rows, pitch, x_even_.backward.data(), x_even_.stride, folded, pitch, cells_.y, x_even_.stride, even});
    if (odd > 0)
        kernels_->multiply({rows + odd_offset_, pitch, x_odd_.backward.data(), x_odd_.stride, folded + odd_offset_, pitch,
                            cells_.y, x_odd_.stride, odd});
    for (int j = 0; j < cells_.y; ++j)
        kernels_->unfold_row({cells_.x, odd}, folded + j * pitch, odd_offset_, rows + j * pitch);
}

// A column's lines are one plane apart, a power of two in the usual boxes, so that they map to the same few sets of a cache.
// Each line is read once and written once, and processed in a dense copy.
void SeparableSolver::solve_block(int block, float* data, float* scratch) const {
    const int rows = cells_.y, modes = cells_.z, even = basis_z_.even_size, odd = basis_z_.odd_size;
    const std::ptrdiff_t plane = static_cast<std::ptrdiff_t>(pitch_) * rows;
    const std::ptrdiff_t stride = mode_stride(), pivots = static_cast<std::ptrdiff_t>(rows) * modes * k_lanes;
    float* const columns = data + block * k_lanes;
    float* const work = scratch + block * block_size();
    float* const line = work + stride * modes; // [modes][k_lanes]
    float* const line_odd = line + even * k_lanes;
    const Fold fold{modes, odd};
    for (int j = 0; j < rows; ++j) {
        float* const out = work + j * k_lanes;
        kernels_->fold_lines(fold, columns + static_cast<std::ptrdiff_t>(j) * pitch_, plane, line);
        kernels_->multiply({z_even_.backward.data(), z_even_.stride, line, k_lanes, out, stride, even, k_lanes, even});
        if (odd > 0)
            kernels_->multiply(
                {z_odd_.backward.data(), z_odd_.stride, line_odd, k_lanes, out + even * stride, stride, odd, k_lanes, odd});
    }
    const bool holds_singular = singular_ && shift_ == 0.0 && basis_x_.zero_mode / k_lanes == block;
    float* const column = work + basis_z_.zero_mode * stride + basis_x_.zero_mode % k_lanes;
    double saved[k_max_axis_cells];
    if (holds_singular)
        for (int j = 0; j < rows; ++j)
            saved[j] = column[j * k_lanes];
    kernels_->tridiagonal(
        {work, stride, pivots_.data() + block * pivots, cyclic_ ? cyclic_vectors_.data() + block * pivots : nullptr,
         cyclic_ ? cyclic_factors_.data() + static_cast<std::ptrdiff_t>(block) * modes * 2 * k_lanes : nullptr, modes, rows,
         scale_in_.empty() ? nullptr : scale_in_.data(), scale_out_.empty() ? nullptr : scale_out_.data()});
    if (holds_singular)
        solve_singular_column(saved, rows, ends_[1][0] == EndRule::periodic, rows_, column);
    for (int j = 0; j < rows; ++j) {
        const float* const in = work + j * k_lanes;
        kernels_->multiply({z_even_.forward.data(), z_even_.stride, in, stride, line, k_lanes, even, k_lanes, even});
        if (odd > 0)
            kernels_->multiply(
                {z_odd_.forward.data(), z_odd_.stride, in + even * stride, stride, line_odd, k_lanes, odd, k_lanes, odd});
        kernels_->unfold_lines(fold, line, columns + static_cast<std::ptrdiff_t>(j) * pitch_, plane);
    }
}

void SeparableSolver::solve(float* data, float* scratch, const ParallelFor& parallel_for) const {
    parallel_for(cells_.z, [&](int plane) { rows_to_modes(plane, data, scratch); });
    parallel_for(pitch_ / k_lanes, [&](int block) { solve_block(block, data, scratch); });
    parallel_for(cells_.z, [&](int plane) { modes_to_rows(plane, data, scratch); });
}

} // namespace windrow::cpu
