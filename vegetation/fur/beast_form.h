// Where a wolf's joints are, in heights of the withers, read off a skeleton's side view: the flesh and the bones share them.
// x is to its left, y up, z forward; of legs and ears the left one.
#pragma once

#include <glm/vec3.hpp>

namespace windrow::vegetation::fur::beast_form {

inline constexpr glm::vec3 k_hips{0.0f, 0.80f, -0.42f}, k_loin{0.0f, 0.82f, -0.12f}, k_withers{0.0f, 0.86f, 0.28f};
inline constexpr glm::vec3 k_neck{0.0f, 0.86f, 0.38f}, k_nape{0.0f, 1.02f, 0.60f}, k_nose{0.0f, 0.95f, 0.945f};
inline constexpr glm::vec3 k_ear{0.066f, 1.11f, 0.61f}, k_ear_tip{0.09f, 1.275f, 0.605f};
inline constexpr glm::vec3 k_tail{0.0f, 0.82f, -0.55f}, k_tail_middle{0.0f, 0.60f, -0.71f}, k_tail_tip{0.0f, 0.34f, -0.79f};
inline constexpr glm::vec3 k_shoulder{0.12f, 0.70f, 0.30f}, k_elbow{0.13f, 0.50f, 0.19f}, k_wrist{0.12f, 0.23f, 0.235f},
    k_fore_paw{0.12f, 0.05f, 0.26f}, k_fore_toes{0.12f, 0.045f, 0.345f};
inline constexpr glm::vec3 k_hip{0.09f, 0.74f, -0.41f}, k_knee{0.12f, 0.50f, -0.31f}, k_hock{0.12f, 0.27f, -0.56f},
    k_hind_paw{0.12f, 0.05f, -0.50f}, k_hind_toes{0.12f, 0.045f, -0.415f};

/// The other side's.
[[nodiscard]] constexpr glm::vec3 mirrored(const glm::vec3& p) {
    return {-p.x, p.y, p.z};
}

} // namespace windrow::vegetation::fur::beast_form
