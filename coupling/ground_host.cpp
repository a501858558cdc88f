#include "coupling/ground_host.h"

#include "coupling/ground_fading.h"
#include "fluid/core/message.h"
#include "fluid/portable_math.h"
#include "fluid/timed_path.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace windrow::detail {
namespace {

// Beyond this, texels of 1 cm are no longer exact in double.
constexpr double k_farthest = 1e12;

// Rounds a position in texels to the digits of a float within 1024 of the corner: differences of two are exact. Farther away
// only a sweep's direction matters, and differences are rounded.
double rounded(double texels) {
    return std::nearbyint(texels * 16384.0) / 16384.0;
}

} // namespace

Result<void> GroundHost::follow(glm::dvec3 point) {
    if (!is_in_reach(own_place(point)))
        return Error{message("The ground is to follow ", point, ": give finite x and z within ", k_farthest, " m.")};
    point_ = own_place(point);
    return {};
}

Result<void> GroundHost::shift_origin(glm::dvec3 offset) {
    const glm::dvec2 origin = origin_ + glm::dvec2(offset.x, offset.z);
    if (!is_in_reach(origin))
        return Error{message("The origin is to shift by ", offset, ": give finite x and z, in all within ", k_farthest, " m.")};
    origin_ = origin;
    return {};
}

bool GroundHost::is_in_reach(glm::dvec2 point) {
    return std::abs(point.x) <= k_farthest && std::abs(point.y) <= k_farthest;
}

GroundHost::Texel GroundHost::corner_about(glm::dvec2 point) const {
    const double size = config_.texel_size;
    const auto along = [&](double value) {
        return static_cast<std::int64_t>(std::floor(value / size + 0.5)) - config_.texels / 2;
    };
    return {along(point.x), along(point.y)};
}

glm::ivec2 GroundHost::slot_of(Texel corner) const {
    const auto n = static_cast<std::int64_t>(config_.texels);
    const auto along = [&](std::int64_t texel) { return static_cast<int>(((texel % n) + n) % n); };
    return {along(corner.x), along(corner.y)};
}

glm::dvec2 GroundHost::next_centre(glm::ivec2 slot) const {
    const Texel corner = corner_about(point_);
    const glm::ivec2 within = glm::clamp(slot, glm::ivec2(0), glm::ivec2(config_.texels - 1));
    const glm::ivec2 texel = numerics::windrow_ground_in_slot(within, slot_of(corner), config_.texels);
    return origin_ + (glm::dvec2(corner) + glm::dvec2(texel) + 0.5) * static_cast<double>(config_.texel_size);
}

// In texels from the corner; empty where the sweep's bounds are outside the window, or where it presses nothing
// (windrow_ground_contact).
std::optional<numerics::WindrowWalker> GroundHost::local(const GroundWalker& walker, double duration, Texel corner) const {
    const double size = config_.texel_size;
    const auto place = [&](glm::dvec3 world) { return own_place(world) / size - glm::dvec2(corner); };
    const glm::dvec2 to = place(walker.position);
    const glm::dvec3 way(walker.position.x - walker.previous.x, 0.0, walker.position.z - walker.previous.z);
    const bool jumped = detail::is_jump(way, duration, config_.jump_speed); // in no time any way is one
    const glm::dvec2 from = jumped ? to : place(walker.previous);
    const float before = jumped ? walker.foot_height : walker.previous_foot_height;
    if (!(walker.weight > 0.0f) || std::min(before, walker.foot_height) >= config_.clearance ||
        std::max(before, walker.foot_height) <= -2.0f * config_.clearance)
        return std::nullopt;
    // Each place is within 0.71 texels of a centre; at one texel, a foot there still has a quarter of its weight.
    const double radius = std::max(static_cast<double>(walker.radius) / size, 1.0);
    for (int axis = 0; axis < 2; ++axis)
        if (std::max(from[axis], to[axis]) + radius < 0.0 || std::min(from[axis], to[axis]) - radius > config_.texels)
            return std::nullopt;
    numerics::WindrowWalker found;
    found.from = glm::vec4(rounded(from.x), rounded(from.y), before, radius);
    found.to = glm::vec4(rounded(to.x), rounded(to.y), walker.foot_height, walker.weight);
    return found;
}

