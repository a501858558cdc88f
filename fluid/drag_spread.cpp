#include "fluid/drag_spread.h"

#include "fluid/box.h"
#include "fluid/obstacle_force.h"
#include "fluid/rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace windrow::detail {
namespace {

constexpr std::int64_t k_most_periods = 64; // of a deposit that is far longer than a periodic box

struct Interval {
    double low = 0.0, high = 0.0;
};

/// Part of an interval in each cell of an axis, first <= i < end.
struct Parts {
    int first = 0, end = 0;
    std::array<double, k_max_axis_cells> part;
};

// No narrower than two cells. In cells of the world.
Interval widened(double middle, double half, double h) {
    const double wide = std::max(half, h);
    return {(middle - wide) / h, (middle + wide) / h};
}

double overlap(const Interval& along, double low, double high) {
    return std::max(std::min(along.high, high) - std::max(along.low, low), 0.0);
}

// Along an axis of equal cells, of which low <= i < high are asked for.
void find_parts(const Interval& along, std::int64_t origin, int cells, bool repeats, int low, int high, Parts& parts) {
    const double over_all = 1.0 / (along.high - along.low);
    const auto first_of = [&](double period) { return static_cast<double>(origin) + period * cells; };
    if (!repeats) {
        const double from = std::floor(along.low) - first_of(0.0), to = std::ceil(along.high) - first_of(0.0);
        parts.first = static_cast<int>(std::clamp<double>(from, low, high));
        parts.end = static_cast<int>(std::clamp<double>(to, parts.first, high));
        for (int i = parts.first; i < parts.end; ++i) {
            const double cell = static_cast<double>(origin + i);
            parts.part[static_cast<std::size_t>(i)] = over_all * overlap(along, cell, cell + 1.0);
        }
        return;
    }
    parts.first = low;
    parts.end = high;
    std::fill(parts.part.begin() + low, parts.part.begin() + high, 0.0);
    const double first = std::floor((along.low - first_of(0.0)) / cells);
    const auto periods = static_cast<std::int64_t>(
        std::min(std::ceil((along.high - along.low) / cells) + 1.0, static_cast<double>(k_most_periods)));
    for (std::int64_t n = 0; n < periods; ++n)
        for (int i = low; i < high; ++i) {
            const double cell = first_of(first + static_cast<double>(n)) + i;
            parts.part[static_cast<std::size_t>(i)] += over_all * overlap(along, cell, cell + 1.0);
        }
}

// Of rows; `heights` [m] in the world.
void find_rows(const Interval& heights, const DragLattice& lattice, int low, int high, Parts& parts) {
    const Window& window = lattice.window;
    if (!window.rows) {
        const double h = static_cast<double>(window.cell_size);
        return find_parts({heights.low / h, heights.high / h}, window.origin_cells.y, window.cells.y, lattice.repeats.y, low,
                          high, parts);
    }
    const double floor = window.origin().y, over_all = 1.0 / (heights.high - heights.low);
    const Interval over_floor{heights.low - floor, heights.high - floor};
    parts.first = parts.end = high;
    for (int j = low; j < high; ++j) {
        const double part = over_all * overlap(over_floor, window.rows->face(j), window.rows->face(j + 1));
        if (part > 0.0 && parts.first == high)
            parts.first = j;
        if (part > 0.0)
            parts.end = j + 1;
        parts.part[static_cast<std::size_t>(j)] = part;
    }
}

double area_of(const PlantDrag& plant) {
    return static_cast<double>(plant.area);
}
glm::dvec2 level_way(const BeltDrag& belt) {
    return {belt.end.x - belt.start.x, belt.end.z - belt.start.z};
}
double area_of(const BeltDrag& belt) {
    return static_cast<double>(belt.resistance) * static_cast<double>(belt.height) * glm::length(level_way(belt));
}

// visit(i, j, k, part) for each cell of a range that the deposit meets, x fastest.
template <class Visit>
void spread(const PlantDrag& plant, const DragLattice& lattice, const CellRange& in, const Visit& visit) {
    const Window& window = lattice.window;
    const double h = static_cast<double>(window.cell_size), half = static_cast<double>(plant.radius);
    Parts x, y, z;
    find_parts(widened(plant.position.x, half, h), window.origin_cells.x, window.cells.x, lattice.repeats.x, in.low.x, in.high.x,
               x);
    find_parts(widened(plant.position.z, half, h), window.origin_cells.z, window.cells.z, lattice.repeats.z, in.low.z, in.high.z,
               z);
    if (x.first >= x.end || z.first >= z.end)
        return;
    find_rows({plant.position.y + static_cast<double>(plant.base), plant.position.y + static_cast<double>(plant.height)}, lattice,
              in.low.y, in.high.y, y);
    for (int k = z.first; k < z.end; ++k)
        for (int j = y.first; j < y.end; ++j) {
            const double part = z.part[static_cast<std::size_t>(k)] * y.part[static_cast<std::size_t>(j)];
            for (int i = x.first; i < x.end; ++i)
                visit(i, j, k, part * x.part[static_cast<std::size_t>(i)]);
        }
}

/// A convex polygon, of a rectangle that is cut at most four times.
struct Polygon {
    int count = 0;
    std::array<glm::dvec2, 8> corners;
    void add(glm::dvec2 corner) { corners[static_cast<std::size_t>(count++)] = corner; }
    [[nodiscard]] Interval along(int axis) const {
        Interval range{1e300, -1e300};
        for (int n = 0; n < count; ++n) {
            range.low = std::min(range.low, corners[static_cast<std::size_t>(n)][axis]);
            range.high = std::max(range.high, corners[static_cast<std::size_t>(n)][axis]);
        }
        return range;
    }
};

// What of it is on one side of a line across an axis: above `place` with `sign` 1, below it with -1.
Polygon cut(const Polygon& from, int axis, double place, double sign) {
    Polygon left;
    for (int n = 0; n < from.count; ++n) {
        const glm::dvec2 a = from.corners[static_cast<std::size_t>(n)],
                         b = from.corners[static_cast<std::size_t>((n + 1) % from.count)];
        const double above_a = sign * (a[axis] - place), above_b = sign * (b[axis] - place);
        if (above_a >= 0.0)
            left.add(a);
        if ((above_a > 0.0 && above_b < 0.0) || (above_a < 0.0 && above_b > 0.0)) {
            glm::dvec2 crossing = a + (above_a / (above_a - above_b)) * (b - a);
            crossing[axis] = place;
            left.add(crossing);
        }
    }
    return left;
}

// Between `place` and `place` + 1.
Polygon strip(const Polygon& from, int axis, double place) {
    return cut(cut(from, axis, place, 1.0), axis, place + 1.0, -1.0);
}

double area_of(const Polygon& polygon) {
    double twice = 0.0;
    const glm::dvec2 first = polygon.count > 0 ? polygon.corners[0] : glm::dvec2(0.0);
    for (int n = 1; n + 1 < polygon.count; ++n) {
        const glm::dvec2 a = polygon.corners[static_cast<std::size_t>(n)] - first,
                         b = polygon.corners[static_cast<std::size_t>(n + 1)] - first;
        twice += a.x * b.y - a.y * b.x;
    }
    return 0.5 * std::abs(twice);
}

// Cells along an axis, numbered from `base`, that are asked for: visit(cell, index in the box).
template <class Visit>
void each_cell(const Interval& along, std::int64_t base, const DragLattice& lattice, int axis, const CellRange& in,
               const Visit& visit) {
    const std::int64_t origin = lattice.window.origin_cells[axis], cells = lattice.window.cells[axis];
    auto first = static_cast<std::int64_t>(std::floor(along.low)), last = static_cast<std::int64_t>(std::ceil(along.high)) - 1;
    if (!lattice.repeats[axis]) {
        first = std::max(first, origin + in.low[axis] - base);
        last = std::min(last, origin + in.high[axis] - 1 - base);
    }
    for (std::int64_t cell = first; cell <= last; ++cell) {
        std::int64_t index = cell + base - origin;
        if (lattice.repeats[axis])
            index = (index % cells + cells) % cells;
        if (index >= in.low[axis] && index < in.high[axis])
            visit(static_cast<double>(cell), static_cast<int>(index));
    }
}

template <class Visit>
void spread(const BeltDrag& belt, const DragLattice& lattice, const CellRange& in, const Visit& visit) {
    const double h = static_cast<double>(lattice.window.cell_size);
    // In cells from one that is near, in which small differences are exact.
    const std::int64_t base[2] = {static_cast<std::int64_t>(std::floor(belt.start.x / h)),
                                  static_cast<std::int64_t>(std::floor(belt.start.z / h))};
    const glm::dvec2 from(belt.start.x / h - static_cast<double>(base[0]), belt.start.z / h - static_cast<double>(base[1]));
    const glm::dvec2 way = level_way(belt) / h, along = glm::normalize(way), across(-along.y, along.x);
    const double length = glm::length(way);
    const glm::dvec2 beyond = std::max(0.5 * (2.0 - length), 0.0) * along,
                     half = std::max(0.5 * static_cast<double>(belt.width) / h, 1.0) * across;
    Polygon whole;
    for (const glm::dvec2& corner :
         {from - beyond - half, from + way + beyond - half, from + way + beyond + half, from - beyond + half})
        whole.add(corner);
    const double over_all = 1.0 / area_of(whole), height = static_cast<double>(belt.height);
    Parts y;
    each_cell(whole.along(1), base[1], lattice, 2, in, [&](double row, int k) {
        const Polygon in_row = strip(whole, 1, row);
        if (in_row.count < 3)
            return;
        each_cell(in_row.along(0), base[0], lattice, 0, in, [&](double column, int i) {
            const double part = over_all * area_of(strip(in_row, 0, column));
            if (!(part > 0.0))
                return;
            const double on_way = glm::dot(glm::dvec2(column + 0.5, row + 0.5) - from, along) / length;
            const double foot = belt.start.y + std::clamp(on_way, 0.0, 1.0) * (belt.end.y - belt.start.y);
            find_rows({foot, foot + height}, lattice, in.low.y, in.high.y, y);
            for (int j = y.first; j < y.end; ++j)
                visit(i, j, k, part * y.part[static_cast<std::size_t>(j)]);
        });
    });
}

// [1/m^3] 1 over the volume of a cell of a row.
double over_volume(const Window& window, int row) {
    const double h = static_cast<double>(window.cell_size);
    return 1.0 / (h * h * (window.rows ? window.rows->thickness(row) : h));
}

} // namespace

