#include "fluid/vdb/even_grid.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace windrow::vdb {
namespace {

/// Where the voxels of one height read among the rows.
struct Place {
    int below, nearest;
    float part;
};

std::vector<Place> places_of(const RowTable& rows, int count, double thickness) {
    std::vector<Place> places;
    for (int j = 0; j < count; ++j) {
        const double place = std::clamp(rows.place((j + 0.5) * thickness) - 0.5, 0.0, rows.count() - 1.0);
        const int below = std::min(static_cast<int>(place), rows.count() - 2);
        places.push_back({below, static_cast<int>(place + 0.5), static_cast<float>(place - below)});
    }
    return places;
}

template <class Value>
std::vector<Value> even(std::span<const Value> values, glm::ivec3 cells, const std::vector<Place>& places, bool nearest) {
    const Box from{.cells = cells}, to{.cells = {cells.x, static_cast<int>(places.size()), cells.z}};
    std::vector<Value> result(values.empty() ? 0 : to.cell_count());
    if (values.empty())
        return result;
    for (int k = 0; k < to.cells.z; ++k)
        for (int j = 0; j < to.cells.y; ++j) {
            const Place& place = places[static_cast<std::size_t>(j)];
            for (int i = 0; i < to.cells.x; ++i) {
                const Value low = values[from.index(i, place.below, k)], high = values[from.index(i, place.below + 1, k)];
                result[to.index(i, j, k)] = nearest ? values[from.index(i, place.nearest, k)] : low + place.part * (high - low);
            }
        }
    return result;
}

} // namespace

EvenGrid even_grid(const VelocityGrid& source) {
    const float height = source.cell_height > 0.0f ? source.cell_height : source.cell_size;
    EvenGrid to{.grid = source, .thickness = static_cast<double>(height)};
    if (!source.rows)
        return to;
    const RowTable& rows = *source.rows;
    const int count = static_cast<int>(std::clamp(std::ceil(rows.top() / rows.step() - 1e-6), 1.0, double{k_max_axis_cells}));
    to.thickness = std::max(rows.step(), rows.top() / count);
    to.grid.rows.reset();
    to.grid.cells.y = count;
    const std::vector<Place> places = places_of(rows, count, to.thickness);
    to.grid.field = to.field = even(source.field, source.cells, places, false);
    to.grid.obstacle = even(std::span<const float>(source.obstacle), source.cells, places, true);
    for (NamedScalar& scalar : to.grid.scalars)
        scalar.values = to.scalars.emplace_back(even(scalar.values, source.cells, places, false));
    for (NamedVector& vector : to.grid.vectors)
        vector.values = to.vectors.emplace_back(even(vector.values, source.cells, places, false));
    return to;
}

} // namespace windrow::vdb
