#include "vegetation/fur/surface_nets.h"

#include "fluid/core/message.h"
#include "vegetation/fur/mesh_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

namespace windrow::vegetation::fur {
namespace {

using windrow::detail::message;

constexpr std::uint32_t k_none = ~0u;
constexpr int k_max_cells = 512;

class Net {
  public:
    Net(const Flesh& flesh, const glm::dvec3& low, const glm::ivec3& cells, double cell)
        : flesh_(flesh), low_(low), cells_(cells), cell_(cell) {
        const glm::ivec3 n = cells + 1;
        distances_.reserve(static_cast<std::size_t>(n.x) * n.y * n.z);
        for (int z = 0; z < n.z; ++z)
            for (int y = 0; y < n.y; ++y)
                for (int x = 0; x < n.x; ++x)
                    distances_.push_back(distance(flesh, corner({x, y, z})));
        numbers_.assign(distances_.size(), k_none);
    }

    Mesh run() {
        each_cell([&](const glm::ivec3& at) { add_vertex(at); });
        each_cell([&](const glm::ivec3& at) { add_faces(at); });
        return std::move(mesh_);
    }

    // Whether the body comes to the box's sides.
    [[nodiscard]] bool touches() const {
        const glm::ivec3 last = cells_;
        for (int z = 0; z <= last.z; ++z)
            for (int y = 0; y <= last.y; ++y)
                for (int x = 0; x <= last.x; ++x) {
                    const bool rim = x == 0 || y == 0 || z == 0 || x == last.x || y == last.y || z == last.z;
                    if (rim && inside({x, y, z}))
                        return true;
                }
        return false;
    }

  private:
    [[nodiscard]] glm::dvec3 corner(const glm::ivec3& at) const { return low_ + glm::dvec3(at) * cell_; }
    [[nodiscard]] std::size_t index(const glm::ivec3& at) const {
        return (static_cast<std::size_t>(at.z) * (cells_.y + 1) + at.y) * (cells_.x + 1) + at.x;
    }
    [[nodiscard]] bool inside(const glm::ivec3& at) const { return distances_[index(at)] < 0.0; }

    template <class Body>
    void each_cell(Body&& body) {
        for (int z = 0; z < cells_.z; ++z)
            for (int y = 0; y < cells_.y; ++y)
                for (int x = 0; x < cells_.x; ++x)
                    body(glm::ivec3(x, y, z));
    }

    void add_vertex(const glm::ivec3& at) {
        glm::dvec3 sum(0.0);
        int crossings = 0;
        for (int axis = 0; axis < 3; ++axis)
            for (int other = 0; other < 4; ++other) {
                glm::ivec3 from = at;
                from[(axis + 1) % 3] += other & 1;
                from[(axis + 2) % 3] += other >> 1;
                glm::ivec3 to = from;
                ++to[axis];
                if (inside(from) == inside(to))
                    continue;
                const double d0 = distances_[index(from)], d1 = distances_[index(to)];
                sum += corner(from) + (corner(to) - corner(from)) * (d0 / (d0 - d1));
                ++crossings;
            }
        if (crossings == 0)
            return;
        glm::dvec3 p = sum / static_cast<double>(crossings), normal = slope(flesh_, p);
        // Within its cell, with a margin, so that no two vertices meet.
        const glm::dvec3 least = corner(at) + 0.05 * cell_, most = corner(at) + 0.95 * cell_;
        for (int step = 0; step < 4; ++step) {
            p = glm::clamp(p - normal * (distance(flesh_, p) / glm::dot(normal, normal)), least, most);
            normal = slope(flesh_, p);
        }
        numbers_[index(at)] = static_cast<std::uint32_t>(mesh_.vertices.size());
        mesh_.vertices.push_back({.position = glm::vec3(p), .normal = glm::vec3(glm::normalize(normal))});
    }

    // Of the three edges that leave a cell's first corner; those of other corners are its neighbours'.
    void add_faces(const glm::ivec3& at) {
        for (int axis = 0; axis < 3; ++axis) {
            glm::ivec3 to = at;
            ++to[axis];
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            if (at[u] == 0 || at[v] == 0 || inside(at) == inside(to))
                continue;
            std::array<std::uint32_t, 4> around{};
            for (std::size_t k = 0; k < 4; ++k) {
                glm::ivec3 cell = at;
                cell[u] -= k == 0 || k == 3;
                cell[v] -= k < 2;
                around[k] = numbers_[index(cell)];
            }
            if (inside(at))
                add_cell(mesh_, around[0], around[1], around[2], around[3]);
            else
                add_cell(mesh_, around[3], around[2], around[1], around[0]);
        }
    }

    const Flesh& flesh_;
    glm::dvec3 low_;
    glm::ivec3 cells_;
    double cell_;
    std::vector<double> distances_;      // at the grid's corners
    std::vector<std::uint32_t> numbers_; // of a cell's vertex, by its first corner
    Mesh mesh_;
};

// Whether each edge runs once in each direction.
bool closed(const Mesh& mesh) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ways, backs;
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const std::uint32_t a = mesh.indices[i], b = mesh.indices[i % 3 == 2 ? i - 2 : i + 1];
        ways.emplace_back(a, b);
        backs.emplace_back(b, a);
    }
    std::sort(ways.begin(), ways.end());
    std::sort(backs.begin(), backs.end());
    return ways == backs && std::adjacent_find(ways.begin(), ways.end()) == ways.end();
}

} // namespace

Result<Mesh> surface_nets(const Flesh& flesh, const glm::vec3& low, const glm::vec3& high, float cell, const char* material) {
    glm::ivec3 cells(0);
    for (int axis = 0; axis < 3; ++axis) {
        const double count = std::ceil(static_cast<double>(high[axis] - low[axis]) / static_cast<double>(cell));
        if (!(count >= 2.0 && count <= k_max_cells))
            return windrow::Error{message("surface_nets.cell is ", cell, " m: give one that cuts the box into 2 to ", k_max_cells,
                                          " along each edge.")};
        cells[axis] = static_cast<int>(count);
    }
    Net net(flesh, low, cells, static_cast<double>(cell));
    if (net.touches())
        return windrow::Error{message("surface_nets.flesh comes to the box from ", low, " to ", high, ": give a greater box.")};
    Mesh mesh = net.run();
    if (mesh.indices.empty())
        return windrow::Error{
            message("surface_nets.flesh meets no corner of the grid: give smaller cells than ", cell, " m, or a body.")};
    if (!closed(mesh))
        return windrow::Error{message("surface_nets.cell is ", cell,
                                      " m, and two skins cross one cell, which has one vertex: give another, or shift the box.")};
    finish(mesh, material);
    return mesh;
}

} // namespace windrow::vegetation::fur
