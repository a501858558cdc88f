// A person who walks: 1.76 m, eight heads high, of a torso, a head with a hat, arms and legs, a part each.
//
//     Solid person = person_solid();
//     const PersonParts parts = person_parts(stance);          // where each part is, from the person's own space
//
// Own space: feet at the origin on y = 0, facing +z, x to its left. A leg is two links of fixed length from hip to ankle; the knee
// bends forward. (Two-link inverse kinematics by the law of cosines.) An ankle that is out of reach is drawn in onto the leg's
// length.
#pragma once

#include "solids.h"

#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace windrow::vegetation::render {

namespace person {
/// [m] Heights and lengths of a standing person.
inline constexpr float k_height = 1.76f, k_hip = 0.90f, k_shoulder = 1.41f, k_ankle = 0.08f, k_thigh = 0.42f, k_shin = 0.40f,
                       k_upper_arm = 0.29f, k_forearm = 0.25f, k_hip_aside = 0.085f, k_shoulder_aside = 0.185f;
/// Parts in the order of their limbs; left, then right.
enum Part : std::uint8_t {
    torso,
    head,
    upper_arm,
    forearm = upper_arm + 2,
    thigh = forearm + 2,
    shin = thigh + 2,
    foot = shin + 2
};
inline constexpr std::size_t k_parts = foot + 2;
} // namespace person

struct PersonStance {
    struct Leg {
        glm::vec3 ankle{0.0f, person::k_ankle, 0.0f}; ///< [m]
        float pitch = 0.0f;                           ///< [rad] toes downward
    };
    struct Arm {
        float swing = 0.0f; ///< [rad] backward
        float bend = 0.15f; ///< [rad] of the elbow
    };
    float hip = person::k_hip; ///< [m] height of the hips
    float lean = 0.0f;         ///< [rad] of the torso, forward
    float twist = 0.0f;        ///< [rad] of the shoulders, to the left
    std::array<Leg, 2> legs{Leg{{person::k_hip_aside, person::k_ankle, 0.0f}},
                            Leg{{-person::k_hip_aside, person::k_ankle, 0.0f}}};
    std::array<Arm, 2> arms{};
};

using PersonParts = std::array<glm::mat4, person::k_parts>;

[[nodiscard]] PersonParts person_parts(const PersonStance& stance);

/// Its parts; a cloak's begin at person::k_parts (cloak.h).
[[nodiscard]] Solid person_solid();

/// A tapered limb or the trunk, for what must stay outside: capsules with the parts' own radii [m].
struct PersonCapsule {
    glm::vec3 a{0.0f}, b{0.0f};
    float radius_a = 0.1f, radius_b = 0.1f;
    float wide = 1.0f; ///< across x over along z: the trunk is wider than deep
};
inline constexpr std::size_t k_person_capsules = 11;
[[nodiscard]] std::array<PersonCapsule, k_person_capsules> person_flesh(const PersonParts& parts);
/// [m] From the capsule's surface, below 0 within; `outward` receives the unit vector away from its axis.
[[nodiscard]] float distance(const PersonCapsule& capsule, glm::vec3 p, glm::vec3& outward);

} // namespace windrow::vegetation::render
