#include "vegetation/render/person.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace windrow::vegetation::render {
namespace {

using namespace person;

constexpr glm::vec3 k_skin{0.36f, 0.205f, 0.135f}, k_hair{0.030f, 0.018f, 0.010f}, k_felt{0.062f, 0.042f, 0.024f},
    k_band{0.16f, 0.045f, 0.028f}, k_tunic{0.075f, 0.082f, 0.045f}, k_belt{0.045f, 0.024f, 0.012f},
    k_trousers{0.062f, 0.054f, 0.046f}, k_boots{0.052f, 0.028f, 0.014f};
constexpr int k_limb_sides = 16;
constexpr float k_neck_to_hip = 0.575f; // [m] from the hips to the head's joint
constexpr float k_deep = 0.62f;         // of the trunk, over its width

float side_of(std::size_t n) {
    return n == 0 ? 1.0f : -1.0f;
}

Solid scaled(Solid solid, glm::vec3 by, glm::vec3 moved = glm::vec3(0.0f)) {
    for (SolidVertex& vertex : solid) {
        vertex.position = glm::vec4(glm::vec3(vertex.position) * by + moved, vertex.position.w);
        vertex.normal = glm::vec4(glm::normalize(glm::vec3(vertex.normal) / by), 0.0f);
    }
    return solid;
}

Solid ball(glm::vec3 half, glm::vec3 middle, glm::vec3 colour) {
    std::array<glm::vec2, 9> arc{};
    for (std::size_t n = 0; n < arc.size(); ++n) {
        const float turn = 3.14159265f * static_cast<float>(n) / static_cast<float>(arc.size() - 1);
        arc[n] = {std::sin(turn), -std::cos(turn)};
    }
    return scaled(lathe(arc, k_limb_sides, colour), half, middle);
}

// A limb down from its joint: radii at its ends and in between, round at both.
Solid limb(float length, float top, float belly, float end, glm::vec3 colour) {
    return lathe(std::array{glm::vec2(0.0f, -length - 0.7f * end), glm::vec2(0.75f * end, -length - 0.45f * end),
                            glm::vec2(end, -length), glm::vec2(0.5f * (belly + end) + 0.004f, -0.70f * length),
                            glm::vec2(belly, -0.35f * length), glm::vec2(top, 0.0f), glm::vec2(0.72f * top, 0.55f * top),
                            glm::vec2(0.0f, 0.8f * top)},
                 k_limb_sides, colour);
}

void add_part(Solid& whole, std::size_t part, Solid solid) {
    for (SolidVertex& vertex : solid)
        vertex.position.w = static_cast<float>(part);
    whole.insert(whole.end(), solid.begin(), solid.end());
}

// From the hips' middle.
Solid trunk() {
    Solid solid = scaled(
        lathe(std::array{glm::vec2(0.180f, -0.19f), glm::vec2(0.192f, -0.18f), glm::vec2(0.174f, -0.04f),
                         glm::vec2(0.150f, 0.06f), glm::vec2(0.135f, 0.16f), glm::vec2(0.150f, 0.28f), glm::vec2(0.176f, 0.40f),
                         glm::vec2(0.178f, 0.47f), glm::vec2(0.140f, 0.525f), glm::vec2(0.075f, 0.560f), glm::vec2(0.0f, 0.565f)},
              20, k_tunic),
        {1.0f, 1.0f, k_deep});
    add(solid, scaled(lathe(std::array{glm::vec2(0.141f, 0.125f), glm::vec2(0.147f, 0.130f), glm::vec2(0.147f, 0.170f),
                                       glm::vec2(0.141f, 0.175f)},
                            20, k_belt),
                      {1.0f, 1.0f, k_deep}));
    add(solid, scaled(lathe(std::array{glm::vec2(0.066f, 0.50f), glm::vec2(0.056f, 0.57f), glm::vec2(0.056f, 0.64f)},
                            k_limb_sides, k_skin),
                      {1.0f, 1.0f, 1.0f}));
    for (const float side : {1.0f, -1.0f}) // rounded shoulders
        add(solid, ball({0.062f, 0.052f, 0.056f}, {side * (k_shoulder_aside - 0.022f), 0.485f, 0.0f}, k_tunic));
    return solid;
}

// From the joint of neck and skull.
Solid head_and_hat() {
    Solid solid = ball({0.077f, 0.118f, 0.094f}, {0.0f, 0.128f, 0.018f}, k_skin);
    add(solid, ball({0.085f, 0.104f, 0.092f}, {0.0f, 0.146f, -0.008f}, k_hair));
    add(solid, ball({0.012f, 0.020f, 0.018f}, {0.0f, 0.110f, 0.113f}, k_skin)); // nose
    Solid hat = scaled(lathe(std::array{glm::vec2(0.085f, 0.0f), glm::vec2(0.150f, -0.010f), glm::vec2(0.166f, 0.002f),
                                        glm::vec2(0.156f, 0.010f), glm::vec2(0.092f, 0.016f), glm::vec2(0.088f, 0.030f),
                                        glm::vec2(0.084f, 0.085f), glm::vec2(0.066f, 0.115f), glm::vec2(0.030f, 0.108f),
                                        glm::vec2(0.0f, 0.104f)},
                             24, k_felt),
                       {0.96f, 1.0f, 1.08f});
    add(hat,
        scaled(lathe(std::array{glm::vec2(0.092f, 0.017f), glm::vec2(0.093f, 0.043f), glm::vec2(0.086f, 0.046f)}, 24, k_band),
               {0.96f, 1.0f, 1.08f}));
    for (SolidVertex& vertex : hat) { // the brim droops before and behind
        const float out = vertex.position.z;
        vertex.position.y -= 0.55f * out * out;
    }
    add(solid, hat, glm::rotate(glm::translate(glm::mat4(1.0f), {0.0f, 0.196f, 0.002f}), -0.10f, {1.0f, 0.0f, 0.0f}));
    return solid;
}

Solid boot() {
    Solid solid = ball({0.046f, 0.042f, 0.125f}, {0.0f, -0.045f, 0.060f}, k_boots);
    for (SolidVertex& vertex : solid) // a level sole
        vertex.position.y = std::max(vertex.position.y, -k_ankle);
    return solid;
}

/// Its -y along `way`, its z as near to `forward` as that leaves.
glm::mat4 hung(glm::vec3 joint, glm::vec3 way, glm::vec3 forward) {
    const glm::vec3 y = -glm::normalize(way);
    const glm::vec3 x = glm::normalize(glm::cross(y, forward));
    return {glm::vec4(x, 0.0f), glm::vec4(y, 0.0f), glm::vec4(glm::cross(x, y), 0.0f), glm::vec4(joint, 1.0f)};
}

glm::vec3 place_of(const glm::mat4& part, glm::vec3 own) {
    return glm::vec3(part * glm::vec4(own, 1.0f));
}

} // namespace

