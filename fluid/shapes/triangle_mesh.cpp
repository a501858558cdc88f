#include "fluid/shapes/triangle_mesh.h"

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

/// Rays into the body, one from the middle of each part of a triangle.
class Thickness {
  public:
    Thickness(const MeshTree& tree, glm::vec3 size)
        : tree_(tree), longest_(std::max({size.x, size.y, size.z})), least_(std::min({size.x, size.y, size.z})) {}

    void measure(glm::vec3 a, glm::vec3 b, glm::vec3 c) {
        const glm::vec3 normal(glm::cross(glm::dvec3(b - a), glm::dvec3(c - a)));
        if (const float length = glm::length(normal); length > 0.0f)
            cast(a, b, c, normal / length, 0);
    }
    [[nodiscard]] float least() const { return least_; }

  private:
    static constexpr int k_most_cuts = 4;

    void cast(glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 normal, int cuts) {
        const float apart = longest_ / 8.0f;
        if (cuts < k_most_cuts && std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)}) > apart) {
            const glm::vec3 ab = 0.5f * (a + b), bc = 0.5f * (b + c), ca = 0.5f * (c + a);
            cast(a, ab, ca, normal, cuts + 1);
            cast(ab, b, bc, normal, cuts + 1);
            cast(ca, bc, c, normal, cuts + 1);
            cast(ab, bc, ca, normal, cuts + 1);
            return;
        }
        const glm::vec3 place = (a + b + c) / 3.0f, out = 1e-4f * longest_ * normal;
        const bool before = winds_around(tree_.winding_number(place + out)); // as where triangles face inward
        if (before && winds_around(tree_.winding_number(place - out)))
            return;
        least_ = tree_.first_hit(place, before ? normal : -normal, -normal, least_);
    }

    const MeshTree& tree_;
    float longest_, least_;
};

} // namespace

TriangleMesh::TriangleMesh(MeshData data)
    : data_(std::move(data)), hash_(detail::content_hash(data_.vertices) * 31 + detail::content_hash(data_.triangles)),
      low_(data_.vertices.front()), high_(low_) {
    for (const glm::vec3& place : data_.vertices) {
        low_ = glm::min(low_, place);
        high_ = glm::max(high_, place);
    }
    tree_ = std::make_unique<MeshTree>(data_);
    signs_ = std::make_unique<detail::MeshSigns>(data_, *tree_, low_, high_);
    Thickness rays(*tree_, high_ - low_);
    for (const glm::uvec3& t : data_.triangles)
        rays.measure(data_.vertices[t.x], data_.vertices[t.y], data_.vertices[t.z]);
    thickness_ = rays.least();
}

TriangleMesh::~TriangleMesh() = default;

Result<std::shared_ptr<const TriangleMesh>> TriangleMesh::create(MeshData data) {
    return detail::where_memory_lasts([&]() -> Result<std::shared_ptr<const TriangleMesh>> {
        if (auto checked = detail::check_parts(data); !checked)
            return checked.failure();
        detail::weld(data);
        if (auto closed = detail::close_surface(data); !closed)
            return closed.failure();
        data.vertices.shrink_to_fit();
        data.triangles.shrink_to_fit();
        return std::shared_ptr<const TriangleMesh>(new TriangleMesh(std::move(data)));
    });
}

float TriangleMesh::distance_to(glm::vec3 point, float most) const {
    const float away = tree_->distance(point, most);
    return signs_->inside(point, *tree_) ? -away : away;
}

bool TriangleMesh::crosses(glm::vec3 from, glm::vec3 to) const {
    return tree_->crosses(from, to);
}

double TriangleMesh::winding_number(glm::vec3 point) const {
    return tree_->winding_number(point);
}

std::size_t TriangleMesh::memory_bytes() const {
    return sizeof(*this) + data_.vertices.capacity() * sizeof(glm::vec3) + data_.triangles.capacity() * sizeof(glm::uvec3) +
           tree_->memory_bytes() + signs_->memory_bytes();
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
