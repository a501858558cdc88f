// Closed meshes: distances and winding numbers against shapes with known ones, and what is rejected.
#include "tests/shapes.h"
#include "tests/winds.h"

#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

namespace windrow::test {
namespace {

glm::vec3 turned(glm::vec3 v) {
    return glm::angleAxis(0.7f, glm::normalize(glm::vec3(0.3f, 1.0f, -0.5f))) * v;
}

TEST(Mesh, OfABoxHasTheBoxesDistances) {
    const Block block{{1.0f, 0.4f, 2.0f}};
    const MeshShape mesh{mesh_of(box_mesh(block.half_size))};
    Random random(3);
    for (int n = 0; n < 20'000; ++n) {
        const glm::vec3 p = random.vector(n % 2 == 0 ? 2.5f : 1.0f);
        const float expected = detail::distance_to(block, p);
        ASSERT_NEAR(detail::distance_to(mesh, p), expected, 1e-5f) << p.x << ' ' << p.y << ' ' << p.z;
        const float bounded = detail::distance_to(mesh, p, 0.25f);
        ASSERT_NEAR(std::clamp(bounded, -0.25f, 0.25f), std::clamp(expected, -0.25f, 0.25f), 1e-5f);
    }
    EXPECT_EQ(detail::half_extent(mesh), block.half_size);
    EXPECT_NEAR(detail::thickness(mesh), 0.8f, 1e-5f);
}

TEST(Mesh, OfABallHasTheBallsDistances) {
    const float radius = 1.5f;
    const auto mesh = mesh_of(ball_mesh(radius, 5)); // 20,480 triangles; its faces are within 3e-4 of the radius
    Random random(4);
    float farthest = 0.0f;
    for (int n = 0; n < 5'000; ++n) {
        const glm::vec3 p = random.vector(2.5f);
        farthest = std::max(farthest, std::abs(mesh->distance_to(p) - (glm::length(p) - radius)));
    }
    EXPECT_LT(farthest, 5e-4f * radius);
    // To the corners themselves the distance is the sphere's from outside.
    for (const glm::vec3& corner : mesh->data().vertices)
        ASSERT_NEAR(mesh->distance_to(1.7f * corner), 0.7f * radius, 1e-5f);
    EXPECT_NEAR(mesh->thickness(), 2.0f * radius, 0.02f);
}

TEST(Mesh, SizeAndTurnGoWithTheDistance) {
    const auto straight = mesh_of(torus_mesh(2.0f, 0.5f, 48, 24));
    const auto aslant = mesh_of(placed(torus_mesh(2.0f, 0.5f, 48, 24), turned));
    const MeshShape larger{straight, 3.0f};
    Random random(5);
    for (int n = 0; n < 5'000; ++n) {
        const glm::vec3 p = random.vector(3.0f);
        const float distance = straight->distance_to(p);
        ASSERT_NEAR(aslant->distance_to(turned(p)), distance, 1e-5f);
        ASSERT_NEAR(detail::distance_to(larger, 3.0f * p), 3.0f * distance, 3e-5f);
        // Of 48 and 24 corners: within 2.5 % of the tube of the smooth one.
        const float smooth = glm::length(glm::vec2(glm::length(glm::vec2(p.x, p.z)) - 2.0f, p.y)) - 0.5f;
        ASSERT_NEAR(distance, smooth, 0.013f);
    }
}

// The sum of all solid angles, without the tree.
double exact_winding(const MeshData& data, glm::vec3 p) {
    double sum = 0.0;
    for (const glm::uvec3 t : data.triangles) {
        const glm::dvec3 a(data.vertices[t.x] - p), b(data.vertices[t.y] - p), c(data.vertices[t.z] - p);
        const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
        sum += std::atan2(glm::dot(a, glm::cross(b, c)),
                          la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
    }
    return sum / (2.0 * std::numbers::pi);
}

TEST(Mesh, WindingNumbersAreWhole) {
    const MeshData ball = ball_mesh(1.0f, 4), torus = torus_mesh(1.0f, 0.3f, 96, 48);
    const std::pair<const char*, MeshData> meshes[] = {
        {"ball", ball},
        {"torus", torus},
        {"ball within a ball", both(ball, placed(ball, [](glm::vec3 v) { return 0.6f * v; }))},
        {"balls that overlap", both(ball, placed(ball, [](glm::vec3 v) { return v + glm::vec3(0.7f, 0.2f, 0.0f); }))},
        {"a hollow", both(ball, inside_out(placed(ball, [](glm::vec3 v) { return 0.6f * v; })))},
        {"inside out", inside_out(torus)},
    };
    for (const auto& [name, data] : meshes) {
        const auto mesh = mesh_of(data);
        Random random(6);
        double off = 0.0;
        for (int n = 0; n < 200; ++n) {
            const glm::vec3 p = random.vector(1.3f);
            const double exact = exact_winding(mesh->data(), p);
            ASSERT_NEAR(exact, std::round(exact), 1e-3) << name;
            off = std::max(off, std::abs(mesh->winding_number(p) - exact));
            const float distance = mesh->distance_to(p);
            ASSERT_EQ(distance < 0.0f, std::round(exact) != 0.0) << name << ' ' << distance;
        }
        EXPECT_LT(off, 0.1) << name;
        RecordProperty(name, std::to_string(off));
    }
}

TEST(Mesh, NestedPartsAreSolidWhereTheyFaceAlikeAndHollowWhereNot) {
    const MeshData ball = ball_mesh(1.0f, 3), core = placed(ball, [](glm::vec3 v) { return 0.5f * v; });
    EXPECT_LT(mesh_of(both(ball, core))->distance_to({0.0f, 0.1f, 0.0f}), -0.3f);
    const auto hollow = mesh_of(both(ball, inside_out(core)));
    EXPECT_GT(hollow->distance_to({0.0f, 0.1f, 0.0f}), 0.3f);
    EXPECT_LT(hollow->distance_to({0.75f, 0.0f, 0.0f}), -0.2f);
    EXPECT_NEAR(hollow->thickness(), 0.5f, 0.02f);
    const auto wrong = mesh_of(inside_out(both(ball, inside_out(core))));
    EXPECT_LT(wrong->distance_to({0.75f, 0.0f, 0.0f}), -0.2f) << "all triangles face inward: the same body";
    EXPECT_NEAR(wrong->thickness(), 0.5f, 0.02f);
}

TEST(Mesh, PartsMayTouch) {
    const MeshData left = box_mesh(glm::vec3(1.0f), {-1.0f, 0.0f, 0.0f}), right = box_mesh(glm::vec3(1.0f), {1.0f, 0.0f, 0.0f});
    const auto mesh = mesh_of(both(left, right));
    EXPECT_EQ(mesh->data().vertices.size(), 12u) << "four are shared";
    EXPECT_NEAR(mesh->winding_number({0.5f, 0.0f, 0.0f}), 1.0, 1e-6);
    EXPECT_LT(mesh->distance_to({0.5f, 0.0f, 0.0f}), 0.0f);
    EXPECT_GT(mesh->distance_to({2.5f, 0.0f, 0.0f}), 0.0f);
}

TEST(Mesh, ADoubledFaceCountsOnce) {
    MeshData data = box_mesh(glm::vec3(1.0f));
    data.triangles.push_back({6, 0, 4}); // the first, from another corner on
    const auto mesh = mesh_of(data);
    EXPECT_EQ(mesh->data().triangles.size(), 12u);
    EXPECT_NEAR(mesh->winding_number({0.2f, 0.1f, 0.3f}), 1.0, 1e-6);
    EXPECT_NEAR(mesh->winding_number({-1.2f, 0.1f, 0.3f}), 0.0, 1e-6);
}

TEST(Mesh, ASheetOfTwoSidesIsClosedAndHasNoInside) {
    const auto sheet = mesh_of({.vertices = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}},
                                .triangles = {{0, 1, 2}, {0, 2, 3}, {0, 2, 1}, {0, 3, 2}}});
    EXPECT_EQ(sheet->thickness(), 0.0f);
    EXPECT_NEAR(sheet->distance_to({0.2f, 0.3f, 0.4f}), 0.4f, 1e-6f);
    EXPECT_TRUE(sheet->crosses({0.2f, 0.3f, 0.4f}, {0.2f, 0.3f, -0.1f}));
    EXPECT_TRUE(sheet->crosses({0.0f, 0.0f, 0.4f}, {0.0f, 0.0f, -0.1f})) << "through the diagonal";
    EXPECT_FALSE(sheet->crosses({0.2f, 0.3f, 0.4f}, {0.2f, 0.3f, 0.1f}));
    EXPECT_FALSE(sheet->crosses({1.2f, 0.3f, 0.4f}, {1.2f, 0.3f, -0.1f}));
    EXPECT_FALSE(sheet->crosses({-2.0f, 0.1f, 0.0f}, {2.0f, 0.1f, 0.0f})) << "within its plane";
}

// Through corners and along edges too: no segment from inside reaches outside without a crossing.
TEST(Mesh, NoSegmentLeavesItWithoutACrossing) {
    const auto mesh = mesh_of(ball_mesh(1.0f, 2));
    Random random(7);
    for (const glm::vec3& corner : mesh->data().vertices)
        ASSERT_TRUE(mesh->crosses(glm::vec3(0.0f), 2.0f * corner));
    for (const glm::uvec3& t : mesh->data().triangles)
        for (int n = 0; n < 3; ++n) {
            const float along = random.uniform(0.0f, 1.0f);
            const glm::vec3 on = glm::mix(mesh->data().vertices[t[n]], mesh->data().vertices[t[(n + 1) % 3]], along);
            ASSERT_TRUE(mesh->crosses(0.1f * random.vector(1.0f), 2.0f * on));
        }
    for (int n = 0; n < 20'000; ++n) {
        const glm::vec3 from = random.vector(0.5f), to = glm::vec3(random.direction()) * random.uniform(1.01f, 3.0f);
        ASSERT_TRUE(mesh->crosses(from, to));
        const glm::vec3 out = random.vector(3.0f), near = out + random.vector(0.1f);
        if (mesh->distance_to(out) > glm::distance(out, near)) {
            ASSERT_FALSE(mesh->crosses(out, near));
        }
    }
}

TEST(Mesh, ThicknessIsThatOfTheThinnestPart) {
    EXPECT_NEAR(mesh_of(room_mesh({4.0f, 2.5f, 3.0f}, 0.2f))->thickness(), 0.2f, 1e-5f);
    // A large block with a fin of .3.
    const MeshData body = box_mesh(glm::vec3(2.0f)), fin = box_mesh({1.0f, 1.0f, 0.15f}, {2.5f, 0.0f, 0.0f});
    EXPECT_NEAR(mesh_of(both(body, fin))->thickness(), 0.3f, 1e-5f);
    EXPECT_NEAR(mesh_of(placed(both(body, fin), turned))->thickness(), 0.3f, 1e-4f);
    EXPECT_NEAR(mesh_of(torus_mesh(2.0f, 0.5f, 48, 24))->thickness(), 1.0f, 0.03f);
}

TEST(Mesh, WhatIsNoClosedMeshIsRejected) {
    const MeshData box = box_mesh(glm::vec3(1.0f));
    const auto with = [&](const std::function<void(MeshData&)>& change) {
        MeshData data = box;
        change(data);
        return data;
    };
    const std::pair<MeshData, std::string> bad[] = {
        {{}, "the mesh has no triangles: give the triangles of a closed surface."},
        {with([](MeshData& m) { m.triangles.pop_back(); }), "the mesh is open at 3 edges, the first from (-1, -1, 1) to (-1, 1, "
                                                            "1): close it, or build it of plates, which have no inside."},
        {with([](MeshData& m) { m.triangles.resize(10); }),
         "the mesh is open at 4 edges, the first from (-1, -1, 1) to (-1, 1, 1)"},
        {with([](MeshData& m) { std::swap(m.triangles[0].x, m.triangles[0].y); }),
         "the mesh has 3 edges whose triangles face opposite ways, the first from (-1, -1, -1) to (-1, -1, 1): turn triangles "
         "around "
         "until all face outward."},
        {with([](MeshData& m) { m.triangles[7].y = 8; }),
         "triangle 7 of the mesh has the vertex 8 of 8: give indices from 0 to 7."},
        {with([](MeshData& m) { m.vertices[2].y = k_nan; }),
         "vertex 2 of the mesh is at (-1, nan, -1) m: give each component -1e5 to"},
        {with([](MeshData& m) { m.vertices[5].z = k_infinity; }),
         "vertex 5 of the mesh is at (1, -1, inf) m: give each component"},
        {with([](MeshData& m) { m.vertices[5].z = 2e5f; }), "and move a mesh that is farther out to its origin."},
        {with([](MeshData& m) {
             for (glm::uvec3& t : m.triangles)
                 t.z = t.x;
         }),
         "each triangle of the mesh has a corner twice: give triangles with three corners."},
        {placed(box, [](glm::vec3 v) { return 1e-8f * v; }), "m large: give 1e-6 m at least along one axis."},
        {{.vertices = box.vertices, .triangles = std::vector<glm::uvec3>(1'000'001, box.triangles[0])},
         "the mesh has 1000001 triangles and 8 vertices: give at most 1000000 and 3000000, which is finer than any box of "
         "cells."},
    };
    for (const auto& [data, reason] : bad) {
        const auto made = TriangleMesh::create(data);
        ASSERT_FALSE(made) << reason;
        EXPECT_NE(made.error().find(reason), std::string::npos) << made.error();
    }
    MeshData slivers = box; // a triangle without area that fills a gap between two edges is part of the surface
    slivers.vertices.emplace_back(0.0f, 0.0f, 1.0f);
    slivers.triangles[11] = {4, 7, 8};
    slivers.triangles.push_back({8, 7, 6});
    slivers.triangles.push_back({4, 8, 6});
    EXPECT_TRUE(TriangleMesh::create(slivers));
}

TEST(Mesh, IsWhatItIsMadeOf) {
    const MeshData data = ball_mesh(1.0f, 2);
    const auto one = mesh_of(data), again = mesh_of(data), back = mesh_of(one->data());
    EXPECT_TRUE(*one == *again);
    EXPECT_EQ(back->data(), one->data());
    MeshData other = data;
    other.vertices[3].x += 1e-6f;
    const auto changed = mesh_of(other);
    EXPECT_FALSE(*one == *changed);
    EXPECT_EQ(*one<*changed, *changed> * one);
    EXPECT_TRUE(detail::same(MeshShape{one}, MeshShape{again}));
    EXPECT_FALSE(detail::same(MeshShape{one}, MeshShape{one, 2.0f}));
    EXPECT_FALSE(detail::same(MeshShape{one}, MeshShape{changed}));
}

} // namespace
} // namespace windrow::test
