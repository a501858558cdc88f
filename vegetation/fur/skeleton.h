// Bones that move a mesh by formulas: no clip is read. A mesh is bound to them once, posed for any time, and its vertices
// skinned.
//
//     fur::Mesh beast = *fur::beast_mesh();
//     const fur::Skeleton bones = *fur::beast_skeleton();
//     bind(beast, bones);
//     skin(beast, pose(bones, seconds), positions, normals);
//
// A vertex v with weights w over bones b is drawn at sum w M_b v, and its normal is the unit vector along sum w R_b n, R the turn
// of M. (Linear blend skinning: Magnenat-Thalmann et al. 1988, Joint-dependent local deformations.) M_b is rigid: it turns the
// bone about its head, after its parent's, and may move. Without swings and sway it is the identity to the bit.
#pragma once

#include "vegetation/fur/mesh.h"

#include <glm/mat4x4.hpp>
#include <span>
#include <string>
#include <vector>

namespace windrow::vegetation::fur {

/// One swing of a bone about an axis: angle = rest + amplitude sin(a) + second sin(2 a + second_phase), a = 2 pi hz t + phase.
struct Swing {
    glm::vec3 axis{1.0f, 0.0f, 0.0f}; ///< of the mesh at rest; any length but 0
    float rest = 0.0f;                ///< [rad] held always, -pi to pi. Default 0
    float amplitude = 0.0f;           ///< [rad] 0 to pi/2
    float hz = 1.0f;                  ///< 0 to 20
    float phase = 0.0f;               ///< [rad]
    float second = 0.0f;              ///< [rad] of the double frequency, 0 to pi/2: a knee bends and stretches unevenly
    float second_phase = 0.0f;        ///< [rad]
};

struct Bone {
    std::string name;
    int parent = -1;             ///< an index before its own; -1: none
    glm::vec3 head{0.0f};        ///< [m] in the mesh at rest: what it turns about
    glm::vec3 tail{0.0f};        ///< [m]
    float radius = 0.1f;         ///< [m] of the flesh around it, above 0, at most 100: thick bones hold vertices from farther
    std::vector<Swing> swings{}; ///< at most 4, the first applied last
    glm::vec3 sway{0.0f};        ///< [m] the bone moves by sway sin(2 pi sway_hz t + sway_phase); each at most 10
    float sway_hz = 1.0f;        ///< 0 to 20
    float sway_phase = 0.0f;     ///< [rad]
};

struct Skeleton {
    std::vector<Bone> bones; ///< 1 to 128, parents first
};

inline constexpr std::size_t k_most_bones = 128;

/// Refuses parents that do not come before (so circles too), what is not finite, and fields out of range.
[[nodiscard]] Result<void> validate(const Skeleton& skeleton);

/// Gives each vertex its four nearest bones. With d the distance to the bone's segment over its radius, the weight falls as
/// 1 / d^4 beyond the flesh and is made 0 at the fifth bone, so that no vertex jumps where a neighbour has other bones; weights
/// sum to 1 within 2^-22. Refuses what validate refuses.
[[nodiscard]] Result<void> bind(Mesh& mesh, const Skeleton& skeleton);

/// One rigid matrix a bone, for mesh positions [m]; any finite time. Of a valid skeleton.
[[nodiscard]] std::vector<glm::mat4> pose(const Skeleton& skeleton, double seconds);

/// One entry a vertex. Vertices without weights stay where they are. Refuses spans of other sizes, and bones without a matrix.
[[nodiscard]] Result<void> skin(const Mesh& mesh, std::span<const glm::mat4> matrices, std::span<glm::vec3> positions,
                                std::span<glm::vec3> normals);

} // namespace windrow::vegetation::fur
