// Obstacles as they are drawn are where the air has them; streaks are the ways that the air goes.
#include "fluid/shapes/triangle_mesh.h"
#include "fluid/shapes/voxel_grid.h"
#include "vegetation/render/obstacle_solid.h"
#include "vegetation/render/wind_streaks.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace windrow::vegetation::render {
namespace {

float area_of(const Solid& solid) {
    float area = 0.0f;
    for (std::size_t n = 0; n < solid.size(); n += 3) {
        const glm::vec3 a(solid[n].position), b(solid[n + 1].position), c(solid[n + 2].position);
        area += 0.5f * glm::length(glm::cross(b - a, c - a));
    }
    return area;
}

TEST(ObstacleSolid, IsTheSurfaceOfItsShape) {
    constexpr float k_pi = 3.14159265f;
    const auto wedge = TriangleMesh::create(
        {.vertices = {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 1}}, .triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}});
    const auto bricks = VoxelGrid::create({.cells = {3, 1, 2}, .closed = {1, 1, 0, 0, 1, 1}});
    ASSERT_TRUE(wedge && bricks);
    const std::pair<Shape, float> shapes[] = {
        {MeshShape{*wedge, 2.0f}, 4.0f * (3.0f + 1.0f + 1.5f + 3.5f)},
        {VoxelShape{*bricks, 0.5f}, 0.25f * (4.0f + 4.0f + 10.0f)},
        {Sphere{1.5f}, 4.0f * k_pi * 2.25f},
        {Capsule{.half_axis = {1.0f, 2.0f, -2.0f}, .radius = 0.5f}, 4.0f * k_pi * 0.25f + 2.0f * k_pi * 0.5f * 6.0f},
        {Capsule{.half_axis = {0.0f, 0.0f, 0.0f}, .radius = 0.5f}, 4.0f * k_pi * 0.25f},
        {Block{{1.0f, 2.0f, 3.0f}}, 8.0f * (2.0f + 6.0f + 3.0f)},
        {Cylinder{.radius = 0.7f, .half_length = 3.0f}, 2.0f * k_pi * 0.7f * (0.7f + 6.0f)},
        {Plate{{2.0f, 1.0f}}, 2.0f * 8.0f},
    };
    for (const auto& [shape, area] : shapes) {
        SCOPED_TRACE(shape.index());
        const bool plate = std::holds_alternative<Plate>(shape);
        const Solid solid = obstacle_solid(shape, {});
        ASSERT_FALSE(solid.empty());
        EXPECT_NEAR(area_of(solid), area, 0.02f * area + (plate ? 0.3f : 0.0f));
        for (const SolidVertex& vertex : solid) {
            const glm::vec3 at(vertex.position), normal(vertex.normal);
            EXPECT_NEAR(detail::distance_to(shape, at), 0.0f, plate ? 0.03f : 1e-4f);
            EXPECT_NEAR(glm::length(normal), 1.0f, 1e-4f);
        }
        for (std::size_t n = 0; n < solid.size(); n += 3) {
            const glm::vec3 middle(solid[n].position + solid[n + 1].position + solid[n + 2].position);
            EXPECT_GT(detail::distance_to(shape, middle / 3.0f + 0.1f * glm::vec3(solid[n].normal)), 0.07f) << "outward";
        }
    }
}

TEST(ObstacleSolid, WindowsAreOnTheWalls) {
    const Block house{{4.0f, 2.7f, 3.0f}};
    const ObstacleLook look{.ends = glm::vec3(0.9f, 0.1f, 0.1f), .windows = WallWindows{.door = true}};
    const Solid solid = obstacle_solid(house, look);
    const std::size_t plain = obstacle_solid(house, {}).size();
    ASSERT_GT(solid.size(), plain);
    int panes = 0;
    for (std::size_t n = plain; n < solid.size(); ++n) {
        const glm::vec3 at(solid[n].position);
        EXPECT_LT(detail::distance_to(house, at), 0.06f);
        EXPECT_GT(detail::distance_to(house, at), -1e-4f);
        EXPECT_GE(at.y, -2.7f - 1e-4f) << "not below the foot";
        panes += glm::vec3(solid[n].colour) == look.windows->glass ? 1 : 0;
    }
    // Two storeys; three columns along x, two along z; the door takes the middle column of the ground floor before it.
    EXPECT_EQ(panes, 36 * (2 * (2 * 3 + 2 * 2) - 1 + 1));
    for (std::size_t n = 0; n < plain; ++n)
        EXPECT_EQ(glm::vec3(solid[n].colour) == *look.ends, solid[n].normal.x != 0.0f);
}

