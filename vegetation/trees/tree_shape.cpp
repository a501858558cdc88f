#include "vegetation/trees/tree_shape.h"

#include "coupling/chance.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

namespace windrow::vegetation::trees::shape {
namespace {

using windrow::detail::Chance;

constexpr float k_golden = 2.39996323f;   // [rad] 137.5 degrees
constexpr float k_branch_turn = 2.44346f; // [rad] 140 degrees
constexpr float k_radius_power = 1.2f;    // Weber & Penn's RatioPower
constexpr float k_below = 0.4f;           // [m] that the trunk reaches into the ground, for slopes

// A unit vector at right angles to a unit vector, turned about it.
glm::vec3 beside(glm::vec3 axis, float turn) {
    const glm::vec3 guide = std::abs(axis.y) < 0.9f ? glm::vec3(0.0f, 1.0f, 0.0f) : glm::vec3(1.0f, 0.0f, 0.0f);
    const glm::vec3 x = glm::normalize(glm::cross(guide, axis)), y = glm::cross(axis, x);
    return std::cos(turn) * x + std::sin(turn) * y;
}

struct Way {
    glm::vec3 from{0.0f}, direction{0.0f, 1.0f, 0.0f};
    float length = 1.0f, radius = 0.1f, tip = 0.1f; // tip: radius there over that at the root
    float rise = 0.0f, wander = 0.0f;
    int rings = 3, limb = 0;
};

// A stem that turns up or down and strays as it goes.
Stem walk(const Way& way, Chance& chance) {
    Stem stem{.limb = way.limb};
    const int steps = way.rings - 1;
    glm::vec3 at = way.from, direction = way.direction;
    for (int n = 0; n <= steps; ++n) {
        const float t = static_cast<float>(n) / static_cast<float>(steps);
        stem.points.push_back(at);
        stem.radii.push_back(way.radius * (1.0f - (1.0f - way.tip) * t));
        at += direction * (way.length / static_cast<float>(steps));
        const glm::vec3 stray = chance.vector(way.wander);
        const glm::vec3 turned = direction + stray + glm::vec3(0.0f, 2.0f * way.rise / static_cast<float>(steps), 0.0f);
        direction = glm::normalize(turned + 1e-4f * direction);
    }
    return stem;
}

Stem grow_trunk(const TreeSettings& s) {
    Chance chance(s.seed, 1);
    Stem trunk;
    const float phase_x = chance.between(0.0f, 6.28f), phase_z = chance.between(0.0f, 6.28f);
    for (int n = 0; n < k_trunk_rings; ++n) {
        // More rings at the foot, where the flare is.
        const float t = std::pow(static_cast<float>(n) / (k_trunk_rings - 1), 1.35f);
        const float y = n == 0 ? -std::min(k_below, 0.2f * s.height) : t * s.height;
        const float stray = s.trunk_wander * s.height * t;
        const glm::vec3 aside(std::sin(5.0f * t + phase_x) - std::sin(phase_x), 0.0f,
                              std::sin(4.3f * t + phase_z) - std::sin(phase_z));
        const float flare = 0.75f * std::exp(-std::max(y, 0.0f) / (1.6f * s.trunk_radius));
        trunk.points.push_back(glm::vec3(0.0f, y, 0.0f) + stray * aside);
        trunk.radii.push_back(s.trunk_radius * (1.0f + flare) * (1.0f - 0.94f * t));
    }
    return trunk;
}

// The trunk at a height [m]: its rings stand closer at the foot.
float share_at_height(const Stem& trunk, float y) {
    const auto above = std::find_if(trunk.points.begin() + 1, trunk.points.end() - 1, [&](glm::vec3 p) { return p.y >= y; });
    const auto n = static_cast<std::size_t>(above - trunk.points.begin());
    const float low = trunk.points[n - 1].y, high = trunk.points[n].y;
    const float between = std::clamp((y - low) / std::max(high - low, 1e-6f), 0.0f, 1.0f);
    return (static_cast<float>(n - 1) + between) / static_cast<float>(trunk.points.size() - 1);
}

struct Row {
    int row = 0, rows = 1;
};

// Limbs of one height, counted from the crown's base.
Row row_of(const TreeSettings& s, int limb) {
    const int whorl = std::max(s.whorl, 1);
    return {limb / whorl, (s.limbs + whorl - 1) / whorl};
}

Stem grow_limb(const TreeSettings& s, const Stem& trunk, int n, Chance& chance) {
    const auto [row, rows] = row_of(s, n);
    const float jitter = s.whorl > 0 ? 0.5f + chance.around(0.12f) : chance.share();
    const float t = (static_cast<float>(row) + jitter) / static_cast<float>(rows); // 0 the crown's base, 1 its top
    const float y = s.height * (s.crown_base + (0.985f - s.crown_base) * std::pow(t, s.limb_crowding));
    const float around = s.whorl > 0 ? glm::two_pi<float>() * static_cast<float>(n % s.whorl) / static_cast<float>(s.whorl) +
                                           0.7f * static_cast<float>(row) + chance.around(0.25f)
                                     : k_golden * static_cast<float>(n) + chance.around(0.35f);
    const float from_up = glm::radians(s.limb_low_deg + (s.limb_high_deg - s.limb_low_deg) * t + chance.around(9.0f));
    const float share = share_at_height(trunk, y);
    Way way;
    way.from = point_on(trunk, share);
    way.direction = {std::sin(from_up) * std::cos(around), std::cos(from_up), std::sin(from_up) * std::sin(around)};
    way.length = s.limb_length * form_length(s.form, 1.0f - t) * chance.between(0.82f, 1.08f);
    const float by_length = s.trunk_radius * std::pow(way.length / s.height, k_radius_power);
    way.radius = std::clamp(by_length, 0.004f, 0.75f * radius_on(trunk, share) + 0.004f);
    way.tip = 0.12f;
    way.rise = s.limb_rise;
    way.wander = s.wander;
    way.rings = k_limb_rings;
    way.limb = n;
    return walk(way, chance);
}

Stem grow_branch(const TreeSettings& s, const Stem& limb, int n, int count, float turn, Chance& chance) {
    const bool last = n + 1 == count;                                    // goes on where the limb ends
    const float bare = s.leaf_form == LeafForm::needles ? 0.06f : 0.22f; // needles bear shade: they stay near the trunk
    const float t =
        last ? 0.97f
             : bare + (0.97f - bare) * (static_cast<float>(n) + chance.share()) / static_cast<float>(std::max(count - 1, 1));
    const glm::vec3 along = glm::normalize(point_on(limb, std::min(t + 0.08f, 1.0f)) - point_on(limb, t - 0.08f));
    const glm::vec3 chord = limb.points.back() - limb.points.front();
    const float limb_length = glm::length(chord);
    const float angle = glm::radians(last ? 12.0f : s.branch_deg + chance.around(14.0f));
    glm::vec3 side = beside(along, turn);
    side.y *= 0.6f; // sprays lie flat rather than all around
    Way way;
    way.from = point_on(limb, t);
    way.direction = glm::normalize(std::cos(angle) * along + std::sin(angle) * side + glm::vec3(0.0f, 1e-4f, 0.0f));
    way.length = limb_length * s.branch_fraction * (last ? 0.55f : 1.0f - 0.55f * t) * chance.between(0.8f, 1.2f);
    const float by_length = limb.radii.front() * std::pow(way.length / std::max(limb_length, 1e-3f), k_radius_power);
    way.radius = std::clamp(by_length, 0.003f, 0.8f * radius_on(limb, t) + 0.003f);
    way.tip = 0.3f;
    way.rise = s.branch_rise;
    way.wander = s.wander;
    way.rings = k_branch_rings;
    way.limb = limb.limb;
    return walk(way, chance);
}

Cluster grow_cluster(const TreeSettings& s, const Stem& branch, int n, Chance& chance) {
    const float t =
        s.clusters == 1 ? 1.0f : 0.25f + 0.75f * (static_cast<float>(n) + 0.7f * chance.share()) / static_cast<float>(s.clusters);
    const glm::vec3 along = glm::normalize(branch.points.back() - branch.points.front());
    const float angle = n + 1 == s.clusters ? 0.15f : chance.between(0.5f, 1.1f);
    const glm::vec3 side = beside(along, k_branch_turn * static_cast<float>(n) + chance.around(0.6f));
    const glm::vec3 axis =
        std::cos(angle) * along + std::sin(angle) * side + s.leaf_droop * glm::vec3(0.0f, -1.0f, 0.0f) + chance.vector(0.1f);
    return {.root = point_on(branch, t),
            .axis = glm::normalize(axis + 1e-3f * along),
            .length = s.cluster_length * chance.between(0.75f, 1.25f),
            .limb = branch.limb};
}

} // namespace

float form_length(CrownForm form, float r) {
    const float pi = glm::pi<float>();
    switch (form) {
    case CrownForm::cone:
        return 0.15f + 0.85f * r;
    case CrownForm::round:
        return 0.25f + 0.75f * std::sin(pi * std::clamp(r, 0.0f, 1.0f));
    case CrownForm::dome:
        return 0.45f + 0.55f * std::sin(0.5f * pi * std::clamp(r, 0.0f, 1.0f));
    case CrownForm::column:
        return 1.0f;
    case CrownForm::flame:
        return 0.2f + 0.8f * (r < 0.7f ? r / 0.7f : (1.15f - r) / 0.45f);
    }
    return 1.0f;
}

glm::vec3 point_on(const Stem& stem, float t) {
    const float at = std::clamp(t, 0.0f, 1.0f) * static_cast<float>(stem.points.size() - 1);
    const auto n = std::min(static_cast<std::size_t>(at), stem.points.size() - 2);
    return stem.points[n] + (at - static_cast<float>(n)) * (stem.points[n + 1] - stem.points[n]);
}

float radius_on(const Stem& stem, float t) {
    const float at = std::clamp(t, 0.0f, 1.0f) * static_cast<float>(stem.radii.size() - 1);
    const auto n = std::min(static_cast<std::size_t>(at), stem.radii.size() - 2);
    return stem.radii[n] + (at - static_cast<float>(n)) * (stem.radii[n + 1] - stem.radii[n]);
}

int branches_of(const TreeSettings& s, int limb) {
    const Row row = row_of(s, limb);
    const float from_top = 1.0f - (static_cast<float>(row.row) + 0.5f) / static_cast<float>(row.rows);
    return 1 + static_cast<int>(std::lround(static_cast<float>(s.branches) * std::min(form_length(s.form, from_top), 1.0f)));
}

Shape grow(const TreeSettings& s) {
    Shape shape;
    shape.trunk = grow_trunk(s);
    Chance chance(s.seed, 2);
    for (int limb = 0; limb < s.limbs; ++limb) {
        shape.limbs.push_back(grow_limb(s, shape.trunk, limb, chance));
        const float first_turn = chance.between(0.0f, glm::two_pi<float>());
        const int count = branches_of(s, limb);
        for (int n = 0; n < count; ++n) {
            const Stem branch =
                grow_branch(s, shape.limbs.back(), n, count, first_turn + k_branch_turn * static_cast<float>(n), chance);
            for (int cluster = 0; cluster < s.clusters; ++cluster)
                shape.clusters.push_back(grow_cluster(s, branch, cluster, chance));
            shape.branches.push_back(branch);
        }
    }
    return shape;
}

} // namespace windrow::vegetation::trees::shape
