#include "fluid/solids/reading.h"

#include "fluid/config.h"
#include "fluid/core/numerics.h"
#include "fluid/solids/surface_layer.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>
#include <variant>

namespace windrow {
namespace {

constexpr float k_reach = 3.0f;         // [cells] of the law over a surface
constexpr float k_most_reach = 8.0f;    // times that, over the roughest ground, where lengths differ by place
constexpr float k_least_height = 0.01f; // [cells] at which a cell shows the law
constexpr float k_deepest = 2.5f;       // thicknesses below a surface that are filled
constexpr float k_least_weight = 1.0f / 64.0f;
constexpr float k_farthest = 6e4f; // a half holds it

bool stands(const PlacedObstacle& body) {
    return body.surface == Surface::free_slip && !body.moves();
}

// [m] Shortest and longest roughness length.
glm::vec2 range_of(const Roughness& roughness) {
    if (!roughness.map)
        return glm::vec2(roughness.length);
    const auto heights = roughness.map->lengths->heights();
    const auto [least, most] = std::minmax_element(heights.begin(), heights.end());
    return glm::max(roughness.map->scale.y * glm::vec2(*least, *most), k_smoothest);
}

} // namespace

WallLaw wall_law(const Config& config, const Box& box) {
    const bool rough = config.roughness && config.stages.diffusion;
    const bool canopy = config.canopy && config.stages.sources && config.canopy->height > 0.0f && config.canopy->drag > 0.0f;
    if (!rough || canopy)
        return {};
    const glm::vec2 lengths = range_of(*config.roughness);
    WallLaw law{.per_length = 1.0f / lengths.y,
                .reach = k_reach * std::min(lengths.y / lengths.x, k_most_reach) * box.cell_size,
                .fall = config.roughness->map ? 0.0f : 1.0f};
    law.per_log = 1.0f / numerics::log1p(law.reach / lengths.y);
    law.lowest = box.boundaries.y_low.kind == BoundaryKind::free_slip ? box.centre(0, 0, 0).y : -1e30f;
    return law;
}

// --- Showing -----------------------------------------------------------------------------------------------------------------

std::optional<std::uint32_t> SurfaceReading::index_in(const Part& part, std::uint32_t cell) const {
    if (is_whole(part))
        return cell;
    const auto x = static_cast<std::uint32_t>(size_.x), y = static_cast<std::uint32_t>(size_.y);
    const glm::ivec3 at = glm::ivec3(cell % x, cell / x % y, cell / x / y) - part.low;
    if (glm::any(glm::lessThan(at, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(at, part.cells)))
        return std::nullopt;
    return static_cast<std::uint32_t>((at.z * part.cells.y + at.y) * part.cells.x + at.x);
}

glm::vec3 SurfaceReading::over_wall(const Cell& cell, glm::vec3 sum, bool raised) const {
    const Wall& wall = walls_[cell.wall];
    const float raise = raised ? cell.raise : 1.0f;
    return numerics::windrow_beside_surface(sum, wall.normal, raise * wall.across, raise * wall.own, wall.keep);
}

// Of a part; what is beyond it is left out.
glm::vec3 SurfaceReading::filled(const Cell& cell, std::span<const glm::vec4> air, const Part& part, bool raised) const {
    glm::vec3 sum(0.0f);
    float lost = 0.0f;
    for (const Term& term : terms().subspan(cell.first, cell.count)) {
        const auto at = index_in(part, term.cell);
        if (at)
            sum += (raised ? term.raised : term.weight) * glm::vec3(air[*at]);
        else
            lost += term.weight;
    }
    if (lost > 0.0f && lost < 1.0f)
        sum /= 1.0f - lost;
    return over_wall(cell, sum, raised);
}

// The same of the whole box: four floats at a time.
glm::vec3 SurfaceReading::filled(const Cell& cell, const float* air) const {
    float sum[4] = {};
    const Term* const terms = terms_.data() + cell.first;
    for (std::uint32_t n = 0; n < cell.count; ++n) {
        const float* const u = air + 4 * std::size_t{terms[n].cell};
        for (int c = 0; c < 4; ++c)
            sum[c] += terms[n].raised * u[c];
    }
    return over_wall(cell, {sum[0], sum[1], sum[2]}, true);
}

void SurfaceReading::show(std::span<const glm::vec4> air, const Part& part, std::span<glm::vec4> shown,
                          const ParallelFor& parallel_for) const {
    const glm::ivec3 cells = part.cells;
    const bool law = !rows_.empty(), whole = is_whole(part);
    const auto plane_cells = static_cast<std::size_t>(cells.y) * static_cast<std::size_t>(cells.x);
    parallel_for(cells.z, [&](int k) {
        std::size_t n = static_cast<std::size_t>(k) * plane_cells;
        if (!law)
            std::copy_n(air.data() + n, plane_cells, shown.data() + n);
        for (int j = 0; j < cells.y && law; ++j) {
            const Row& row = rows_[static_cast<std::size_t>(j + part.rows_low)];
            for (int i = 0; i < cells.x; ++i, ++n)
                shown[n] = glm::vec4(row.raise * glm::vec3(air[n]), row.height);
        }
        if (!whole)
            return;
        const auto begin = static_cast<std::uint32_t>(static_cast<std::size_t>(k) * plane_cells);
        auto cell =
            std::lower_bound(cells_.begin(), cells_.end(), begin, [](const Cell& a, std::uint32_t b) { return a.cell < b; });
        for (; cell != cells_.end() && cell->cell < begin + plane_cells; ++cell) {
            const glm::vec3 u = cell->count > 0 ? filled(*cell, &air.data()->x) : cell->raise * glm::vec3(air[cell->cell]);
            shown[cell->cell] = glm::vec4(u, law ? cell->height : 0.0f);
        }
    });
    for (std::size_t n = 0; n < cells_.size() && !whole; ++n) {
        const Cell& cell = cells_[n];
        const auto at = index_in(part, cell.cell);
        if (!at)
            continue;
        const glm::vec3 u = cell.count > 0 ? filled(cell, air, part, true) : cell.raise * glm::vec3(air[*at]);
        shown[*at] = glm::vec4(u, law ? cell.height : 0.0f);
    }
}

void SurfaceReading::clear() {
    cells_.clear();
    terms_.clear();
    walls_.clear();
    rows_.clear();
}

std::size_t SurfaceReading::memory_bytes() const {
    return cells_.capacity() * sizeof(Cell) + terms_.capacity() * sizeof(Term) + walls_.capacity() * sizeof(Wall) +
           rows_.capacity() * sizeof(Row);
}

// --- Filling -----------------------------------------------------------------------------------------------------------------

ReadingMaker::ReadingMaker(const Box& box, const Config& config) : box_(box), config_(config), law_(wall_law(config, box)) {}
ReadingMaker::~ReadingMaker() = default;

bool ReadingMaker::depends_on_place() const {
    return law_.acts() && config_.roughness->map;
}

std::shared_ptr<const SurfaceReading> ReadingMaker::make(const Solids* solids, const Boundaries& boundaries, const Window& window,
                                                         const DragCells& drag) {
    box_.boundaries = boundaries;
    law_ = wall_law(config_, box_);
    auto unused = std::find_if(made_.begin(), made_.end(), [](const auto& one) { return one.use_count() == 1; });
    if (unused == made_.end())
        unused = made_.insert(made_.end(), std::make_shared<SurfaceReading>());
    SurfaceReading& reading = **unused;
    reading.clear();
    reading.size_ = box_.cells;
    reading.law_ = law_;
    for (const Near& near : near_)
        near_of_[near.cell] = k_none;
    near_.clear();
    heights_.clear();
    if (solids != nullptr)
        collect(*solids);
    if (law_.acts()) {
        per_heights_.clear();
        const bool floor = box_.boundaries.y_low.kind == BoundaryKind::free_slip && !depends_on_place();
        for (int j = 0; j < box_.cells.y; ++j) {
            const float height = floor ? kept(box_.centre(0, j, 0).y, 1.0f) : law_.reach;
            reading.rows_.push_back({height, raise_of(height)});
        }
        find_heights(solids, window, drag, reading);
    }
    for (std::uint32_t n = 0; n < near_.size(); ++n)
        visit(*solids, n, reading);
    write_cells(reading);
    const auto spare = [](auto&... lists) { (detail::make_room(lists, lists.size() + lists.size() / 4), ...); };
    spare(reading.cells_, reading.terms_, reading.walls_, near_);
    return reading.empty() ? nullptr : *unused;
}

void ReadingMaker::collect(const Solids& solids) {
    near_of_.resize(box_.cell_count(), k_none);
    solids.for_each_near([&](std::uint32_t cell, glm::ivec3 place, float away, std::size_t body) {
        std::uint32_t& at = near_of_[cell];
        if (at == k_none) {
            near_.push_back({.cell = cell, .place = place, .away = away, .body = body}); // first: it may lack memory
            at = static_cast<std::uint32_t>(near_.size() - 1);
        } else if (away < near_[at].away) {
            near_[at].away = away;
            near_[at].body = body;
        }
    });
}

// After those farther out, from which it takes air and height.
void ReadingMaker::visit(const Solids& solids, std::uint32_t number, SurfaceReading& reading) {
    if (std::exchange(near_[number].done, true))
        return;
    Near& near = near_[number];
    Source sources[6];
    const std::span<const Source> farther(sources, static_cast<std::size_t>(find_sources(solids, near, sources)));
    for (const Source& source : farther)
        visit(solids, near_of_[source.cell], reading);
    if (!heights_.empty() && solids.inside(near.cell) && stands(solids.bodies()[near.body]))
        extend_height(solids, near, farther);
    fill(solids, near, farther, reading);
}

// In near_, or k_none.
std::uint32_t ReadingMaker::neighbour(const Near& near, int axis, int side) const {
    glm::ivec3 at = near.place;
    at[axis] += side;
    if (at[axis] < 0 || at[axis] >= box_.cells[axis]) {
        if (!box_.boundaries.periodic(axis))
            return k_none;
        at[axis] -= side * box_.cells[axis];
    }
    return near_of_[box_.index(at.x, at.y, at.z)];
}

// [cells] From a row to its neighbour.
float ReadingMaker::apart(int row, int axis, int side) const {
    if (axis != 1 || !box_.rows)
        return 1.0f;
    return 1.0f / box_.rows->links()[static_cast<std::size_t>(side < 0 ? row : row + 1)];
}

// Of the distance: central, but from one side where both neighbours are farther out, as beside a plate.
void ReadingMaker::find_normal(Near& near) const {
    glm::vec3 slope(0.0f);
    for (int axis = 0; axis < 3; ++axis) {
        const std::uint32_t at[2] = {neighbour(near, axis, -1), neighbour(near, axis, 1)};
        float rise[2] = {}, way[2] = {};
        for (int side = 0; side < 2; ++side)
            if (at[side] != k_none) {
                way[side] = apart(near.place.y, axis, 2 * side - 1);
                rise[side] = near_[at[side]].away - near.away;
            }
        if (rise[0] > 0.0f && rise[1] > 0.0f)
            way[rise[0] > rise[1] ? 1 : 0] = 0.0f;
        const float whole = way[0] + way[1];
        if (whole > 0.0f)
            slope[axis] = ((way[1] > 0.0f ? rise[1] : 0.0f) - (way[0] > 0.0f ? rise[0] : 0.0f)) / whole;
    }
    const float length = glm::length(slope);
    near.normal = length > 0.0f ? slope / length : glm::vec3(0.0f);
}

// Neighbours farther out, with the weights of the upwind solution.
int ReadingMaker::find_sources(const Solids& solids, const Near& near, Source (&sources)[6]) const {
    constexpr float k_alike = 1e-3f; // [cells] a wall's two sides
    int count = 0;
    for (int axis = 0; axis < 3; ++axis) {
        float out[2] = {};
        std::uint32_t at[2] = {};
        for (int side = 0; side < 2; ++side) {
            at[side] = neighbour(near, axis, 2 * side - 1);
            if (at[side] == k_none)
                continue;
            const std::uint32_t low = side == 0 ? near_[at[side]].cell : near.cell;
            if (near.away <= 0.0f || !solids.blocked(low, axis))
                out[side] = std::max(near_[at[side]].away - near.away, 0.0f);
        }
        const bool alike = std::abs(out[0] - out[1]) < k_alike;
        for (int side = 0; side < 2; ++side) {
            if (!(out[side] > 0.0f) || (!alike && out[side] < out[1 - side]))
                continue;
            const float way = apart(near.place.y, axis, 2 * side - 1);
            sources[count++] = {.cell = near_[at[side]].cell,
                                .weight = (alike ? 0.5f : 1.0f) * out[side] / (way * way),
                                .away = near_[at[side]].away,
                                .rise = axis == 1 ? static_cast<float>(2 * side - 1) * way * box_.cell_size : 0.0f};
        }
    }
    return count;
}

// [m/s] Of a body's own point at a place, of its nearest image.
glm::vec3 ReadingMaker::velocity_of(const PlacedObstacle& body, glm::vec3 place) const {
    const glm::vec3 size = box_.size();
    for (int axis = 0; axis < 3; ++axis)
        if (box_.boundaries.periodic(axis))
            place[axis] -= size[axis] * std::round((place[axis] - body.position[axis]) / size[axis]);
    return body.velocity_at(place);
}

void ReadingMaker::fill(const Solids& solids, Near& near, std::span<const Source> sources, SurfaceReading& reading) {
    const float row = box_.volume(near.place.y), most = std::max(row, 1.0f);
    if (near.away >= 0.5f * most || near.away <= -k_deepest * most)
        return;
    find_normal(near);
    const float thickness = 1.0f + (row - 1.0f) * near.normal.y * near.normal.y;
    if (near.away >= 0.5f * thickness || near.away <= -k_deepest * thickness || near.normal == glm::vec3(0.0f))
        return;
    auto& terms = reading.terms_;
    const std::size_t first = terms.size();
    const auto add = [&](std::uint32_t cell, float weight) {
        const auto same = std::find_if(terms.begin() + static_cast<std::ptrdiff_t>(first), terms.end(),
                                       [&](const auto& term) { return term.cell == cell; });
        if (same == terms.end())
            terms.push_back({.cell = cell, .weight = weight});
        else
            same->weight += weight;
    };
    float sum = 0.0f;
    for (const Source& source : sources) {
        const Near& from = near_[near_of_[source.cell]];
        if (from.count == 0 && (from.away <= 0.0f || solids.inside(from.cell)))
            continue; // no air reaches it
        sum += source.weight;
        if (from.count == 0)
            add(from.cell, source.weight);
        for (std::uint32_t m = from.first; m < from.first + from.count; ++m) {
            const SurfaceReading::Term term = terms[m];
            add(term.cell, source.weight * term.weight);
        }
    }
    if (!(sum > 0.0f))
        return;
    terms.erase(std::remove_if(terms.begin() + static_cast<std::ptrdiff_t>(first), terms.end(),
                               [&](const auto& term) { return term.weight < k_least_weight * sum; }),
                terms.end());
    sum = 0.0f;
    for (std::size_t n = first; n < terms.size(); ++n)
        sum += terms[n].weight;
    float away = 0.0f;
    for (std::size_t n = first; n < terms.size(); ++n) {
        terms[n].weight /= sum;
        away += terms[n].weight * near_[near_of_[terms[n].cell]].away;
    }
    near.first = static_cast<std::uint32_t>(first);
    near.count = static_cast<std::uint32_t>(terms.size() - first);
    near.wall = static_cast<std::uint32_t>(reading.walls_.size());
    const PlacedObstacle& body = solids.bodies()[near.body];
    const glm::vec3 own =
        body.moves() ? velocity_of(body, box_.centre(near.place.x, near.place.y, near.place.z)) : glm::vec3(0.0f);
    SurfaceReading::Wall wall{.normal = near.normal, .across = glm::dot(own, near.normal)};
    if (body.surface == Surface::no_slip) {
        wall.own = own;
        wall.keep = std::clamp(near.away / away, -1.0f, 1.0f);
    }
    reading.walls_.push_back(wall);
}

// --- Heights -----------------------------------------------------------------------------------------------------------------

float ReadingMaker::raise_of(float height) const {
    if (!(height > 0.0f))
        return 1.0f;
    return 1.0f / law_.fraction(std::max(height, k_least_height * box_.cell_size));
}

// A height [m] as cells hold it. From some cells up it is the law's reach, above which no height counts.
float ReadingMaker::kept(float height, float per_height) const {
    const float scaled = std::clamp(height * per_height, -k_farthest, k_farthest);
    return per_heights_.empty() || height > 2.0f * box_.coarsest() ? std::min(scaled, law_.reach) : scaled;
}

float ReadingMaker::per_height_at(int i, int k) const {
    return per_heights_.empty() ? 1.0f : per_heights_[static_cast<std::size_t>(k * box_.cells.x + i)];
}

float ReadingMaker::height_of(const SurfaceReading& reading, std::uint32_t cell) const {
    const auto x = static_cast<std::uint32_t>(box_.cells.x), y = static_cast<std::uint32_t>(box_.cells.y);
    return heights_.empty() ? reading.rows_[cell / x % y].height : heights_[cell];
}

void ReadingMaker::find_heights(const Solids* solids, const Window& window, const DragCells& drag,
                                const SurfaceReading& reading) {
    const glm::ivec3 cells = box_.cells;
    if (depends_on_place()) {
        for (int k = 0; k < cells.z; ++k)
            for (int i = 0; i < cells.x; ++i)
                per_heights_.push_back(1.0f / (law_.per_length * roughness_at(*config_.roughness, window.centre(i, 0, k))));
    }
    if (solids == nullptr && per_heights_.empty() && !drag.any())
        return;
    heights_.resize(box_.cell_count());
    const bool floor = box_.boundaries.y_low.kind == BoundaryKind::free_slip;
    for (int k = 0; k < cells.z; ++k)
        for (int j = 0; j < cells.y; ++j)
            for (int i = 0; i < cells.x; ++i)
                heights_[box_.index(i, j, k)] = per_heights_.empty() ? reading.rows_[static_cast<std::size_t>(j)].height
                                                : floor              ? kept(box_.centre(0, j, 0).y, per_height_at(i, k))
                                                                     : law_.reach;
    for (int k = 0; k < cells.z && solids != nullptr; ++k)
        for (int i = 0; i < cells.x; ++i)
            find_column(*solids, i, k, per_height_at(i, k));
    if (drag.any())
        lift_plants(drag);
}

// No law in columns with plants: their air is as if so high that none counts, down to the floor.
void ReadingMaker::lift_plants(const DragCells& drag) {
    const float above = law_.reach + (law_.fall > 0.0f ? std::max(law_.lowest, 0.0f) : law_.reach);
    const int nx = box_.cells.x, ny = box_.cells.y;
    for (int row = 0; row < ny * box_.cells.z; ++row)
        for (int i = drag.runs[static_cast<std::size_t>(row)].low; i < drag.runs[static_cast<std::size_t>(row)].high; ++i)
            for (int j = 0; j < ny && drag.drag[static_cast<std::size_t>(row * nx + i)] > 0.0f; ++j)
                if (float& height = heights_[box_.index(i, j, row / ny)]; height < law_.reach)
                    height = above;
}

// Heights of a column's air over what is below it.
void ReadingMaker::find_column(const Solids& solids, int i, int k, float per_height) {
    constexpr float k_no_law = -std::numeric_limits<float>::infinity();
    const auto cell = [&](int j) { return static_cast<std::uint32_t>(box_.index(i, j, k)); };
    bool touched = false;
    for (int j = 0; j < box_.cells.y && !touched; ++j)
        touched = !solids.untouched(cell(j));
    if (!touched)
        return;
    float surface = box_.boundaries.y_low.kind == BoundaryKind::free_slip ? 0.0f : k_no_law; // [m] over the low boundary
    const auto find = [&](std::size_t body, int j) {
        const std::uint32_t near = near_of_[cell(j)];
        const float away = near != k_none && near_[near].body == body ? near_[near].away : solids.height_over(body, {i, j, k});
        surface = stands(solids.bodies()[body]) ? box_.centre(i, j, k).y - away * box_.cell_size : k_no_law;
    };
    for (int j = 0; j < box_.cells.y; ++j) {
        if (solids.inside(cell(j)) || solids.in_room(cell(j))) {
            heights_[cell(j)] = law_.reach;
            continue;
        }
        const bool over = j > 0 && solids.inside(cell(j - 1));
        const ClosedFace* const closed = j > 0 ? solids.face(cell(j - 1), 1) : nullptr;
        if (over || (closed != nullptr && closed->closed >= 0.5f))
            find(over ? solids.body_in(cell(j - 1)) : closed->body, j);
        else if (j == 0 && near_of_[cell(0)] != k_none)
            if (const std::size_t body = near_[near_of_[cell(0)]].body; TiledGround::is_upright_ground(solids.bodies()[body]))
                find(body, 0); // within the lowest cell
        heights_[cell(j)] = surface == k_no_law ? law_.reach : kept(box_.centre(i, j, k).y - surface, per_height);
    }
}

// Below a surface: over a ground the height itself, elsewhere as the cells farther out have it.
void ReadingMaker::extend_height(const Solids& solids, const Near& near, std::span<const Source> sources) {
    const float per_height = per_height_at(near.place.x, near.place.z);
    float& height = heights_[near.cell];
    if (TiledGround::is_upright_ground(solids.bodies()[near.body])) {
        height = kept(near.away * box_.cell_size, per_height);
        return;
    }
    float sum = 0.0f, weights = 0.0f;
    for (const Source& source : sources) {
        sum += source.weight * (heights_[source.cell] - per_height * source.rise);
        weights += source.weight;
    }
    if (weights > 0.0f)
        height = std::min(sum / weights, law_.reach);
}

// All cells that are not shown as their rows are, in order.
void ReadingMaker::write_cells(SurfaceReading& reading) {
    const bool law = !reading.rows_.empty();
    const auto write = [&](std::uint32_t cell, const Near* near, float height) {
        SurfaceReading::Cell to{.cell = cell, .height = height, .raise = law ? raise_of(height) : 1.0f};
        if (near != nullptr && near->count > 0)
            to.first = near->first, to.count = near->count, to.wall = near->wall;
        reading.cells_.push_back(to);
    };
    for (SurfaceReading::Term& term : reading.terms_)
        term.raised = term.weight * (law ? raise_of(height_of(reading, term.cell)) : 1.0f);
    if (law && !heights_.empty()) {
        std::uint32_t n = 0;
        for (int k = 0; k < box_.cells.z; ++k)
            for (int j = 0; j < box_.cells.y; ++j) {
                const float row = reading.rows_[static_cast<std::size_t>(j)].height;
                for (int i = 0; i < box_.cells.x; ++i, ++n) {
                    const Near* const near = near_of_.empty() || near_of_[n] == k_none ? nullptr : &near_[near_of_[n]];
                    if (heights_[n] != row || (near != nullptr && near->count > 0))
                        write(n, near, heights_[n]);
                }
            }
        return;
    }
    for (const Near& near : near_)
        if (near.count > 0)
            write(near.cell, &near, 0.0f);
    const auto in_order = [](const SurfaceReading::Cell& a, const SurfaceReading::Cell& b) { return a.cell < b.cell; };
    if (!std::is_sorted(reading.cells_.begin(), reading.cells_.end(), in_order)) // those of one body are
        std::sort(reading.cells_.begin(), reading.cells_.end(), in_order);
}

std::size_t ReadingMaker::memory_bytes() const {
    std::size_t made = 0;
    for (const auto& reading : made_)
        made += reading->memory_bytes();
    return made + near_.capacity() * sizeof(Near) + near_of_.capacity() * sizeof(std::uint32_t) +
           (heights_.capacity() + per_heights_.capacity()) * sizeof(float);
}

} // namespace windrow
