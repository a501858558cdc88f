// Calls of vdb.h.
#include "c_api/vdb.h"

#include "c_api/source/tables.h"
#include "c_api/source/vdb_library.h"
#include "fluid/core/message.h"
#include "fluid/vdb/film_grid.h"
#include "fluid/vdb/vdb_export.h"

#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace windrow::c_api {

template <>
inline constexpr int k_values<vdb::Form> = 2;
template <>
inline constexpr int k_values<vdb::Precision> = 2;
template <>
inline constexpr int k_values<vdb::UpAxis> = 2;
template <>
inline constexpr int k_values<vdb::Format> = 2;

void read_rest(Reasons&, const Path&, const char* from, std::string& to) {
    if (from != nullptr)
        to = from;
}

WINDROW_C_STRUCT(windrow_vdb_options, vdb::Options, name, form, precision, up, time, frame, format);
WINDROW_C_STRUCT_BUT(6, windrow_vdb_grid, vdb::VelocityGrid, cells, cell_size, cell_height, origin, outside);
WINDROW_C_STRUCT_BUT(4, windrow_vdb_film, vdb::FilmSettings, speed, vorticity);

} // namespace windrow::c_api

using namespace windrow;
using namespace windrow::c_api;

namespace {

windrow_result done_with(const vdb::WriteResult& written) {
    switch (written.problem()) {
    case vdb::Problem::none:
        return WINDROW_OK;
    case vdb::Problem::rejected:
        return fail(WINDROW_REJECTED, written.error());
    case vdb::Problem::cannot_write:
        return fail(WINDROW_CANNOT_WRITE, written.error());
    case vdb::Problem::disk_full:
        return fail(WINDROW_DISK_FULL, written.error());
    case vdb::Problem::out_of_memory:
        return fail(WINDROW_OUT_OF_MEMORY, written.error());
    }
    return fail(WINDROW_UNEXPECTED, written.error());
}

/// The host's further grids, whose arrays have `count` entries each.
template <class Cpp, class C>
std::vector<Cpp> grids_of(const C* list, std::uint32_t number, std::uint64_t count) {
    std::vector<Cpp> grids;
    for (std::uint32_t n = 0; n < number; ++n) {
        Cpp grid;
        grid.name = list[n].name != nullptr ? list[n].name : "";
        grid.units = list[n].units != nullptr ? list[n].units : "";
        if constexpr (requires { grid.outside; })
            grid.outside = list[n].outside;
        using Value = std::remove_reference_t<decltype(grid.values[0])>;
        grid.values = {same_layout<Value>(list[n].values), list[n].values != nullptr ? static_cast<std::size_t>(count) : 0};
        grids.push_back(std::move(grid));
    }
    return grids;
}

/// Runs use(calls, options) with OpenVDB's library.
template <class Use>
windrow_result with_options(const windrow_vdb_options* options, const Use& use) {
    const auto calls = vdb_calls();
    if (!calls)
        return fail(WINDROW_UNSUPPORTED, calls.error());
    if (options == nullptr)
        return use(**calls, vdb::Options{});
    return with(options, [&](const vdb::Options& wanted) { return use(**calls, wanted); });
}

/// Runs use(grid) on the cells of a wind.
template <class Use>
windrow_result with_grid(const windrow_wind* wind, const Use& use) {
    if (const auto view = wind->reader->view(); !view)
        return fail(WINDROW_NOT_READY, view.error());
    const Result<vdb::VelocityGrid> grid = vdb::grid_of(*wind->control, *wind->reader);
    return grid ? use(*grid) : done(grid);
}

/// The region that a host asks for, on voxels of a wind.
vdb::Region region_of(const windrow_vdb_film& film, const WindView& view) {
    vdb::Region region = vdb::region_around(view, film.margin, film.voxel_size);
    if (film.has_region != 0) {
        region.low = to_cpp(film.low);
        region.high = to_cpp(film.high);
    }
    return region;
}

} // namespace

