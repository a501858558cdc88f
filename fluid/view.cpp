#include "fluid/view.h"

#include "fluid/message.h"
#include "fluid/numerics.h"

#include <algorithm>
#include <cmath>

namespace windrow {
namespace {

float side_number(const Boundary& side) {
    return side.kind == BoundaryKind::open ? 0.0f : side.kind == BoundaryKind::periodic ? 2.0f : 1.0f;
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

float WindView::blend_fraction(glm::dvec3 position) const {
    float share = 1.0f;
    for (int axis = 0; axis < 3; ++axis)
        if (blend_zone_.reach[axis] > 0.0f) {
            const double cells = (position[axis] - blend_zone_.point[axis]) / static_cast<double>(box_->cell_size);
            share *= numerics::windrow_blend_fraction(static_cast<float>(cells), blend_zone_.reach[axis], blend_zone_.width);
        }
    return share;
}

glm::vec3 WindView::velocity(glm::dvec3 position) const {
    glm::dvec3 exact = window_.local(position);
    if (!(std::isfinite(exact.x) && std::isfinite(exact.y) && std::isfinite(exact.z)))
        return ambient_->mean();
    for (int axis = 0; axis < 3; ++axis) // wrapped in double: a large float does not resolve a fraction of a cell
        if (box_->boundaries.periodic(axis))
            exact[axis] = std::fmod(exact[axis], static_cast<double>(box_->cells[axis]));
    const glm::vec3 local(exact);
    float share = blend_fraction(position);
    glm::ivec3 low(0), high(0);
    glm::vec3 between(0.0f);
    for (int axis = 0; axis < 3 && share > 0.0f; ++axis) {
        const auto cells = static_cast<float>(box_->cells[axis]);
        const float low_kind = side_number(box_->boundaries.at(axis, 0)), high_kind = side_number(box_->boundaries.at(axis, 1));
        share *= numerics::windrow_axis_fraction(local[axis], cells, low_kind, high_kind);
        const float sample = numerics::windrow_axis_sample(local[axis], cells, low_kind) - 0.5f;
        const float below = std::floor(sample);
        between[axis] = sample - below;
        low[axis] = static_cast<int>(below);
        high[axis] = low[axis] + 1;
        if (low_kind == 2.0f) {
            low[axis] = (low[axis] + box_->cells[axis]) % box_->cells[axis];
            high[axis] = high[axis] % box_->cells[axis];
        }
        low[axis] = std::clamp(low[axis], 0, box_->cells[axis] - 1);
        high[axis] = std::clamp(high[axis], 0, box_->cells[axis] - 1);
    }
    if (share <= 0.0f)
        return ambient_->velocity(position);
    const auto cell = [&](int i, int j, int k) { return glm::vec3(field_[box_->index(i, j, k)]); };
    const auto line = [&](int j, int k) { return glm::mix(cell(low.x, j, k), cell(high.x, j, k), between.x); };
    const auto plane = [&](int k) { return glm::mix(line(low.y, k), line(high.y, k), between.y); };
    const glm::vec3 inside = glm::mix(plane(low.z), plane(high.z), between.z);
    return share == 1.0f ? inside : glm::mix(ambient_->velocity(position), inside, share);
}

void WindView::velocity(std::span<const glm::dvec3> positions, std::span<glm::vec3> velocities) const {
    const std::size_t count = std::min(positions.size(), velocities.size());
    for (std::size_t n = 0; n < count; ++n)
        velocities[n] = velocity(positions[n]);
}

glm::vec3 WindView::felt(glm::dvec3 position, const Sampling& sampling) const {
    return ambient_->felt(velocity(position), position, sampling);
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
