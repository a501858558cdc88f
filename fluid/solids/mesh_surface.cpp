// An edge between two triangles is passed by one of them from its first end to its second, and by the other back. So a surface is
// closed, and its winding number is whole, where each edge is passed as often one way as the other.
// Based on: Jacobson, Kavan & Sorkine-Hornung 2013, ACM Transactions on Graphics 32 (whole winding numbers of closed surfaces).
#include "fluid/solids/mesh_surface.h"

#include "fluid/core/message.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
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

/// Edges that are not passed as often one way as the other.
struct Faults {
    std::size_t open = 0;   ///< with a triangle too few
    std::size_t turned = 0; ///< whose triangles face opposite ways
    Edge first_open{}, first_turned{};
};

Faults faults_of(const MeshData& data) {
    Faults faults;
    const std::vector<Edge> edges = sorted_edges(data);
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

Result<void> close_surface(MeshData& data) {
    if (data.triangles.empty())
        return Error{"each triangle of the mesh has a corner twice: give triangles with three corners."};
    glm::vec3 low = data.vertices.front(), high = low;
    for (const glm::vec3& place : data.vertices) {
        low = glm::min(low, place);
        high = glm::max(high, place);
    }
    if (const glm::vec3 size = high - low; std::max({size.x, size.y, size.z}) < TriangleMesh::k_smallest)
        return Error{message("the mesh is ", size, " m large: give 1e-6 m at least along one axis.")};
    Faults faults = faults_of(data);
    if (faults.open + faults.turned > 0) {
        leave_out_doubled(data);
        faults = faults_of(data);
    }
    if (faults.open > 0)
        return Error{message("the mesh is open at ", faults.open, faults.open == 1 ? " edge" : " edges", ", the first from ",
                             data.vertices[faults.first_open.low], " to ", data.vertices[faults.first_open.high],
                             ": close it, or build it of plates, which have no inside.")};
    if (faults.turned > 0)
        return Error{message("the mesh has ", faults.turned, faults.turned == 1 ? " edge" : " edges",
                             " whose triangles face opposite ways, the first from ", data.vertices[faults.first_turned.low],
                             " to ", data.vertices[faults.first_turned.high], ": turn triangles around until all face outward.")};
    return {};
}

} // namespace windrow::detail
