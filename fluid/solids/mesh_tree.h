// Triangles in a tree of boxes: nearest distance, winding number, and what a segment or a ray meets.
//
// The winding number of a closed surface about a point is the sum of its triangles' solid angles over 4 pi. A part of the tree that
// is far away counts as a dipole at its centre: N . (c - p) / |c - p|^3, N the sum of its triangles' area vectors.
//
// Based on: Jacobson, Kavan and Sorkine-Hornung 2013, ACM Transactions on Graphics 32 (winding numbers of meshes); Barill, Dickson,
// Schmidt, Levin and Jacobson 2018, ACM Transactions on Graphics 37 (the tree); van Oosterom and Strackee 1983, IEEE Transactions on
// Biomedical Engineering 30 (solid angles).
#pragma once

#include "fluid/shapes/triangle_mesh.h"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>

namespace windrow::detail {

class MeshTree {
  public:
    /// Throws std::bad_alloc. The data is closed and has triangles.
    explicit MeshTree(const MeshData& data);
    MeshTree() = default; ///< empty, for `pass`
    /// Into an archive of mesh_bytes.cpp, or out of one.
    static void pass(auto& archive, auto& tree) {
        archive.list(tree.nodes_);
        archive.list(tree.triangles_);
    }
    /// Whether no node leads out of the lists or deeper than a walk goes, and each triangle's number is below `count`.
    [[nodiscard]] bool is_sound(std::size_t count) const;

    /// [m] To the nearest triangle, or `most` where none is nearer.
    [[nodiscard]] float distance(glm::vec3 point, float most) const;
    /// Adds to `steps` the nodes and triangles that it looks at.
    [[nodiscard]] double winding_number(glm::vec3 point, std::size_t* steps = nullptr) const;
    /// Whether a triangle is met by the segment, its ends counted in. No segment passes between two triangles with a common edge.
    [[nodiscard]] bool crosses(glm::vec3 from, glm::vec3 to) const;
    /// [m] Along a ray to the first triangle whose normal is `along` within 45 degrees, or `most`. `direction` and `along` are
    /// unit vectors. Adds to `steps` as the winding number does.
    [[nodiscard]] float first_hit(glm::vec3 from, glm::vec3 direction, glm::vec3 along, float most, std::size_t& steps) const;

    /// visit(number) for each triangle that is nearer to a point than `most` [m].
    void for_each_near(glm::vec3 point, float most, const std::function<void(std::uint32_t)>& visit) const;
    /// visit(number) for each triangle whose box meets another one. Returns how many nodes and triangles it looked at.
    std::size_t for_each_in(glm::vec3 low, glm::vec3 high, const std::function<void(std::uint32_t)>& visit) const;

    [[nodiscard]] std::size_t memory_bytes() const {
        return nodes_.capacity() * sizeof(Node) + triangles_.capacity() * sizeof(Triangle);
    }

  private:
    static constexpr int k_depth = 64; // halved each time: 20 levels for a million

    struct Triangle {
        glm::vec3 corner[3];
        glm::vec3 normal;     ///< of length 1; 0 for a triangle without area
        std::uint32_t number; ///< in the mesh
    };
    struct Node {
        glm::vec3 low, high;
        std::uint32_t first = 0; ///< child, its sibling follows; or triangle
        std::uint32_t count = 0; ///< of triangles; 0: has children
        glm::vec3 centre, area;  ///< of the dipole
        float reach = 0.0f;      ///< of the triangles from `centre`
    };

    void build(std::size_t node, std::span<std::uint32_t> members, const MeshData& data, std::span<const glm::vec3> middles);
    [[nodiscard]] std::span<const Triangle> triangles_of(const Node& node) const {
        return std::span(triangles_).subspan(node.first, node.count);
    }
    /// enter(node): whether to go on into it; visit(triangle): whether to go on at all. Returns how many of both it looked at.
    template <class Enter, class Visit>
    std::size_t walk(const Enter& enter, const Visit& visit) const;

    std::vector<Node> nodes_;
    std::vector<Triangle> triangles_;
};

/// Those of a mesh.
struct MeshEdges {
    /// As MeshTree's.
    static void pass(auto& archive, auto& edges);

    std::vector<MeshEdge> edges{};
    std::unique_ptr<const MeshTree> tree{}; ///< of the edges, as triangles; none where there are none
};

/// The two halves of a triangle across the middle of its longest edge. None where floats end.
[[nodiscard]] std::optional<std::array<std::array<glm::vec3, 3>, 2>> halves_of(const std::array<glm::vec3, 3>& corner);

} // namespace windrow::detail
