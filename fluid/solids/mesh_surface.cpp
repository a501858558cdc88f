// An edge between two triangles is passed by one of them from its first end to its second, and by the other back. So a surface is
// closed, and its winding number is whole, where each edge is passed as often one way as the other.
//
// The surface of the union of its parts has the inside on one side alone. That changes only where another part crosses it. So of connected
// triangles that no other part crosses, one winding number decides for all.
// Based on: Jacobson, Kavan & Sorkine-Hornung 2013, ACM Transactions on Graphics 32 (whole winding numbers of closed surfaces).
#include "fluid/solids/mesh_surface.h"

#include "fluid/core/message.h"
#include "fluid/solids/mesh_signs.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>
#include <tuple>

namespace windrow::detail {
namespace {

auto by_place(const glm::vec3& v) {
    return std::tuple(v.x, v.y, v.z);
}

/// One of a triangle's edges, its ends in order.
struct Edge {
    std::uint32_t low, high;
    std::uint32_t triangle;
    bool forward; ///< from low to high

    [[nodiscard]] auto ends() const { return std::pair(low, high); }
};

std::vector<Edge> sorted_edges(const MeshData& data) {
    std::vector<Edge> edges;
    edges.reserve(3 * data.triangles.size());
    for (std::uint32_t t = 0; t < data.triangles.size(); ++t)
        for (int n = 0; n < 3; ++n) {
            const std::uint32_t from = data.triangles[t][n], to = data.triangles[t][(n + 1) % 3];
            edges.push_back({std::min(from, to), std::max(from, to), t, from < to});
        }
    std::sort(edges.begin(), edges.end(),
              [](const Edge& a, const Edge& b) { return std::pair(a.ends(), a.triangle) < std::pair(b.ends(), b.triangle); });
    return edges;
}

/// Sets that are joined two by two, each known by its least member.
class Sets {
  public:
    explicit Sets(std::size_t count) : lower_(count) { std::iota(lower_.begin(), lower_.end(), 0u); }
    [[nodiscard]] std::uint32_t of(std::uint32_t member) {
        while (lower_[member] != member)
            member = lower_[member] = lower_[lower_[member]];
        return member;
    }
    void join(std::uint32_t one, std::uint32_t other) {
        one = of(one);
        other = of(other);
        lower_[std::max(one, other)] = std::min(one, other);
    }

