#include "fluid/motor_reach.h"

#include "fluid/core/numerics.h"
#include "fluid/gust_tile.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace windrow::detail {
namespace {

// Constants that the shaders compare with.
static_assert(numerics::windrow_sphere == static_cast<glm::uint>(MotorReach::Shape::sphere));
static_assert(numerics::windrow_capsule == static_cast<glm::uint>(MotorReach::Shape::capsule));
static_assert(numerics::windrow_box == static_cast<glm::uint>(MotorReach::Shape::box));
static_assert(numerics::windrow_cone == static_cast<glm::uint>(MotorReach::Shape::cone));
static_assert(numerics::windrow_jet == static_cast<glm::uint>(MotorReach::Shape::jet));
static_assert(numerics::windrow_vortex == static_cast<glm::uint>(MotorReach::Shape::vortex));
static_assert(numerics::windrow_path == static_cast<glm::uint>(MotorReach::Shape::path));
static_assert(numerics::windrow_force == static_cast<glm::uint>(MotorReach::Law::force));
static_assert(numerics::windrow_drive == static_cast<glm::uint>(MotorReach::Law::drive));
static_assert(numerics::windrow_source == static_cast<glm::uint>(MotorReach::Law::source));

constexpr float k_pi = 3.14159265f;
constexpr double k_min_eddy = 1e-3; // [m] shorter ones are noise in any cell
constexpr float k_min_felt = 1e-2f; // [m/s] inflow from a source outside the box

// Cells with centres within `low`..`high` [m from the box's corner]; false if there are none.
bool cover(MotorReach& reach, glm::vec3 low, glm::vec3 high, const Window& window) {
    const float h = window.cell_size;
    const auto place = [&](float metres, int axis) {
        return window.rows && axis == 1 ? static_cast<float>(window.rows->place(static_cast<double>(metres))) : metres / h;
    };
    for (int axis = 0; axis < 3; ++axis) {
        const auto cells = static_cast<float>(window.cells[axis]);
        reach.low[axis] = static_cast<int>(std::clamp(std::floor(place(low[axis], axis) - 0.5f), 0.0f, cells));
        reach.high[axis] = static_cast<int>(std::clamp(std::ceil(place(high[axis], axis) + 0.5f), 0.0f, cells));
        if (reach.low[axis] >= reach.high[axis])
            return false;
    }
    return true;
}

glm::vec3 metres(const Window& window, glm::dvec3 position) {
    return glm::vec3(window.local_rounded(position) * window.units());
}

// To what the cells can hold. Rows may be thicker: they take a mean over their thickness.
float widened(float radius, const Window& window) {
    return numerics::windrow_widened(radius, window.cell_size);
}

float cubed(float x) {
    return x * x * x;
}

// Smallest box around a cone's two end discs, each bounded by a ball.
bool cover_cone(MotorReach& reach, const Window& window) {
    const glm::vec3 start = reach.centre, end = reach.centre + reach.extent;
    return cover(reach, glm::min(start - reach.radius, end - reach.end_radius),
                 glm::max(start + reach.radius, end + reach.end_radius), window);
}

// A column's axis and radii, widened; returns the fraction of its strength that it keeps.
float shape_cone(MotorReach& reach, glm::vec3 axis, float start_radius, float end_radius, const Window& window) {
    const float length = glm::length(axis);
    // A column shorter than three cells could also fall between them. It is lengthened about its middle.
    const float wide_length = 2.0f * widened(0.5f * length, window);
    const glm::vec3 direction = axis / length;
    reach.centre -= 0.5f * (wide_length - length) * direction;
    reach.extent = wide_length * direction;
    reach.radius = widened(start_radius, window);
    reach.end_radius = widened(end_radius, window);
    const auto volume = [](float column, float start, float end) {
        const float sum = 0.5f * (start + end), difference = 0.5f * (end - start);
        return column * (sum * sum + difference * difference / 7.0f);
    };
    return volume(length, start_radius, end_radius) / volume(wide_length, reach.radius, reach.end_radius);
}

// Shape, size and cells of a region about `reach.centre`. Returns the fraction of its strength that a widened region keeps, so
// that its impulse is unchanged; 0 if it covers no cell.
struct RegionReach {
    MotorReach& reach;
    const Window& window;

