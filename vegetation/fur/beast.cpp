#include "vegetation/fur/beast.h"

#include "fluid/core/validation.h"
#include "vegetation/fur/beast_form.h"
#include "vegetation/fur/surface_nets.h"

#include <cmath>

namespace windrow::vegetation::fur {
namespace {

using windrow::detail::message;

using namespace beast_form;

// In heights of the withers. What melts wide comes first, since a later capsule's fillet reaches all before it.
Flesh flesh_of() {
    Flesh flesh{
        // trunk: deep chest, tucked belly, a level back
        {{0.0f, 0.70f, 0.26f}, {0.0f, 0.70f, 0.04f}, 0.19f, 0.185f, 0.05f},
        {{0.0f, 0.73f, 0.02f}, {0.0f, 0.77f, -0.36f}, 0.16f, 0.130f, 0.10f},
        {k_withers, {0.0f, 0.84f, -0.38f}, 0.115f, 0.105f, 0.08f},
        {k_hips, {0.0f, 0.79f, -0.47f}, 0.125f, 0.10f, 0.08f},
        // neck and its mane
        {k_neck, k_nape, 0.165f, 0.125f, 0.12f},
        {{0.0f, 0.72f, 0.38f}, {0.0f, 0.93f, 0.59f}, 0.145f, 0.105f, 0.10f},
        // head: skull, cheeks, muzzle, jaw
        {{0.0f, 1.045f, 0.64f}, {0.0f, 1.03f, 0.71f}, 0.118f, 0.098f, 0.06f},
        {{0.0f, 0.995f, 0.74f}, k_nose, 0.076f, 0.044f, 0.05f},
        {{0.0f, 0.945f, 0.71f}, {0.0f, 0.912f, 0.875f}, 0.060f, 0.032f, 0.04f},
        // tail: a brush, thickest in its middle
        {k_tail, k_tail_middle, 0.055f, 0.085f, 0.06f},
        {k_tail_middle, k_tail_tip, 0.085f, 0.036f, 0.05f},
    };
    const auto both = [&](const glm::vec3& a, const glm::vec3& b, float ra, float rb, float melt) {
        flesh.push_back({a, b, ra, rb, melt});
        flesh.push_back({mirrored(a), mirrored(b), ra, rb, melt});
    };
    both({0.065f, 1.0f, 0.63f}, {0.055f, 0.98f, 0.70f}, 0.078f, 0.06f, 0.05f); // cheeks
    both(k_ear, k_ear_tip, 0.060f, 0.020f, 0.035f);
    both(k_shoulder, k_elbow, 0.105f, 0.07f, 0.06f);
    both(k_elbow, k_wrist, 0.070f, 0.050f, 0.03f);
    both(k_wrist, k_fore_paw, 0.050f, 0.046f, 0.02f);
    both(k_fore_paw, k_fore_toes, 0.052f, 0.046f, 0.02f);
    both(k_hip, k_knee, 0.122f, 0.088f, 0.06f);
    both(k_knee, k_hock, 0.078f, 0.050f, 0.04f);
    both(k_hock, k_hind_paw, 0.050f, 0.046f, 0.02f);
    both(k_hind_paw, k_hind_toes, 0.052f, 0.046f, 0.02f);
    return flesh;
}

} // namespace

Result<Mesh> beast_mesh(const Beast& beast) {
    if (const auto valid = windrow::detail::validate_settings(beast, "beast"); !valid)
        return valid.failure();
    const float cell = 1.0f / static_cast<float>(beast.detail);
    const float side = std::ceil(0.35f / cell) * cell; // left and right cells mirror each other
    // Where two limbs come close, both may cross one cell; in a grid that lies a little otherwise they do not.
    constexpr int k_tries = 32;
    Result<Mesh> mesh = Error{};
    for (int i = 0; i < k_tries && !mesh; ++i) {
        const float up = static_cast<float>(i) / k_tries, back = static_cast<float>(7 * i % k_tries) / k_tries;
        mesh = surface_nets(flesh_of(), {-side, -0.06f - cell * up, -1.0f - cell * back}, {side, 1.40f, 1.1f}, cell, "coat");
    }
    if (!mesh)
        return windrow::Error{message("beast.detail is ", beast.detail,
                                      ", and two limbs cross one cell at every grid offset: give another detail.")};
    const float floor = mesh->low.y;
    for (MeshVertex& vertex : mesh->vertices)
        vertex.position = beast.height * (vertex.position - glm::vec3(0.0f, floor, 0.0f));
    project_uv(*mesh);
    measure(*mesh);
    return mesh;
}

} // namespace windrow::vegetation::fur
