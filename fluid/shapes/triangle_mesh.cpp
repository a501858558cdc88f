#include "fluid/shapes/triangle_mesh.h"

#include "fluid/core/message.h"
#include "fluid/solids/content.h"
#include "fluid/solids/mesh_signs.h"
#include "fluid/solids/mesh_surface.h"
#include "fluid/solids/mesh_tree.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <tuple>

namespace windrow {
namespace {

using detail::MeshTree, detail::winds_around;

/// Rays into the body, one from the middle of each part of a triangle. Of more than k_most_rays parts of large triangles some have a
/// ray, evenly, and each triangle has one.
class Thickness {
  public:
    /// `surface` is what a ray meets; `tree` holds all of the mesh.
    Thickness(const MeshTree& tree, const MeshTree& surface, glm::vec3 size)
        : tree_(tree), surface_(surface), longest_(std::max({size.x, size.y, size.z})),
          least_(std::min({size.x, size.y, size.z})) {}

    void count(glm::vec3 a, glm::vec3 b, glm::vec3 c) {
        cut(a, b, c, is_thin(a, b, c), 0, [&](glm::vec3, int cuts) { parts_ += cuts > 0 ? 1 : 0; });
    }
    /// After all are counted.
    void measure(glm::vec3 a, glm::vec3 b, glm::vec3 c) {
        const glm::vec3 normal(glm::cross(glm::dvec3(b - a), glm::dvec3(c - a)));
        const float length = glm::length(normal);
        if (!(length > 0.0f))
            return;
        bool first = true;
        cut(a, b, c, is_thin(a, b, c), 0, [&](glm::vec3 place, int cuts) {
            if (const bool chosen = cuts == 0 || has_ray(); chosen || first)
                cast(place, normal / length);
            first = false;
        });
    }
    [[nodiscard]] float least() const { return least_; }
    /// Of the mesh's tree.
    [[nodiscard]] std::size_t steps() const { return steps_; }

  private:
    static constexpr int k_most_cuts = 4;
    static constexpr float k_thin = 32.0f; ///< times as long as high
    static constexpr std::size_t k_most_rays = 8'192;

    static float longest_edge(glm::vec3 a, glm::vec3 b, glm::vec3 c) {
        return std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
    }
    static bool is_thin(glm::vec3 a, glm::vec3 b, glm::vec3 c) {
        const float longest = longest_edge(a, b, c);
        return glm::length(glm::cross(glm::dvec3(b - a), glm::dvec3(c - a))) < static_cast<double>(longest * longest / k_thin);
    }
    [[nodiscard]] bool has_ray() {
        const std::size_t part = part_++;
        return parts_ <= k_most_rays || (part + 1) * k_most_rays / parts_ > part * k_most_rays / parts_;
    }

    /// visit(middle, cuts) for each part. Of a thin triangle, parts beside each other would find the same.
    template <class Visit>
    void cut(glm::vec3 a, glm::vec3 b, glm::vec3 c, bool thin, int cuts, const Visit& visit) {
        const float edge = longest_edge(a, b, c);
        if (cuts == k_most_cuts || !(edge > longest_ / 8.0f))
            return visit((a + b + c) / 3.0f, cuts);
        const glm::vec3 ab = 0.5f * (a + b), bc = 0.5f * (b + c), ca = 0.5f * (c + a);
        if (!thin) {
            cut(a, ab, ca, thin, cuts + 1, visit);
            cut(ab, b, bc, thin, cuts + 1, visit);
            cut(ca, bc, c, thin, cuts + 1, visit);
            cut(ab, bc, ca, thin, cuts + 1, visit);
        } else if (glm::distance(a, b) == edge) {
            cut(a, ab, c, thin, cuts + 1, visit);
            cut(ab, b, c, thin, cuts + 1, visit);
        } else if (glm::distance(b, c) == edge) {
            cut(a, b, bc, thin, cuts + 1, visit);
            cut(a, bc, c, thin, cuts + 1, visit);
        } else {
            cut(a, b, ca, thin, cuts + 1, visit);
            cut(ca, b, c, thin, cuts + 1, visit);
        }
    }

    void cast(glm::vec3 place, glm::vec3 normal) {
        // What a ray meets is found first, both ways: it is seldom nearer than what is known, and a winding number takes longer.
        const float inward = surface_.first_hit(place, -normal, -normal, least_, steps_),
                    outward = surface_.first_hit(place, normal, -normal, least_, steps_);
        if (!(std::min(inward, outward) < least_))
            return;
        const glm::vec3 out = 1e-4f * longest_ * normal;
        const bool before = winds_around(tree_.winding_number(place + out, &steps_)); // as where triangles face inward
        if (before && winds_around(tree_.winding_number(place - out, &steps_)))
            return;
        least_ = before ? outward : inward;
    }