    float operator()(const Sphere& sphere) const {
        reach.shape = MotorReach::Shape::sphere;
        reach.radius = widened(sphere.radius, window);
        return within(glm::vec3(reach.radius)) ? cubed(sphere.radius / reach.radius) : 0.0f;
    }
    float operator()(const Capsule& capsule) const {
        reach.shape = MotorReach::Shape::capsule;
        reach.extent = capsule.half_axis;
        reach.radius = widened(capsule.radius, window);
        // Volume of the weight: a ball's 32 pi R^3 / 105 and pi R^2 / 3 for each metre of axis.
        const float length = 2.0f * glm::length(capsule.half_axis);
        const auto volume = [&](float radius) { return radius * radius * (32.0f / 105.0f * radius + length / 3.0f); };
        return within(glm::abs(reach.extent) + reach.radius) ? volume(capsule.radius) / volume(reach.radius) : 0.0f;
    }
    float operator()(const AlignedBox& box) const {
        reach.shape = MotorReach::Shape::box;
        float share = 1.0f;
        for (int axis = 0; axis < 3; ++axis) {
            reach.extent[axis] = widened(box.half_size[axis], window);
            share *= box.half_size[axis] / reach.extent[axis];
        }
        return within(reach.extent) ? share : 0.0f;
    }
    float operator()(const Cone& cone) const {
        reach.shape = MotorReach::Shape::cone;
        const float share = shape_cone(reach, cone.axis, cone.start_radius, cone.end_radius, window);
        return cover_cone(reach, window) ? share : 0.0f;
    }

