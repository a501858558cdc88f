// Cells on voxels of one size: rows of unequal thickness become voxels as thick as the lowest row.
#pragma once

#include "fluid/vdb/vdb_export.h"

#include <glm/vec4.hpp>
#include <vector>

namespace windrow::vdb {

/// The grid itself where its rows are equal.
struct EvenGrid {
    VelocityGrid grid;
    double thickness = 0.0; ///< [m] of a voxel along y
    std::vector<glm::vec4> field{};
    std::vector<std::vector<float>> scalars{};
    std::vector<std::vector<glm::vec4>> vectors{};
};

/// Linear in height between the rows' centres, constant beyond them; obstacles are those of the nearest row. Throws std::bad_alloc.
[[nodiscard]] EvenGrid even_grid(const VelocityGrid& source);

} // namespace windrow::vdb