WINDROW_C_INIT(windrow_vdb_film)
WINDROW_EXPORT windrow_result windrow_vdb_write_film(const windrow_wind* wind, const windrow_vdb_film* film, const char* path,
                                                     const windrow_vdb_options* options) {
    return call({{wind, "wind"}, {film, "film"}, {path, "path"}}, [&]() -> windrow_result {
        const Result<WindView> view = wind->reader->view();
        if (!view)
            return fail(WINDROW_NOT_READY, view.error());
        Reasons reasons;
        windrow_vdb_film taken;
        vdb::FilmSettings settings;
        if (!take(reasons, Path{nullptr, "film"}, film, taken))
            return fail(WINDROW_REJECTED, reasons.take());
        read_fields(reasons, Path{nullptr, "film"}, taken, settings);
        if (!(taken.margin >= 0.0 && taken.voxel_size >= 0.0f && std::isfinite(taken.margin) && std::isfinite(taken.voxel_size)))
            reasons.add("film.margin is ", taken.margin, " m, film.voxel_size ", taken.voxel_size, " m: give 0 or more, finite.");
        if (taken.scalars == nullptr && taken.scalar_count > 0)
            reasons.add("film.scalars is null: give as many as film.scalar_count, or count 0.");
        if (!reasons.empty())
            return fail(WINDROW_REJECTED, reasons.take());
        const auto scalars = grids_of<vdb::CellScalar>(taken.scalars, taken.scalar_count, view->box().cell_count());
        std::vector<float> obstacle;
        if (wind->control->obstacles().count() > 0 && view->box().cells == wind->control->box().cells) {
            obstacle.resize(view->box().cell_count());
            if (auto written = wind->reader->write_obstacles(obstacle); !written)
                return done(written);
        }
        settings.region = region_of(taken, *view);
        settings.obstacle = obstacle;
        settings.scalars = scalars;
        settings.parallel_for = wind->control->config().parallel_for;
        const Result<vdb::FilmGrid> grid = vdb::film_grid(*view, settings);
        if (!grid)
            return done(grid);
        return with_options(options, [&](const VdbCalls& openvdb, const vdb::Options& how) {
            return done_with(openvdb.write(grid->grid, path_of(path), how));
        });
    });
}
WINDROW_C_INIT(windrow_vdb_options)
WINDROW_C_INIT(windrow_vdb_grid)
WINDROW_EXPORT int32_t windrow_vdb_has_nanovdb(void) {
    const auto calls = vdb_calls();
    return calls && (*calls)->has_nanovdb();
}
WINDROW_EXPORT windrow_result windrow_vdb_write(const windrow_wind* wind, const char* path, const windrow_vdb_options* options) {
    return call({{wind, "wind"}, {path, "path"}}, [&] {
        return with_options(options, [&](const VdbCalls& openvdb, const vdb::Options& wanted) {
            return with_grid(
                wind, [&](const vdb::VelocityGrid& grid) { return done_with(openvdb.write(grid, path_of(path), wanted)); });
        });
    });
}
WINDROW_EXPORT windrow_result windrow_vdb_write_frame(const windrow_wind* wind, const char* folder, const char* prefix,
                                                      int32_t digits, int32_t frame, double time,
                                                      const windrow_vdb_options* options) {
    return call({{wind, "wind"}, {folder, "folder"}, {prefix, "prefix"}}, [&] {
        return with_options(options, [&](const VdbCalls& openvdb, const vdb::Options& wanted) {
            const vdb::Sequence sequence{.folder = path_of(folder), .prefix = prefix, .digits = digits, .options = wanted};
            return with_grid(
                wind, [&](const vdb::VelocityGrid& grid) { return done_with(openvdb.write_frame(sequence, grid, frame, time)); });
        });
    });
}
WINDROW_EXPORT windrow_result windrow_vdb_write_grid(const windrow_vdb_grid* grid, const char* path,
                                                     const windrow_vdb_options* options) {
    return call({{grid, "grid"}, {path, "path"}}, [&]() -> windrow_result {
        Reasons reasons;
        windrow_vdb_grid taken;
        if (!take(reasons, Path{nullptr, "grid"}, grid, taken))
            return fail(WINDROW_REJECTED, reasons.take());
        if (taken.field == nullptr && taken.count > 0)
            return fail(WINDROW_REJECTED, detail::message("grid.field is null: give ", taken.count, " cells."));
        if (taken.count > k_max_cells)
            return fail(WINDROW_REJECTED,
                        detail::message("grid.count is ", taken.count, ": give at most ", k_max_cells, " cells."));
        vdb::VelocityGrid wanted;
        read_fields(reasons, Path{nullptr, "grid"}, taken, wanted);
        wanted.field = {same_layout<const glm::vec4>(taken.field), static_cast<std::size_t>(taken.count)};
        if (taken.obstacle != nullptr)
            wanted.obstacle.assign(taken.obstacle, taken.obstacle + taken.count);
        if ((taken.scalars == nullptr && taken.scalar_count > 0) || (taken.vectors == nullptr && taken.vector_count > 0))
            return fail(WINDROW_REJECTED, "grid.scalars or grid.vectors is null: give as many as its count, or count 0.");
        wanted.scalars = grids_of<vdb::NamedScalar>(taken.scalars, taken.scalar_count, taken.count);
        wanted.vectors = grids_of<vdb::NamedVector>(taken.vectors, taken.vector_count, taken.count);
        return with_options(options, [&](const VdbCalls& openvdb, const vdb::Options& how) {
            return done_with(openvdb.write(wanted, path_of(path), how));
        });
    });
}