PersonParts person_parts(const PersonStance& stance) {
    PersonParts parts{};
    const glm::mat4 hips = glm::translate(glm::mat4(1.0f), {0.0f, stance.hip, 0.0f});
    const glm::mat4 trunk = glm::rotate(glm::rotate(hips, stance.lean, {1.0f, 0.0f, 0.0f}), stance.twist, {0.0f, 1.0f, 0.0f});
    parts[torso] = trunk;
    glm::mat4 skull = glm::translate(trunk, {0.0f, k_neck_to_hip, 0.0f});
    skull = glm::rotate(skull, -stance.twist, {0.0f, 1.0f, 0.0f}); // it looks ahead
    parts[head] = glm::rotate(skull, -0.8f * stance.lean, {1.0f, 0.0f, 0.0f});
    for (std::size_t n = 0; n < 2; ++n) {
        glm::mat4 arm = glm::translate(trunk, {side_of(n) * k_shoulder_aside, k_shoulder - k_hip, 0.0f});
        arm = glm::rotate(arm, side_of(n) * 0.10f, {0.0f, 0.0f, 1.0f}); // a little aside
        arm = glm::rotate(arm, stance.arms[n].swing, {1.0f, 0.0f, 0.0f});
        parts[upper_arm + n] = arm;
        parts[forearm + n] =
            glm::rotate(glm::translate(arm, {0.0f, -k_upper_arm, 0.0f}), -stance.arms[n].bend, {1.0f, 0.0f, 0.0f});

        const glm::vec3 hip = place_of(hips, {side_of(n) * k_hip_aside, 0.0f, 0.0f});
        const glm::vec3 way = stance.legs[n].ankle - hip;
        const float reach = std::clamp(glm::length(way), 0.2f, k_thigh + k_shin - 1e-4f);
        const glm::vec3 down = way / std::max(glm::length(way), 1e-6f);
        const float along = (k_thigh * k_thigh - k_shin * k_shin + reach * reach) / (2.0f * reach);
        const float bend = std::sqrt(std::max(k_thigh * k_thigh - along * along, 0.0f));
        const glm::vec3 ahead = glm::normalize(glm::vec3(0.0f, 0.0f, 1.0f) - down.z * down);
        const glm::vec3 knee = hip + along * down + bend * ahead, ankle = hip + reach * down;
        parts[thigh + n] = hung(hip, knee - hip, ahead);
        parts[shin + n] = hung(knee, ankle - knee, ahead);
        parts[foot + n] = glm::rotate(glm::translate(glm::mat4(1.0f), ankle), stance.legs[n].pitch, {1.0f, 0.0f, 0.0f});
    }
    return parts;
}

