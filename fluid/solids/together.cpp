#include "fluid/solids/together.h"

#include "fluid/solids/edges.h"
#include "fluid/solids/wholes.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

namespace windrow {
namespace {

constexpr float k_touching = Wholes::k_seam;
constexpr float k_normal_step = 0.1f; // [cells]
constexpr float k_seam_step = 0.02f;  // [cells]
constexpr float k_deepest_seam =
    0.6f;                  // of `far`: no seam that deep is looked for, the corners of a face are nearer to each other
constexpr int k_seams = 2; // that meet: of a third one the distance is taken as it is
constexpr float k_ways[] = {1.0f, 0.5f, 0.25f, 0.1f}; // of `far`, from a seam to where the bodies are looked at

// [m] From a box; 0 within it.
float outside(const detail::Extent& box, glm::vec3 place) {
    return glm::length(glm::max(glm::max(box.low - place, place - box.high), 0.0f));
}

// An order of two bodies that is the same wherever the box is, and in a scene that is mirrored in x or z or turned about y: by their
// heights, by what they are and how fast, and last by where they are.
bool other_precedes(const PlacedObstacle& own, const PlacedObstacle& other, glm::vec3 from, float touch) {
    if (std::abs(from.y) > touch)
        return from.y < 0.0f;
    const auto in_no_direction = [](PlacedObstacle body) {
        body.position = glm::vec3(0.0f);
        body.axes = glm::mat3(1.0f);
        body.velocity = {glm::length(body.velocity), 0.0f, 0.0f};
        body.spin = {glm::length(body.spin), 0.0f, 0.0f};
        return body;
    };
    const PlacedObstacle here = in_no_direction(own), there = in_no_direction(other);
    if (detail::precedes(there, here) || detail::precedes(here, there))
        return detail::precedes(there, here);
    for (const int axis : {0, 2})
        if (std::abs(from[axis]) > touch)
            return from[axis] < 0.0f;
    return other.slot < own.slot;
}

} // namespace

void Together::begin(const PlacedObstacle& body, float cell, float far) {
    constexpr std::size_t k_room = 12; // bodies that move allocate nothing when they meet others
    if (bodies_.capacity() < k_room)
        bodies_.reserve(k_room);
    if (bridges_.capacity() < k_room)
        bridges_.reserve(k_room);
    bodies_.clear();
    has_wall_ = {};
    any_wall_ = any_before_ = false;
    any_edges_ = detail::has_sharp_edges(body.shape);
    has_seams_ = !(std::holds_alternative<MeshShape>(body.shape) && body.moves());
    cell_ = cell;
    far_ = far;
    bodies_.push_back({.body = &body,
                       .to_own = glm::transpose(body.axes),
                       .from = glm::vec3(0.0f),
                       .extent = detail::extent_of(body),
                       .drawn_before = false,
                       .precedes = false});
}

void Together::add_wall(int axis, bool high, float away) {
    const auto end = static_cast<std::size_t>(2 * axis + (high ? 1 : 0));
    walls_[end] = away;
    has_wall_[end] = any_wall_ = true;
}

void Together::add(const PlacedObstacle& other, glm::vec3 from, bool drawn_before) {
    const detail::Extent own = detail::extent_of(other);
    bodies_.push_back({.body = &other,
                       .to_own = glm::transpose(other.axes),
                       .from = from,
                       .extent = {from + own.low, from + own.high},
                       .drawn_before = drawn_before,
                       .precedes = other_precedes(*bodies_[0].body, other, from, k_touching * cell_)});
    any_before_ = any_before_ || drawn_before;
    any_edges_ = any_edges_ || (!drawn_before && detail::has_sharp_edges(other.shape));
}

// A block and another one of the same axes hold a third, along each axis along which they touch: as long as both, and across what they have
// in common. It is as deep beside their seam as they are together.
void Together::add_bridges(const Body& other, std::size_t& count) {
    const float seam = k_touching * cell_;
    const glm::vec3 half[2] = {std::get<Block>(bodies_[0].body->shape).half_size, std::get<Block>(other.body->shape).half_size};
    const glm::vec3 from = bodies_[0].to_own * other.from;
    const glm::vec3 low[2] = {-half[0], from - half[1]}, high[2] = {half[0], from + half[1]};
    const glm::vec3 common_low = glm::max(low[0], low[1]), common_high = glm::min(high[0], high[1]);
    for (int axis = 0; axis < 3; ++axis) {
        glm::vec3 from_low = common_low, to_high = common_high;
        from_low[axis] = std::min(low[0][axis], low[1][axis]);
        to_high[axis] = std::max(high[0][axis], high[1][axis]);
        const auto is_one = [&](int which) {
            return glm::all(glm::lessThanEqual(low[which], from_low + seam)) &&
                   glm::all(glm::greaterThanEqual(high[which], to_high - seam));
        };
        if (glm::any(glm::lessThan(to_high - from_low, glm::vec3(seam))) || is_one(0) || is_one(1))
            continue;
        if (count == bridges_.size())
            return;
        PlacedObstacle& bridge = bridges_[count++];
        bridge = {.shape = Block{.half_size = 0.5f * (to_high - from_low)}, .axes = bodies_[0].body->axes};
        const detail::Extent own = detail::extent_of(bridge);
        const glm::vec3 middle = bridge.axes * (0.5f * (from_low + to_high));
        bodies_.push_back({.body = &bridge,
                           .to_own = bodies_[0].to_own,
                           .from = middle,
                           .extent = {middle + own.low, middle + own.high},
                           .drawn_before = false,
                           .precedes = false,
                           .is_bridge = true});
    }
}

void Together::end() {
    const std::size_t bodies = bodies_.size();
    bridges_.resize(3 * bodies); // all at once: they must stay
    std::size_t count = 0;
    const auto is_block = [](const Body& body) { return std::holds_alternative<Block>(body.body->shape); };
    for (std::size_t n = 1; n < bodies && is_block(bodies_[0]); ++n)
        if (const Body other = bodies_[n]; is_block(other) && !other.drawn_before && other.body->axes == bodies_[0].body->axes)
            add_bridges(other, count);
}

// Infinitely far where there is none.
Together::Nearest Together::nearest(glm::vec3 place, Of of, float most) const {
    Nearest found{std::numeric_limits<float>::infinity(), nullptr};
    for (const Body& body : bodies_) {
        if ((of != Of::all && body.drawn_before != (of == Of::before)) ||
            (found.body != nullptr && outside(body.extent, place) > std::max(found.away, 0.0f)))
            continue;
        const float away = body.distance(place, most);
        if (found.body == nullptr || away < found.away)
            found = {away, &body};
    }
    return found;
}

float Together::away(glm::vec3 place, Of of, int seams) const {
    const Nearest surface = nearest(place, of, seams == 0 ? far_ : k_deepest_seam * far_);
    const bool may_be_seam = surface.away <= k_touching * cell_ && surface.away > -k_deepest_seam * far_ && seams < k_seams &&
                             (any_wall_ || bodies_.size() > 1);
    return may_be_seam ? depth(place, surface, of, seams) : surface.away;
}

// Whether a body reaches as far as a surface that is so near to a place inside of another one.
bool Together::others_reach(glm::vec3 place, const Nearest& surface) const {
    const float reach = 4.0f * k_touching * cell_ - surface.away;
    return bodies_.size() > 1 && std::any_of(bodies_.begin(), bodies_.end(), [&](const Body& body) {
               return &body != surface.body && outside(body.extent, place) <= reach &&
                      body.distance(place, 2.0f * reach) <= reach;
           });
}

Together::Apart Together::apart(glm::vec3 place) const {
    const Nearest before = nearest(place, Of::before, far_);
    if (before.away < -0.5f * far_) // so are all corners of a face
        return {before.away, before.away};
    if (before.away < 0.0f)
        place -= before.away * out_of(*before.body, place, k_normal_step * cell_, -before.away);
    return {away(place, Of::own, 0), before.away};
}

glm::vec3 Together::out_of(const Body& body, glm::vec3 place, float step, float most) const {
    return body.body->axes * detail::normal_at(body.body->shape, body.to_own * (place - body.from), step, most + 4.0f * step);
}

glm::vec3 Together::normal(glm::vec3 place, float step) const {
    glm::vec3 rise;
    for (int axis = 0; axis < 3; ++axis) {
        glm::vec3 beside(0.0f);
        beside[axis] = step;
        rise[axis] = nearest(place + beside, Of::all, far_).away - nearest(place - beside, Of::all, far_).away;
    }
    const float length = glm::length(rise);
    return length > 0.0f ? rise / length : glm::vec3(0.0f);
}

// Out of the box where the surface nearest to a place inside stands on its wall; 0 where it does not.
glm::vec3 Together::wall_at(glm::vec3 place, const Nearest& surface) const {
    const float seam = k_touching * cell_;
    for (int end = 0; end < 6 && any_wall_; ++end) {
        const float side = end % 2 == 0 ? -1.0f : 1.0f, to_wall = side * (walls_[static_cast<std::size_t>(end)] - place[end / 2]);
        if (!has_wall_[static_cast<std::size_t>(end)] || std::abs(to_wall + surface.away) > 2.0f * seam)
            continue;
        glm::vec3 out(0.0f);
        out[end / 2] = side;
        if (std::abs(surface.body->distance(place + to_wall * out, 8.0f * seam)) <= 3.0f * seam)
            return out;
    }
    return glm::vec3(0.0f);
}

// Whether air is about a place on a surface: in one of 26 ways.
bool Together::is_in_air(glm::vec3 place) const {
    const float seam = k_touching * cell_;
    for (int way = 0; way < 27; ++way) {
        const glm::vec3 to(way % 3 - 1, way / 3 % 3 - 1, way / 9 - 1);
        if (way != 13 && nearest(place + 8.0f * seam * glm::normalize(to), Of::all, 9.0f * seam).away > 1.5f * seam)
            return true;
    }
    return false;
}

// Out of the surface nearest to a place inside, if this is a seam of bodies that touch: no air is beyond it. Else 0. Where several are
// as near, none of them may be a surface.
glm::vec3 Together::seam_at(glm::vec3 place, const Nearest& surface) const {
    const float seam = k_touching * cell_, beyond = 4.0f * seam - surface.away;
    glm::vec3 out = out_of(*surface.body, place, k_seam_step * cell_, -surface.away);
    if (surface.away >= -seam)
        return is_in_air(place) ? glm::vec3(0.0f) : out;
    glm::vec3 found(0.0f);
    for (int way = -1; way < 6; ++way) { // the second and later ones where it is as near in several ways
        if (way >= 0) {
            glm::vec3 aside(0.0f);
            aside[way / 2] = (way % 2 == 0 ? -2.5f : 2.5f) * k_seam_step * cell_;
            out = out_of(*surface.body, place + aside, k_seam_step * cell_, -surface.away);
        }
        const glm::vec3 at = place + beyond * out;
        if (out == glm::vec3(0.0f) || surface.body->distance(at, 8.0f * seam) < 2.0f * seam)
            continue;
        if (nearest(at, Of::all, 8.0f * seam).away > -2.0f * seam)
            return glm::vec3(0.0f);
        found = out;
        if (way < 0)
            break;
    }
    return found;
}

// Inside: that of the nearest surface, or if this is a seam, that of a ball on both sides of it.
float Together::depth(glm::vec3 place, const Nearest& surface, Of of, int seams) const {
    glm::vec3 out = wall_at(place, surface);
    const bool at_wall = out != glm::vec3(0.0f);
    if (!at_wall)
        out = has_seams_ && others_reach(place, surface) ? seam_at(place, surface) : glm::vec3(0.0f);
    if (out == glm::vec3(0.0f))
        return surface.away;
    float deepest = surface.away;
    for (const float way : k_ways) {
        float ball = away(place - way * far_ * out, of, seams + 1);
        if (!at_wall && ball < deepest)
            ball = std::max(ball, away(place + (way * far_ - surface.away) * out, Of::all, seams + 1));
        deepest = std::min(deepest, ball);
    }
    return deepest;
}

bool Together::is_anothers(glm::vec3 place) const {
    if (bodies_.size() == 1)
        return false;
    const float seam = k_touching * cell_, own = bodies_[0].distance(place, far_);
    return std::any_of(bodies_.begin() + 1, bodies_.end(), [&](const Body& body) {
        if (body.drawn_before || body.is_bridge || outside(body.extent, place) > std::max(own, 0.0f) + seam)
            return false;
        const float away = body.distance(place, far_);
        return away < own - seam || (away <= own + seam && body.precedes);
    });
}

bool Together::blocks(glm::vec3 from, glm::vec3 to) const {
    return std::any_of(bodies_.begin(), bodies_.end(), [&](const Body& body) {
        return !body.drawn_before && !body.is_bridge &&
               detail::blocks(body.body->shape, body.to_own * (from - body.from), body.to_own * (to - body.from));
    });
}

bool Together::is_beyond_wall(glm::vec3 place) const {
    for (int end = 0; end < 6 && any_wall_; ++end)
        if (has_wall_[static_cast<std::size_t>(end)] &&
            (end % 2 == 0 ? -1.0f : 1.0f) * (place[end / 2] - walls_[static_cast<std::size_t>(end)]) >= 0.0f)
            return true;
    return false;
}

glm::vec3 Together::edges_at(glm::vec3 place, glm::vec3 cell_size) const {
    constexpr float k_reach = 1.5f, k_whole = 1.0f; // [cells] an edge farther away has no part in a cell, and one as near all
    constexpr float k_askew = 0.97f, k_aligned = 0.995f; // cosine of its angle to an axis: 14 and 6 degrees
    const float reach = k_reach * std::max({cell_size.x, cell_size.y, cell_size.z});
    const auto near = [&](glm::vec3 at) {
        return std::clamp((k_reach - glm::length((at - place) / cell_size)) / (k_reach - k_whole), 0.0f, 1.0f);
    };
    std::array<detail::SharpEdge, 16> edges;
    glm::vec3 most(0.0f);
    for (const Body& body : bodies_) {
        if (body.drawn_before || body.is_bridge || outside(body.extent, place) > reach)
            continue;
        const glm::mat3& axes = body.body->axes;
        const glm::vec3 own = body.to_own * (place - body.from);
        const std::size_t count = detail::sharp_edges_near(body.body->shape, own, reach, cell_, edges);
        for (const detail::SharpEdge& edge : std::span(edges).first(count)) {
            const glm::vec3 beside = axes * glm::normalize(edge.normal - edge.other);
            const float length = glm::distance(edge.from, edge.to);
            const glm::vec3 way = (edge.to - edge.from) / length, along = glm::abs(axes * way);
            const int axis = along.x > k_askew ? 0 : along.y > k_askew ? 1 : 2;
            const float aligned = std::clamp((along[axis] - k_askew) / (k_aligned - k_askew), 0.0f, 1.0f);
            const auto place_of = [&](float from_end) { return body.from + axes * (edge.from + from_end * way); };
            const auto look = [&](float from_end) {
                const glm::vec3 at = place_of(from_end);
                if (const float part = aligned * near(at); part > most[axis])
                    most[axis] = std::max(most[axis], part * sharpness(at, beside));
            };
            // Another body may cover it where it is nearest: then a place along it where none does.
            constexpr int k_places = 12;                         // to either side
            const float apart = reach / k_places;                // [m]
            const float middle = glm::dot(own - edge.from, way); // [m] from its end to the place beside this one
            const float nearest = std::clamp(middle, 0.0f, length);
            look(nearest);
            for (int n = 1; n <= k_places && most[axis] < aligned * near(place_of(nearest)); ++n)
                for (const float at : {middle - static_cast<float>(n) * apart, middle + static_cast<float>(n) * apart})
                    if (at > 0.0f && at < length)
                        look(at);
        }
    }
    return most;
}

// Of an edge at a place; `beside`, a unit vector, is across it and along neither surface.
float Together::sharpness(glm::vec3 edge, glm::vec3 beside) const {
    constexpr float k_away = 0.5f;                  // [cells] from the edge
    constexpr float k_right = 0.70710678f;          // of that way, how far the surface is there beside a right angle
    constexpr float k_blunt = 0.5f, k_sharp = 0.8f; // of that
    const auto away = [&](glm::vec3 at) { return is_beyond_wall(at) ? 0.0f : nearest(at, Of::all, far_).away; };
    const glm::vec3 way = k_away * cell_ * beside;
    const float sharp = std::min(away(edge + way), away(edge - way)) / (k_right * k_away * cell_);
    return std::clamp((sharp - k_blunt) / (k_sharp - k_blunt), 0.0f, 1.0f);
}

float Together::run_from(glm::vec3 place, glm::vec3 way, float most) const {
    constexpr float k_step = 0.25f;                 // [cells] a gap that is thinner may be missed
    const auto is_beyond_wall = [&](glm::vec3 at) { // one that the way is across
        for (int end = 0; end < 6; ++end)
            if (has_wall_[static_cast<std::size_t>(end)] && std::abs(way[end / 2]) > 0.999f &&
                (end % 2 == 0 ? -1.0f : 1.0f) * (at[end / 2] - walls_[static_cast<std::size_t>(end)]) >= 0.0f)
                return true;
        return false;
    };
    float run = 0.0f;
    while (run < most) {
        const glm::vec3 at = place + (run + 2.0f * k_touching * cell_) * way;
        if (is_beyond_wall(at))
            return most;
        const float away = nearest(at, Of::all, far_).away;
        if (away > k_touching * cell_)
            return run;
        run += std::max(-away, k_step * cell_);
    }
    return most;
}

bool Together::touch(const PlacedObstacle& one, const PlacedObstacle& other, glm::vec3 from, float cell) {
    const float seam = k_touching * cell;
    const detail::Extent a = detail::extent_of(one);
    detail::Extent b = detail::extent_of(other);
    b = {b.low + from, b.high + from};
    const detail::Extent both{glm::max(a.low, b.low), glm::min(a.high, b.high)};
    if (glm::any(glm::greaterThan(both.low, both.high + seam)))
        return false;
    const auto* const block = std::get_if<Block>(&one.shape);
    const auto* const other_block = std::get_if<Block>(&other.shape);
    if (block != nullptr && other_block != nullptr && one.axes == other.axes) {
        const glm::vec3 gap = glm::abs(glm::transpose(one.axes) * from) - block->half_size - other_block->half_size;
        return std::max({gap.x, gap.y, gap.z}) <= seam;
    }
    // From some places to the nearer of both, in turn: to where both are, if both are convex thereabouts.
    constexpr int k_turns = 16;
    const float most = glm::length(both.high - both.low) + 4.0f * cell;
    const glm::vec3 middle = 0.5f * (both.low + both.high);
    const glm::mat3 to_own[2] = {glm::transpose(one.axes), glm::transpose(other.axes)};
    for (const glm::vec3 start :
         {middle, glm::vec3(middle.x, both.low.y, middle.z), glm::vec3(both.low.x, both.low.y, both.low.z),
          glm::vec3(both.high.x, both.low.y, both.low.z), glm::vec3(both.low.x, both.low.y, both.high.z),
          glm::vec3(both.high.x, both.low.y, both.high.z)}) {
        glm::vec3 place = start;
        float before = std::numeric_limits<float>::infinity();
        for (int turn = 0; turn < k_turns; ++turn) {
            const glm::vec3 own[2] = {to_own[0] * place, to_own[1] * (place - from)};
            const float away[2] = {detail::distance_to(one.shape, own[0], most), detail::distance_to(other.shape, own[1], most)};
            const int farther = away[0] > away[1] ? 0 : 1;
            if (away[farther] <= seam)
                return true;
            if (turn % 4 == 3 && away[farther] > 0.8f * std::exchange(before, away[farther]))
                break; // they do not come nearer
            const PlacedObstacle& body = farther == 0 ? one : other;
            const float step = k_normal_step * cell;
            const glm::vec3 out = body.axes * detail::normal_at(body.shape, own[farther], step, away[farther] + 4.0f * step);
            if (out == glm::vec3(0.0f))
                break;
            place -= away[farther] * out;
        }
    }
    return false;
}

} // namespace windrow
