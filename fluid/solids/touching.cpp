// Bodies that touch: which of them one is drawn with, and how thick they are together (together.h).
#include "fluid/solids/body_view.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

namespace windrow {
namespace {

constexpr float k_wide = 16.0f;       // [m] bodies that are wider are looked at one by one
constexpr std::size_t k_most_met = 8; // for bodies that one meets as it moves: none is allocated then

bool is_shell(const PlacedObstacle& body) { // no inside, or a surface of its own
    return std::holds_alternative<Plate>(body.shape) || std::holds_alternative<Ground>(body.shape);
}

} // namespace

void Solids::sort_by_place() {
    detail::make_room(extents_, bodies_.size());
    detail::make_room(by_place_, bodies_.size());
    detail::make_room(wide_, bodies_.size());
    by_place_.clear();
    wide_.clear();
    extents_.resize(bodies_.size());
    for (std::uint32_t n = 0; n < bodies_.size(); ++n) {
        const detail::Extent own = detail::extent_of(bodies_[n]);
        extents_[n] = {bodies_[n].position + own.low, bodies_[n].position + own.high};
        if (!std::holds_alternative<Plate>(bodies_[n].shape))
            (own.high.x - own.low.x > k_wide ? wide_ : by_place_).push_back(n);
    }
    const auto order = [&](std::uint32_t a, std::uint32_t b) { return extents_[a].low.x < extents_[b].low.x; };
    std::sort(by_place_.begin(), by_place_.end(), order);
}

// Ground is drawn without regard to bodies, and bodies at rest without regard to those that move.
bool Solids::is_drawn_before(const PlacedObstacle& body, const PlacedObstacle& other) {
    return std::holds_alternative<Ground>(other.shape) || (body.moves() && !other.moves());
}

void Solids::find_beside(std::size_t number) {
    beside_.clear();
    const PlacedObstacle &body = bodies_[number], &whole = wholes_.of(number);
    if (is_shell(body))
        return;
    const float margin = 2.0f * box_.coarsest(); // a face that it closes in part may be as far from the other body
    const glm::ivec3 images(box_.boundaries.periodic(0), box_.boundaries.periodic(1), box_.boundaries.periodic(2));
    const auto add = [&](std::uint32_t other, glm::vec3 by) {
        const detail::Extent &a = extents_[number], &b = extents_[other];
        if (glm::any(glm::greaterThan(b.low + by, a.high + margin)) || glm::any(glm::lessThan(b.high + by, a.low - margin)))
            return;
        const PlacedObstacle& beside = wholes_.of(other);
        if ((!body.moves() && beside.moves()) || wholes_.are_of_one(number, other))
            return;
        const glm::vec3 from = beside.position + by - body.position;
        const auto is_it = [&](const PlacedObstacle& one) { return wholes_.is_part(other) && one.position == from; };
        if (std::any_of(beside_.begin(), beside_.end(), is_it) ||
            !Together::touch(whole, beside, from - wholes_.part(number).from, box_.cell_size))
            return;
        beside_.push_back(beside);
        beside_.back().position = from;
    };
    if (body.moves() && beside_.capacity() < k_most_met)
        beside_.reserve(k_most_met);
    for (int z = -images.z; z <= images.z; ++z)
        for (int y = -images.y; y <= images.y; ++y)
            for (int x = -images.x; x <= images.x; ++x) {
                const glm::vec3 by = glm::vec3(x, y, z) * box_.size();
                const auto add_other = [&](std::uint32_t other) { // its own images close a face once, whatever they touch
                    if (other != number)
                        add(other, by);
                };
                std::for_each(wide_.begin(), wide_.end(), add_other);
                const float first = extents_[number].low.x - margin - k_wide - by.x,
                            last = extents_[number].high.x + margin - by.x;
                auto near = std::lower_bound(by_place_.begin(), by_place_.end(), first,
                                             [&](std::uint32_t other, float low) { return extents_[other].low.x < low; });
                for (; near != by_place_.end() && extents_[*near].low.x <= last; ++near)
                    add_other(*near);
            }
}

// What the image of a body is drawn with.
void Solids::collect_together(std::size_t number, const View& view, std::span<const PlacedObstacle> beside) {
    together_.begin(view.body, box_.cell_size, View::k_far * box_.coarsest());
    if (is_shell(view.body))
        return;
    for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end)
            if (!is_open_end(axis, end) && !box_.boundaries.periodic(axis))
                together_.add_wall(axis, end == 1, view.from_middle(glm::vec3(end * box_.cells))[axis]);
    for (const PlacedObstacle& other : beside)
        together_.add(other, other.position - wholes_.part(number).from, is_drawn_before(bodies_[number], other));
    together_.end();
}

