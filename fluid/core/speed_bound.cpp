#include "fluid/core/speed_bound.h"

#include "fluid/core/ambient_numerics.h"
#include "fluid/core/numerics.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

namespace windrow {
namespace {

using detail::MotorReach;

constexpr float k_around_bodies = 2.0f; ///< air around a body over what meets it: potential flow past a cylinder

float largest_component(const glm::vec3& u) {
    return std::max({std::abs(u.x), std::abs(u.y), std::abs(u.z)});
}

// Cells that are not finite become ambient.
float largest_component(std::span<const glm::vec4> cells) {
    float largest = 0.0f;
    for (const glm::vec4& u : cells)
        if (const float component = largest_component(glm::vec3(u)); std::isfinite(component))
            largest = std::max(largest, component);
    return largest;
}

// Largest component of a motor's force or target velocity at any place.
float largest_push(const MotorReach& motor, float longest_eddy) {
    float push = largest_component(motor.push);
    if (motor.shape == MotorReach::Shape::jet) { // its rays slant, and are faster where it narrows
        const float slope = (motor.end_radius - motor.radius) / glm::length(motor.extent);
        push *= std::sqrt(1.0f + slope * slope) * motor.radius / std::min(motor.radius, motor.end_radius);
    } else if (motor.shape == MotorReach::Shape::vortex) {
        push *= std::sqrt(1.0f + motor.lift * motor.lift);
    }
    return push + motor.eddies * longest_eddy;
}

// Sides that an axis is closed or periodic at reflect a source.
int mirrors(const Boundaries& boundaries, int axis) {
    int count = 0;
    for (int end = 0; end < 2; ++end)
        count += boundaries.at(axis, end).kind != BoundaryKind::open ? 1 : 0;
    return count;
}

// A ball of S0 [1/s] and radius R in free air: at most .1247 S0 R, at .593 R (windrow_source_potential). A wall doubles it;
// between two, all of its 32 pi / 105 S0 R^3 pass a section of the box.
float largest_source_flow(const MotorReach& motor, const Box& box) {
    const float strength = std::abs(motor.amount), radius = motor.radius;
    float flow = 0.125f * strength * radius;
    bool duct = false;
    for (int axis = 0; axis < 3; ++axis) {
        const int count = mirrors(box.boundaries, axis);
        flow *= count > 0 ? 2.0f : 1.0f;
        duct = duct || count == 2;
    }
    if (duct) {
        const glm::vec3 size = box.size();
        const float section = std::min({size.x * size.y, size.y * size.z, size.z * size.x});
        flow += strength * 0.958f * radius * radius * radius / section;
    }
    return flow;
}

} // namespace

float largest_ambient(const AmbientWind& ambient, const Window& window, float* gusts) {
    const AmbientBlock block = ambient.block(window.origin());
    const float top = block.anchor_height + static_cast<float>(window.size().y);
    const float factor = block.roughness_length > 0.0f
                             ? std::max(1.0f, numerics::windrow_profile(top, block.roughness_length, block.reference_height))
                             : 1.0f;
    const float varying = ambient.gusting() ? block.gust_strength * block.longest_gust : 0.0f;
    if (gusts != nullptr)
        *gusts = varying;
    return factor * largest_component(block.mean) + varying;
}

void SpeedBound::note(const CellChange& change) {
    using Kind = CellChange::Kind;
    const float ambient_before = ambient_;
    if (change.kind == Kind::fill || change.kind == Kind::add_wind || change.kind == Kind::set || change.kind == Kind::add_change)
        ambient_ = std::max(ambient_, largest_ambient(change.ambient, change.window));
    const float more = std::max(ambient_ - ambient_before, 0.0f);
    if (change.kind == Kind::fill) {
        waiting_.air.reset(ambient_);
        waiting_.apart.reset(0.0f);
        waiting_.expected.reset(k_around_bodies * ambient_);
        source_flow_ = 0.0f;
    } else if (change.kind == Kind::set) {
        const float largest = largest_component(change.cells);
        waiting_.air.reset(std::max(largest, ambient_));
        waiting_.apart.reset(largest + ambient_);
        waiting_.expected.reset(k_around_bodies * std::max(largest, ambient_));
    } else if (change.kind == Kind::add_wind) {
        waiting_.air.by(ambient_);
        if (change.factor < 0.0f)
            taken_ = change.ambient.mean();
        else
            waiting_.expected.by(std::max(more, largest_component(change.ambient.mean() - taken_)));
    } else if (change.kind == Kind::add_change && change.to_air) {
        waiting_.air.by(ambient_); // the profile at its top included
        waiting_.expected.by(largest_component(change.change));
    }
}

void SpeedBound::note_read(std::span<const glm::vec4> air, const AmbientWind& ambient, const Window& window) {
    const float largest = largest_component(air), around = largest_ambient(ambient, window);
    waiting_.air.reset(std::max(largest, around));
    waiting_.apart.reset(largest + around);
}

void SpeedBound::note(const CellStep& step, const Box& box) {
    ambient_ = largest_ambient(*step.ambient, *step.window, &gusts_);
    float target = std::max(ambient_, step.outer_speed), moved = 0.0f, force = 0.0f, flow = 0.0f;
    for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end)
            target = std::max(target, largest_component(box.boundaries.at(axis, end).wall_velocity));
    for (const detail::PlacedObstacle& body : step.obstacles) {
        const float turning =
            body.spin == glm::vec3(0.0f) ? 0.0f : glm::length(body.spin) * glm::length(detail::half_extent(body.shape));
        moved = std::max(moved, k_around_bodies * (largest_component(body.velocity) + turning));
    }
    const float longest_eddy = step.tile ? step.tile->bound() : 0.0f;
    for (const MotorReach& motor : step.motors) {
        if (motor.law == MotorReach::Law::drive)
            target = std::max(target, largest_push(motor, longest_eddy));
        else if (motor.law == MotorReach::Law::force)
            force += largest_push(motor, longest_eddy);
        else
            flow += largest_source_flow(motor, box);
    }
    const float duration = static_cast<float>(step.duration);
    if (step.renews_sources) { // the flow of before goes, the new one comes
        for (Rise* rise : {&waiting_.air, &waiting_.apart})
            rise->by(source_flow_ + flow);
        waiting_.expected.by(std::max(flow - source_flow_, 0.0f));
    }
    source_flow_ = step.has_source_flow ? flow : 0.0f;
    waiting_.expected.toward(std::max(target, moved) + source_flow_);
    target = std::max({target, moved, step.obstacles.empty() ? 0.0f : k_around_bodies * ambient_});
    waiting_.air.toward(target);
    waiting_.apart.toward(target > ambient_ ? target + ambient_ : 0.0f);
    for (Rise* rise : {&waiting_.air, &waiting_.apart, &waiting_.expected})
        rise->by(duration * force);
    ticks_[++last_ % k_ticks] = {.rises = std::exchange(waiting_, {})};
}

