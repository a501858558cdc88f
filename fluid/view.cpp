#include "fluid/view.h"

#include "fluid/message.h"
#include "fluid/numerics.h"
#include "fluid/view_place.h"

#include <algorithm>
#include <cmath>

namespace windrow {
namespace {

float side_number(const Boundary& side) {
    return side.kind == BoundaryKind::open ? 0.0f : side.kind == BoundaryKind::periodic ? 2.0f : 1.0f;
}

template <class Number>
Result<void> write_numbers(std::span<const glm::vec4> field, std::span<Number> texels) {
    if (texels.size() != 4 * field.size())
        return Error{detail::message("write_vectors got room for ", texels.size(), " numbers, but the box has ", field.size(),
                                     " cells: give one array of 4 * box().cell_count().")};
    pack_vectors(field, texels);
    return {};
}

template <class Texel>
Result<void> write_texels(std::span<const glm::vec4> field, std::span<Texel> x, std::span<Texel> y, std::span<Texel> z) {
    for (const auto& texels : {x, y, z})
        if (texels.size() != field.size())
            return Error{detail::message("write_axes got room for ", texels.size(), " texels, but the box has ", field.size(),
                                         " cells: give three arrays of box().cell_count().")};
    extract_axis(field, 0, x);
    extract_axis(field, 1, y);
    extract_axis(field, 2, z);
    return {};
}

} // namespace

detail::ViewPlace detail::place_in(const Box& box, const Window& window, const BlendZone& blend_zone, const AmbientWind& ambient,
                                   glm::dvec3 position) {
    ViewPlace place;
    glm::dvec3 exact = window.local(position);
    if (!(std::isfinite(exact.x) && std::isfinite(exact.y) && std::isfinite(exact.z))) {
        place.ambient = ambient.mean();
        return place;
    }
    for (int axis = 0; axis < 3; ++axis) // wrapped in double: a large float does not resolve a fraction of a cell
        if (box.boundaries.periodic(axis))
            exact[axis] = std::fmod(exact[axis], static_cast<double>(box.cells[axis]));
    const glm::vec3 local(exact);
    float& share = place.fraction = 1.0f;
    for (int axis = 0; axis < 3 && share > 0.0f; ++axis) {
        int& low = place.low[axis];
        int& high = place.high[axis];
        const auto cells = static_cast<float>(box.cells[axis]);
        const float low_kind = side_number(box.boundaries.at(axis, 0)), high_kind = side_number(box.boundaries.at(axis, 1));
        // Over a cell's size, also where the outermost row has another thickness.
        float from_low = local[axis], from_high = cells - local[axis];
        if (box.rows && axis == 1) {
            const double over = position.y - window.origin().y, h = static_cast<double>(box.cell_size);
            from_low = static_cast<float>(over / h);
            from_high = static_cast<float>((box.rows->top() - over) / h);
        }
        share *= numerics::windrow_edge_share(low_kind == 0.0f ? 1.0f + from_low : k_never_fades,
                                              high_kind == 0.0f ? 1.0f + from_high : k_never_fades, 0.0f);
        // The zone of the whole box may reach beyond a box that was read out of it: both weights count.
        if (const float reach = blend_zone.reach[axis]; reach > 0.0f) {
            const auto from_point =
                static_cast<float>((position[axis] - blend_zone.point[axis]) / static_cast<double>(box.cell_size));
            share *= numerics::windrow_edge_share((reach + from_point) / blend_zone.width,
                                                  (reach - from_point) / blend_zone.width, 1.0f);
        }
        const float sample = numerics::windrow_axis_sample(local[axis], cells, low_kind) - 0.5f;
        const float below = std::floor(sample);
        place.between[axis] = sample - below;
        low = static_cast<int>(below);
        high = low + 1;
        if (low_kind == 2.0f) {
            low = (low + box.cells[axis]) % box.cells[axis];
            high = high % box.cells[axis];
        }
        low = std::clamp(low, 0, box.cells[axis] - 1);
        high = std::clamp(high, 0, box.cells[axis] - 1);
    }
    if (share != 1.0f)
        place.ambient = ambient.velocity(position);
    return place;
}

glm::vec3 WindView::velocity(glm::dvec3 position) const {
    return detail::wind_at(detail::place_in(*box_, window_, blend_zone_, *ambient_, position),
                           [&](int i, int j, int k) { return glm::vec3(field_[box_->index(i, j, k)]); });
}

void WindView::velocity(std::span<const glm::dvec3> positions, std::span<glm::vec3> velocities) const {
    const std::size_t count = std::min(positions.size(), velocities.size());
    for (std::size_t n = 0; n < count; ++n)
        velocities[n] = velocity(positions[n]);
}

glm::vec3 WindView::felt(glm::dvec3 position, const Sampling& sampling) const {
    return ambient_->felt(velocity(position), position, sampling);
}

Result<void> WindView::write_vectors(std::span<float> texels) const {
    return write_numbers(field_, texels);
}
Result<void> WindView::write_vectors(std::span<std::uint16_t> texels) const {
    return write_numbers(field_, texels);
}
Result<void> WindView::write_axes(std::span<float> x, std::span<float> y, std::span<float> z) const {
    return write_texels(field_, x, y, z);
}
Result<void> WindView::write_axes(std::span<std::uint16_t> x, std::span<std::uint16_t> y, std::span<std::uint16_t> z) const {
    return write_texels(field_, x, y, z);
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
    block.blend_centre = glm::vec3(blend_zone_.point - anchor);
    block.blend_width = blend_zone_.width * h;
    block.blend_reach = blend_zone_.reach * h;
    block.previous_blend_centre = block.blend_centre;
    return block;
}

} // namespace windrow