  private:
    std::vector<std::uint32_t> lower_;
};

/// Of triangles for which go_on(triangle), by the edges that two alone have in common.
template <class GoOn>
Sets joined(const std::vector<Edge>& edges, std::size_t triangles, const GoOn& go_on) {
    Sets sets(triangles);
    for (std::size_t n = 0, next = 0; n < edges.size(); n = next) {
        while (next < edges.size() && edges[next].ends() == edges[n].ends())
            ++next;
        if (next - n == 2 && go_on(edges[n].triangle) && go_on(edges[n + 1].triangle))
            sets.join(edges[n].triangle, edges[n + 1].triangle);
    }
    return sets;
}

/// Edges that are not passed as often one way as the other.
struct Faults {
    std::size_t open = 0;   ///< with a triangle too few
    std::size_t turned = 0; ///< whose triangles face opposite ways
    Edge first_open{}, first_turned{};
};

Faults faults_of(const std::vector<Edge>& edges) {
    Faults faults;
    for (std::size_t n = 0; n < edges.size();) {
        const Edge& first = edges[n];
        int forward = 0, all = 0;
        for (; n < edges.size() && edges[n].ends() == first.ends(); ++n, ++all)
            forward += edges[n].forward ? 1 : 0;
        if (2 * forward == all)
            continue;
        const bool open = all % 2 != 0;
        Edge& noted = open ? faults.first_open : faults.first_turned;
        if (std::size_t& count = open ? faults.open : faults.turned; count++ == 0 || first.triangle < noted.triangle)
            noted = first;
    }
    return faults;
}

/// The same for the same corners in the same order around.
glm::uvec3 from_lowest(glm::uvec3 t) {
    while (t.x > t.y || t.x > t.z)
        t = {t.y, t.z, t.x};
    return t;
}

void leave_out_doubled(MeshData& data) {
    const auto key = [&](std::uint32_t t) {
        const glm::uvec3 corners = from_lowest(data.triangles[t]);
        return std::tuple(corners.x, corners.y, corners.z, t);
    };
    std::vector<std::uint32_t> order(data.triangles.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    std::vector<bool> doubled(order.size());
    for (std::size_t n = 1; n < order.size(); ++n)
        doubled[order[n]] = from_lowest(data.triangles[order[n]]) == from_lowest(data.triangles[order[n - 1]]);
    std::size_t kept = 0;
    for (std::size_t t = 0; t < data.triangles.size(); ++t)
        if (!doubled[t])
            data.triangles[kept++] = data.triangles[t];
    data.triangles.resize(kept);
}

// Those that two triangles alone have in common. Most of the surface faces outward where its volume is positive.
MeshEdges sharp_edges(const MeshData& data, const std::vector<Edge>& edges) {
    constexpr float k_flat = 0.77f; // cosine of 40 degrees
    const auto corner = [&](std::uint32_t t, int n) { return glm::dvec3(data.vertices[data.triangles[t][n]]); };
    double volume = 0.0;
    for (std::uint32_t t = 0; t < data.triangles.size(); ++t)
        volume += glm::dot(corner(t, 0), glm::cross(corner(t, 1), corner(t, 2)));
    const auto normal = [&](std::uint32_t t) {
        const glm::dvec3 across = glm::cross(corner(t, 1) - corner(t, 0), corner(t, 2) - corner(t, 0));
        const double length = glm::length(across);
        return length > 0.0 ? glm::vec3((volume < 0.0 ? -across : across) / length) : glm::vec3(0.0f);
    };
    MeshEdges sharp;
    MeshData thin;
    for (std::size_t n = 0, next = 0; n < edges.size(); n = next) {
        while (next < edges.size() && edges[next].ends() == edges[n].ends())
            ++next;
        if (next - n != 2)
            continue;
        const glm::vec3 one = normal(edges[n].triangle), other = normal(edges[n + 1].triangle);
        const glm::vec3 from = data.vertices[edges[n].low], to = data.vertices[edges[n].high];
        const glm::uvec3 beyond = data.triangles[edges[n + 1].triangle];
        float over = 0.0f; // of the other triangle's third corner over the first one's plane
        for (int c = 0; c < 3; ++c)
            if (beyond[c] != edges[n].low && beyond[c] != edges[n].high)
                over = glm::dot(one, data.vertices[beyond[c]] - from);
        if (one == glm::vec3(0.0f) || other == glm::vec3(0.0f) || glm::dot(one, other) > k_flat || over > 0.0f)
            continue;
        sharp.edges.push_back({from, to, one, other});
        const auto first = static_cast<std::uint32_t>(thin.vertices.size());
        thin.vertices.insert(thin.vertices.end(), {from, to});
        thin.triangles.emplace_back(first, first + 1, first + 1);
    }
    if (!sharp.edges.empty())
        sharp.tree = std::make_unique<MeshTree>(thin);
    return sharp;
}

// A triangle without a margin along its edges, or with one beyond them if it is negative, as what a plane through it and the planes across its edges bound.
class Inner {
  public:
    Inner(const std::array<glm::vec3, 3>& corner, float margin) : corner_(corner), margin_(margin) {
        const glm::dvec3 across = glm::cross(glm::dvec3(corner[1] - corner[0]), glm::dvec3(corner[2] - corner[0]));
        if (const double length = glm::length(across); length > 0.0)
            normal_ = glm::vec3(across / length);
        for (int n = 0; n < 3; ++n)
            in_[n] = glm::normalize(glm::cross(normal_, corner[(n + 1) % 3] - corner[n]));
    }
    [[nodiscard]] bool any() const { return normal_ != glm::vec3(0.0f); }
    /// [m] From its plane.
    [[nodiscard]] float over(glm::vec3 place) const { return glm::dot(normal_, place - corner_[0]); }
    /// Whether a part of a segment in its plane is in it.
    [[nodiscard]] bool holds_some(glm::vec3 from, glm::vec3 to) const {
        float first = 0.0f, last = 1.0f;
        for (int n = 0; n < 3; ++n) {
            const float one = glm::dot(in_[n], from - corner_[n]) - margin_, other = glm::dot(in_[n], to - corner_[n]) - margin_;
            if (one <= 0.0f && other <= 0.0f)
                return false;
            if (one < 0.0f)
                first = std::max(first, one / (one - other));
            if (other < 0.0f)
                last = std::min(last, one / (one - other));
        }
        return first <= last;
    }

  private:
    const std::array<glm::vec3, 3>& corner_;
    float margin_;
    glm::vec3 normal_{0.0f}, in_[3];
};

// Whether a triangle meets another one, or an edge of it one in the same plane; what is nearer than `touch` to that plane is in it.
bool cuts(const std::array<glm::vec3, 3>& corner, const Inner& inner, float touch) {
    glm::vec3 in_plane[3];
    int count = 0;
    float over[3];
    for (int n = 0; n < 3; ++n)
        if (over[n] = inner.over(corner[n]); std::abs(over[n]) <= touch)
            in_plane[count++] = corner[n];
    if (count == 3)
        return inner.holds_some(corner[0], corner[1]) || inner.holds_some(corner[1], corner[2]) ||
               inner.holds_some(corner[2], corner[0]);
    for (int n = 0; n < 3 && count < 2; ++n) {
        const float one = over[n], other = over[(n + 1) % 3];
        if (std::min(one, other) < -touch && std::max(one, other) > touch)
            in_plane[count++] = glm::mix(corner[n], corner[(n + 1) % 3], one / (one - other));
    }
    return count > 0 && inner.holds_some(in_plane[0], in_plane[count - 1]);
}

// Work is bounded by the number of triangles, so that what is left of crowded parts counts as surface.
class Union {
  public:
    Union(const MeshData& data, std::span<const std::uint32_t> parts, const MeshTree& tree)
        : data_(data), parts_(parts), tree_(tree), looks_left_(1'000 * data.triangles.size()),
          cuts_left_(2'000'000 + 500 * data.triangles.size()) {
        glm::vec3 low = data.vertices.front(), high = low;
        for (const glm::vec3& place : data.vertices) {
            low = glm::min(low, place);
            high = glm::max(high, place);
        }
        const float longest = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
        touch_ = k_touching * longest;
        smallest_ = k_smallest * longest;
    }

    MeshData surface() {
        const auto count = static_cast<std::uint32_t>(data_.triangles.size());
        std::vector<bool> is_cut = repeated(); // or touched: another part may begin along its edge
        const std::vector<bool> is_again = is_cut;
        bool all = true;
        for (std::uint32_t t = 0; t < count && looks_left_ > 0; ++t) {
            if (is_again[t])
                continue;
            others_.clear();
            find_others(t);
            is_cut[t] = !others_.empty();
            if (is_cut[t])
                all = cut(piece_of(t), 0) == Is::surface && all;
        }
        Sets alike = joined(sorted_edges(data_), count, [&](std::uint32_t t) { return !is_cut[t]; });
        std::vector<bool> is_within(count); // of those that are the least of their set
        for (std::uint32_t t = 0; t < count; ++t) {
            if (is_cut[t])
                continue;
            const std::uint32_t first = alike.of(t);
            if (first == t)
                is_within[t] = looks_left_ > 0 && lies_within(piece_of(t), looks_left_);
            if (is_within[first])
                all = false;
            else
                keep(piece_of(t));
        }
        return all ? MeshData{} : std::move(surface_);
    }

  private:
    using Piece = std::array<glm::vec3, 3>;
    enum class Is : std::uint8_t { surface, within, both };
    static constexpr float k_touching = 1e-4f, k_smallest = 1.0f / 128.0f; // of the longest side

    [[nodiscard]] Piece piece_of(std::uint32_t t) const {
        const glm::uvec3 corners = data_.triangles[t];
        return {data_.vertices[corners.x], data_.vertices[corners.y], data_.vertices[corners.z]};
    }
    /// Triangles with the corners of an earlier one, whichever way they face.
    [[nodiscard]] std::vector<bool> repeated() const {
        std::vector<std::pair<std::array<std::uint32_t, 3>, std::uint32_t>> keys;
        keys.reserve(data_.triangles.size());
        for (std::uint32_t t = 0; t < data_.triangles.size(); ++t) {
            const glm::uvec3 triangle = data_.triangles[t];
            std::array<std::uint32_t, 3> corners{triangle.x, triangle.y, triangle.z};
            std::sort(corners.begin(), corners.end());
            keys.emplace_back(corners, t);
        }
        std::sort(keys.begin(), keys.end());
        std::vector<bool> again(keys.size());
        for (std::size_t n = 1; n < keys.size(); ++n)
            again[keys[n].second] = keys[n].first == keys[n - 1].first;
        return again;
    }
    static void spend(std::size_t steps, std::size_t& left) { left -= std::min(steps, left); }
    void keep(const Piece& piece) {
        const auto first = static_cast<std::uint32_t>(surface_.vertices.size());
        surface_.vertices.insert(surface_.vertices.end(), piece.begin(), piece.end());
        surface_.triangles.emplace_back(first, first + 1, first + 2);
    }
    /// Triangles of other parts that cut one, or touch it.
    void find_others(std::uint32_t t) {
        const Piece piece = piece_of(t);
        const Inner around(piece, -2.0f * touch_);
        if (!around.any())
            return;
        const glm::vec3 low = glm::min(piece[0], glm::min(piece[1], piece[2])),
                        high = glm::max(piece[0], glm::max(piece[1], piece[2]));
        const std::size_t steps = tree_.for_each_in(low - touch_, high + touch_, [&](std::uint32_t other) {
            if (parts_[other] != parts_[t] && cuts(piece_of(other), around, touch_))
                others_.push_back(other);
        });
        spend(steps, looks_left_);
    }
    /// Whether both of its sides are inside.
    [[nodiscard]] bool lies_within(const Piece& piece, std::size_t& left) const {
        const glm::dvec3 across = glm::cross(glm::dvec3(piece[1] - piece[0]), glm::dvec3(piece[2] - piece[0]));
        const double length = glm::length(across);
        if (!(length > 0.0))
            return false;
        const glm::vec3 middle = (piece[0] + piece[1] + piece[2]) / 3.0f, out = touch_ * glm::vec3(across / length);
        std::size_t steps = 0;
        const bool within =
            winds_around(tree_.winding_number(middle + out, &steps)) && winds_around(tree_.winding_number(middle - out, &steps));
        spend(steps, left);
        return within;
    }
    /// Keeps the parts of a piece that are a surface, as large as they can be. `others_` from `first` on may cut it.
    Is cut(const Piece& piece, std::size_t first) {
        const std::size_t end = others_.size();
        const Inner inner(piece, 2.0f * touch_);
        for (std::size_t n = first; n < end && inner.any(); ++n)
            if (const std::uint32_t other = others_[n]; cuts(piece_of(other), inner, touch_))
                others_.push_back(other);
        spend(end - first, cuts_left_);
        const Is is = others_.size() > end ? cut_in_two(piece, end) : whole(piece);
        others_.resize(end);
        return is;
    }
    Is whole(const Piece& piece) {
        if (cuts_left_ > 0 && lies_within(piece, cuts_left_))
            return Is::within;
        keep(piece);
        return Is::surface;
    }
    Is cut_in_two(const Piece& piece, std::size_t first) {
        const float longest =
            std::max({glm::distance(piece[0], piece[1]), glm::distance(piece[1], piece[2]), glm::distance(piece[2], piece[0])});
        const auto halves = longest <= smallest_ || cuts_left_ == 0 ? std::nullopt : halves_of(piece);
        if (!halves)
            return whole(piece);
        const std::size_t vertices = surface_.vertices.size(), triangles = surface_.triangles.size();
        const Is one = cut((*halves)[0], first), other = cut((*halves)[1], first);
        if (one != other)
            return Is::both;
        if (one == Is::surface) {
            surface_.vertices.resize(vertices);
            surface_.triangles.resize(triangles);
            keep(piece);
        }
        return one;
    }

    const MeshData& data_;
    std::span<const std::uint32_t> parts_;
    const MeshTree& tree_;
    std::size_t looks_left_, cuts_left_; ///< nodes and triangles that may be looked at
    float touch_ = 0.0f, smallest_ = 0.0f;
    std::vector<std::uint32_t> others_; ///< a stack
    MeshData surface_;
};

} // namespace

Result<void> check_parts(const MeshData& data) {
    constexpr std::size_t k_most = TriangleMesh::k_max_triangles;
    if (data.triangles.empty())
        return Error{"the mesh has no triangles: give the triangles of a closed surface."};
    if (data.triangles.size() > k_most || data.vertices.size() > 3 * k_most)
        return Error{message("the mesh has ", data.triangles.size(), " triangles and ", data.vertices.size(),
                             " vertices: give at most ", k_most, " and ", 3 * k_most, ", which is finer than any box of cells.")};
    for (std::size_t t = 0; t < data.triangles.size(); ++t)
        for (int n = 0; n < 3; ++n)
            if (data.triangles[t][n] >= data.vertices.size())
                return Error{message("triangle ", t, " of the mesh has the vertex ", data.triangles[t][n], " of ",
                                     data.vertices.size(), ": give indices from 0 to ", data.vertices.size() - 1, ".")};
    for (std::size_t v = 0; v < data.vertices.size(); ++v)
        for (int n = 0; n < 3; ++n)
            if (!(std::abs(data.vertices[v][n]) <= TriangleMesh::k_farthest))
                return Error{
                    message("vertex ", v, " of the mesh is at ", data.vertices[v],
                            " m: give each component -1e5 to 1e5 m, and move a mesh that is farther out to its origin.")};
    return {};
}

void weld(MeshData& data) {
    std::vector<std::uint32_t> order(data.vertices.size());
    std::iota(order.begin(), order.end(), 0u);
    for (glm::vec3& place : data.vertices)
        place += 0.0f; // -0 becomes 0
    const auto key = [&](std::uint32_t v) { return std::tuple_cat(by_place(data.vertices[v]), std::tuple(v)); };
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    std::vector<std::uint32_t> first(order.size()); // vertex at the same place
    for (std::size_t n = 0; n < order.size(); ++n) {
        const bool again = n > 0 && data.vertices[order[n]] == data.vertices[order[n - 1]];
        first[order[n]] = again ? first[order[n - 1]] : order[n];
    }
    std::vector<bool> used(first.size());
    std::size_t kept = 0;
    for (glm::uvec3 t : data.triangles) {
        t = {first[t.x], first[t.y], first[t.z]};
        if (t.x == t.y || t.y == t.z || t.z == t.x)
            continue;
        used[t.x] = used[t.y] = used[t.z] = true;
        data.triangles[kept++] = t;
    }
    data.triangles.resize(kept);
    std::uint32_t count = 0;
    for (std::size_t v = 0; v < first.size(); ++v)
        if (used[v]) {
            first[v] = count;
            data.vertices[count++] = data.vertices[v];
        }
    data.vertices.resize(count);
    for (glm::uvec3& t : data.triangles)
        t = {first[t.x], first[t.y], first[t.z]};
}

Result<ClosedSurface> close_surface(MeshData& data) {
    if (data.triangles.empty())
        return Error{"each triangle of the mesh has a corner twice: give triangles with three corners."};
    glm::vec3 low = data.vertices.front(), high = low;
    for (const glm::vec3& place : data.vertices) {
        low = glm::min(low, place);
        high = glm::max(high, place);
    }
    if (const glm::vec3 size = high - low; std::max({size.x, size.y, size.z}) < TriangleMesh::k_smallest)
        return Error{message("the mesh is ", size, " m large: give 1e-6 m at least along one axis.")};
    std::vector<Edge> edges = sorted_edges(data);
    Faults faults = faults_of(edges);
    if (faults.open + faults.turned > 0) {
        leave_out_doubled(data);
        edges = sorted_edges(data);
        faults = faults_of(edges);
    }
    if (faults.open > 0)
        return Error{message("the mesh is open at ", faults.open, faults.open == 1 ? " edge" : " edges", ", the first from ",
                             data.vertices[faults.first_open.low], " to ", data.vertices[faults.first_open.high],
                             ": close it, or build it of plates, which have no inside.")};
    if (faults.turned > 0)
        return Error{message("the mesh has ", faults.turned, faults.turned == 1 ? " edge" : " edges",
                             " whose triangles face opposite ways, the first from ", data.vertices[faults.first_turned.low],
                             " to ", data.vertices[faults.first_turned.high], ": turn triangles around until all face outward.")};
    Sets sets = joined(edges, data.triangles.size(), [](std::uint32_t) { return true; });
    ClosedSurface surface{.parts = std::vector<std::uint32_t>(data.triangles.size()), .edges = sharp_edges(data, edges)};
    for (std::uint32_t t = 0; t < surface.parts.size(); ++t)
        surface.parts[t] = sets.of(t);
    return surface;
}

MeshData surface_of_union(const MeshData& data, std::span<const std::uint32_t> parts, const MeshTree& tree) {
    const bool is_one = std::all_of(parts.begin(), parts.end(), [&](std::uint32_t part) { return part == parts.front(); });
    return is_one ? MeshData{} : Union(data, parts, tree).surface();
}

} // namespace windrow::detail
