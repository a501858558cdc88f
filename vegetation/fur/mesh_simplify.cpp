// Fewer triangles: the edge whose collapse moves the surface least goes first.
//
// The error of a vertex moved to p is the sum of its planes' squared distances times their triangles' areas, p^T Q p with
// homogeneous p; a collapse keeps one end of its edge where it is, so that all vertices are the file's own, and gives it both
// quadrics. Vertices on borders, on seams of the uv and between parts stay, but others may collapse onto them. A collapse is
// rejected that would turn a triangle by more than 75 degrees, or pinch the surface.
// Based on: Garland & Heckbert 1997, Surface simplification using quadric error metrics, sections 4 and 5; Dey et al. 1999,
// Topology preserving edge contraction (the link condition).
#include "vegetation/fur/mesh.h"
#include "vegetation/fur/mesh_weld.h"

#include <algorithm>
#include <array>
#include <functional>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>

namespace windrow::vegetation::fur {
namespace {

// A symmetric 4 x 4 matrix: the sum of planes n.p + d = 0, each times an area.
struct Quadric {
    glm::dvec3 diagonal{0.0}, others{0.0}, linear{0.0}; // xx yy zz; xy xz yz; n d
    double constant = 0.0;

    void add(const glm::dvec3& n, double d, double area) {
        diagonal += area * n * n;
        others += area * glm::dvec3(n.x * n.y, n.x * n.z, n.y * n.z);
        linear += area * d * n;
        constant += area * d * d;
    }
    void add(const Quadric& q) {
        diagonal += q.diagonal;
        others += q.others;
        linear += q.linear;
        constant += q.constant;
    }
    [[nodiscard]] double at(const glm::dvec3& p) const {
        return glm::dot(diagonal, p * p) + 2.0 * glm::dot(others, glm::dvec3(p.x * p.y, p.x * p.z, p.y * p.z)) +
               2.0 * glm::dot(linear, p) + constant;
    }
};

// Triangles looked at around points. A usual mesh takes 40 a triangle, one with a fan of 4096 triangles 220. A point with tens of
// thousands would take the square of their number, so the collapses end when this work is done.
constexpr std::size_t k_min_work = 12'000'000, k_work_a_triangle = 100;

struct Collapse {
    double cost;
    std::uint32_t from, to; // points
    std::uint32_t age;      // of `from` when it was priced
    bool operator>(const Collapse& o) const { return std::tie(cost, from, to) > std::tie(o.cost, o.from, o.to); }
};

class Simplifier {
  public:
    explicit Simplifier(Mesh& mesh) : mesh_(mesh), point_(same_positions(mesh.vertices)) {
        const std::size_t points = point_.empty() ? 0 : *std::max_element(point_.begin(), point_.end()) + std::size_t{1};
        places_.resize(points);
        quadrics_.resize(points);
        fans_.resize(points);
        fixed_.resize(points);
        ages_.resize(points);
        alive_.assign(mesh.triangles(), true);
        left_ = mesh.triangles();
        find_fixed();
        for (std::uint32_t triangle = 0; triangle < alive_.size(); ++triangle) {
            const glm::dvec3 across = facing(triangle);
            const double area = glm::length(across);
            for (std::size_t k = 0; k < 3; ++k) {
                fans_[corner(triangle, k)].push_back(triangle);
                if (area > 0.0)
                    quadrics_[corner(triangle, k)].add(across / area, -glm::dot(across / area, places_[corner(triangle, k)]),
                                                       area);
            }
        }
        for (std::uint32_t from = 0; from < points; ++from)
            price(from);
    }

    void run(std::size_t most) {
        const std::size_t max_work = k_min_work + k_work_a_triangle * left_;
        while (left_ > most && !queue_.empty() && work_ < max_work) {
            std::pop_heap(queue_.begin(), queue_.end(), std::greater<>());
            const Collapse next = queue_.back();
            queue_.pop_back();
            if (next.age == ages_[next.from] && fits(next.from, next.to))
                collapse(next.from, next.to);
        }
        compact();
    }

  private:
    [[nodiscard]] std::uint32_t vertex(std::uint32_t triangle, std::size_t k) const { return mesh_.indices[3 * triangle + k]; }
    [[nodiscard]] std::uint32_t corner(std::uint32_t triangle, std::size_t k) const { return point_[vertex(triangle, k)]; }
    [[nodiscard]] bool has(std::uint32_t triangle, std::uint32_t point) const {
        return corner(triangle, 0) == point || corner(triangle, 1) == point || corner(triangle, 2) == point;
    }
    [[nodiscard]] glm::dvec3 facing(std::uint32_t triangle) const {
        const glm::dvec3 a = places_[corner(triangle, 0)];
        return glm::cross(places_[corner(triangle, 1)] - a, places_[corner(triangle, 2)] - a);
    }

    // Points with several vertices (seams), with an edge that has not two triangles, or in several parts.
    void find_fixed() {
        std::vector<std::uint32_t> vertices(places_.size(), ~0u), part_of(places_.size(), ~0u);
        for (std::uint32_t i = 0; i < point_.size(); ++i) {
            fixed_[point_[i]] = vertices[point_[i]] != ~0u;
            vertices[point_[i]] = i;
            places_[point_[i]] = mesh_.vertices[i].position;
        }
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
        for (std::uint32_t part = 0; part < mesh_.parts.size(); ++part)
            for (std::uint32_t i = mesh_.parts[part].first; i < mesh_.parts[part].first + mesh_.parts[part].count; ++i) {
                const std::uint32_t a = point_[mesh_.indices[i]], b = point_[mesh_.indices[i % 3 == 2 ? i - 2 : i + 1]];
                fixed_[a] = fixed_[a] || (part_of[a] != ~0u && part_of[a] != part);
                part_of[a] = part;
                ++edges[std::minmax(a, b)];
            }
        for (const auto& [edge, triangles] : edges)
            if (triangles != 2)
                fixed_[edge.first] = fixed_[edge.second] = true;
    }