    [[nodiscard]] bool within(glm::vec3 half) const { return cover(reach, reach.centre - half, reach.centre + half, window); }
};

// Effect of a law at full weight; `share` is the fraction left by widening and envelope.
void apply_law(MotorReach& reach, const std::variant<Force, Drive>& law, glm::vec3 direction, float share, double duration) {
    if (const auto* force = std::get_if<Force>(&law)) {
        reach.law = MotorReach::Law::force;
        reach.push = share * force->acceleration * direction;
    } else {
        const auto& drive = std::get<Drive>(law);
        reach.law = MotorReach::Law::drive;
        reach.push = drive.speed * direction;
        // At this limit the drive has replaced the whole wind.
        reach.amount = std::min(share * drive.rate * static_cast<float>(duration), 1e9f);
    }
}

// Eddies of standard deviation `eddies` that travel at `carried` [m/s], `time` [s] after they left `from` [m from the box's low
// corner]. Their default length is proportional to `radius` [m].
void stir(MotorReach& reach, const Turbulence& turbulence, float eddies, glm::dvec3 from, glm::dvec3 carried, double time,
          float radius) {
    reach.eddies = eddies;
    const float length = turbulence.length > 0.0f ? turbulence.length : 2.0f * radius;
    const double texel = std::max(static_cast<double>(length), k_min_eddy) / GustTile::k_longest_texels;
    reach.texels = static_cast<float>(1.0 / texel);
    // Irrational steps: consecutive seeds are far apart in the tile.
    const glm::dvec3 stretch = static_cast<double>(turbulence.seed) * glm::dvec3(0.6180339887498949, 0.0, 0.4142135623730950);
    const glm::dvec3 texels(GustTile::k_side, 2 * GustTile::k_height, GustTile::k_side);
    for (int axis = 0; axis < 3; ++axis) {
        const double place = (from[axis] + std::fmod(carried[axis] * time, texels[axis] * texel)) / -texel;
        reach.tile_place[axis] =
            static_cast<float>(std::fmod(place + std::fmod(stretch[axis], 1.0) * texels[axis], texels[axis])) - 0.5f;
    }
}

// The same for a region that blows along `direction`; `radius` [m] is its smallest.
void stir(MotorReach& reach, const Turbulence& turbulence, const std::variant<Force, Drive>& law, float strength,
          glm::vec3 direction, double time, float radius) {
    if (!(turbulence.intensity > 0.0f))
        return;
    constexpr double k_carried = 0.7; // motor.h
    constexpr float k_weighted = 2.8f;
    double speed = 0.0;
    if (const auto* force = std::get_if<Force>(&law)) {
        const auto size = static_cast<double>(std::abs(force->acceleration));
        speed = std::copysign(std::sqrt(2.0 * size * static_cast<double>(radius)), static_cast<double>(force->acceleration));
        strength *= std::abs(force->acceleration);
    } else {
        speed = static_cast<double>(std::get<Drive>(law).speed);
        strength = std::abs(std::get<Drive>(law).speed);
    }
    stir(reach, turbulence, k_weighted * turbulence.intensity * strength, glm::dvec3(reach.centre),
         k_carried * speed * glm::dvec3(direction), time, radius);
}

// Smallest radius of a widened region.
float min_radius(const MotorReach& reach) {
    if (reach.shape == MotorReach::Shape::box)
        return std::min({reach.extent.x, reach.extent.y, reach.extent.z});
    return reach.radius;
}

// Position of a volume source and its flow, less the part that a wall cuts off. Over a ball cut at s radii the weight is
// (1 - s^2)^3 / 3. Each wall is treated separately. False where the source does not affect the box.
bool blow_into(MotorReach& reach, float flow, const Window& window, const Boundaries& boundaries) {
    reach.extent = reach.centre;
    const glm::vec3 size(window.size());
    for (int axis = 0; axis < 3; ++axis) {
        if (!boundaries.has_solid(axis))
            continue;
        const bool low = boundaries.at(axis, 0).solid();
        const float depth = low ? reach.centre[axis] : size[axis] - reach.centre[axis];
        const float s = std::clamp(depth / reach.radius, -1.0f, 1.0f), s2 = s * s;
        constexpr float k_half = 16.0f / 35.0f;
        const float kept = k_half + s * (1.0f - s2 * (1.0f - s2 * (0.6f - s2 / 7.0f)));
        if (!(kept > 0.0f))
            return false;
        const float inward = reach.radius * 0.125f * cubed(1.0f - s2) * (1.0f - s2) / kept;
        reach.extent[axis] += low ? inward : -inward;
        flow *= kept / (2.0f * k_half);
    }
    reach.push.x = flow;
    const glm::vec3 apart = reach.extent - glm::clamp(reach.extent, glm::vec3(0.0f), size);
    return std::abs(flow) > k_min_felt * 4.0f * k_pi * glm::dot(apart, apart);
}

// S0 of a ball with an outflow of 4 pi R^2 v cubic metres a second: the outflow over the volume of its weight, 32 pi r^3 / 105.
bool shape_source(MotorReach& reach, float radius, float speed, float strength, const Window& window,
                  const Boundaries& boundaries) {
    reach.law = MotorReach::Law::source;
    const bool inside = RegionReach{reach, window}(Sphere{radius}) > 0.0f;
    const float flow = strength * 4.0f * k_pi * radius * radius * speed;
    reach.amount = flow / (32.0f * k_pi / 105.0f * cubed(reach.radius));
    const bool felt = boundaries.in_free_air() && blow_into(reach, flow, window, boundaries);
    if (!inside)
        reach.low = reach.high = glm::ivec3(0);
    return (inside || felt) && reach.amount != 0.0f;
}

struct Preparation {
    const Track& track;
    std::span<const Track::Segment> path;
    double age, duration;
    const Window& window;
    const Boundaries& boundaries;
    std::span<MotorReach> reach;

