// Bones: weights, rigid poses, rest; the walk; what is rejected.
#include "tests/figure.h"
#include "vegetation/files/mesh_file.h"
#include "vegetation/fur/beast.h"
#include "vegetation/fur/horse_skeleton.h"
#include "vegetation/fur/shapes.h"
#include "vegetation/fur/skeleton.h"
#include "vegetation/tests/fur/folder.h"
#include "vegetation/tests/fur/surface.h"

#include <cmath>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>
#include <limits>
#include <tuple>

namespace windrow::vegetation::fur {
namespace {

using windrow::test::figure;

std::string name_of(int number, const char* what) {
    return "shells/beast/" + std::to_string(number) + "/" + what;
}

TEST(Beast, IsClosedAtEveryDetail) {
    for (const int detail : {20, 23, 27, 34, 40}) {
        const auto beast = beast_mesh({.detail = detail});
        ASSERT_TRUE(beast) << beast.error();
        EXPECT_TRUE(validate(*beast));
        const auto surface = test::surface_of(*beast);
        EXPECT_EQ(surface.open, 0u) << detail;
        EXPECT_EQ(surface.euler(), 2) << detail;
        EXPECT_EQ(surface.split, 0.0) << detail;
        figure(name_of(detail, "points"), static_cast<double>(surface.points));
        figure(name_of(detail, "vertices"), static_cast<double>(beast->vertices.size()));
        WINDROW_EXPECT_FIGURE(name_of(detail, "behind"), surface.behind, 2e-3); // the tips of ears and toes: a few corners
        EXPECT_GT(surface.volume, 0.0);
        EXPECT_EQ(beast->low.y, 0.0f);
    }
    // Styles 2024: the rigged horse of the thesis has 3,269 vertices.
    WINDROW_EXPECT_FIGURE("shells/beast/vertices_from_3269",
                          std::abs(static_cast<double>(beast_mesh()->vertices.size()) / 3269.0 - 1.0), 0.05);
    const auto small = beast_mesh({.height = 0.8f}), large = beast_mesh({.height = 8.0f});
    EXPECT_NEAR(large->high.y / small->high.y, 10.0f, 1e-4f);
    EXPECT_FALSE(beast_mesh({.height = 0.0f}));
    EXPECT_FALSE(beast_mesh({.detail = 1000}));
}

TEST(Skeletons, WeightsSumToOneAndRestIsExact) {
    auto beast = beast_mesh();
    auto bones = beast_skeleton();
    ASSERT_TRUE(bones) << bones.error();
    ASSERT_TRUE(bind(*beast, *bones));
    EXPECT_TRUE(validate(*beast));
    double worst = 0.0;
    for (const MeshVertex& vertex : beast->vertices) {
        double sum = 0.0;
        for (int k = 0; k < 4; ++k) {
            EXPECT_GE(vertex.weights[k], 0.0f);
            EXPECT_LT(vertex.bones[k], bones->bones.size());
            sum += static_cast<double>(vertex.weights[k]);
        }
        worst = std::max(worst, std::abs(sum - 1.0));
    }
    WINDROW_EXPECT_FIGURE("shells/skeleton/weight_sum_error", worst, 0x1p-22);

    for (Bone& bone : bones->bones) {
        bone.swings.clear();
        bone.sway = glm::vec3(0.0f);
    }
    std::vector<glm::vec3> positions(beast->vertices.size()), normals(positions.size());
    const auto matrices = pose(*bones, 12.3);
    for (const glm::mat4& matrix : matrices)
        EXPECT_EQ(matrix, glm::mat4(1.0f));
    ASSERT_TRUE(skin(*beast, matrices, positions, normals));
    double moved = 0.0;
    for (std::size_t i = 0; i < positions.size(); ++i)
        moved = std::max(moved, static_cast<double>(glm::length(positions[i] - beast->vertices[i].position)));
    WINDROW_EXPECT_FIGURE("shells/skeleton/rest_error_m", moved, 1e-6 * 2.6); // of its size: the weights' own rounding
}

// A vertex between four bones has weights that change without a jump: half the step halves the greatest change.
TEST(Skeletons, WeightsAreContinuous) {
    const auto bones = beast_skeleton();
    const auto greatest_change = [&](int columns) {
        Mesh line = *sheet({.size = {3.0f, 0.001f}, .columns = columns, .rows = 1});
        for (MeshVertex& vertex : line.vertices) // along the body, through hip, loin and shoulder
            vertex.position = {0.25f, 1.4f + 0.2f * std::sin(3.0f * vertex.position.x), vertex.position.x};
        measure(line);
        EXPECT_TRUE(bind(line, *bones));
        double greatest = 0.0;
        for (int i = 0; i < columns; ++i) {
            double change = 0.0;
            for (std::uint32_t bone = 0; bone < bones->bones.size(); ++bone) {
                const auto weight = [&](int at) {
                    double sum = 0.0;
                    const MeshVertex& vertex = line.vertices[static_cast<std::size_t>(at)];
                    for (int k = 0; k < 4; ++k)
                        sum += vertex.bones[k] == bone ? static_cast<double>(vertex.weights[k]) : 0.0;
                    return sum;
                };
                change += std::abs(weight(i + 1) - weight(i));
            }
            greatest = std::max(greatest, change);
        }
        return greatest;
    };
    WINDROW_EXPECT_FIGURE("shells/skeleton/weight_change_ratio", greatest_change(1000) / greatest_change(250),
                          0.3); // 1/4 and curvature
}

TEST(Skeletons, PosesAreRigidAndComeAgain) {
    const auto bones = beast_skeleton({}, 0.5f); // the head looks about at half of that
    double stretch = 0.0, late = 0.0, joint = 0.0;
    for (int i = 0; i < 50; ++i) {
        const double seconds = 0.137 * i;
        const auto matrices = pose(*bones, seconds), again = pose(*bones, seconds + 4.0 * 250'000.0);
        for (std::size_t b = 0; b < matrices.size(); ++b) {
            const glm::dmat3 turn(matrices[b]);
            const glm::dmat3 error = glm::transpose(turn) * turn - glm::dmat3(1.0);
            for (int c = 0; c < 3; ++c)
                stretch = std::max(stretch, glm::length(error[c]));
            stretch = std::max(stretch, std::abs(glm::determinant(turn) - 1.0));
            late = std::max(late, static_cast<double>(glm::length(glm::vec3((matrices[b] - again[b])[3]))));
            if (const int parent = bones->bones[b].parent; parent >= 0) { // a joint is one place
                const glm::vec4 head(bones->bones[b].head, 1.0f);
                joint = std::max(joint, static_cast<double>(glm::length(
                                            glm::vec3(matrices[b] * head - matrices[static_cast<std::size_t>(parent)] * head))));
            }
        }
    }
    WINDROW_EXPECT_FIGURE("shells/skeleton/stretch", stretch, 1e-6);
    WINDROW_EXPECT_FIGURE("shells/skeleton/drift_after_11_days_m", late, 1e-6);
    WINDROW_EXPECT_FIGURE("shells/skeleton/joint_gap_m", joint, 2e-6);
}

// The order of the feet: each reaches farthest forward, where it is set down, a quarter of a stride after the one before it.
TEST(Skeletons, TheBeastWalks) {
    const auto bones = beast_skeleton({}, 1.0f);
    const auto foremost_at = [&](const char* name) {
        for (std::size_t b = 0; b < bones->bones.size(); ++b) {
            if (bones->bones[b].name != name)
                continue;
            double best = -1e9, at = 0.0;
            for (int i = 0; i < 1000; ++i) {
                const glm::vec4 toes = pose(*bones, i / 1000.0)[b] * glm::vec4(bones->bones[b].tail, 1.0f);
                if (static_cast<double>(toes.z) > best)
                    std::tie(best, at) = std::pair(static_cast<double>(toes.z), i / 1000.0);
            }
            return at;
        }
        ADD_FAILURE() << name;
        return 0.0;
    };
    const auto after = [](double one, double other) { return other - one - std::floor(other - one); };
    const double left_hind = foremost_at("left hind foot"), left_fore = foremost_at("left forefoot");
    const double right_hind = foremost_at("right hind foot"), right_fore = foremost_at("right forefoot");
    // Hind and fore legs fold at other joints, so that they are at their foremost at somewhat other phases.
    WINDROW_EXPECT_FIGURE("shells/beast/hind_feet_apart_less_half", std::abs(after(left_hind, right_hind) - 0.5), 0.02);
    WINDROW_EXPECT_FIGURE("shells/beast/fore_feet_apart_less_half", std::abs(after(left_fore, right_fore) - 0.5), 0.02);
    WINDROW_EXPECT_FIGURE("shells/beast/fore_after_hind_less_quarter", std::abs(after(left_hind, left_fore) - 0.25), 0.1);
    EXPECT_GT(after(right_hind, right_fore), 0.0);
    // All feet stay near the ground: no leg is thrown up.
    for (const char* foot : {"left hind foot", "right forefoot"})
        for (std::size_t b = 0; b < bones->bones.size(); ++b)
            for (int i = 0; i < 100 && bones->bones[b].name == foot; ++i) {
                const float y = (pose(*bones, i / 100.0)[b] * glm::vec4(bones->bones[b].tail, 1.0f)).y;
                EXPECT_GT(y, -0.1f) << foot << i; // [m] of a beast of 2 m
                EXPECT_LT(y, 0.7f) << foot << i;
            }
}

TEST(Skeletons, TheHorseIsBoundWhole) {
    auto horse = read_mesh(test::made("horse.obj"), {.size = 2.4f});
    const auto bones = horse_skeleton(2.4f);
    ASSERT_TRUE(horse) << horse.error();
    ASSERT_TRUE(bones) << bones.error();
    ASSERT_TRUE(bind(*horse, *bones));
    // Bones lie within the flesh: the skin is nearer to each one's middle than the belly is thick.
    for (const Bone& bone : bones->bones) {
        const glm::vec3 middle = 0.5f * (bone.head + bone.tail);
        float nearest = 1e9f;
        for (const MeshVertex& vertex : horse->vertices)
            nearest = std::min(nearest, glm::length(vertex.position - middle));
        EXPECT_LT(nearest, 0.13f * 2.4f) << bone.name;
    }
    std::vector<glm::vec3> positions(horse->vertices.size()), normals(positions.size());
    const auto rest_feet = pose(*bones, 0.0), later = pose(*bones, 0.4);
    ASSERT_TRUE(skin(*horse, later, positions, normals));
    EXPECT_EQ(rest_feet[3], later[3]) << "the hooves stand";
    float moved = 0.0f;
    for (std::size_t i = 0; i < positions.size(); ++i)
        moved = std::max(moved, glm::length(positions[i] - horse->vertices[i].position));
    EXPECT_GT(moved, 0.05f);
}

TEST(Skeletons, WhatIsWrongIsRejected) {
    constexpr float k_nan = std::numeric_limits<float>::quiet_NaN();
    Mesh ball = *globe_sphere({});
    const auto rejected = [&](const char* field, auto&& spoil) {
        Skeleton bones = *beast_skeleton();
        spoil(bones.bones);
        const auto valid = validate(bones);
        ASSERT_FALSE(valid) << field;
        EXPECT_NE(valid.error().find(field), std::string::npos) << valid.error();
        EXPECT_NE(valid.error().find(": give "), std::string::npos) << valid.error();
        EXPECT_FALSE(bind(ball, bones));
    };
    rejected("bones has 0", [](auto& bones) { bones.clear(); });
    rejected("bones has 129", [](auto& bones) { bones.resize(129); });
    rejected("bones[0].parent is 0", [](auto& bones) { bones[0].parent = 0; });
    rejected("bones[2].parent is 3", [](auto& bones) { bones[2].parent = 3; });
    rejected("bones[1].parent is -2", [](auto& bones) { bones[1].parent = -2; });
    rejected("bones[1].head is (", [](auto& bones) { bones[1].head.y = k_nan; });
    rejected("bones[1].tail is (", [](auto& bones) { bones[1].tail.z = 1e9f; });
    rejected("bones[1].radius", [](auto& bones) { bones[1].radius = 0.0f; });
    rejected("bones[1].swings", [](auto& bones) { bones[1].swings.resize(5); });
    rejected("bones[1].swings[0].axis", [](auto& bones) { bones[1].swings[0].axis = glm::vec3(0.0f); });
    rejected("bones[1].swings[0].axis", [](auto& bones) { bones[1].swings[0].axis = glm::vec3(k_nan); });
    rejected("bones[1].swings[0].amplitude", [](auto& bones) { bones[1].swings[0].amplitude = 2.0f; });
    rejected("bones[1].swings[0].hz", [](auto& bones) { bones[1].swings[0].hz = -1.0f; });
    rejected("bones[0].sway is (nan, ", [](auto& bones) { bones[0].sway.x = k_nan; });
    EXPECT_FALSE(beast_skeleton({}, 6.0f));
    EXPECT_FALSE(horse_skeleton(0.0f));

    ASSERT_TRUE(bind(ball, *beast_skeleton()));
    std::vector<glm::vec3> positions(ball.vertices.size()), normals(positions.size() - 1);
    const auto matrices = pose(*beast_skeleton(), 0.0);
    EXPECT_FALSE(skin(ball, matrices, positions, normals));
    normals.resize(positions.size());
    EXPECT_TRUE(skin(ball, matrices, positions, normals));
    EXPECT_FALSE(skin(ball, std::span(matrices).first(1), positions, normals));
}

} // namespace
} // namespace windrow::vegetation::fur