// [m] Of a block or a cylinder with what it touches all over a flat side, along the axis where that is least, at most `most`; of another
// shape its own.
float Solids::thickness_together(std::size_t number, float own, float most) {
    constexpr float k_inset = 0.98f; // of the way to a side's edge
    const PlacedObstacle& whole = wholes_.of(number);
    glm::vec3 half(0.0f), across(0.0f); // of its flat sides: the places that are looked from
    bool flat[3] = {false, true, false};
    if (const auto* const block = std::get_if<Block>(&whole.shape)) {
        half = across = block->half_size;
        flat[0] = flat[2] = true;
    } else if (const auto* const cylinder = std::get_if<Cylinder>(&whole.shape)) {
        half = {cylinder->radius, cylinder->half_length, cylinder->radius};
        across = {0.7f * cylinder->radius, cylinder->half_length, 0.7f * cylinder->radius};
    } else {
        return own;
    }
    collect_together(number, View(whole, glm::ivec3(0), box_), beside_);
    for (int axis = 0; axis < 3; ++axis) {
        const float width = 2.0f * half[axis], room = most - width;
        if (!(room > 0.0f))
            continue;
        const glm::vec3 way = whole.axes[axis];
        float beside[2] = {flat[axis] ? room : 0.0f, flat[axis] ? room : 0.0f};
        for (int n = 0; n < 9 && beside[0] + beside[1] > 0.0f; ++n) {
            glm::vec3 at(0.0f);
            at[(axis + 1) % 3] = k_inset * static_cast<float>(n % 3 - 1) * across[(axis + 1) % 3];
            at[(axis + 2) % 3] = k_inset * static_cast<float>(n / 3 - 1) * across[(axis + 2) % 3];
            const glm::vec3 middle = whole.axes * at;
            for (int side = 0; side < 2; ++side) {
                const glm::vec3 out = side == 0 ? way : -way;
                beside[side] = std::min(beside[side], together_.run_from(middle + half[axis] * out, out, beside[side]));
            }
        }
        most = std::min(most, width + beside[0] + beside[1]);
    }
    return most;
}

// Whether two lists of one length hold the same bodies: in one order, but where rounding has changed it.
bool Solids::are_same(std::span<const PlacedObstacle> bodies, std::span<const PlacedObstacle> others) const {
    for (std::size_t n = 0; n < bodies.size(); ++n)
        if (!is_same(bodies[n], others[n]) && !stands_in(bodies[n], others))
            return false;
    return true;
}

// Whether two bodies beside another are one; rounding may have moved it a little.
bool Solids::is_same(const PlacedObstacle& body, const PlacedObstacle& other) const {
    return glm::all(glm::lessThan(glm::abs(body.position - other.position), glm::vec3(k_touch * box_.cell_size))) &&
           body.surface == other.surface && body.axes == other.axes && detail::same(body.shape, other.shape);
}

bool Solids::stands_in(const PlacedObstacle& body, std::span<const PlacedObstacle> list) const {
    return std::any_of(list.begin(), list.end(), [&](const PlacedObstacle& other) { return is_same(body, other); });
}

} // namespace windrow