// At any frame rate: streaks of so many frames, not of `seconds`, are .87 of their length at 30 Hz and .18 at 144 Hz.
TEST(WindStreaks, AreTheWaysOfTheAir) {
    const WindStreakSettings settings{.count = 500, .seconds = 1.3f, .life = 4.0f, .lowest = 0.5f, .highest = 6.0f};
    const StreakBox box{{1e5, 2.0, -50.0}, {40.0, 10.0, 30.0}};
    const auto wind = [&](std::span<const glm::dvec3> places, std::span<glm::vec3> velocities) {
        for (std::size_t n = 0; n < places.size(); ++n) // calm beyond the middle
            velocities[n] = places[n].x < 1e5 + 20.0 ? glm::vec3(3.0f, 0.0f, 1.0f) : glm::vec3(0.0f);
    };
    // A wall across the wind, thinner than a step.
    const auto blocked = [](const glm::dvec3& from, const glm::dvec3& to) {
        return (from.x - 1e5 - 10.0) * (to.x - 1e5 - 10.0) <= 0.0;
    };
    for (const double rate : {2.0, 10.0, 24.0, 60.0, 144.0}) {
        StreakWays ways(settings, box);
        for (int frame = 0; frame < static_cast<int>(6.0 * rate); ++frame)
            ways.advance(1.0 / rate, wind, blocked);
        int whole = 0, calm = 0;
        for (const StreakWays::Way& way : ways.ways()) {
            const glm::dvec3 head = way.points[0];
            const StreakWays::Point tail = ways.point(way, way.used - 1);
            const glm::dvec3 share = (head - box.low) / box.extent;
            EXPECT_TRUE(share.x >= 0.0 && share.y >= 0.0 && share.z >= 0.0 && share.x <= 1.0 && share.y <= 1.0 && share.z <= 1.0);
            EXPECT_GT((head.x - 1e5 - 10.0) * (tail.place.x - 1e5 - 10.0), 0.0) << "through the wall";
            EXPECT_TRUE(ways.strength(way) >= 0.0f && ways.strength(way) <= 1.0f);
            for (int n = 0; n < way.used; ++n) { // widths end where the way does
                const StreakWays::Point point = ways.point(way, n);
                EXPECT_TRUE(point.share >= 0.0 && (n == 0 ? point.share == 1.0 : point.share <= ways.point(way, n - 1).share))
                    << n;
            }
            if (way.used < StreakWays::k_points)
                continue;
            EXPECT_EQ(tail.share, 0.0);
            if (head.x < 1e5 + 20.0) {
                ++whole;
                EXPECT_NEAR(glm::distance(head, tail.place), std::sqrt(10.0) * 1.3, 1e-6) << rate;
            } else if (tail.place.x > 1e5 + 20.3) { // beyond the step that led there
                ++calm;
                EXPECT_NEAR(glm::distance(head, tail.place), 0.0, 1e-9);
            }
        }
        EXPECT_GT(whole, 20) << rate;
        EXPECT_GT(calm, 50) << rate;
    }
}

// A box that follows somebody at 60 m/s has its streaks about him, not where it began.
TEST(WindStreaks, GoWithTheBox) {
    StreakWays ways({.count = 200, .lowest = 0.5f, .highest = 6.0f}, {{}, {40.0, 10.0, 30.0}});
    const auto calm = [](std::span<const glm::dvec3>, std::span<glm::vec3> velocities) {
        std::fill(velocities.begin(), velocities.end(), glm::vec3(0.0f));
    };
    for (int frame = 1; frame <= 60; ++frame) {
        ways.follow({2.0 * frame, 0.0, 0.0});
        ways.advance(1.0 / 30.0, calm, [](const glm::dvec3&, const glm::dvec3&) { return false; });
    }
    for (const StreakWays::Way& way : ways.ways())
        EXPECT_TRUE(way.points[0].x >= 120.0 && way.points[0].x <= 160.0) << way.points[0].x;
}

// A solid's normal that looks away from the eye is turned round: a streak above the eye would have the colour of the ground.
TEST(WindStreaks, AreLitFromAboveAboveTheEyeToo) {
    for (int deg = -89; deg <= 60; ++deg) { // of a streak above the horizon
        const float angle = static_cast<float>(deg) * 0.0174533f;
        const glm::vec3 to_eye(std::cos(angle), -std::sin(angle), 0.0f), normal = upright_normal(to_eye);
        EXPECT_NEAR(glm::length(normal), 1.0f, 1e-6f);
        EXPECT_GT(glm::dot(normal, to_eye), 0.02f) << deg;
        EXPECT_GT(normal.y, 0.3f) << deg;
        if (deg < -6) {
            EXPECT_NEAR(normal.y, 1.0f, 1e-6f) << deg;
        }
    }
}

TEST(WindStreaks, FaultsAreNamed) {
    const auto judged = validate(WindStreakSettings{.count = 0, .lowest = 3.0f, .highest = 2.0f});
    ASSERT_FALSE(judged);
    EXPECT_EQ(judged.error(), "streaks.count is 0: give 1 to 100000.\n"
                              "streaks.highest is 2 m, below streaks.lowest, 3 m: give at least that.");
}

} // namespace
} // namespace windrow::vegetation::render
