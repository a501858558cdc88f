#include "fluid/vdb/film_grid.h"

#include "fluid/core/message.h"
#include "fluid/core/view_place.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

namespace windrow::vdb {
namespace {

using windrow::detail::message;

/// Voxels of a region in the world.
struct Lattice {
    glm::dvec3 low{0.0};  ///< [m] corner
    glm::dvec3 size{1.0}; ///< [m] of a voxel
    glm::ivec3 voxels{0};

    [[nodiscard]] glm::dvec3 centre(int i, int j, int k) const { return low + size * (glm::dvec3(i, j, k) + 0.5); }
    [[nodiscard]] std::size_t index(int i, int j, int k) const {
        return (static_cast<std::size_t>(k) * static_cast<std::size_t>(voxels.y) + static_cast<std::size_t>(j)) *
                   static_cast<std::size_t>(voxels.x) +
               static_cast<std::size_t>(i);
    }
    /// visit(index, i, j, k) of all voxels, planes in any order.
    template <class Visit>
    void for_each(const ParallelFor& parallel_for, const Visit& visit) const {
        parallel_for(voxels.z, [&](int k) {
            for (int j = 0; j < voxels.y; ++j)
                for (int i = 0; i < voxels.x; ++i)
                    visit(index(i, j, k), i, j, k);
        });
    }
};

Result<Lattice> lattice_of(const Region& region) {
    windrow::detail::Reasons reasons;
    const double h = static_cast<double>(region.voxel_size);
    const double height = region.voxel_height > 0.0f ? static_cast<double>(region.voxel_height) : h;
    if (!Box::k_cell_size_range.holds(region.voxel_size) || !(region.voxel_height >= 0.0f))
        reasons.add("region.voxel_size is ", region.voxel_size, " m: give 1e-06 to 1e6 m.");
    const auto finite = [](const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); };
    if (!finite(region.low) || !finite(region.high) || !glm::all(glm::lessThan(region.low, region.high)))
        reasons.add("region is from ", region.low, " m to ", region.high, " m: give a low corner and a high one.");
    if (!reasons.empty())
        return Error{reasons.take()};

    Lattice lattice{.low = region.low, .size = {h, height, h}};
    constexpr double k_rounding = 1e-6; // of a voxel
    const bool cubes = region.voxel_height == 0.0f;
    for (int axis = 0; axis < 3; ++axis) {
        const double size = lattice.size[axis];
        if (axis != 1 || cubes)
            lattice.low[axis] = size * std::floor(region.low[axis] / size + k_rounding);
        const double count = std::ceil((region.high[axis] - lattice.low[axis]) / size - k_rounding);
        if (count > k_max_axis_cells)
            return Error{message("region has ", count, " voxels along ", std::string(1, "xyz"[axis]), ": give at most ",
                                 k_max_axis_cells, ", by larger voxels or a smaller region.")};
        lattice.voxels[axis] = std::max(1, static_cast<int>(count));
    }
    if (auto valid = validate(Box{.cells = lattice.voxels, .cell_size = region.voxel_size, .boundaries = {}}); !valid)
        return valid.failure().after(message("region: "));
    return lattice;
}

// Half the differences of the velocities around voxel n of a lattice with a voxel more on each side.
glm::vec3 curl(std::span<const glm::vec3> u, const Lattice& around, std::size_t n) {
    const std::size_t row = static_cast<std::size_t>(around.voxels.x), plane = row * static_cast<std::size_t>(around.voxels.y);
    const glm::vec3 scale(0.5 / around.size);
    const glm::vec3 dx = scale.x * (u[n + 1] - u[n - 1]), dy = scale.y * (u[n + row] - u[n - row]),
                    dz = scale.z * (u[n + plane] - u[n - plane]);
    return {dy.z - dz.y, dz.x - dx.z, dx.y - dy.x};
}

std::vector<glm::vec4> vorticity_of(const WindView& air, const Lattice& lattice, const ParallelFor& parallel_for) {
    const Lattice around{.low = lattice.low - lattice.size, .size = lattice.size, .voxels = lattice.voxels + 2};
    std::vector<glm::vec3> u(around.index(0, 0, around.voxels.z));
    around.for_each(parallel_for, [&](std::size_t n, int i, int j, int k) { u[n] = air.velocity(around.centre(i, j, k)); });
    std::vector<glm::vec4> vorticity(lattice.index(0, 0, lattice.voxels.z));
    lattice.for_each(parallel_for, [&](std::size_t n, int i, int j, int k) {
        vorticity[n] = glm::vec4(curl(u, around, around.index(i + 1, j + 1, k + 1)), 0.0f);
    });
    return vorticity;
}

// The cell that holds a place, or nothing outside of the box.
std::optional<std::size_t> cell_at(const WindView& air, glm::dvec3 position) {
    const Box& box = air.box();
    const glm::dvec3 cell = glm::floor(air.window().local(position));
    if (!glm::all(glm::greaterThanEqual(cell, glm::dvec3(0.0))) || !glm::all(glm::lessThan(cell, glm::dvec3(box.cells))))
        return std::nullopt;
    const glm::ivec3 place(cell);
    return box.index(place.x, place.y, place.z);
}

std::vector<float> on_voxels(const WindView& air, const Lattice& lattice, std::span<const float> cells,
                             const ParallelFor& parallel_for) {
    std::vector<float> values(lattice.index(0, 0, lattice.voxels.z), 0.0f);
    const Box& box = air.box();
    lattice.for_each(parallel_for, [&](std::size_t n, int i, int j, int k) {
        const auto place = windrow::detail::place_in(box, air.window(), air.blend_zone(), air.ambient(), lattice.centre(i, j, k));
        if (place.fraction > 0.0f)
            values[n] = place.fraction *
                        windrow::detail::between_cells(place, [&](int x, int y, int z) { return cells[box.index(x, y, z)]; });
    });
    return values;
}

void add_scalar(FilmGrid& film, const std::string& name, const std::string& units, std::vector<float> values,
                float outside = 0.0f) {
    film.scalars.push_back(std::move(values));
    film.grid.scalars.push_back({name, units, film.scalars.back(), outside});
}

Result<void> check_cells(const WindView& air, const FilmSettings& settings) {
    windrow::detail::Reasons reasons;
    const std::size_t cells = air.box().cell_count();
    if (!settings.obstacle.empty() && settings.obstacle.size() != cells)
        reasons.add("obstacle holds ", settings.obstacle.size(), " values and the box ", cells, " cells: give one a cell.");
    for (const CellScalar& scalar : settings.scalars)
        if (scalar.values.size() != cells)
            reasons.add(scalar.name, " holds ", scalar.values.size(), " values and the box ", cells, " cells: give one a cell.");
    if (!reasons.empty())
        return Error{reasons.take()};
    return {};
}

} // namespace

