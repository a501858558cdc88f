// Wind of a wind's box and around it on voxels of one size: what a film shows.
//
//     const auto region = windrow::vdb::region_around(wind->view(), 16.0);           // 16 m more on each side
//     auto film = windrow::vdb::film_grid(wind->view(), {.region = region, .speed = true, .vorticity = true});
//     windrow::vdb::write(film->grid, "wind.vdb");
//
// Voxels hold Wind::velocity at their centres: the solver's cells inside, the ambient wind outside with its profile and gusts, and
// between them the blend zone. So nothing jumps at the box. Where voxels are the cells, both agree to rounding.
//
// Between centres a reader is linear. In a log profile that is off by h^2 / (8 z ln(10 m / z0)) of the mean wind at height z, and
// across a texel of gusts by at most h / 4 of the change of slope there: choose the voxel size by it (docs/vdb.md).
#pragma once

#include "../api.h"
#include "../parallel.h"
#include "../view.h"
#include "vdb_export.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace windrow::vdb {

/// Box of the world, in whole voxels that do not move with it.
struct Region {
    /// [m] Corners. Grown to whole voxels; voxels begin at whole multiples of their size, as cells do.
    glm::dvec3 low{0.0}, high{0.0};
    /// [m] Edge of a voxel, above 0. Default 1, the solver's.
    float voxel_size = 1.0f;
    /// [m] The same along y, where it differs; 0: voxel_size. Multiples count from `low`.
    float voxel_height = 0.0f;
};

/// The box of a wind and `margin` [m] more on each side, no margin below a wall. `voxel_size` 0: that of its cells, along y that of
/// the lowest row.
[[nodiscard]] WINDROW_API Region region_around(const WindView& air, double margin = 0.0, float voxel_size = 0.0f);

/// A scalar of the wind's cells to show beside the wind.
struct CellScalar {
    std::string name;                ///< of its grid
    std::string units;               ///< "1/s"
    std::span<const float> values{}; ///< one a cell, laid out as box.h says; outside of the box it fades to 0
};

struct FilmSettings {
    /// Default: the box of the wind.
    std::optional<Region> region{};
    /// Adds the float grid `speed` [m/s].
    bool speed = false;
    /// Adds the grid of vectors `vorticity` [1/s], central differences of the velocity over two voxels.
    bool vorticity = false;
    /// 1 inside obstacles, one value a cell; empty: none.
    std::span<const float> obstacle{};
    std::span<const CellScalar> scalars{};
    ParallelFor parallel_for{};
};

/// A grid with memory of its own.
struct FilmGrid {
    FilmGrid() = default;
    FilmGrid(FilmGrid&&) = default;
    FilmGrid& operator=(FilmGrid&&) = default;

    VelocityGrid grid; ///< its spans are into the vectors below
    std::vector<glm::vec4> velocity;
    std::vector<glm::vec4> vorticity;
    std::vector<std::vector<float>> scalars;
};

/// Rejects a region without extent, and more voxels than a box may have cells. Takes 16 bytes a voxel for the velocity, 16 for the
/// vorticity and 4 for each scalar.
[[nodiscard]] WINDROW_API Result<FilmGrid> film_grid(const WindView& air, const FilmSettings& settings = {});

} // namespace windrow::vdb