    [[nodiscard]] std::vector<std::uint32_t> neighbours(std::uint32_t point) {
        work_ += fans_[point].size();
        std::vector<std::uint32_t> result;
        for (const std::uint32_t triangle : fans_[point])
            for (std::size_t k = 0; k < 3; ++k)
                if (corner(triangle, k) != point)
                    result.push_back(corner(triangle, k));
        std::sort(result.begin(), result.end());
        result.erase(std::unique(result.begin(), result.end()), result.end());
        return result;
    }

    void price(std::uint32_t from) {
        if (fixed_[from])
            return;
        ++ages_[from];
        for (const std::uint32_t to : neighbours(from)) {
            Quadric sum = quadrics_[from];
            sum.add(quadrics_[to]);
            queue_.push_back({sum.at(places_[to]), from, to, ages_[from]});
            std::push_heap(queue_.begin(), queue_.end(), std::greater<>());
        }
        if (queue_.size() > longest_queue_)
            drop_outdated();
    }

    // Each collapse prices its neighbourhood again: without this, most of the queue would be outdated.
    void drop_outdated() {
        std::erase_if(queue_, [&](const Collapse& each) { return each.age != ages_[each.from]; });
        std::make_heap(queue_.begin(), queue_.end(), std::greater<>());
        longest_queue_ = std::max(longest_queue_, 2 * queue_.size());
    }

    // Whether the surface stays a surface and no triangle turns over.
    [[nodiscard]] bool fits(std::uint32_t from, std::uint32_t to) {
        const auto mine = neighbours(from), theirs = neighbours(to);
        std::vector<std::uint32_t> common;
        std::set_intersection(mine.begin(), mine.end(), theirs.begin(), theirs.end(), std::back_inserter(common));
        std::size_t shared = 0;
        for (const std::uint32_t triangle : fans_[from]) {
            if (has(triangle, to)) {
                ++shared;
                continue;
            }
            std::array<glm::dvec3, 3> moved;
            for (std::size_t k = 0; k < 3; ++k)
                moved[k] = places_[corner(triangle, k) == from ? to : corner(triangle, k)];
            const glm::dvec3 before = facing(triangle), after = glm::cross(moved[1] - moved[0], moved[2] - moved[0]);
            constexpr double k_cosine = 0.26; // of 75 degrees
            if (glm::dot(before, after) <= k_cosine * glm::length(before) * glm::length(after))
                return false;
        }
        // Where both ends lie on the last tetrahedron the surface would fold onto itself.
        return shared == 2 && common.size() == 2 && mine.size() > 3 && left_ > 4;
    }

    void collapse(std::uint32_t from, std::uint32_t to) {
        std::uint32_t onto = 0; // the vertex of `to` on this side of a seam
        for (const std::uint32_t triangle : fans_[from])
            for (std::size_t k = 0; k < 3; ++k)
                if (has(triangle, to) && corner(triangle, k) == to)
                    onto = vertex(triangle, k);
        for (const std::uint32_t triangle : fans_[from]) {
            if (has(triangle, to)) {
                alive_[triangle] = false;
                --left_;
                for (std::size_t k = 0; k < 3; ++k)
                    if (corner(triangle, k) != from)
                        std::erase(fans_[corner(triangle, k)], triangle);
                continue;
            }
            for (std::size_t k = 0; k < 3; ++k)
                if (corner(triangle, k) == from)
                    mesh_.indices[3 * triangle + k] = onto;
            fans_[to].push_back(triangle);
        }
        fans_[from].clear();
        ++ages_[from];
        quadrics_[to].add(quadrics_[from]);
        price(to);
        for (const std::uint32_t point : neighbours(to))
            price(point);
    }

    void compact() {
        std::vector<std::uint32_t> indices, numbers(mesh_.vertices.size(), ~0u);
        std::vector<MeshVertex> vertices;
        for (MeshPart& part : mesh_.parts) {
            const auto first = static_cast<std::uint32_t>(indices.size());
            for (std::uint32_t i = part.first; i < part.first + part.count; ++i) {
                if (!alive_[i / 3])
                    continue;
                std::uint32_t& number = numbers[mesh_.indices[i]];
                if (number == ~0u) {
                    number = static_cast<std::uint32_t>(vertices.size());
                    vertices.push_back(mesh_.vertices[mesh_.indices[i]]);
                }
                indices.push_back(number);
            }
            part.first = first;
            part.count = static_cast<std::uint32_t>(indices.size()) - first;
        }
        std::erase_if(mesh_.parts, [](const MeshPart& part) { return part.count == 0; });
        mesh_.vertices = std::move(vertices);
        mesh_.indices = std::move(indices);
        measure(mesh_);
    }

    Mesh& mesh_;
    std::vector<std::uint32_t> point_; // of each vertex: seams are doubled vertices on one point
    std::vector<glm::dvec3> places_;
    std::vector<Quadric> quadrics_;
    std::vector<std::vector<std::uint32_t>> fans_; // triangles at a point
    std::vector<bool> fixed_, alive_;
    std::vector<std::uint32_t> ages_;
    std::size_t left_ = 0;
    std::vector<Collapse> queue_; // a heap, the least cost first
    std::size_t longest_queue_ = std::size_t{1} << 18;
    std::size_t work_ = 0;
};

} // namespace

void simplify(Mesh& mesh, std::size_t most) {
    if (mesh.triangles() > most)
        Simplifier(mesh).run(most);
}

} // namespace windrow::vegetation::fur
