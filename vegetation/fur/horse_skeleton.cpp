#include "vegetation/fur/horse_skeleton.h"

#include "fluid/core/validation.h"

namespace windrow::vegetation::fur {
namespace {

constexpr float k_turn = 6.2831853f;
constexpr glm::vec3 k_y{0.0f, 1.0f, 0.0f};
// The horse looks along +x and a little to -z: a turn about this raises what points ahead.
constexpr glm::vec3 k_across{0.2f, 0.0f, 1.0f};

Swing sway(const glm::vec3& axis, float amplitude, float hz, float late) {
    return {.axis = axis, .amplitude = amplitude, .hz = hz, .phase = -k_turn * late};
}

} // namespace

// Joints were read off pictures of the mesh from two sides, to about a hundredth of its height.
Result<Skeleton> horse_skeleton(float size, float hz) {
    windrow::detail::Reasons reasons;
    windrow::detail::check_value(reasons, {nullptr, "horse_skeleton.size"}, size, {1e-3, 1e3, "m"});
    windrow::detail::check_value(reasons, {nullptr, "horse_skeleton.hz"}, hz, {0.0, 5.0, "Hz"});
    if (!reasons.empty())
        return Error{reasons.take()};

    Skeleton skeleton;
    const auto add = [&](const char* name, int parent, const glm::vec3& head, const glm::vec3& tail, float radius,
                         std::vector<Swing> swings) {
        skeleton.bones.push_back({.name = name,
                                  .parent = parent,
                                  .head = size * head,
                                  .tail = size * tail,
                                  .radius = size * radius,
                                  .swings = std::move(swings)});
        return static_cast<int>(skeleton.bones.size()) - 1;
    };
    // The croup and the hind legs carry all and stand still.
    const int croup = add("croup", -1, {-0.20f, 0.38f, 0.06f}, {-0.12f, 0.46f, 0.04f}, 0.11f, {});
    add("near thigh", croup, {-0.13f, 0.36f, 0.11f}, {-0.06f, 0.32f, 0.13f}, 0.07f, {});
    add("near shank", croup, {-0.04f, 0.29f, 0.13f}, {-0.08f, 0.15f, 0.11f}, 0.04f, {});
    add("near hoof", croup, {-0.08f, 0.14f, 0.11f}, {0.12f, 0.02f, 0.035f}, 0.03f, {});
    add("far thigh", croup, {-0.17f, 0.34f, -0.01f}, {-0.13f, 0.27f, -0.02f}, 0.06f, {});
    add("far shank", croup, {-0.15f, 0.25f, -0.01f}, {-0.16f, 0.13f, -0.01f}, 0.04f, {});
    add("far hoof", croup, {-0.15f, 0.11f, -0.01f}, {0.0f, 0.02f, -0.16f}, 0.03f, {});
    const int loin = add("loin", croup, {-0.12f, 0.46f, 0.04f}, {-0.03f, 0.57f, 0.0f}, 0.11f, {sway(k_across, 0.035f, hz, 0.0f)});
    const int chest =
        add("chest", loin, {-0.03f, 0.57f, 0.0f}, {0.06f, 0.70f, -0.06f}, 0.12f, {sway(k_across, 0.035f, hz, 0.1f)});
    const int neck = add("neck", chest, {-0.01f, 0.75f, -0.02f}, {-0.11f, 0.91f, 0.14f}, 0.08f,
                         {sway(k_across, 0.09f, hz, 0.3f), sway(k_y, 0.06f, 0.5f * hz, 0.0f)});
    add("head", neck, {-0.11f, 0.92f, 0.16f}, {0.07f, 0.90f, 0.11f}, 0.05f,
        {sway(k_across, 0.12f, hz, 0.45f), sway(k_y, 0.08f, 0.5f * hz, 0.1f)});
    const int dock =
        add("tail", croup, {-0.26f, 0.38f, 0.10f}, {-0.32f, 0.23f, 0.16f}, 0.04f, {sway({1.0f, 0.0f, 0.0f}, 0.10f, hz, 0.0f)});
    add("tail_tip", dock, {-0.32f, 0.23f, 0.16f}, {-0.30f, 0.04f, 0.15f}, 0.05f, {sway({1.0f, 0.0f, 0.0f}, 0.16f, hz, 0.2f)});
    // The forelegs paw in turn.
    const int near_arm =
        add("near forearm", chest, {0.13f, 0.69f, -0.05f}, {0.25f, 0.82f, -0.06f}, 0.04f, {sway(k_across, 0.20f, hz, 0.0f)});
    add("near forefoot", near_arm, {0.25f, 0.82f, -0.06f}, {0.36f, 0.69f, -0.085f}, 0.03f, {sway(k_across, 0.40f, hz, 0.12f)});
    const int far_arm =
        add("far forearm", chest, {0.11f, 0.73f, -0.15f}, {0.17f, 0.83f, -0.19f}, 0.04f, {sway(k_across, 0.20f, hz, 0.5f)});
    add("far forefoot", far_arm, {0.17f, 0.83f, -0.19f}, {0.19f, 0.65f, -0.205f}, 0.03f, {sway(k_across, 0.40f, hz, 0.62f)});
    if (const auto valid = validate(skeleton); !valid)
        return valid.failure();
    return skeleton;
}

} // namespace windrow::vegetation::fur
