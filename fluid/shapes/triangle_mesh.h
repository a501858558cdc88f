// A closed mesh of triangles: the form of a body, made once and shared by any number of obstacles.
//
//     auto house = windrow::TriangleMesh::create({.vertices = corners, .triangles = faces});
//     if (!house) std::fprintf(stderr, "%s\n", house.error().c_str());
//     else (void)wind.obstacles().add({.position = here, .shape = windrow::MeshShape{*house}});
//
// A point is inside where the winding number of the surface about it is not 0. So parts may touch, overlap and be nested: what of
// them is within others is no surface, a part inside another that faces the same way changes nothing, and one that faces the other
// way is a hollow. It does not matter
// whether triangles face outward or inward, as long as neighbours agree.
#pragma once

#include "../api.h"
#include "../result.h"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace windrow {

namespace detail {
/// [m] Its ends, and unit vectors out of the surfaces that meet there, as most of the mesh faces.
struct MeshEdge {
    glm::vec3 from, to, normal, other;
};
struct ClosedSurface;
struct MeshEdges;
class MeshTree;
class MeshSigns;
} // namespace detail

/// Vertices [m] and their indices, three a triangle.
struct MeshData {
    std::vector<glm::vec3> vertices{};
    std::vector<glm::uvec3> triangles{};
    friend bool operator==(const MeshData&, const MeshData&) = default;
};

class WINDROW_API TriangleMesh {
  public:
    using Data = MeshData;

    /// Ten triangles for each cell of the usual box: more change no cell, and take 110 bytes each.
    static constexpr std::size_t k_max_triangles = 1'000'000;
    /// [m] Largest coordinate: beyond it a float is a centimetre wide.
    static constexpr float k_farthest = 1e5f;
    /// [m] Least edge of the box that holds it, the longest of the three.
    static constexpr float k_smallest = 1e-6f;

    /// Of its search tree, for one point beside the surface, in the mean: 900 for 500,000 round triangles. Long thin triangles and
    /// those that are nested take one or two each, however many there are.
    static constexpr std::size_t k_max_steps = 10'000;

    /// Vertices at the same place become one, and triangles with a corner twice are left out. A triangle that is there twice counts
    /// once where the surface is closed only so. Takes 1 s for 500,000 triangles.
    /// Rejects no triangles or more than k_max_triangles, indices without a vertex, coordinates that are not finite or beyond
    /// k_farthest, a mesh smaller than k_smallest, a surface that is open (an edge without a second triangle) or whose neighbours
    /// face opposite ways, one that takes more than k_max_steps to search, and memory that is short.
    [[nodiscard]] static Result<std::shared_ptr<const TriangleMesh>> create(MeshData data);
    /// All that `create` finds, as bytes: 110 to 190 a triangle. An engine makes a mesh when it builds its data, and loads it in a game.
    /// Fails without memory.
    [[nodiscard]] Result<std::vector<std::byte>> save() const;
    /// The mesh that was saved: each call gives the same bits. Takes a small part of the time of `create`. Rejects bytes that are truncated, changed
    /// or of another version, and those whose parts do not fit one another.
    [[nodiscard]] static Result<std::shared_ptr<const TriangleMesh>> load(std::span<const std::byte> bytes);
    ~TriangleMesh();
    TriangleMesh(const TriangleMesh&) = delete;
    TriangleMesh& operator=(const TriangleMesh&) = delete;

    /// What it was made of, without what `create` leaves out.
    [[nodiscard]] const MeshData& data() const { return data_; }
    /// [m] Corners of the box that holds it.
    [[nodiscard]] glm::vec3 low() const { return low_; }
    [[nodiscard]] glm::vec3 high() const { return high_; }
    /// [m] From a point to the surface, negative inside. What is within the union of its parts is no surface of it. Beyond `most` it may be any value from `most` on, of the right sign.
    [[nodiscard]] float distance_to(glm::vec3 point, float most = std::numeric_limits<float>::infinity()) const;
    /// Whether the segment between two points meets the surface.
    [[nodiscard]] bool crosses(glm::vec3 from, glm::vec3 to) const;
    /// visit(edge) for each that is nearer to a point than `most` [m] and where the surface turns by more than 40 degrees away from the
    /// body.
    void for_each_edge_near(glm::vec3 point, float most, const std::function<void(const detail::MeshEdge&)>& visit) const;
    /// How often the surface is wound about a point, to .1: 0 outside, 1 inside, -1 where it faces inward.
    [[nodiscard]] double winding_number(glm::vec3 point) const;
    /// [m] The shortest way through the body between two faces that are parallel within 45 degrees, and at most the shortest edge
    /// of the box that holds it. Measured by rays into the body from points on each triangle, no farther apart than 1/8 of the longest
    /// edge of that box. Of a long thin triangle, parts across have none. Where large triangles have more than 8192 such points,
    /// some of these have a ray, one at least of each triangle.
    [[nodiscard]] float thickness() const { return thickness_; }

    [[nodiscard]] std::size_t memory_bytes() const;
    /// Equal for equal data.
    [[nodiscard]] std::uint64_t content_hash() const { return hash_; }
    /// By what they are made of, not by where they are in memory.
    friend bool operator==(const TriangleMesh& a, const TriangleMesh& b) { return (a <=> b) == 0; }
    friend std::strong_ordering operator<=>(const TriangleMesh& a, const TriangleMesh& b);

  private:
    TriangleMesh();                       ///< empty, for `load`
    explicit TriangleMesh(MeshData data); ///< closed; throws std::bad_alloc
    static void pass(auto& archive, auto& mesh);
    [[nodiscard]] static std::uint64_t hash_of(const MeshData& data);
    [[nodiscard]] bool is_sound() const; ///< no part leads out of another
    /// What is found by its tree. Throws std::bad_alloc.
    [[nodiscard]] Result<void> measure(detail::ClosedSurface found);

    MeshData data_;
    std::uint64_t hash_ = 0;
    glm::vec3 low_{0.0f}, high_{0.0f};
    std::unique_ptr<const detail::MeshEdges> edges_;
    std::unique_ptr<const detail::MeshTree> tree_;
    std::unique_ptr<const detail::MeshTree> surface_; ///< of the union of its parts; none where that is all of it
    std::unique_ptr<const detail::MeshSigns> signs_;
    float thickness_ = 0.0f;
};

} // namespace windrow
