// The direct solve's tables as the passes read them: eigenvectors of x and z, and the factored columns of y, in one array of
// floats.
#pragma once

#include "fluid/grid/columns.h"

#include <array>
#include <glm/vec3.hpp>
#include <vector>

namespace windrow::vulkan {

struct SolveTables {
    using Ends = std::array<std::array<EndRule, 2>, 3>;

    /// L phi = rhs with the ends given; L is the 7-point Laplacian of a box of `cells`.
    /// `rows`: empty where all are equal. `in_slabs`: the passes may solve in slabs, where the ends allow it.
    SolveTables(glm::ivec3 cells, const Ends& ends, const ColumnRows& rows = {}, bool in_slabs = false);

    std::vector<float> values;
    /// Floats that any mix of sides takes, with and without diffusion.
    [[nodiscard]] static std::size_t max_floats(glm::ivec3 cells, bool diffusion);
    /// Appends what implicit diffusion of the velocity's components needs.
    void add_diffusion(glm::ivec3 cells, const std::array<Ends, 3>& ends);
    // Where each table begins in `values`.
    struct Vectors {
        int x_forward = 0, x_back = 0; ///< [input][output] of shaders/fluid/modes.glsl, cells to modes and back
        int z_forward = 0, z_back = 0;
        int x_even = 0, z_even = 0; ///< even vectors (AxisBasis::even_size): the inputs of a table
    };
    Vectors pressure, diffusion[3];
    int diffusion_columns[3] = {}; ///< eigenvalues of x, of z, what both ends of y add, 1 where y is periodic
    bool slabs = false;            ///< the passes solve in slabs: both ends of x are alike, and of z, and no column is special
    int pivots = 0;                ///< [y][mode of z][mode of x]; for slabs [mode of x][y][mode of z]
    int vectors = -1;              ///< the same, of periodic columns; then [2][mode of z][mode of x], their factors; -1: none
    int singular = -1;             ///< [mode of z][mode of x] of the column without an inverse; -1: all have one
};

} // namespace windrow::vulkan