Solid person_solid() {
    Solid solid;
    add_part(solid, torso, trunk());
    add_part(solid, head, head_and_hat());
    for (std::size_t n = 0; n < 2; ++n) {
        add_part(solid, upper_arm + n, limb(k_upper_arm, 0.052f, 0.050f, 0.040f, k_tunic));
        Solid lower = limb(k_forearm, 0.041f, 0.041f, 0.028f, k_tunic);
        add(lower, ball({0.030f, 0.060f, 0.038f}, {0.0f, -k_forearm - 0.050f, 0.006f}, k_skin));
        add_part(solid, forearm + n, lower);
        add_part(solid, thigh + n, limb(k_thigh, 0.086f, 0.080f, 0.054f, k_trousers));
        Solid calf = limb(k_shin, 0.054f, 0.058f, 0.040f, k_trousers);
        add(calf, lathe(std::array{glm::vec2(0.044f, -k_shin - 0.01f), glm::vec2(0.049f, -k_shin + 0.06f),
                                   glm::vec2(0.062f, -0.17f), glm::vec2(0.068f, -0.14f), glm::vec2(0.060f, -0.135f)},
                        k_limb_sides, k_boots)); // the boot's leg
        add_part(solid, shin + n, calf);
        add_part(solid, foot + n, boot());
    }
    return solid;
}

std::array<PersonCapsule, k_person_capsules> person_flesh(const PersonParts& parts) {
    std::array<PersonCapsule, k_person_capsules> flesh{};
    std::size_t next = 0;
    flesh[next++] = {place_of(parts[torso], {0.0f, -0.12f, 0.0f}), place_of(parts[torso], {0.0f, 0.15f, 0.0f}), 0.170f * k_deep,
                     0.148f * k_deep, 1.0f / k_deep};
    flesh[next++] = {place_of(parts[torso], {0.0f, 0.15f, 0.0f}), place_of(parts[torso], {0.0f, 0.46f, 0.0f}), 0.148f * k_deep,
                     0.180f * k_deep, 1.0f / k_deep};
    flesh[next++] = {place_of(parts[head], {0.0f, 0.0f, 0.0f}), place_of(parts[head], {0.0f, 0.15f, 0.0f}), 0.055f, 0.09f};
    for (std::size_t n = 0; n < 2; ++n) {
        flesh[next++] = {place_of(parts[upper_arm + n], {}), place_of(parts[upper_arm + n], {0.0f, -k_upper_arm, 0.0f}), 0.060f,
                         0.044f};
        flesh[next++] = {place_of(parts[forearm + n], {}), place_of(parts[forearm + n], {0.0f, -k_forearm - 0.08f, 0.0f}), 0.044f,
                         0.036f};
        flesh[next++] = {place_of(parts[thigh + n], {}), place_of(parts[thigh + n], {0.0f, -k_thigh, 0.0f}), 0.088f, 0.062f};
        flesh[next++] = {place_of(parts[shin + n], {}), place_of(parts[shin + n], {0.0f, -k_shin, 0.0f}), 0.068f, 0.052f};
    }
    return flesh;
}

float distance(const PersonCapsule& capsule, glm::vec3 p, glm::vec3& outward) {
    const glm::vec3 squeeze(1.0f / capsule.wide, 1.0f, 1.0f); // in which it is round; distances across x are then too short
    const glm::vec3 axis = squeeze * (capsule.b - capsule.a), from = squeeze * (p - capsule.a);
    const float t = std::clamp(glm::dot(from, axis) / std::max(glm::dot(axis, axis), 1e-12f), 0.0f, 1.0f);
    const glm::vec3 off = from - t * axis;
    const float away = glm::length(off);
    outward = away > 1e-6f ? glm::normalize(squeeze * off) : glm::vec3(0.0f, 0.0f, -1.0f);
    return away - glm::mix(capsule.radius_a, capsule.radius_b, t);
}

} // namespace windrow::vegetation::render