    int operator()(const DirectionalMotor& motor) const {
        const auto strength = static_cast<float>(motor.envelope.mean(age, age + duration));
        reach[0].centre = metres(window, track.middle());
        const float share = std::visit(RegionReach{reach[0], window}, motor.region);
        apply_law(reach[0], motor.law, motor.direction, strength * share, duration);
        stir(reach[0], motor.turbulence, motor.law, strength * share, motor.direction, age + 0.5 * duration,
             min_radius(reach[0]));
        return strength * share > 0.0f ? 1 : 0;
    }
    int operator()(const JetMotor& motor) const {
        const auto strength = static_cast<float>(motor.envelope.mean(age, age + duration));
        reach[0].centre = metres(window, track.middle());
        shape_cone(reach[0], motor.length * motor.direction, motor.start_radius, motor.end_radius, window);
        reach[0].shape = MotorReach::Shape::jet;
        // Weight times velocity r0 / r over a section is r0 r. Integrated over the length: L r0 (r0 + r1) / 2.
        const auto impulse = [](float length, float start, float end) { return length * start * (start + end); };
        const float share = impulse(motor.length, motor.start_radius, motor.end_radius) /
                            impulse(glm::length(reach[0].extent), reach[0].radius, reach[0].end_radius);
        apply_law(reach[0], motor.law, {1.0f, 0.0f, 0.0f}, strength * share, duration);
        stir(reach[0], motor.turbulence, motor.law, strength * share, motor.direction, age + 0.5 * duration, reach[0].radius);
        return cover_cone(reach[0], window) && strength * share > 0.0f ? 1 : 0;
    }
    int operator()(const VortexMotor& motor) const {
        const auto strength = static_cast<float>(motor.envelope.mean(age, age + duration));
        MotorReach& whirl = reach[0];
        whirl.centre = metres(window, track.middle());
        whirl.shape = MotorReach::Shape::vortex;
        whirl.radius = widened(motor.radius, window);
        const float half_length = widened(motor.half_length, window);
        whirl.extent = half_length * motor.axis;
        whirl.lift = motor.lift;
        // Conserves its angular impulse: arm times volume.
        const float share = cubed(motor.radius / whirl.radius) * (motor.half_length / half_length);
        apply_law(whirl, motor.law, {1.0f, 0.0f, 0.0f}, strength * share, duration);
        const glm::vec3 half = glm::abs(whirl.extent) + whirl.radius;
        return cover(whirl, whirl.centre - half, whirl.centre + half, window) && strength * share > 0.0f ? 1 : 0;
    }
    // Position at the end of the tick: the flow of volume sources is part of the velocity at that time.
    int operator()(const OmniMotor& motor) const {
        reach[0].centre = metres(window, track.here());
        const auto strength = static_cast<float>(motor.envelope.mean(age, age + duration));
        return shape_source(reach[0], motor.radius, motor.speed, strength, window, boundaries) ? 1 : 0;
    }
    int operator()(const PressureMotor& motor) const {
        reach[0].centre = metres(window, track.here());
        const auto strength = static_cast<float>(motor.mean(age, age + duration));
        return shape_source(reach[0], motor.radius, motor.speed, strength, window, boundaries) ? 1 : 0;
    }

    // One reach per segment of the path. The force law divides the tick's impulse by length; the drive's target is the body's
    // velocity on the segment.
    int operator()(const WakeMotor& motor) const {
        const auto strength = static_cast<float>(motor.envelope.mean(age, age + duration));
        const float radius = widened(motor.radius, window);
        const float share = strength * cubed(motor.radius / radius);
        int count = 0;
        for (const Track::Segment& piece : path) {
            MotorReach& swept = reach[static_cast<std::size_t>(count)];
            swept = {};
            swept.shape = MotorReach::Shape::path;
            swept.radius = radius;
            swept.centre = metres(window, piece.start);
            swept.extent = metres(window, piece.end);
            const glm::vec3 way = swept.extent - swept.centre;
            const float length = glm::length(way);
            if (!(length > 0.0f) || !(share > 0.0f))
                continue;
            if (const auto* force = std::get_if<WakeForce>(&motor.law)) {
                swept.law = MotorReach::Law::force;
                swept.push = (share * force->strength / (static_cast<float>(duration) * length)) * way;
            } else {
                const auto& drive = std::get<WakeDrive>(motor.law);
                swept.law = MotorReach::Law::drive;
                swept.push = (drive.entrainment / static_cast<float>(piece.duration)) * way;
                swept.amount = share * drive.per_metre;
            }
            if (motor.turbulence.intensity > 0.0f)
                stir(swept, motor.turbulence, motor.turbulence.intensity * glm::length(swept.push),
                     -window.origin_at(window.origin_cells - window.shifted), glm::dvec3(0.0), 0.0, radius);
            if (cover(swept, glm::min(swept.centre, swept.extent) - radius, glm::max(swept.centre, swept.extent) + radius,
                      window))
                ++count;
        }
        return count;
    }
};

} // namespace

int prepare(const Motor& motor, const Track& track, std::span<const Track::Segment> path, double age, double duration,
            const Window& window, const Boundaries& boundaries, std::span<MotorReach> reach) {
    reach[0] = {};
    return std::visit(Preparation{track, path, age, duration, window, boundaries, reach}, motor);
}

bool before(const MotorReach& a, const MotorReach& b) {
    return std::memcmp(&a, &b, sizeof a) < 0;
}

} // namespace windrow::detail
