// The air of a wind as a grid to write. It includes none of OpenVDB, so that the library for C has it without OpenVDB.
#include "fluid/core/message.h"
#include "fluid/vdb/vdb_export.h"

namespace windrow::vdb {
namespace {

VelocityGrid grid_of(const WindView& view) {
    const Box& box = view.box();
    VelocityGrid grid{.cells = box.cells, .cell_size = box.cell_size, .origin = view.origin(), .field = view.field()};
    grid.rows = box.rows;
    grid.outside = view.ambient().without_gusts().velocity(view.origin() + 0.5 * view.window().size());
    return grid;
}

Result<void> add_obstacle(VelocityGrid& grid, const WindControl& wind, const WindReader& air) {
    // What is read back may be a part of the box.
    if (wind.obstacles().count() == 0 || grid.cells != wind.box().cells)
        return {};
    if (!windrow::detail::memory_lasts([&] { grid.obstacle.resize(grid.field.size()); }))
        return windrow::detail::out_of_memory();
    return air.write_obstacles(grid.obstacle);
}

} // namespace

Result<VelocityGrid> grid_of(const WindControl& wind, const WindReader& air) {
    const auto view = air.view();
    if (!view)
        return view.failure();
    VelocityGrid grid = grid_of(*view);
    if (auto added = add_obstacle(grid, wind, air); !added)
        return added.failure();
    return grid;
}

VelocityGrid grid_of(const Wind& wind) {
    VelocityGrid grid = grid_of(wind.view());
    grid.lacks_obstacle = !add_obstacle(grid, wind, wind);
    return grid;
}

} // namespace windrow::vdb
