#include "fluid/view.h"

#include "fluid/core/message.h"
#include "fluid/core/numerics.h"
#include "fluid/core/view_place.h"
#include "fluid/cpu/point_tasks.h"
#include "fluid/solids/reading.h"
#include "fluid/wind.h"

#include <algorithm>
#include <array>
#include <optional>
#include <type_traits>

namespace windrow {
namespace {

float side_number(const Boundary& side) {
    return side.kind == BoundaryKind::open ? 0.0f : side.kind == BoundaryKind::periodic ? 2.0f : 1.0f;
}

template <class Number>
Result<void> write_numbers(std::span<const glm::vec4> cells, bool heights, std::span<Number> texels) {
    if (texels.size() != 4 * cells.size())
        return Error{detail::message("write_vectors got room for ", texels.size(), " numbers, but the box has ", cells.size(),
                                     " cells: give one array of 4 * box().cell_count().")};
    pack_vectors(cells, texels);
    for (std::size_t n = 0; heights && n < cells.size(); ++n)
        if constexpr (std::is_same_v<Number, float>)
            texels[4 * n + 3] = cells[n].w;
        else
            texels[4 * n + 3] = to_half(cells[n].w);
    return {};
}

// What is off stays unset: a single point pays for each line.
cpu::PointTask point_task(const Box& box, const Window& window, const BlendZone& blend_zone, const AmbientWind& ambient,
                          std::span<const glm::vec4> field, const WallLaw& law = {}) {
    cpu::PointTask task;
    const Boundaries& b = box.boundaries;
    const Boundary* const sides[3][2] = {{&b.x_low, &b.x_high}, {&b.y_low, &b.y_high}, {&b.z_low, &b.z_high}};
    task.per_cell = 1.0 / static_cast<double>(box.cell_size);
    task.field = field.empty() ? nullptr : &field.data()->x;
    for (int axis = 0; axis < 3; ++axis) {
        cpu::PointAxis& to = task.axis[axis];
        to.cells = box.cells[axis];
        to.low_kind = side_number(*sides[axis][0]);
        to.high_kind = side_number(*sides[axis][1]);
        to.origin = static_cast<double>(window.origin_cells[axis]);
        to.reach = blend_zone.reach[axis];
        if (to.reach > 0.0f) {
            to.per_width = 1.0f / blend_zone.width;
            to.point = blend_zone.point[axis] * task.per_cell;
        }
        if (sides[axis][0]->kind == BoundaryKind::periodic)
            to.period = cpu::period_of(box.cells[axis]);
    }
    task.wall_per_length = law.per_length;
    task.wall_per_log = law.per_log;
    task.wall_lowest = law.lowest;
    task.wall_fall = law.fall;
    task.rows = 0;
    if (box.rows || law.acts())
        task.bottom = window.origin().y;
    if (box.rows) {
        task.row_heights = box.rows->heights().data();
        task.rows = box.rows->count();
        task.top = box.rows->top();
    }
    cpu::set_ambient(task.ambient, ambient);
    return task;
}

cpu::PointPlace of_kernels(const detail::ViewPlace& place) {
    cpu::PointPlace to{};
    for (int axis = 0; axis < 3; ++axis) {
        to.low[axis] = place.low[axis];
        to.high[axis] = place.high[axis];
        to.between[axis] = place.between[axis];
        to.ambient[axis] = place.ambient[axis];
    }
    to.share = place.fraction;
    return to;
}

// A list in parts that stay in the first cache between the wind and what it does to a plant.
constexpr std::size_t k_part = 512;

// Where the share of the box's wind is below 1, what is mixed with it is the outer wind in place of the ambient one.
template <class Velocity>
void mix_outer(const cpu::Kernels& kernels, const cpu::PointTask& task, const WindView& outer,
               std::span<const glm::dvec3> positions, std::span<Velocity> velocities) {
    std::array<glm::dvec3, k_part> beyond;
    std::array<glm::vec3, k_part> winds, ambient;
    std::array<std::size_t, k_part> places;
    std::array<float, k_part> shares;
    std::size_t count = 0;
    for (std::size_t n = 0; n < positions.size(); ++n) {
        cpu::PointPlace place{};
        kernels.place_point(task, &positions[n].x, place);
        if (place.share == 1.0f)
            continue;
        places[count] = n;
        beyond[count] = positions[n];
        shares[count] = place.share;
        ambient[count++] = {place.ambient[0], place.ambient[1], place.ambient[2]};
    }
    outer.velocity(std::span(beyond).first(count), std::span(winds).first(count));
    for (std::size_t m = 0; m < count; ++m) {
        Velocity& velocity = velocities[places[m]];
        glm::vec3 wind = winds[m];
        if (shares[m] > 0.0f)
            wind = glm::vec3(velocity) + (1.0f - shares[m]) * (wind - ambient[m]);
        for (int axis = 0; axis < 3; ++axis)
            velocity[axis] = wind[axis];
    }
}

} // namespace

detail::ViewPlace detail::place_in(const Box& box, const Window& window, const BlendZone& blend_zone, const AmbientWind& ambient,
                                   glm::dvec3 position) {
    cpu::PointPlace found{};
    cpu::best_kernels().place_point(point_task(box, window, blend_zone, ambient, {}), &position.x, found);
    ViewPlace place{.fraction = found.share};
    for (int axis = 0; axis < 3; ++axis) {
        place.low[axis] = found.low[axis];
        place.high[axis] = found.high[axis];
        place.between[axis] = found.between[axis];
        place.ambient[axis] = found.ambient[axis];
    }
    return place;
}

glm::vec3 detail::blended(const ViewPlace& place, const std::array<glm::vec4, 8>& corners) {
    glm::vec4 wind;
    cpu::best_kernels().blend_corners(&corners.front().x, of_kernels(place), &wind.x);
    return wind;
}

glm::vec3 WindView::velocity(glm::dvec3 position) const {
    glm::vec3 wind;
    velocity(std::span(&position, 1), std::span(&wind, 1));
    return wind;
}
// Velocities are of three floats or of four.
template <class Velocity>
void WindView::read(const Sampling* felt, std::span<const glm::dvec3> positions, std::span<Velocity> velocities) const {
    const cpu::Kernels& kernels = *cpu::kernels_for(simd_);
    const cpu::PointTask task = point_task(*box_, window_, blend_zone_, *ambient_, shown(), shown_.law);
    std::optional<WindView> outer;
    if (around_.outer != nullptr)
        outer = around_.before ? around_.outer->previous_view() : around_.outer->view();
    std::optional<cpu::FeltTask> feel;
    if (felt != nullptr)
        feel = cpu::felt_task(*ambient_, *felt);
    const std::size_t count = std::min(positions.size(), velocities.size());
    for (std::size_t first = 0; first < count; first += k_part) {
        const std::size_t size = std::min(k_part, count - first);
        const double* const points = &positions[first].x;
        float* const out = &velocities[first].x;
        kernels.sample_points(task, points, size, Velocity::length(), out);
        if (outer)
            mix_outer(kernels, task, *outer, positions.subspan(first, size), velocities.subspan(first, size));
        if (feel)
            kernels.feel(*feel, points, size, Velocity::length(), out);
    }
}

void WindView::velocity(std::span<const glm::dvec3> positions, std::span<glm::vec3> velocities) const {
    read(nullptr, positions, velocities);
}
void WindView::velocity(std::span<const glm::dvec3> positions, std::span<glm::vec4> velocities) const {
    read(nullptr, positions, velocities);
}

glm::vec3 WindView::felt(glm::dvec3 position, const Sampling& sampling) const {
    glm::vec3 wind;
    felt(std::span(&position, 1), sampling, std::span(&wind, 1));
    return wind;
}
void WindView::felt(std::span<const glm::dvec3> positions, const Sampling& sampling, std::span<glm::vec3> velocities) const {
    read(&sampling, positions, velocities);
}
void WindView::felt(std::span<const glm::dvec3> positions, const Sampling& sampling, std::span<glm::vec4> velocities) const {
    read(&sampling, positions, velocities);
}

Result<void> WindView::write_vectors(std::span<float> texels) const {
    return write_numbers(shown(), shown_.law.acts(), texels);
}
Result<void> WindView::write_vectors(std::span<std::uint16_t> texels) const {
    return write_numbers(shown(), shown_.law.acts(), texels);
}

template <class Texel>
Result<void> WindView::write_texels(std::span<Texel> x, std::span<Texel> y, std::span<Texel> z) const {
    for (const auto& texels : {x, y, z})
        if (texels.size() != field_.size())
            return Error{detail::message("write_axes got room for ", texels.size(), " texels, but the box has ", field_.size(),
                                         " cells: give three arrays of box().cell_count().")};
    const std::span<const glm::vec4> cells = shown_.law.acts() ? field_ : shown(); // no texture holds the height
    extract_axis(cells, 0, x);
    extract_axis(cells, 1, y);
    extract_axis(cells, 2, z);
    if (!shown_.law.acts() || shown_.reading == nullptr)
        return {};
    shown_.reading->for_each_filled(field_, {box_->cells, shown_.low, shown_.rows_low}, [&](std::uint32_t cell, glm::vec3 u) {
        const glm::vec4 filled(u, 0.0f);
        const std::span one(&filled, 1);
        extract_axis(one, 0, x.subspan(cell, 1));
        extract_axis(one, 1, y.subspan(cell, 1));
        extract_axis(one, 2, z.subspan(cell, 1));
    });
    return {};
}
Result<void> WindView::write_axes(std::span<float> x, std::span<float> y, std::span<float> z) const {
    return write_texels(x, y, z);
}
Result<void> WindView::write_axes(std::span<std::uint16_t> x, std::span<std::uint16_t> y, std::span<std::uint16_t> z) const {
    return write_texels(x, y, z);
}

float WallLaw::fraction(float height) const {
    return numerics::windrow_wall_share(height, per_length, per_log);
}

WindowBlock WindView::block(glm::dvec3 anchor) const {
    anchor = detail::usable_anchor(anchor);
    const float h = box_->cell_size;
    WindowBlock block;
    block.origin = glm::vec3(origin() - anchor);
    block.cell_size = h;
    block.cells = glm::vec3(box_->cells);
    block.rows = box_->rows ? block.cells.y : 0.0f;
    block.height = box_->size().y;
    block.factor = 1.0f;
    block.previous_origin = block.origin;
    block.ambient = ambient_->mean();
    for (int axis = 0; axis < 3; ++axis) {
        block.low_boundaries[axis] = side_number(box_->boundaries.at(axis, 0));
        block.high_boundaries[axis] = side_number(box_->boundaries.at(axis, 1));
    }
    block.wall_per_length = shown_.law.per_length;
    block.wall_per_log = shown_.law.per_log;
    block.wall_lowest = shown_.law.lowest;
    block.wall_fall = shown_.law.fall;
    block.blend_centre = glm::vec3(blend_zone_.point - anchor);
    block.blend_width = blend_zone_.width * h;
    block.blend_reach = blend_zone_.reach * h;
    block.previous_blend_centre = block.blend_centre;
    return block;
}

} // namespace windrow
