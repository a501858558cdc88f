#include "fluid/grid/box_rules.h"

#include <cassert>

namespace windrow {
namespace {

// Wraps accept any distance; this limit keeps index arithmetic within 32 bits for winds without a clamp.
constexpr float k_farthest_wrap = 65536.0f;

// Applies one wall's mirror to a rule.
void mirror(HaloRule& rule, const Boundary& side, int axis) {
    for (int component = 0; component < 3; ++component) {
        const bool normal = component == axis;
        const bool odd = normal || side.kind == BoundaryKind::no_slip;
        if (odd) {
            rule.scale[component] = -rule.scale[component];
            rule.offset[component] = 2.0f * side.wall_velocity[component] - rule.offset[component];
        }
        if (normal)
            rule.history_scale[component] = -rule.history_scale[component];
    }
    rule.identity = false;
}

// Follows an index outside [0, count) through mirrors and wraps until it is inside, or beyond an open boundary.
HaloRule rule_at(const Boundaries& boundaries, int axis, int index, int count) {
    // The mirrors nearest to the ghost act last on the value: gather them outermost first, then apply in reverse.
    const Boundary* passed[16];
    int passes = 0;
    HaloRule rule;
    while (index < 0 || index >= count) {
        const Boundary& side = boundaries.at(axis, index < 0 ? 0 : 1);
        if (side.kind == BoundaryKind::open) {
            rule.ambient = true;
            rule.identity = false;
            index = index < 0 ? 0 : count - 1;
            break;
        }
        if (side.kind == BoundaryKind::periodic) {
            index += index < 0 ? count : -count;
            continue;
        }
        assert(passes < 16);
        passed[passes++] = &side;
        index = index < 0 ? -1 - index : 2 * count - 1 - index;
    }
    rule.source = index;
    while (!rule.ambient && passes > 0)
        mirror(rule, *passed[--passes], axis);
    return rule;
}

} // namespace

EndRule pressure_end(const Boundary& side) {
    switch (side.kind) {
    case BoundaryKind::open:
        return EndRule::zero_at_ghost;
    case BoundaryKind::periodic:
        return EndRule::periodic;
    default:
        return EndRule::even_at_face;
    }
}

EndRule velocity_end(const Boundary& side, bool normal) {
    switch (side.kind) {
    case BoundaryKind::open:
        return EndRule::zero_at_ghost;
    case BoundaryKind::periodic:
        return EndRule::periodic;
    case BoundaryKind::no_slip:
        return EndRule::zero_at_face;
    default:
        return normal ? EndRule::zero_at_face : EndRule::even_at_face;
    }
}

std::array<std::array<EndRule, 2>, 3> pressure_ends(const Boundaries& boundaries) {
    std::array<std::array<EndRule, 2>, 3> ends{};
    for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end)
            ends[axis][end] = pressure_end(boundaries.at(axis, end));
    return ends;
}

std::array<std::array<EndRule, 2>, 3> velocity_ends(const Boundaries& boundaries, int component) {
    std::array<std::array<EndRule, 2>, 3> ends{};
    for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end)
            ends[axis][end] = velocity_end(boundaries.at(axis, end), axis == component);
    return ends;
}

detail::HostVector<HaloRule> halo_rules(const Box& box, int axis) {
    detail::HostVector<HaloRule> rules(static_cast<std::size_t>(box.cells[axis] + k_halo));
    for (int padded = 0; padded < box.cells[axis] + k_halo; ++padded)
        rules[padded] = rule_at(box.boundaries, axis, padded - k_halo_low, box.cells[axis]);
    return rules;
}

detail::HostVector<HaloRule> carried_rules(const Box& box, int axis) {
    Box slip = box;
    for (Boundary* side : {&slip.boundaries.x_low, &slip.boundaries.x_high, &slip.boundaries.y_low, &slip.boundaries.y_high,
                           &slip.boundaries.z_low, &slip.boundaries.z_high})
        if (side->solid())
            *side = Boundary{BoundaryKind::free_slip};
    return halo_rules(slip, axis);
}

namespace {

NormalGhost ghost(const Box& box, int axis, int end, float open, float wall) {
    const Boundary& side = box.boundaries.at(axis, end);
    const int last = box.cells[axis] - 1, edge = end == 0 ? 0 : last;
    if (side.kind == BoundaryKind::periodic)
        return {last - edge, 1.0f};
    return {edge, side.kind == BoundaryKind::open ? open : wall};
}

} // namespace

NormalGhost velocity_ghost(const Box& box, int axis, int end) {
    return ghost(box, axis, end, 1.0f, -1.0f);
}

NormalGhost potential_ghost(const Box& box, int axis, int end) {
    return ghost(box, axis, end, 0.0f, 1.0f);
}

LegalPlaces legal_places(const Box& box, int axis) {
    const auto cells = static_cast<float>(box.cells[axis]);
    if (box.boundaries.periodic(axis))
        return {-k_farthest_wrap, k_farthest_wrap, cells, 1.0f / cells};
    return {box.boundaries.at(axis, 0).kind == BoundaryKind::open ? -1.0f : -0.5f,
            cells - (box.boundaries.at(axis, 1).kind == BoundaryKind::open ? 0.0f : 0.5f), 0.0f, 0.0f};
}

} // namespace windrow
