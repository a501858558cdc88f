#include "fluid/solids/mesh_tree.h"

#include "fluid/portable_math.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <numbers>
#include <numeric>

namespace windrow::detail {
namespace {

constexpr std::size_t k_leaf = 4; // triangles
// [reaches] A part of the tree farther away than this counts as a dipole. At 3 the winding number is right to .07.
constexpr float k_far = 3.0f;
constexpr float k_parallel = 0.70710678f; // cosine of 45 degrees

float square(glm::vec3 v) {
    return glm::dot(v, v);
}

float square_to_box(glm::vec3 low, glm::vec3 high, glm::vec3 p) {
    return square(glm::max(glm::max(low - p, p - high), glm::vec3(0.0f)));
}

float square_to_edge(glm::vec3 edge, glm::vec3 p) {
    const float along = std::clamp(glm::dot(edge, p) / std::max(square(edge), 1e-37f), 0.0f, 1.0f);
    return square(p - along * edge);
}

// Of the plane where the point is between the edges' normal planes, else of the nearest edge: also right without area.
float square_to_triangle(const glm::vec3 (&corner)[3], glm::vec3 normal, glm::vec3 p) {
    bool between = normal != glm::vec3(0.0f);
    float nearest = std::numeric_limits<float>::infinity();
    for (int n = 0; n < 3; ++n) {
        const glm::vec3 edge = corner[(n + 1) % 3] - corner[n], from = p - corner[n];
        between = between && glm::dot(glm::cross(normal, edge), from) >= 0.0f;
        nearest = std::min(nearest, square_to_edge(edge, from));
    }
    const float away = glm::dot(normal, p - corner[0]);
    return between ? away * away : nearest;
}

double solid_angle(const glm::vec3 (&corner)[3], glm::vec3 p) {
    const glm::dvec3 a(corner[0] - p), b(corner[1] - p), c(corner[2] - p);
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    return 2.0 * numerics::atan2(glm::dot(a, glm::cross(b, c)),
                                 la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
}

// The sides of the edges are the same number, of the other sign, for both triangles of an edge.
bool meets(const glm::vec3 (&corner)[3], glm::dvec3 from, glm::dvec3 to) {
    const glm::dvec3 a = glm::dvec3(corner[0]) - from, b = glm::dvec3(corner[1]) - from, c = glm::dvec3(corner[2]) - from;
    const glm::dvec3 way = to - from;
    const double u = glm::dot(way, glm::cross(b, c)), v = glm::dot(way, glm::cross(c, a)), w = glm::dot(way, glm::cross(a, b));
    if (!((u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0)))
        return false;
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double before = glm::dot(normal, a), after = glm::dot(normal, a - way);
    const bool along = before == 0.0 && after == 0.0; // in the triangle's plane: others are crossed, if any
    return !along && ((before <= 0.0 && after >= 0.0) || (before >= 0.0 && after <= 0.0));
}

} // namespace

std::optional<std::array<std::array<glm::vec3, 3>, 2>> halves_of(const std::array<glm::vec3, 3>& corner) {
    std::size_t first = 0; // of the longest edge
    float longest = 0.0f;
    for (std::size_t n = 0; n < 3; ++n)
        if (const float length = glm::distance(corner[n], corner[(n + 1) % 3]); length > longest) {
            longest = length;
            first = n;
        }
    const glm::vec3 a = corner[first], b = corner[(first + 1) % 3], c = corner[(first + 2) % 3], middle = 0.5f * (a + b);
    if (middle == a || middle == b)
        return std::nullopt;
    return std::array{std::array{a, middle, c}, std::array{middle, b, c}};
}

MeshTree::MeshTree(const MeshData& data) {
    std::vector<std::uint32_t> members(data.triangles.size());
    std::iota(members.begin(), members.end(), 0u);
    std::vector<glm::vec3> middles;
    middles.reserve(members.size());
    for (const glm::uvec3& t : data.triangles)
        middles.push_back((data.vertices[t.x] + data.vertices[t.y] + data.vertices[t.z]) / 3.0f);
    triangles_.reserve(members.size());
    nodes_.emplace_back();
    build(0, members, data, middles);
    nodes_.shrink_to_fit();
}

void MeshTree::build(std::size_t at, std::span<std::uint32_t> members, const MeshData& data, std::span<const glm::vec3> middles) {
    constexpr float k_infinity = std::numeric_limits<float>::infinity();
    Node node{.low = glm::vec3(k_infinity), .high = glm::vec3(-k_infinity), .centre{}, .area{}};
    glm::vec3 low = node.low, high = node.high; // of the middles
    glm::dvec3 area(0.0), centre(0.0);
    double weight = 0.0;
    const auto corner = [&](std::uint32_t triangle, int n) { return data.vertices[data.triangles[triangle][n]]; };
    for (const std::uint32_t t : members) {
        const glm::dvec3 a = 0.5 * glm::cross(glm::dvec3(corner(t, 1) - corner(t, 0)), glm::dvec3(corner(t, 2) - corner(t, 0)));
        area += a;
        weight += glm::length(a);
        centre += glm::length(a) * glm::dvec3(middles[t]);
        low = glm::min(low, middles[t]);
        high = glm::max(high, middles[t]);
        for (int n = 0; n < 3; ++n) {
            node.low = glm::min(node.low, corner(t, n));
            node.high = glm::max(node.high, corner(t, n));
        }
    }
    node.area = glm::vec3(area);
    node.centre = weight > 0.0 ? glm::vec3(centre / weight) : 0.5f * (node.low + node.high);
    for (const std::uint32_t t : members)
        for (int n = 0; n < 3; ++n)
            node.reach = std::max(node.reach, glm::distance(node.centre, corner(t, n)));
    if (members.size() <= k_leaf) {
        std::sort(members.begin(), members.end());
        node.first = static_cast<std::uint32_t>(triangles_.size());
        node.count = static_cast<std::uint32_t>(members.size());
        for (const std::uint32_t t : members) {
            const glm::dvec3 normal =
                glm::cross(glm::dvec3(corner(t, 1) - corner(t, 0)), glm::dvec3(corner(t, 2) - corner(t, 0)));
            const double length = glm::length(normal);
            triangles_.push_back({.corner = {corner(t, 0), corner(t, 1), corner(t, 2)},
                                  .normal = length > 0.0 ? glm::vec3(normal / length) : glm::vec3(0.0f),
                                  .number = t});
        }
        nodes_[at] = node;
        return;
    }
    const glm::vec3 size = high - low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::size_t half = members.size() / 2;
    std::nth_element(members.begin(), members.begin() + static_cast<std::ptrdiff_t>(half), members.end(),
                     [&](std::uint32_t a, std::uint32_t b) {
                         return middles[a][axis] != middles[b][axis] ? middles[a][axis] < middles[b][axis] : a < b;
                     });
    node.first = static_cast<std::uint32_t>(nodes_.size());
    nodes_[at] = node;
    nodes_.resize(nodes_.size() + 2);
    build(node.first, members.first(half), data, middles);
    build(node.first + 1, members.subspan(half), data, middles);
}

bool MeshTree::is_sound(std::size_t count) const {
    std::vector<std::uint8_t> depth(nodes_.size(), 0);
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        const Node& node = nodes_[n];
        if (node.count > 0) {
            if (node.first > triangles_.size() || node.count > triangles_.size() - node.first)
                return false;
            continue;
        }
        // A child is behind its parent, so that no walk returns.
        if (node.first <= n || node.first >= nodes_.size() - 1 || depth[n] + 2 >= k_depth)
            return false;
        depth[node.first] = depth[node.first + 1] = static_cast<std::uint8_t>(depth[n] + 1);
    }
    return !nodes_.empty() &&
           std::all_of(triangles_.begin(), triangles_.end(), [&](const Triangle& triangle) { return triangle.number < count; });
}

template <class Enter, class Visit>
std::size_t MeshTree::walk(const Enter& enter, const Visit& visit) const {
    std::uint32_t open[k_depth];
    std::size_t steps = 0;
    int count = 0;
    open[count++] = 0;
    while (count > 0) {
        const Node& node = nodes_[open[--count]];
        ++steps;
        if (!enter(node))
            continue;
        steps += node.count;
        for (const Triangle& triangle : triangles_of(node))
            if (!visit(triangle))
                return steps;
        if (node.count == 0) {
            open[count++] = node.first + 1;
            open[count++] = node.first;
        }
    }
    return steps;
}

float MeshTree::distance(glm::vec3 p, float most) const {
    struct Open {
        std::uint32_t node;
        float square;
    } open[k_depth];
    float nearest = most * most;
    int count = 0;
    open[count++] = {0, square_to_box(nodes_[0].low, nodes_[0].high, p)};
    while (count > 0) {
        const Open next = open[--count];
        if (!(next.square < nearest))
            continue;
        const Node& node = nodes_[next.node];
        for (const Triangle& triangle : triangles_of(node))
            nearest = std::min(nearest, square_to_triangle(triangle.corner, triangle.normal, p));
        if (node.count > 0)
            continue;
        Open near = {node.first, square_to_box(nodes_[node.first].low, nodes_[node.first].high, p)};
        Open far = {node.first + 1, square_to_box(nodes_[node.first + 1].low, nodes_[node.first + 1].high, p)};
        if (far.square < near.square)
            std::swap(near, far);
        open[count++] = far;
        open[count++] = near;
    }
    return std::sqrt(nearest);
}

double MeshTree::winding_number(glm::vec3 p, std::size_t* steps) const {
    double sum = 0.0;
    const std::size_t walked = walk(
        [&](const Node& node) {
            const glm::vec3 to = node.centre - p;
            const float away = square(to), far = k_far * node.reach;
            if (!(away > far * far))
                return true;
            sum += static_cast<double>(glm::dot(node.area, to) / (away * std::sqrt(away)));
            return false;
        },
        [&](const Triangle& triangle) {
            sum += solid_angle(triangle.corner, p);
            return true;
        });
    if (steps != nullptr)
        *steps += walked;
    return sum / (4.0 * std::numbers::pi);
}

bool MeshTree::crosses(glm::vec3 from, glm::vec3 to) const {
    const glm::vec3 low = glm::min(from, to), high = glm::max(from, to);
    bool met = false;
    walk(
        [&](const Node& node) {
            return glm::all(glm::lessThanEqual(node.low, high)) && glm::all(glm::lessThanEqual(low, node.high));
        },
        [&](const Triangle& triangle) {
            met = meets(triangle.corner, glm::dvec3(from), glm::dvec3(to));
            return !met;
        });
    return met;
}

void MeshTree::for_each_near(glm::vec3 point, float most, const std::function<void(std::uint32_t)>& visit) const {
    walk([&](const Node& node) { return square_to_box(node.low, node.high, point) < most * most; },
         [&](const Triangle& triangle) {
             if (square_to_triangle(triangle.corner, triangle.normal, point) < most * most)
                 visit(triangle.number);
             return true;
         });
}

std::size_t MeshTree::for_each_in(glm::vec3 low, glm::vec3 high, const std::function<void(std::uint32_t)>& visit) const {
    const auto meets = [&](glm::vec3 from, glm::vec3 to) {
        return glm::all(glm::lessThanEqual(from, high)) && glm::all(glm::lessThanEqual(low, to));
    };
    return walk([&](const Node& node) { return meets(node.low, node.high); },
                [&](const Triangle& triangle) {
                    const auto& [a, b, c] = triangle.corner;
                    if (meets(glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))))
                        visit(triangle.number);
                    return true;
                });
}

