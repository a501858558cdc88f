#include "fluid/vulkan/tables.h"

#include <cstddef>

namespace windrow::vulkan {
namespace {

// Inputs are the even part, then the odd one, each from the low end (modes.glsl). What the odd part lacks of an odd count is 0.
int append_vectors(const AxisBasis& basis, bool forward, std::vector<float>& values) {
    const auto begin = static_cast<int>(values.size());
    const int even = basis.even_size, odd = basis.odd_size;
    const auto at = [](const std::vector<double>& part, int size, int mode, int cell) {
        return static_cast<float>(part[static_cast<std::size_t>(mode) * size + cell]);
    };
    for (int from = 0; from < even; ++from)
        for (int to = 0; to < basis.count; ++to) {
            if (to < even)
                values.push_back(forward ? at(basis.even, even, to, from) : at(basis.even, even, from, to));
            else if (from < odd)
                values.push_back(forward ? at(basis.odd, odd, to - even, from) : at(basis.odd, odd, from, basis.count - 1 - to));
            else
                values.push_back(0.0f);
        }
    return begin;
}

SolveTables::Vectors append_both(const AxisBasis& x, const AxisBasis& z, std::vector<float>& values) {
    SolveTables::Vectors begin;
    begin.x_forward = append_vectors(x, true, values);
    begin.x_back = append_vectors(x, false, values);
    begin.z_forward = append_vectors(z, true, values);
    begin.z_back = append_vectors(z, false, values);
    begin.x_even = x.even_size;
    begin.z_even = z.even_size;
    return begin;
}

} // namespace

std::size_t SolveTables::max_floats(glm::ivec3 cells, bool diffusion) {
    const auto x = static_cast<std::size_t>(cells.x), y = static_cast<std::size_t>(cells.y),
               z = static_cast<std::size_t>(cells.z);
    const std::size_t vectors = 2 * (x * x + z * z);
    return vectors + (2 * y + 2) * x * z + (diffusion ? 3 * (vectors + x + z + 3) : 0);
}

SolveTables::SolveTables(glm::ivec3 cells, const Ends& ends, const ColumnRows& law, bool in_slabs) {
    const AxisBasis x(cells.x, ends[0][0], ends[0][1]), z(cells.z, ends[2][0], ends[2][1]);
    pressure = append_both(x, z, values);
    const bool cyclic = is_cyclic(ends[1], cells.y);
    bool closed = true;
    for (const auto& axis : ends)
        for (const EndRule end : axis)
            closed = closed && (end == EndRule::even_at_face || end == EndRule::periodic);
    if (closed)
        singular = z.zero_mode * cells.x + x.zero_mode;

    slabs = in_slabs && 2 * x.even_size == cells.x && 2 * z.even_size == cells.z && !cyclic && !closed;

    const auto rows = static_cast<std::size_t>(cells.y),
               plane = static_cast<std::size_t>(cells.x) * static_cast<std::size_t>(cells.z);
    pivots = static_cast<int>(values.size());
    if (cyclic)
        vectors = pivots + static_cast<int>(rows * plane);
    values.resize(values.size() + rows * plane + (cyclic ? (rows + 2) * plane : 0));
    std::vector<double> pivot(rows), vector(rows);
    for (int mode_z = 0; mode_z < cells.z; ++mode_z)
        for (int mode_x = 0; mode_x < cells.x; ++mode_x) {
            const std::size_t column = static_cast<std::size_t>(mode_z) * cells.x + mode_x;
            if (static_cast<int>(column) == singular)
                continue;
            std::array<double, 2> factors{};
            factor_column(-2.0 + x.eigenvalues[mode_x] + z.eigenvalues[mode_z], ends[1], law, pivot, vector, factors);
            const std::size_t in_slab = static_cast<std::size_t>(mode_x) * rows * cells.z + mode_z;
            for (std::size_t j = 0; j < rows; ++j)
                values[pivots + (slabs ? in_slab + j * cells.z : j * plane + column)] = static_cast<float>(pivot[j]);
            for (std::size_t j = 0; cyclic && j < rows; ++j)
                values[vectors + j * plane + column] = static_cast<float>(vector[j]);
            for (std::size_t n = 0; cyclic && n < 2; ++n)
                values[vectors + (rows + n) * plane + column] = static_cast<float>(factors[n]);
        }
}

void SolveTables::add_diffusion(glm::ivec3 cells, const std::array<Ends, 3>& ends) {
    for (std::size_t component = 0; component < 3; ++component) {
        const auto& [of_x, of_y, of_z] = ends[component];
        const AxisBasis x(cells.x, of_x[0], of_x[1]), z(cells.z, of_z[0], of_z[1]);
        diffusion[component] = append_both(x, z, values);
        diffusion_columns[component] = static_cast<int>(values.size());
        for (const AxisBasis* basis : {&x, &z})
            for (const double eigenvalue : basis->eigenvalues)
                values.push_back(static_cast<float>(eigenvalue));
        for (const EndRule end : of_y)
            values.push_back(static_cast<float>(diagonal_correction(end)));
        values.push_back(of_y[0] == EndRule::periodic ? 1.0f : 0.0f);
    }
}

} // namespace windrow::vulkan
