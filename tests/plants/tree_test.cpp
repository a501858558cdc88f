// Trees: C18, the one bend on trunk, branch and leaf.
#include "coupling/plant_numerics.h"
#include "coupling/tree.h"
#include "tests/fields.h"
#include "tests/figure.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <vector>

namespace windrow {
namespace {

using test::Random;

TreeBearers small_tree() {
    return {.trunk = {.axis = {0.0f, 1.0f, 0.0f}, .length = 8.0f},
            .branch = {.root = {0.0f, 5.0f, 0.0f}, .axis = glm::normalize(glm::vec3(1.0f, 0.4f, 0.2f)), .length = 2.5f},
            .leaf = {.root = glm::vec3(0.0f, 5.0f, 0.0f) + 2.0f * glm::normalize(glm::vec3(1.0f, 0.4f, 0.2f)),
                     .axis = {0.0f, 0.0f, 1.0f},
                     .length = 0.1f}};
}

Tree tree(const TreeSettings& settings = {}) {
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

TEST(Tree, InStillAirItIsTheMeshToTheBit) {
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
    double loose = 0.0, stretched = 0.0;
    const TreeBearers all = small_tree();
    const TreeBearers up_to_branch{.trunk = all.trunk, .branch = all.branch}, only_trunk{.trunk = all.trunk};
    for (int n = 0; n < 500; ++n) {
        const glm::vec3 wind = random.vector(30.0f);
        const auto leaf = [&](glm::vec3 p) { return glm::dvec3(oak.vertex(all, wind, {.position = p}).position); };
        const auto branch = [&](glm::vec3 p) { return glm::dvec3(oak.vertex(up_to_branch, wind, {.position = p}).position); };
        const auto trunk = [&](glm::vec3 p) { return glm::dvec3(oak.vertex(only_trunk, wind, {.position = p}).position); };
        loose = std::max(loose, glm::length(leaf(all.leaf.root) - branch(all.leaf.root)));
        loose = std::max(loose, glm::length(branch(all.branch.root) - trunk(all.branch.root)));
        const auto length = [](const auto& at, const TreePart& part) {
            double sum = 0.0;
            glm::dvec3 last = at(part.root);
            for (int k = 1; k <= 200; ++k) {
                const glm::dvec3 next = at(part.root + part.axis * (part.length * static_cast<float>(k) / 200.0f));
                sum += glm::length(next - last);
                last = next;
            }
            return sum / static_cast<double>(part.length);
        };
        stretched = std::max({stretched, std::abs(length(trunk, all.trunk) - 1.0), std::abs(length(branch, all.branch) - 1.0)});
    }
    WINDROW_EXPECT_FIGURE("plants/tree/parts_apart_m", loose, 1e-5);
    WINDROW_EXPECT_FIGURE("plants/tree/length_change", stretched, 0.01);
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
        const glm::vec3 trunk = oak.vertex({.trunk = {.axis = up, .length = 0.4f}}, wind, {.position = 0.4f * h * up}).position;
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
    std::vector<Tree::Bearers> bearers(k_count);
    for (std::size_t n = 0; n < k_count; ++n) {
        positions[n] = glm::vec4(random.vector(4.0f), 0.0f);
        normals[n] = glm::vec4(glm::vec3(random.direction()), 0.0f);
        bearers[n] = {
            .trunk = 0, .branch = n % 2 == 0 ? 1u : Tree::Bearers::k_none, .leaf = n % 4 == 0 ? 2u : Tree::Bearers::k_none};
    }
    ASSERT_TRUE(oak.vertices(parts, winds, {positions, normals, bearers}, out, turned));
    for (std::size_t n = 0; n < k_count; ++n) {
        const TreeBearers own{.trunk = all.trunk,
                              .branch = n % 2 == 0 ? all.branch : TreePart{.stiffness = 0.0f},
                              .leaf = n % 4 == 0 ? all.leaf : TreePart{.stiffness = 0.0f}};
        const PlantVertex one = oak.vertex(own, wind, {.position = glm::vec3(positions[n]), .normal = glm::vec3(normals[n])});
        ASSERT_EQ(glm::vec3(out[n]), one.position);
        ASSERT_EQ(glm::vec3(turned[n]), one.normal);
    }
    bearers[7].leaf = 3;
    EXPECT_FALSE(oak.vertices(parts, winds, {positions, normals, bearers}, out, turned));
}

} // namespace
} // namespace windrow