void CellRange::add(const CellRange& other) {
    if (other.empty())
        return;
    if (empty()) {
        *this = other;
        return;
    }
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
}

DragSquare square_around(const DragDeposit& deposit, float cell_size) {
    const double h = static_cast<double>(cell_size);
    if (const auto* const plant = std::get_if<PlantDrag>(&deposit))
        return {plant->position, std::max(static_cast<double>(plant->radius), h)};
    const auto& belt = std::get<BeltDrag>(deposit);
    const glm::dvec2 way = glm::abs(level_way(belt));
    return {0.5 * (belt.start + belt.end),
            std::max(0.5 * std::max(way.x, way.y), h) + std::max(0.5 * static_cast<double>(belt.width), h)};
}

CellRange add_drag(const DragDeposit& deposit, const DragLattice& lattice, const CellRange& in, bool out,
                   std::span<DragSum> sums) {
    CellRange met{lattice.window.cells, glm::ivec3(0)};
    const glm::ivec3 cells = lattice.window.cells;
    const DragSum sign = out ? -1 : 1;
    std::visit(
        [&](const auto& kind) {
            const double in_units = area_of(kind) / k_drag_unit;
            int row = -1;
            double factor = 0.0;
            spread(kind, lattice, in, [&](int i, int j, int k, double part) {
                if (j != row) {
                    row = j;
                    factor = in_units * over_volume(lattice.window, j);
                }
                const double units = std::min(factor * part, k_most_drag / k_drag_unit);
                const auto index =
                    (static_cast<std::size_t>(k) * static_cast<std::size_t>(cells.y) + static_cast<std::size_t>(j)) *
                        static_cast<std::size_t>(cells.x) +
                    static_cast<std::size_t>(i);
                sums[index] += sign * static_cast<DragSum>(units + 0.5);
                met.low = glm::min(met.low, glm::ivec3(i, j, k));
                met.high = glm::max(met.high, glm::ivec3(i, j, k) + 1);
            });
        },
        deposit);
    return met.empty() ? CellRange{} : met;
}

DragForce drag_force(const DragDeposit& deposit, const DragLattice& lattice, std::span<const glm::vec4> velocity) {
    const glm::ivec3 cells = lattice.window.cells;
    glm::dvec3 sum(0.0);
    double within = 0.0;
    const double area = std::visit([](const auto& kind) { return area_of(kind); }, deposit);
    std::visit(
        [&](const auto& kind) {
            spread(kind, lattice, {glm::ivec3(0), cells}, [&](int i, int j, int k, double part) {
                const auto index =
                    (static_cast<std::size_t>(k) * static_cast<std::size_t>(cells.y) + static_cast<std::size_t>(j)) *
                        static_cast<std::size_t>(cells.x) +
                    static_cast<std::size_t>(i);
                const glm::dvec3 u(velocity[index]);
                sum += part * glm::length(u) * u;
                within += part;
            });
        },
        deposit);
    return {.force = glm::vec3(static_cast<double>(k_air_density) * area * sum),
            .in_box = static_cast<float>(std::min(within, 1.0))};
}

} // namespace windrow::detail