Region region_around(const WindView& air, double margin, float voxel_size) {
    const Box& box = air.box();
    Region region{.low = air.origin() - margin,
                  .high = air.origin() + air.window().size() + margin,
                  .voxel_size = voxel_size > 0.0f ? voxel_size : box.cell_size};
    if (voxel_size == 0.0f && box.rows)
        region.voxel_height = static_cast<float>(box.rows->step());
    if (box.boundaries.y_low.solid())
        region.low.y = air.origin().y;
    return region;
}

Result<FilmGrid> film_grid(const WindView& air, const FilmSettings& settings) {
    const auto lattice = lattice_of(settings.region.value_or(region_around(air)));
    if (!lattice)
        return lattice.failure();
    if (auto fits = check_cells(air, settings); !fits)
        return fits.failure();
    return windrow::detail::where_memory_lasts([&]() -> Result<FilmGrid> {
        FilmGrid film;
        VelocityGrid& grid = film.grid;
        grid.cells = lattice->voxels;
        grid.cell_size = static_cast<float>(lattice->size.x);
        grid.cell_height = static_cast<float>(lattice->size.y);
        grid.origin = lattice->low;
        grid.outside = air.ambient().without_gusts().velocity(lattice->low + 0.5 * glm::dvec3(lattice->voxels) * lattice->size);
        film.velocity.resize(lattice->index(0, 0, lattice->voxels.z));
        const ParallelFor& parallel_for = settings.parallel_for;
        lattice->for_each(parallel_for, [&](std::size_t n, int i, int j, int k) {
            film.velocity[n] = glm::vec4(air.velocity(lattice->centre(i, j, k)), 0.0f);
        });
        grid.field = film.velocity;
        if (!settings.obstacle.empty()) {
            grid.obstacle.resize(film.velocity.size());
            lattice->for_each(parallel_for, [&](std::size_t n, int i, int j, int k) {
                const auto cell = cell_at(air, lattice->centre(i, j, k));
                grid.obstacle[n] = cell ? settings.obstacle[*cell] : 0.0f;
            });
        }
        film.scalars.reserve(settings.scalars.size() + 1);
        if (settings.speed) {
            std::vector<float> speed(film.velocity.size());
            std::transform(film.velocity.begin(), film.velocity.end(), speed.begin(),
                           [](const glm::vec4& u) { return glm::length(glm::vec3(u)); });
            add_scalar(film, "speed", "m/s", std::move(speed), glm::length(grid.outside));
        }
        if (settings.vorticity) {
            film.vorticity = vorticity_of(air, *lattice, parallel_for);
            grid.vectors.push_back({"vorticity", "1/s", film.vorticity});
        }
        for (const CellScalar& scalar : settings.scalars)
            add_scalar(film, scalar.name, scalar.units, on_voxels(air, *lattice, scalar.values, parallel_for));
        return film;
    });
}

} // namespace windrow::vdb