float MeshTree::first_hit(glm::vec3 from, glm::vec3 direction, glm::vec3 along, float most, std::size_t& steps) const {
    glm::vec3 slowness;
    for (int axis = 0; axis < 3; ++axis)
        slowness[axis] = 1.0f / (std::abs(direction[axis]) > 1e-30f ? direction[axis] : 1e-30f);
    float first = most;
    steps += walk(
        [&](const Node& node) {
            const glm::vec3 one = (node.low - from) * slowness, other = (node.high - from) * slowness;
            const glm::vec3 in = glm::min(one, other), out = glm::max(one, other);
            return std::max({in.x, in.y, in.z, 0.0f}) <= std::min({out.x, out.y, out.z, first});
        },
        [&](const Triangle& triangle) {
            if (glm::dot(triangle.normal, along) < k_parallel)
                return true;
            const float at = glm::dot(triangle.corner[0] - from, triangle.normal) / glm::dot(direction, triangle.normal);
            const glm::vec3 point = from + at * direction;
            bool within = at >= 0.0f && at < first;
            for (int n = 0; n < 3; ++n)
                within = within && glm::dot(glm::cross(triangle.normal, triangle.corner[(n + 1) % 3] - triangle.corner[n]),
                                            point - triangle.corner[n]) >= 0.0f;
            if (within)
                first = at;
            return true;
        });
    return first;
}

} // namespace windrow::detail
