// Distances: exact for each shape. Based on: Hart 1996, "Sphere tracing", The Visual Computer 12 (the march along a segment).
#include "fluid/obstacle.h"

#include "fluid/core/message.h"
#include "fluid/core/validation.h"
#include "fluid/portable_math.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <utility>

namespace windrow {
namespace detail {
namespace {

constexpr float k_everywhere = 1e7f; // [m] of the ground: past the ends of the world

glm::vec3 in_grid(const VoxelShape& shape, glm::vec3 p) {
    return p / shape.cell_size + 0.5f * glm::vec3(shape.grid->data().cells);
}

float distance(const Sphere& ball, glm::vec3 p, float) {
    return glm::length(p) - ball.radius;
}

float distance(const Capsule& capsule, glm::vec3 p, float) {
    const float square = glm::dot(capsule.half_axis, capsule.half_axis);
    const float along = square > 0.0f ? std::clamp(glm::dot(p, capsule.half_axis) / square, -1.0f, 1.0f) : 0.0f;
    return glm::length(p - along * capsule.half_axis) - capsule.radius;
}

float distance(const Block& block, glm::vec3 p, float) {
    const glm::vec3 beyond = glm::abs(p) - block.half_size;
    return glm::length(glm::max(beyond, 0.0f)) + std::min(std::max({beyond.x, beyond.y, beyond.z}), 0.0f);
}

float distance(const Cylinder& cylinder, glm::vec3 p, float) {
    const glm::vec2 beyond(glm::length(glm::vec2(p.x, p.z)) - cylinder.radius, std::abs(p.y) - cylinder.half_length);
    return glm::length(glm::max(beyond, 0.0f)) + std::min(std::max(beyond.x, beyond.y), 0.0f);
}

float distance(const Plate& plate, glm::vec3 p, float) {
    return glm::length(glm::vec3(glm::max(glm::abs(glm::vec2(p)) - plate.half_size, 0.0f), p.z));
}

float distance(const MeshShape& shape, glm::vec3 p, float most) {
    return shape.scale * shape.mesh->distance_to(p / shape.scale, most / shape.scale);
}

float distance(const VoxelShape& shape, glm::vec3 p, float most) {
    return shape.cell_size * shape.grid->distance_to(in_grid(shape, p), most / shape.cell_size);
}

// The height over it: the surface may be nearer. From its end or a hole, the distance.
float distance(const Ground& shape, glm::vec3 p, float) {
    const float height = p.y - height_at(shape, p);
    const glm::vec2 at(p.x, p.z);
    float outside = std::numeric_limits<float>::infinity(), end = whole_of(shape).before_end(at);
    for (const HeightMap::Part& part : shape.heights->parts())
        outside = std::min(outside, part_of(shape, part).outside(at));
    if (outside > 0.0f)
        return height > 0.0f ? glm::length(glm::vec2(outside, height)) : outside;
    for (const HeightMap::Part& hole : shape.heights->holes())
        end = std::min(end, part_of(shape, hole).outside(at));
    return std::max(height, -end);
}

glm::vec3 extent(const Sphere& ball) {
    return glm::vec3(ball.radius);
}
glm::vec3 extent(const Capsule& capsule) {
    return glm::abs(capsule.half_axis) + capsule.radius;
}
glm::vec3 extent(const Block& block) {
    return block.half_size;
}
glm::vec3 extent(const Cylinder& cylinder) {
    return {cylinder.radius, cylinder.half_length, cylinder.radius};
}
glm::vec3 extent(const Plate& plate) {
    return {plate.half_size, 0.0f};
}
glm::vec3 extent(const MeshShape& shape) {
    return shape.scale * glm::max(-shape.mesh->low(), shape.mesh->high());
}
glm::vec3 extent(const VoxelShape& shape) {
    return 0.5f * shape.cell_size * glm::vec3(shape.grid->data().cells);
}

glm::vec3 extent(const Ground& ground) {
    const glm::vec2 across = glm::min(whole_of(ground).last, k_everywhere);
    return {across.x, k_everywhere, across.y};
}

Extent own_extent(const auto& shape) {
    const glm::vec3 half = extent(shape);
    return {-half, half};
}
Extent own_extent(const Ground& ground) {
    Extent result = {glm::vec3(-k_everywhere), extent(ground)};
    if (ground.beyond == Beyond::nothing)
        result.low.x = result.low.z = 0.0f;
    return result;
}

float least_thickness(const auto& shape) {
    const glm::vec3 half = extent(shape);
    return 2.0f * std::min({half.x, half.y, half.z});
}
float least_thickness(const Ground& ground) {
    const glm::vec3 size = extent(ground);
    return std::min(size.x, size.z);
}
float least_thickness(const Capsule& capsule) {
    return 2.0f * capsule.radius;
}
float least_thickness(const MeshShape& shape) {
    return shape.scale * shape.mesh->thickness();
}
float least_thickness(const VoxelShape& shape) {
    return shape.cell_size * static_cast<float>(shape.grid->thickness());
}

// Bodies without hollows: the distance from one is a convex function of the way, so its least is where one narrows it down to, by the
// golden section. A search that follows the distance ends too early along a surface.
bool crosses(const auto& convex, glm::vec3 from, glm::vec3 to) {
    constexpr float k_section = 0.618034f;
    constexpr int k_steps = 40; // it is within k_touches of the length after 20
    const float length = glm::distance(from, to), near = k_touches * length;
    if (length == 0.0f)
        return distance(convex, from, 0.0f) <= 0.0f;
    const auto at = [&](float way) { return distance(convex, glm::mix(from, to, way / length), length); };
    float low = 0.0f, high = length, first = high - k_section * length, second = low + k_section * length;
    float by_first = at(first), by_second = at(second);
    for (int n = 0; n < k_steps; ++n) {
        const float least = std::min(by_first, by_second);
        if (least <= near)
            return true;
        if (least - (1.0f - k_section) * (high - low) > near || high - low < near)
            return false; // no place between is so much nearer
        if (by_first < by_second) {
            high = std::exchange(second, first);
            by_second = std::exchange(by_first, at(first = high - k_section * (high - low)));
        } else {
            low = std::exchange(first, second);
            by_first = std::exchange(by_second, at(second = low + k_section * (high - low)));
        }
    }
    return false;
}
// A point on the plane counts as above it, so that each path between its sides has one crossing at least; of two edges that lines go
// through one holds them, so that a plate closes as many faces as it covers. What only rounding parts is on them: a plate that is
// turned by a right angle is tilted by a rounding.
bool crosses(const Plate& plate, glm::vec3 from, glm::vec3 to) {
    const float near = k_touches * glm::distance(from, to);
    if ((from.z < -near) == (to.z < -near))
        return false;
    const glm::vec2 at(glm::mix(from, to, from.z / (from.z - to.z))), size = plate.half_size;
    return glm::all(glm::greaterThanEqual(at, -size - near)) && glm::all(glm::lessThan(at, size - near));
}
bool crosses(const MeshShape& shape, glm::vec3 from, glm::vec3 to) {
    return shape.mesh->crosses(from / shape.scale, to / shape.scale);
}
bool crosses(const Ground& ground, glm::vec3 from, glm::vec3 to) {
    const auto parts = ground.heights->parts();
    return std::any_of(parts.begin(), parts.end(), [&](const HeightMap::Part& part) {
        return least_rise(ground, part_of(ground, part), from, to) <= k_touches * glm::distance(from, to);
    });
}
bool crosses(const VoxelShape& shape, glm::vec3 from, glm::vec3 to) {
    return shape.grid->crosses(in_grid(shape, from), in_grid(shape, to));
}

template <int Count>
std::partial_ordering compare(const glm::vec<Count, float>& a, const glm::vec<Count, float>& b) {
    for (int n = 0; n < Count; ++n)
        if (a[n] != b[n])
            return a[n] <=> b[n];
    return std::partial_ordering::equivalent;
}
std::partial_ordering compare(float a, float b) {
    return a <=> b;
}
std::partial_ordering compare(Beyond a, Beyond b) {
    return a <=> b;
}
template <class Content>
std::partial_ordering compare(const std::shared_ptr<const Content>& a, const std::shared_ptr<const Content>& b) {
    return *a <=> *b;
}
std::partial_ordering compare(const Shape& a, const Shape& b) {
    if (a.index() != b.index())
        return a.index() <=> b.index();
    return std::visit(
        [&]<class Kind>(const Kind& kind) {
            std::partial_ordering order = std::partial_ordering::equivalent;
            for_each_setting(kind, [&](const auto& row, const auto& member) {
                if (order == 0)
                    order = compare(member, std::get<Kind>(b).*row.member);
            });
            return order;
        },
        a);
}

} // namespace

GroundPart part_of(const Ground& ground, const HeightMap::Part& part) {
    constexpr float k_infinite = std::numeric_limits<float>::infinity();
    const glm::vec2 scale(ground.scale.x, ground.scale.z), most = ground.heights->extent();
    GroundPart found{part.low * scale, part.high * scale};
    for (int axis = 0; axis < 2 && ground.beyond == Beyond::edge; ++axis) {
        found.first[axis] = part.low[axis] == 0.0f ? -k_infinite : found.first[axis];
        found.last[axis] = part.high[axis] == most[axis] ? k_infinite : found.last[axis];
    }
    return found;
}

GroundPart whole_of(const Ground& ground) {
    return part_of(ground, {glm::vec2(0.0f), ground.heights->extent()});
}

bool holds(const Ground& ground, glm::vec2 place, float distance) {
    const auto holes = ground.heights->holes();
    return whole_of(ground).before_end(place) >= distance && std::none_of(holes.begin(), holes.end(), [&](const auto& hole) {
               return part_of(ground, hole).before_end(place) > -distance;
           });
}

float height_at(const Ground& ground, glm::vec3 point) {
    const glm::vec3 size = ground.scale;
    return size.y * ground.heights->height(glm::vec2(point.x, point.z) / glm::vec2(size.x, size.z));
}

glm::vec2 part_within(const GroundPart& ground, glm::vec2 from, glm::vec2 to) {
    glm::vec2 part(0.0f, 1.0f);
    const glm::vec2 way = to - from;
    for (int axis = 0; axis < 2; ++axis) {
        if (way[axis] == 0.0f) {
            if (from[axis] < ground.first[axis] || from[axis] > ground.last[axis])
                return {1.0f, 0.0f};
            continue;
        }
        const float a = (ground.first[axis] - from[axis]) / way[axis], b = (ground.last[axis] - from[axis]) / way[axis];
        part = {std::max(part.x, std::min(a, b)), std::min(part.y, std::max(a, b))};
    }
    return part;
}

float least_rise(const Ground& ground, const GroundPart& part, glm::vec3 begin, glm::vec3 end) {
    const glm::vec2 over = part_within(part, {begin.x, begin.z}, {end.x, end.z});
    if (over.x > over.y)
        return std::numeric_limits<float>::infinity();
    const glm::vec3 from = over.x > 0.0f ? glm::mix(begin, end, over.x) : begin,
                    to = over.y < 1.0f ? glm::mix(begin, end, over.y) : end;
    const numerics::WindrowGrid grid = ground.heights->grid();
    const glm::vec2 texel = grid.spacing * glm::vec2(ground.scale.x, ground.scale.z);
    const glm::vec2 start = glm::vec2(from.x, from.z) / texel, way = glm::vec2(to.x, to.z) / texel - start;
    const auto rise = [&](float fraction) {
        const glm::vec3 at = glm::mix(from, to, fraction);
        return at.y - height_at(ground, at);
    };
    // The next line of the grid that each axis meets; beyond the edge there is none.
    glm::ivec2 line(0);
    for (int axis = 0; axis < 2; ++axis) {
        const float last = static_cast<float>(grid.corners[axis] - 1);
        line[axis] = way[axis] > 0.0f ? static_cast<int>(std::floor(std::clamp(start[axis], -1.0f, last))) + 1
                                      : static_cast<int>(std::ceil(std::clamp(start[axis], 0.0f, last + 1.0f))) - 1;
    }
    float at = 0.0f, here = rise(0.0f), least = here;
    while (at < 1.0f) {
        float next = 1.0f;
        for (int axis = 0; axis < 2; ++axis)
            if (way[axis] != 0.0f && line[axis] >= 0 && line[axis] < grid.corners[axis])
                next = std::min(next, std::max((static_cast<float>(line[axis]) - start[axis]) / way[axis], at));
        for (int axis = 0; axis < 2; ++axis)
            if (way[axis] != 0.0f && line[axis] >= 0 && line[axis] < grid.corners[axis] &&
                (static_cast<float>(line[axis]) - start[axis]) / way[axis] <= next)
                line[axis] += way[axis] > 0.0f ? 1 : -1;
        const float middle = rise(0.5f * (at + next)), there = rise(next);
        const float bend = 2.0f * (here + there) - 4.0f * middle, slope = 4.0f * middle - 3.0f * here - there;
        if (bend > 0.0f && slope < 0.0f && -slope < 2.0f * bend)
            least = std::min(least, here - 0.25f * slope * slope / bend);
        least = std::min(least, there);
        at = next;
        here = there;
    }
    return least;
}

glm::vec2 heights_near(const Ground& ground, glm::vec3 point, float distance) {
    const glm::vec2 size(ground.scale.x, ground.scale.z), at(point.x, point.z);
    glm::vec2 range = ground.scale.y * ground.heights->range((at - distance) / size, (at + distance) / size);
    if (!holds(ground, at, distance))
        range.x = -k_everywhere;
    return range;
}

float distance_to(const Shape& shape, glm::vec3 point, float most) {
    return std::visit([&](const auto& kind) { return distance(kind, point, most); }, shape);
}

glm::vec3 normal_at(const Shape& shape, glm::vec3 point, float step, float most) {
    glm::vec3 rise;
    for (int axis = 0; axis < 3; ++axis) {
        glm::vec3 beside(0.0f);
        beside[axis] = step;
        rise[axis] = distance_to(shape, point + beside, most) - distance_to(shape, point - beside, most);
    }
    const float length = glm::length(rise);
    return length > 0.0f ? rise / length : glm::vec3(0.0f);
}

glm::vec3 half_extent(const Shape& shape) {
    return std::visit([](const auto& kind) { return extent(kind); }, shape);
}

Extent extent_of(const PlacedObstacle& obstacle) {
    return extent_of(obstacle.axes, std::visit([](const auto& kind) { return own_extent(kind); }, obstacle.shape));
}

Extent extent_of(const glm::mat3& axes, Extent own) {
    Extent result;
    for (int axis = 0; axis < 3; ++axis) {
        const glm::vec3 a = axes[axis] * own.low[axis], b = axes[axis] * own.high[axis];
        result.low += glm::min(a, b);
        result.high += glm::max(a, b);
    }
    return result;
}

float thickness(const Shape& shape) {
    return std::visit([](const auto& kind) { return least_thickness(kind); }, shape);
}

bool blocks(const Shape& shape, glm::vec3 from, glm::vec3 to) {
    return std::visit([&](const auto& kind) { return crosses(kind, from, to); }, shape);
}

bool same(const Shape& a, const Shape& b) {
    return compare(a, b) == 0;
}

void move_back(std::span<PlacedObstacle> obstacles, double early) {
    const auto back = static_cast<float>(early);
    for (PlacedObstacle& body : obstacles) {
        body.position -= back * body.velocity;
        if (const float angle = back * glm::length(body.spin); angle > 0.0f)
            body.axes = glm::mat3_cast(
                            glm::quat(numerics::cos(-0.5f * angle), numerics::sin(-0.5f * angle) * glm::normalize(body.spin))) *
                        body.axes;
    }
}

bool precedes(const PlacedObstacle& a, const PlacedObstacle& b) {
    std::partial_ordering order = compare(a.position, b.position);
    if (order == 0)
        order = compare(a.shape, b.shape);
    for (int axis = 0; axis < 3 && order == 0; ++axis)
        order = compare(a.axes[axis], b.axes[axis]);
    if (order == 0)
        order = compare(a.velocity, b.velocity);
    if (order == 0)
        order = compare(a.spin, b.spin);
    return order == 0 ? a.surface < b.surface : order < 0;
}

Result<void> validate_pose(glm::dvec3 position, glm::quat orientation, std::optional<glm::vec3> spin) {
    Reasons reasons;
    const FieldPath obstacle{nullptr, "obstacle"};
    check_value(reasons, FieldPath{&obstacle, "position"}, position, k_world_range);
    check_value(reasons, FieldPath{&obstacle, "orientation"}, orientation, {});
    if (spin)
        check_value(reasons, FieldPath{&obstacle, "spin"}, *spin, Range{-1e6, 1e6, "rad/s"});
    return reasons.outcome();
}

} // namespace detail

namespace {

void check_size(detail::Reasons& reasons, const detail::FieldPath& path, const auto& shape) {
    const glm::vec3 half = detail::extent(shape);
    if (const double most = std::max({half.x, half.y, half.z}); most > k_size_range.max)
        reasons.add(path, " reaches ", detail::Figure{most}, " m from its origin: give at most ",
                    detail::Figure{k_size_range.max}, " m.");
}

} // namespace

void check_rules(detail::Reasons& reasons, const detail::FieldPath& path, const MeshShape& shape) {
    if (shape.mesh == nullptr)
        reasons.add(path, " has no mesh: give one that TriangleMesh::create made.");
    else
        check_size(reasons, path, shape);
}

void check_rules(detail::Reasons& reasons, const detail::FieldPath& path, const VoxelShape& shape) {
    if (shape.grid == nullptr)
        reasons.add(path, " has no grid: give one that VoxelGrid::create made.");
    else
        check_size(reasons, path, shape);
}

void check_rules(detail::Reasons& reasons, const detail::FieldPath& path, const Ground& shape) {
    if (shape.heights == nullptr)
        reasons.add(path, " has no heights: give some that HeightMap::create made.");
}

Result<void> validate(const Obstacle& obstacle) {
    return detail::validate_settings(obstacle, "obstacle");
}

} // namespace windrow