Result<numerics::WindrowGroundStep> GroundHost::begin(const GroundStep& step, WindLeans leans) {
    Reasons reasons;
    if (!(std::abs(step.wind_lean.x) <= WINDROW_GROUND_MOST_LEAN) || !(std::abs(step.wind_lean.y) <= WINDROW_GROUND_MOST_LEAN))
        reasons.add("GroundStep::wind_lean is (", step.wind_lean.x, ", ", step.wind_lean.y, "): give two numbers within ",
                    WINDROW_GROUND_MOST_LEAN, ".");
    for (std::size_t n = 0; n < step.walkers.size(); ++n)
        if (auto valid = validate(step.walkers[n]); !valid)
            reasons.add("Walker ", n, ": ", valid.error());
    const auto spring = spring_step(config_.spring, step.duration);
    if (!spring)
        reasons.add(spring.error());
    if (!reasons.empty())
        return Error{reasons.take()};

    Place next{.corner = corner_about(point_), .point = point_, .lean = step.wind_lean};
    walker_count_ = 0;
    left_out_ = 0;
    for (const GroundWalker& walker : step.walkers)
        if (const auto found = local(walker, step.duration, next.corner)) {
            if (walker_count_ < walkers_.size())
                walkers_[walker_count_++] = *found;
            else
                ++left_out_;
        }

    const std::int64_t n = config_.texels;
    const auto clamped = [&](std::int64_t by) { return static_cast<int>(std::clamp(by, -n, n)); };
    const Texel by = next.corner - now_.corner;
    if (!begun_)
        now_ = next; // the frame before the first is the first
    before_ = now_;
    now_ = next;

    const auto fall = [&](float seconds) { return -step.duration / static_cast<double>(seconds); };
    const double trail = fall(config_.trail_time), trample = fall(config_.trample_time);
    const glm::ivec2 slot = slot_of(next.corner);
    numerics::WindrowGroundStep block;
    block.window = {config_.texels, slot.x, slot.y, static_cast<int>(walker_count_)};
    block.moved = {begun_ ? clamped(by.x) : config_.texels, begun_ ? clamped(by.y) : config_.texels,
                   leans == WindLeans::each_texel ? 1 : 0, 0};
    block.contact = {config_.clearance, config_.push, config_.trail_fraction, 0.0f};
    block.fading = glm::vec4(glm::dvec4(numerics::expm1(trail), numerics::expm1(trample), trail, trample));
    const FadingResponse rises = fading_response(config_.spring, step.duration, config_.trail_time);
    const FadingResponse released = fading_response(config_.spring, step.duration, config_.trample_time);
    const FadingResponse released_in_gusts = fading_ramp_response(config_.spring, step.duration, config_.trample_time);
    block.faded_place = glm::vec4(glm::dvec4(rises.place, released.place, released_in_gusts.place, 0.0));
    block.faded_velocity = glm::vec4(glm::dvec4(rises.velocity, released.velocity, released_in_gusts.velocity, 0.0));
    block.wind = {next.lean.x, next.lean.y, 0.0f, 0.0f};
    block.spring = std::bit_cast<numerics::WindrowSpringStep>(spring->block());
    begun_ = true;
    return block;
}

GroundPlaceBlock GroundHost::place_block(const Place& place, glm::dvec3 anchor) const {
    const double size = config_.texel_size;
    const glm::dvec2 origin = own_place(anchor), corner = glm::dvec2(place.corner) * size - origin, point = place.point - origin;
    const glm::ivec2 slot = slot_of(place.corner);
    GroundPlaceBlock block;
    block.corner = glm::vec4(corner.x, corner.y, size, config_.texels);
    // The point is within half a texel of the window's middle, and the outermost centres are half a texel within its edge.
    const int reach = config_.texels / 2 - 1;
    block.blend_zone = glm::vec4(point.x, point.y, reach * size, config_.blend_width);
    block.slot = glm::vec4(slot.x, slot.y, place.lean.x, place.lean.y);
    return block;
}

GroundBlock GroundHost::block(glm::dvec3 anchor) const {
    return {.now = place_block(now_, anchor), .before = place_block(before_, anchor)};
}

GroundPlaceBlock GroundHost::next_place(glm::dvec3 anchor) const {
    return place_block({.corner = corner_about(point_), .point = point_, .lean = now_.lean}, anchor);
}

} // namespace windrow::detail
