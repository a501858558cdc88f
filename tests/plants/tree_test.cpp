// Trees: trunk, branch and leaf call the bend of blades and shells; the base of the trunk stays.
#include "coupling/plant_numerics.h"
#include "coupling/tree.h"
#include "tests/fields.h"
#include "tests/figure.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace windrow {
namespace {

using test::Random;

TreeBearers small_tree() {
    const glm::vec3 along = glm::normalize(glm::vec3(1.0f, 0.4f, 0.2f)), fork{0.0f, 5.0f, 0.0f};
    return {.trunk = {.length = 8.0f, .stiffness = 1.0f},
            .branch = {.root = fork, .axis = along, .length = 2.5f, .stiffness = 1.0f},
            .leaf = {.root = fork + 2.0f * along, .axis = {0.0f, 0.0f, 1.0f}, .length = 0.1f, .stiffness = 1.0f}};
}

glm::vec3 on(const TreePart& part, float h) {
    return part.root + part.axis * (part.length * h);
}

// Parts of any size that point anywhere, held on the axis of what bears them or beside it; every other trunk is soft enough for
// the winds of these tests to lay it down.
TreeBearers any_tree(Random& random) {
    const auto beside = [&](const TreePart& bearer, float way) {
        return on(bearer, random.uniform(0.05f, 1.0f)) + random.vector(way);
    };
    TreeBearers made;
    made.trunk = {.axis = glm::normalize(glm::vec3(0.0f, 1.0f, 0.0f) + random.vector(0.4f)),
                  .length = random.uniform(2.0f, 15.0f),
                  .stiffness = static_cast<float>(random.integer(0, 1) == 0 ? 1.0 : random.spread(1e-4, 1e-2))};
    made.branch = {.root = beside(made.trunk, 0.1f),
                   .axis = glm::vec3(random.direction()),
                   .length = random.uniform(0.5f, 4.0f),
                   .stiffness = static_cast<float>(random.spread(0.01, 10.0))};
    made.leaf = {.root = beside(made.branch, 0.02f),
                 .axis = glm::vec3(random.direction()),
                 .length = random.uniform(0.05f, 0.3f),
                 .stiffness = static_cast<float>(random.spread(0.1, 10.0))};
    return made;
}

Tree tree(const TreeClasses& settings = {}) {
    auto made = Tree::create(settings);
    EXPECT_TRUE(made) << made.error();
    return *made;
}

TEST(Tree, ItsBaseStays) {
    const Tree oak = tree();
    Random random(1);
    const TreeBearers only_trunk{.trunk = small_tree().trunk};
    for (int n = 0; n < 1000; ++n) {
        const glm::vec3 wind = random.vector(60.0f);
        const glm::vec3 bark{random.uniform(-0.1f, 0.1f), random.uniform(-0.5f, 0.0f), random.uniform(-0.1f, 0.1f)};
        ASSERT_EQ(oak.vertex(only_trunk, wind, {.position = glm::vec3(0.0f)}).position, glm::vec3(0.0f));
        const glm::vec3 root = oak.vertex(only_trunk, wind, {.position = bark}).position; // below the ground too
        ASSERT_LE(glm::length(root - bark), 1e-7f);
    }
}

TEST(Tree, InStillAirItIsTheMeshWithinRounding) {
    const Tree oak = tree();
    Random random(2);
    for (int n = 0; n < 1000; ++n) {
        const PlantVertex rest{.position = random.vector(3.0f), .normal = glm::vec3(random.direction())};
        const PlantVertex bent = oak.vertex(small_tree(), glm::vec3(0.0f), rest);
        ASSERT_LE(glm::length(bent.position - rest.position), 1e-6f); // sums of parts round
        ASSERT_LE(glm::length(bent.normal - rest.normal), 1e-6f);
        ASSERT_EQ(oak.vertex({}, glm::vec3(20.0f), rest).position, rest.position); // no bearer, no bend
    }
}

TEST(Tree, PartsStayAttachedAndKeepTheirLengths) {
    const Tree oak = tree();
    Random random(3);
    double loose = 0.0, stretched[3] = {0.0, 0.0, 0.0};
    for (int n = 0; n < 500; ++n) {
        const TreeBearers all = any_tree(random);
        const TreeBearers up_to_branch{.trunk = all.trunk, .branch = all.branch}, only_trunk{.trunk = all.trunk};
        const glm::vec3 wind = random.vector(30.0f);
        const auto at = [&](const TreeBearers& bearers, glm::vec3 p) {
            return glm::dvec3(oak.vertex(bearers, wind, {.position = p}).position);
        };
        loose = std::max(loose, glm::length(at(all, all.leaf.root) - at(up_to_branch, all.leaf.root)));
        loose = std::max(loose, glm::length(at(up_to_branch, all.branch.root) - at(only_trunk, all.branch.root)));
        const auto change = [&](const TreeBearers& bearers, const TreePart& part) {
            double sum = 0.0;
            glm::dvec3 last = at(bearers, part.root);
            for (int k = 1; k <= 400; ++k) {
                const glm::dvec3 next = at(bearers, on(part, static_cast<float>(k) / 400.0f));
                sum += glm::length(next - last);
                last = next;
            }
            return std::abs(sum / static_cast<double>(part.length) - 1.0);
        };
        stretched[0] = std::max(stretched[0], change(only_trunk, all.trunk));
        stretched[1] = std::max(stretched[1], change(up_to_branch, all.branch));
        stretched[2] = std::max(stretched[2], change(all, all.leaf));
    }
    WINDROW_EXPECT_FIGURE("plants/tree/parts_apart_m", loose, 1e-5);
    // What the stem itself leaves, 0.4 % (stem.glsl): the bearers add nothing.
    WINDROW_EXPECT_FIGURE("plants/tree/length_change_of_trunks", stretched[0], 0.004);
    WINDROW_EXPECT_FIGURE("plants/tree/length_change_of_branches", stretched[1], 0.004);
    WINDROW_EXPECT_FIGURE("plants/tree/length_change_of_leaves", stretched[2], 0.004);
}

// The mesh of a stiff part, its outer and its inner side, on bearers that bend far: only their own meshes may bend with them.
TEST(Tree, WhatBearersCarryKeepsItsForm) {
    const Tree oak = tree();
    Random random(5);
    double bough_most = 0.0, leaf_most = 0.0, turned = 0.0;
    for (int n = 0; n < 500; ++n) {
        TreeBearers all = any_tree(random);
        all.leaf.stiffness = 1e6f;
        TreeBearers bough{.trunk = all.trunk, .branch = all.branch};
        bough.branch.stiffness = 1e6f;
        const glm::vec3 wind = random.vector(30.0f);
        const auto change = [&](const TreeBearers& bearers, const TreePart& part) {
            const auto corner = [&] { return on(part, random.uniform(0.0f, 1.0f)) + random.vector(0.3f * part.length); };
            const PlantVertex a{.position = corner(), .normal = glm::vec3(random.direction())}, b{.position = corner()};
            const PlantVertex a_bent = oak.vertex(bearers, wind, a), b_bent = oak.vertex(bearers, wind, b);
            turned = std::max(turned, std::acos(std::clamp(static_cast<double>(glm::dot(a.normal, a_bent.normal)), -1.0, 1.0)));
            const double before = glm::length(glm::dvec3(a.position) - glm::dvec3(b.position));
            return std::abs(glm::length(glm::dvec3(a_bent.position) - glm::dvec3(b_bent.position)) - before) /
                   static_cast<double>(part.length);
        };
        TreeBearers scene_renderer{.trunk = all.trunk, .leaf = all.leaf}; // a leaf that grows from the trunk
        scene_renderer.leaf.root = all.branch.root;
        bough_most = std::max(bough_most, change(bough, bough.branch));
        leaf_most = std::max(leaf_most, change(scene_renderer, scene_renderer.leaf));
        leaf_most = std::max(leaf_most, change(all, all.leaf));
    }
    // A place 15 m up rounds by 1e-6 m, 2e-5 of the shortest leaf; parts 1e6 times as stiff as theirs bend by 1e-5 rad yet.
    WINDROW_EXPECT_FIGURE("plants/tree/change_of_distances_in_a_stiff_bough", bough_most, 1e-4);
    WINDROW_EXPECT_FIGURE("plants/tree/change_of_distances_in_a_stiff_leaf", leaf_most, 1e-4);
    EXPECT_GT(turned, 1.0); // the bearers did bend
}

// The lines at the head of coupling/tree.h.
TEST(Tree, TheHeadersExampleHasNoPartThatIsNotNamed) {
    auto oak = windrow::Tree::create({});
    windrow::TreePart trunk{.length = 8.0f, .stiffness = 1.0f};
    windrow::TreePart bough{.root = {0, 5, 0}, .axis = {1, 0, 0}, .length = 2.5f, .stiffness = 1.0f};
    ASSERT_TRUE(oak);
    Random random(6);
    double most = 0.0;
    for (int n = 0; n < 200; ++n) {
        const glm::vec3 wind = 8.0f * glm::vec3(random.direction());
        windrow::PlantVertex bark = oak->vertex({trunk, bough, {}}, wind, {.position = {2.4f, 5.1f, 0.0f}}); // {}: on no leaf
        most = std::max(most, std::acos(std::clamp(static_cast<double>(bark.normal.z), -1.0, 1.0)));
    }
    // A normal turns by no more than its trunk and its branch lean.
    WINDROW_EXPECT_FIGURE("plants/tree/turn_of_the_headers_example_rad", most,
                          bend_angle(oak->settings().trunk, 8.0f) + bend_angle(oak->settings().branch, 8.0f));
}

TEST(Tree, CallsTheBladesBend) {
    // A trunk with the drag of a blade is that blade's middle line: the one function.
    const Drag stalk{.length = 0.4f, .width = 0.004f, .rigidity = 1e-4f};
    const Tree oak = tree({.trunk = stalk});
    const numerics::WindrowDrag drag{block(stalk).load};
    const glm::vec3 up{0.0f, 1.0f, 0.0f}, wind{3.0f, 0.0f, 1.0f};
    const numerics::WindrowStem stem =
        numerics::windrow_stem(up, 0.4f, numerics::windrow_drag_bend(drag, up, wind, 1.0f), glm::vec3(0.0f), 0.0f, 1.57079633f);
    for (int n = 0; n <= 10; ++n) {
        const float h = static_cast<float>(n) / 10.0f;
        const glm::vec3 blade = 0.4f * h * up + numerics::windrow_stem_shift(stem, h);
        const glm::vec3 trunk =
            oak.vertex({.trunk = {.length = 0.4f, .stiffness = 1.0f}}, wind, {.position = 0.4f * h * up}).position;
        EXPECT_LE(glm::length(blade - trunk), 1e-7f);
    }
}

TEST(Tree, ManyVerticesAreTheSingleOnes) {
    const Tree oak = tree();
    const TreeBearers all = small_tree();
    const std::vector<TreePart> parts{all.trunk, all.branch, all.leaf};
    const glm::vec3 wind{9.0f, 0.5f, -3.0f};
    const std::vector<glm::vec4> winds(3, glm::vec4(wind, 0.0f));
    Random random(4);
    constexpr std::size_t k_count = 1000;
    std::vector<glm::vec4> positions(k_count), normals(k_count), out(k_count), turned(k_count);
    std::vector<Tree::PartIndices> bearers(k_count);
    for (std::size_t n = 0; n < k_count; ++n) {
        positions[n] = glm::vec4(random.vector(4.0f), 0.0f);
        normals[n] = glm::vec4(glm::vec3(random.direction()), 0.0f);
        bearers[n] = {.trunk = 0,
                      .branch = n % 2 == 0 ? 1u : Tree::PartIndices::k_none,
                      .leaf = n % 4 == 0 ? 2u : Tree::PartIndices::k_none};
    }
    ASSERT_TRUE(oak.vertices(parts, winds, {positions, normals, bearers}, out, turned));
    for (std::size_t n = 0; n < k_count; ++n) {
        const TreeBearers own{
            .trunk = all.trunk, .branch = n % 2 == 0 ? all.branch : TreePart{}, .leaf = n % 4 == 0 ? all.leaf : TreePart{}};
        const PlantVertex one = oak.vertex(own, wind, {.position = glm::vec3(positions[n]), .normal = glm::vec3(normals[n])});
        ASSERT_EQ(glm::vec3(out[n]), one.position);
        ASSERT_EQ(glm::vec3(turned[n]), one.normal);
    }
}

TEST(Tree, TellsWhichVertexAndWhichPartItRejects) {
    const Tree oak = tree();
    const TreeBearers all = small_tree();
    std::vector<TreePart> parts{all.trunk, all.branch, all.leaf, {}};
    const std::vector<glm::vec4> winds(4, glm::vec4(9.0f, 0.0f, 0.0f, 0.0f)), rest(10, glm::vec4(1.0f));
    const std::vector<glm::vec4> untouched(10, glm::vec4(7.0f));
    std::vector<Tree::PartIndices> bearers(10, {.trunk = 0, .branch = 3}); // 3: a part of stiffness 0 is none
    std::vector<glm::vec4> out = untouched, turned = untouched;
    ASSERT_TRUE(oak.vertices(parts, winds, {rest, rest, bearers}, out, turned));
    out = turned = untouched;
    bearers[7].leaf = 4;
    parts[1].length = -1.0f;
    const auto rejected = oak.vertices(parts, winds, {rest, rest, bearers}, out, turned);
    ASSERT_FALSE(rejected);
    for (const char* words : {"tree.vertices.mesh.bearers[7].leaf is 4", "below 4", "tree.vertices.parts[1].length is -1"})
        EXPECT_NE(rejected.error().find(words), std::string::npos) << rejected.error();
    EXPECT_EQ(out, untouched);
    EXPECT_EQ(turned, untouched);
}

} // namespace
} // namespace windrow
