#include "fluid/core/validation.h"
#include "vegetation/fur/beast.h"
#include "vegetation/fur/beast_form.h"

#include <cmath>
#include <numbers>

namespace windrow::vegetation::fur {
namespace {

using namespace beast_form;

constexpr float k_turn = 2.0f * std::numbers::pi_v<float>;
constexpr glm::vec3 k_x{1.0f, 0.0f, 0.0f}, k_y{0.0f, 1.0f, 0.0f};

// A turn about x is backwards for what hangs and downwards for what points ahead.
class Gait {
  public:
    Gait(float height, float hz) : height_(height), hz_(hz) {}

    int add(const char* name, int parent, const glm::vec3& head, const glm::vec3& tail, float radius, std::vector<Swing> swings) {
        bones.push_back({.name = name,
                         .parent = parent,
                         .head = height_ * head,
                         .tail = height_ * tail,
                         .radius = height_ * radius,
                         .swings = std::move(swings)});
        return static_cast<int>(bones.size()) - 1;
    }

    // To and fro with the stride; `late` in strides.
    [[nodiscard]] Swing sway(const glm::vec3& axis, float amplitude, float times, float late) const {
        return {.axis = axis, .amplitude = amplitude, .hz = times * hz_, .phase = -k_turn * times * late};
    }
    // A joint that folds by `angle` while its leg swings forward, and is straight while it carries: angle (1 - cos a)^2 / 4, with
    // a half a turn in the middle of the swing forward. That is angle (3/8 - cos a / 2 + cos 2a / 8).
    [[nodiscard]] Swing fold(float angle, float late) const {
        const float size = std::abs(angle);
        return {.axis = angle < 0.0f ? -k_x : k_x,
                .rest = 0.375f * size,
                .amplitude = 0.5f * size,
                .hz = hz_,
                .phase = -k_turn * (late + 0.25f),
                .second = 0.125f * size,
                .second_phase = 0.75f * k_turn};
    }

    std::vector<Bone> bones;

  private:
    float height_, hz_;
};

// [rad] How far joints go, and when each foot does, in strides.
struct Form {
    float shoulder, forearm, forefoot, thigh, shank, knee, hind_foot, hock; // folds and swings, as they are named below
    float back, rise;                                                       // bend of the back; rise of the body in heights
    float rises;                                                            // times a stride
    std::array<float, 2> hind, fore;                                        // left, right
};
constexpr Form k_walk{0.26f, 0.5f, 0.9f, 0.28f, 0.55f, 0.22f, 0.5f, 0.18f, 0.015f, 0.012f, 2.0f, {0.0f, 0.5f}, {0.25f, 0.75f}};
constexpr Form k_gallop{0.60f, 1.0f, 1.1f, 0.62f, 1.0f, 0.30f, 0.8f, 0.25f, 0.16f, 0.035f, 1.0f, {0.0f, 0.1f}, {0.5f, 0.6f}};

} // namespace

Result<Skeleton> beast_skeleton(const Beast& beast, float hz, BeastGait gait) {
    windrow::detail::Reasons reasons;
    windrow::detail::check_settings(reasons, {nullptr, "beast"}, beast);
    windrow::detail::check_value(reasons, {nullptr, "beast_skeleton.hz"}, hz, {0.0, 5.0, "Hz"});
    if (!reasons.empty())
        return Error{reasons.take()};

    const Form& form = gait == BeastGait::gallop ? k_gallop : k_walk;
    const float times = form.rises; // of the back
    Gait walk(beast.height, hz);
    const int hips = walk.add("hips", -1, k_hips, k_loin, 0.14f, {walk.sway(k_y, 0.03f, 1.0f, 0.0f)});
    walk.bones[0].sway = {0.0f, form.rise * beast.height,
                          0.0f}; // the body rises over each pair of legs in a walk: twice a stride
    walk.bones[0].sway_hz = form.rises * hz;
    if (gait == BeastGait::gallop)
        walk.bones[0].swings.push_back(walk.sway(k_x, 0.10f, 1.0f, 0.3f));
    const int chest = walk.add("chest", hips, k_loin, k_withers, 0.18f,
                               {walk.sway(k_y, 0.05f, 1.0f, 0.25f), walk.sway(k_x, form.back, times, 0.1f)});
    const int neck =
        walk.add("neck", chest, k_neck, k_nape, 0.14f, {walk.sway(k_x, 0.05f, 2.0f, 0.15f), walk.sway(k_y, 0.05f, 1.0f, 0.3f)});
    const int head =
        walk.add("head", neck, k_nape, k_nose, 0.10f, {walk.sway(k_x, 0.06f, 2.0f, 0.4f), walk.sway(k_y, 0.04f, 0.5f, 0.0f)});
    const int brush = walk.add("tail", hips, k_tail, k_tail_middle, 0.06f,
                               {walk.sway(k_y, 0.16f, 1.0f, 0.0f), walk.sway(k_x, 0.05f, 2.0f, 0.0f)});
    walk.add("tail_tip", brush, k_tail_middle, k_tail_tip, 0.06f,
             {walk.sway(k_y, 0.22f, 1.0f, 0.15f), walk.sway(k_x, 0.08f, 2.0f, 0.15f)});

    struct Side {
        const char *ear, *shoulder, *fore_arm, *fore_foot, *thigh, *shank, *hind_foot;
        bool is_left;
        float hind_late, fore_late; // in strides
    };
    for (const Side& side : {Side{"left ear", "left shoulder", "left forearm", "left forefoot", "left thigh", "left shank",
                                  "left hind foot", true, form.hind[0], form.fore[0]},
                             Side{"right ear", "right shoulder", "right forearm", "right forefoot", "right thigh", "right shank",
                                  "right hind foot", false, form.hind[1], form.fore[1]}}) {
        const auto at = [&](const glm::vec3& p) { return side.is_left ? p : mirrored(p); };
        walk.add(side.ear, head, at(k_ear), at(k_ear_tip), 0.035f, {walk.sway(k_x, 0.06f, 2.0f, side.fore_late)});
        const int shoulder = walk.add(side.shoulder, chest, at(k_shoulder), at(k_elbow), 0.085f,
                                      {walk.sway(k_x, form.shoulder, 1.0f, side.fore_late)});
        const int arm =
            walk.add(side.fore_arm, shoulder, at(k_elbow), at(k_wrist), 0.055f, {walk.fold(-form.forearm, side.fore_late)});
        walk.add(side.fore_foot, arm, at(k_wrist), at(k_fore_toes), 0.045f, {walk.fold(form.forefoot, side.fore_late)});
        const int thigh =
            walk.add(side.thigh, hips, at(k_hip), at(k_knee), 0.10f, {walk.sway(k_x, form.thigh, 1.0f, side.hind_late)});
        // The knee stretches behind and bends in front, the hock the other way, so that the foot keeps to the ground.
        const int shank = walk.add(side.shank, thigh, at(k_knee), at(k_hock), 0.06f,
                                   {walk.fold(form.shank, side.hind_late), walk.sway(-k_x, form.knee, 1.0f, side.hind_late)});
        walk.add(side.hind_foot, shank, at(k_hock), at(k_hind_toes), 0.045f,
                 {walk.fold(-form.hind_foot, side.hind_late), walk.sway(k_x, form.hock, 1.0f, side.hind_late)});
    }
    Skeleton skeleton{std::move(walk.bones)};
    if (const auto valid = validate(skeleton); !valid)
        return valid.failure();
    return skeleton;
}

} // namespace windrow::vegetation::fur
