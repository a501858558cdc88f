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

#include "../../fluid/setting.h"
#include "mesh.h"

#include <glm/mat4x4.hpp>
#include <span>
#include <string>
#include <vector>

namespace windrow::vegetation::fur {

/// One swing of a bone about an axis: angle = rest + amplitude sin(a) + second sin(2 a + second_phase), a = 2 pi hz t + phase.
struct Swing {
    glm::vec3 axis{1.0f, 0.0f, 0.0f};
    float rest = 0.0f;
    float amplitude = 0.0f;
    float hz = 1.0f;
    float phase = 0.0f;
    float second = 0.0f;
    float second_phase = 0.0f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("axis", &Swing::axis, Range::length(1e-6, 1e6, ""), "Of the mesh at rest; any length but 0."),
            Setting("rest", &Swing::rest, {-3.1415927, 3.1415927, "rad"}, "Held always."),
            Setting("amplitude", &Swing::amplitude, {0.0, 1.5707964, "rad"}, "Of the swing."),
            Setting("hz", &Swing::hz, {0.0, 20.0, "Hz"}, "Its frequency."),
            Setting("phase", &Swing::phase, {-100.0, 100.0, "rad"}, "By which it is ahead."),
            Setting("second", &Swing::second, {0.0, 1.5707964, "rad"},
                    "Amplitude at the double frequency: a knee bends and stretches unevenly."),
            Setting("second_phase", &Swing::second_phase, {-100.0, 100.0, "rad"}, "Of the double frequency."),
        };
    }
};

struct Bone {
    std::string name;
    int parent = -1;
    glm::vec3 head{0.0f};
    glm::vec3 tail{0.0f};
    float radius = 0.1f;
    std::vector<Swing> swings{};
    glm::vec3 sway{0.0f};
    float sway_hz = 1.0f;
    float sway_phase = 0.0f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("name", &Bone::name, "For others to name as their parent."),
            Setting("parent", &Bone::parent, "Index of a bone before it; -1: none.", k_not_stored),
            Setting("head", &Bone::head, {-k_farthest, k_farthest, "m"}, "In the mesh at rest: what it turns about."),
            Setting("tail", &Bone::tail, {-k_farthest, k_farthest, "m"}, "Its other end."),
            Setting("radius", &Bone::radius, {1e-5, 100.0, "m"},
                    "Of the flesh around it: thick bones hold vertices from farther."),
            Setting("swings", &Bone::swings, {0.0, 4.0}, "Turns to and fro about its head, the first applied last."),
            Setting("sway", &Bone::sway, {-10.0, 10.0, "m"},
                    "It moves to and fro by so much, as sway sin(2 pi sway_hz t + sway_phase)."),
            Setting("sway_hz", &Bone::sway_hz, {0.0, 20.0, "Hz"}, "Frequency of the sway."),
            Setting("sway_phase", &Bone::sway_phase, {-100.0, 100.0, "rad"}, "By which the sway is ahead."),
        };
    }
};

struct Skeleton {
    std::vector<Bone> bones; ///< 1 to 128, parents first
};

inline constexpr std::size_t k_max_bones = 128;

/// Rejects parents that do not come before (so circles too), what is not finite, and fields out of range.
[[nodiscard]] Result<void> validate(const Skeleton& skeleton);

/// Gives each vertex its four nearest bones. With d the distance to the bone's segment over its radius, the weight falls as
/// 1 / d^4 beyond the flesh and is made 0 at the fifth bone, so that no vertex jumps where a neighbour has other bones; weights
/// sum to 1 within 2^-22. Rejects what validate rejects.
[[nodiscard]] Result<void> bind(Mesh& mesh, const Skeleton& skeleton);

/// One rigid matrix a bone, for mesh positions [m]; any finite time. Of a valid skeleton.
[[nodiscard]] std::vector<glm::mat4> pose(const Skeleton& skeleton, double seconds);

/// One entry a vertex. Vertices without weights stay where they are. Rejects spans of other sizes, and bones without a matrix.
[[nodiscard]] Result<void> skin(const Mesh& mesh, std::span<const glm::mat4> matrices, std::span<glm::vec3> positions,
                                std::span<glm::vec3> normals);

} // namespace windrow::vegetation::fur
