// Queries against the same formulas one point at a time in GLM (cases/reference/plain_query.h).
//
// With u = 2^-24, M the largest component of a cell and A that of the ambient wind, both sides round as follows.
//   - A blend a + t (b - a) by 5 M u: the difference and the product, each up to 2 M, and the sum. The plain a (1 - t) + b t by 4 M
//     u. Three of each: 27 M u.
//   - The weight: by 4 u in each of up to six factors; where the point is about 1 u of the reach of a blend zone elsewhere, by 3 u
//     reach / width for each axis. Its error counts M + A times, the mix itself 9 (M + A) u.
//   - A place in cells, where the cell size is not a power of two or the plain formula wraps in float: by an ulp of the number of
//     cells, 2 n u, which moves the wind by 2 M for each cell, on three axes: 12 n M u.
//   - The profile: two logarithms by 4 u each and 3 u / log for their arguments, on each side: 40 A u at heights where the logarithm
//     is above 0.3, so that what is below counts absolutely.

#include "cases/reference/plain_query.h"
#include "tests/query_scenes.h"

#include <cstring>

namespace {

using namespace windrow;
using namespace windrow::test;

double largest_component(std::span<const glm::vec4> field) {
    float largest = 0.0f;
    for (const glm::vec4& cell : field)
        for (int axis = 0; axis < 3; ++axis)
            largest = std::max(largest, std::abs(cell[axis]));
    return largest;
}

double bound_of(const Wind& wind, double largest_ambient) {
    constexpr double u = 0x1p-24;
    const Config& config = wind.config();
    const BlendZone zone = wind.view().blend_zone();
    const double M = largest_component(wind.field()), A = largest_ambient;
    const double reach = std::max({zone.reach.x, zone.reach.y, zone.reach.z}), width = std::max(zone.width, 1e-3f);
    double bound = 27.0 * M + (9.0 + 24.0 + 9.0 * reach / width) * (M + A);
    const Boundaries& ends = config.boundaries;
    if (config.cell_size != 0.5f || config.rows || ends.periodic(0) || ends.periodic(1) || ends.periodic(2))
        bound += 12.0 * std::max({config.cells.x, config.cells.y, config.cells.z}) * M;
    if (config.profile)
        bound += 40.0 * A;
    return bound * u;
}

TEST(QueryReference, ListsAreThePlainFormulaToRounding) {
    for (const QueryScene& scene : query_scenes()) {
        const Wind wind = noisy(scene);
        const WindView view = wind.view();
        const std::vector<glm::dvec3> points = points_of(scene, wind, 20'000);
        std::vector<glm::vec3> list(points.size());
        view.velocity(points, list);
        double worst = 0.0, ambient = 0.0;
        int inside = 0, outside = 0;
        for (std::size_t n = 0; n < points.size(); ++n) {
            const glm::vec3 plain = reference::plain_velocity(view, points[n]);
            const glm::vec3 around = reference::plain_ambient(view.ambient(), points[n]);
            inside += plain != around;
            outside += plain == around;
            for (int axis = 0; axis < 3; ++axis) {
                ambient = std::max(ambient, double(std::abs(around[axis])));
                worst = std::max(worst, double(std::abs(list[n][axis] - plain[axis])));
            }
        }
        EXPECT_GT(inside, 2000) << scene.name;
        WINDROW_EXPECT_FIGURE("query_reference/" + scene.name, worst, bound_of(wind, ambient));
        EXPECT_TRUE(outside > 1000 || !wind.box().boundaries.has_open(0)) << scene.name;
    }
}

// Without a profile there is no logarithm: each operation is that of the shared text, in its order.
TEST(QueryReference, GustsAndWhatPlantsFeelHaveTheBitsOfTheSharedText) {
    for (const float length : {24.0f, 3.7f}) {
        auto wind =
            AmbientWind::create({.mean = {5.0f, 0.3f, -2.0f}, .gusts = {.intensity = 0.4f, .length = length}, .ground = 3.0});
        ASSERT_TRUE(wind);
        wind->advance(1234.5);
        Random random(98);
        std::vector<glm::dvec3> points;
        for (int n = 0; n < 10'000; ++n)
            points.push_back(random.direction() * random.spread(1e-3, n % 3 == 0 ? 1e9 : 300.0));
        std::vector<glm::vec3> list(points.size());
        wind->velocity(points, list);
        std::vector<glm::vec3> felt = list;
        wind->felt(points, k_rippled, felt);
        int differing = 0, limited = 0;
        for (std::size_t n = 0; n < points.size(); ++n) {
            const glm::vec3 plain = reference::plain_ambient(*wind, points[n]);
            const glm::vec3 plain_felt = reference::plain_felt(*wind, plain, points[n], k_rippled);
            differing += std::memcmp(&plain, &list[n], sizeof plain) != 0;
            differing += std::memcmp(&plain_felt, &felt[n], sizeof plain) != 0;
            limited += glm::length(felt[n]) > 0.999f * k_rippled.limit;
        }
        EXPECT_GT(limited, 10);
        EXPECT_LT(limited, 9'990);
        WINDROW_EXPECT_FIGURE("query_reference/gusts_that_differ", differing, 0.0);
    }
}

TEST(QueryReference, WhatIsFeltOfNoNumberIsNothing) {
    const auto wind = AmbientWind::create({.mean = {5.0f, 0.0f, 0.0f}, .gusts = {.intensity = 0.4f}});
    ASSERT_TRUE(wind);
    for (const Sampling& sampling : {Sampling{}, k_rippled, Sampling{.strength = 0.0f}, Sampling{.limit = 0.0f}}) {
        std::vector<glm::dvec3> points(40, glm::dvec3(1.0, 2.0, 3.0));
        std::vector<glm::vec3> felt(points.size(), glm::vec3(3.0f, 1.0f, -40.0f));
        felt[3].x = k_nan;
        felt[20].z = k_infinity;
        felt[21] = glm::vec3(3e38f);
        felt[22] = glm::vec3(1e-42f);
        felt[23] = glm::vec3(0.0f);
        points[24].y = k_nan;
        const std::vector<glm::vec3> given = felt;
        wind->felt(points, sampling, felt);
        for (std::size_t n = 0; n < felt.size(); ++n) {
            const glm::vec3 plain = reference::plain_felt(*wind, given[n], points[n], sampling);
            EXPECT_EQ(std::memcmp(&plain, &felt[n], sizeof plain), 0) << n;
        }
        EXPECT_EQ(felt[3], glm::vec3(0.0f));
        EXPECT_EQ(felt[20], glm::vec3(0.0f));
    }
}

} // namespace