    const MeshTree &tree_, &surface_;
    float longest_, least_;
    std::size_t steps_ = 0, parts_ = 0, part_ = 0; ///< of cut triangles
};

} // namespace

TriangleMesh::TriangleMesh() = default;

std::uint64_t TriangleMesh::hash_of(const MeshData& data) {
    return detail::content_hash(data.vertices) * 31 + detail::content_hash(data.triangles);
}

TriangleMesh::TriangleMesh(MeshData data)
    : data_(std::move(data)), hash_(hash_of(data_)), low_(data_.vertices.front()), high_(low_) {
    for (const glm::vec3& place : data_.vertices) {
        low_ = glm::min(low_, place);
        high_ = glm::max(high_, place);
    }
    tree_ = std::make_unique<MeshTree>(data_);
}

Result<void> TriangleMesh::measure(detail::ClosedSurface found) {
    constexpr std::size_t k_points = 256;                 // of which the steps are counted
    constexpr std::size_t k_most_ray_steps = 500'000'000; // 3 s; a million round triangles take 150,000,000
    const Error too_long{detail::message("a point beside the mesh takes more than ", k_max_steps,
                                         " steps of a search, in the mean: its triangles are long and thin, or one around "
                                         "another; cut them shorter, or give fewer.")};
    const std::size_t apart = (data_.triangles.size() + k_points - 1) / k_points;
    std::size_t steps = 0;
    for (std::size_t t = 0, points = 1; t < data_.triangles.size(); t += apart, ++points) {
        const glm::uvec3& corners = data_.triangles[t];
        (void)tree_->winding_number((data_.vertices[corners.x] + data_.vertices[corners.y] + data_.vertices[corners.z]) / 3.0f,
                                    &steps);
        if (steps > k_points * k_max_steps || (t + apart >= data_.triangles.size() && steps > points * k_max_steps))
            return too_long;
    }
    const MeshData outer = detail::surface_of_union(data_, found.parts, *tree_);
    if (!outer.triangles.empty())
        surface_ = std::make_unique<MeshTree>(outer);
    edges_ = std::make_unique<detail::MeshEdges>(std::move(found.edges));
    const MeshData& surface = surface_ ? outer : data_;
    Thickness rays(*tree_, surface_ ? *surface_ : *tree_, high_ - low_);
    for (const glm::uvec3& t : surface.triangles)
        rays.count(surface.vertices[t.x], surface.vertices[t.y], surface.vertices[t.z]);
    for (const glm::uvec3& t : surface.triangles) {
        rays.measure(surface.vertices[t.x], surface.vertices[t.y], surface.vertices[t.z]);
        if (rays.steps() > k_most_ray_steps)
            return too_long;
    }
    thickness_ = rays.least();
    signs_ = std::make_unique<detail::MeshSigns>(surface, *tree_, low_, high_);
    return {};
}

TriangleMesh::~TriangleMesh() = default;

Result<std::shared_ptr<const TriangleMesh>> TriangleMesh::create(MeshData data) {
    return detail::where_memory_lasts([&]() -> Result<std::shared_ptr<const TriangleMesh>> {
        if (auto checked = detail::check_parts(data); !checked)
            return checked.failure();
        detail::weld(data);
        auto closed = detail::close_surface(data);
        if (!closed)
            return closed.failure();
        data.vertices.shrink_to_fit();
        data.triangles.shrink_to_fit();
        std::shared_ptr<TriangleMesh> mesh(new TriangleMesh(std::move(data)));
        if (auto measured = mesh->measure(*std::move(closed)); !measured)
            return measured.failure();
        return std::shared_ptr<const TriangleMesh>(std::move(mesh));
    });
}

float TriangleMesh::distance_to(glm::vec3 point, float most) const {
    const float away = (surface_ ? *surface_ : *tree_).distance(point, most);
    return signs_->inside(point, *tree_) ? -away : away;
}

bool TriangleMesh::crosses(glm::vec3 from, glm::vec3 to) const {
    return tree_->crosses(from, to);
}

void TriangleMesh::for_each_edge_near(glm::vec3 point, float most,
                                      const std::function<void(const detail::MeshEdge&)>& visit) const {
    if (edges_->tree != nullptr)
        edges_->tree->for_each_near(point, most, [&](std::uint32_t number) { visit(edges_->edges[number]); });
}

double TriangleMesh::winding_number(glm::vec3 point) const {
    return tree_->winding_number(point);
}

std::size_t TriangleMesh::memory_bytes() const {
    return sizeof(*this) + data_.vertices.capacity() * sizeof(glm::vec3) + data_.triangles.capacity() * sizeof(glm::uvec3) +
           tree_->memory_bytes() + (surface_ ? surface_->memory_bytes() : 0) + signs_->memory_bytes() +
           edges_->edges.capacity() * sizeof(detail::MeshEdge) + (edges_->tree ? edges_->tree->memory_bytes() : 0);
}

std::strong_ordering operator<=>(const TriangleMesh& a, const TriangleMesh& b) {
    if (&a == &b)
        return std::strong_ordering::equal;
    const auto counts = [](const TriangleMesh& mesh) {
        return std::tuple(mesh.hash_, mesh.data_.vertices.size(), mesh.data_.triangles.size());
    };
    if (const auto order = counts(a) <=> counts(b); order != 0)
        return order;
    const auto order = detail::compare_content(a.data_.vertices, b.data_.vertices);
    return order != 0 ? order : detail::compare_content(a.data_.triangles, b.data_.triangles);
}

} // namespace windrow