void SpeedBound::note(const MeasuredSpeeds& speeds) {
    for (const MeasuredSpeed& speed : speeds) {
        if (speed.tick == 0 || speed.tick > last_ || last_ - speed.tick >= k_ticks)
            continue;
        Tick& tick = ticks_[speed.tick % k_ticks];
        if (tick.measured < 0.0f || &speed == &speeds.front()) {
            tick.measured = speed.largest;
            tick.still = speed.still;
        }
    }
}

float SpeedBound::expected_after(std::uint64_t tick) const {
    Rise since;
    for (; tick > 0; --tick) {
        if (last_ - tick >= k_ticks)
            return k_unknown;
        if (at(tick).measured >= 0.0f)
            return since.of(at(tick).measured);
        since = at(tick).rises.expected.then(since);
    }
    return since.of(0.0f); // the wind's first tick begins with air that was filled
}

int SpeedBound::substeps(const Config& config, double duration) const {
    if (!config.stages.advection)
        return 1;
    const std::uint64_t from = last_ > k_delay ? last_ - k_delay : 0;
    Rise since;
    for (std::uint64_t tick = from + 1; tick <= last_; ++tick)
        since = since.then(at(tick).rises.expected);
    const double wanted = std::ceil(static_cast<double>(since.of(expected_after(from))) * duration /
                                    static_cast<double>(config.cell_size * config.max_cfl));
    return numerics::windrow_substeps(static_cast<float>(wanted), config.max_substeps);
}

bool SpeedBound::was_still(std::uint64_t undisturbed) const {
    for (std::uint64_t ago = k_delay; ago < std::min({undisturbed, last_, std::uint64_t{k_ticks}}); ++ago)
        if (at(last_ - ago).measured >= 0.0f)
            return at(last_ - ago).still;
    return false;
}

float SpeedBound::after(std::uint64_t read_tick, float largest, float apart) const {
    if (last_ - read_tick >= k_ticks)
        return k_unknown;
    Rises since;
    for (std::uint64_t tick = read_tick + 1; tick <= last_; ++tick) {
        since.air = since.air.then(at(tick).rises.air);
        since.apart = since.apart.then(at(tick).rises.apart);
    }
    return std::min(k_margin * since.air.of(largest) + 2.0f * gusts_, k_margin * since.apart.of(apart) + ambient_);
}

} // namespace windrow
