// Many plants at once: the same as one by one, whatever the number of threads; sizes that do not fit are rejected.
#include "coupling/blade.h"
#include "coupling/shell.h"
#include "fluid/thread_pool.h"
#include "tests/fields.h"
#include "tests/figure.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <vector>

namespace windrow {
namespace {

using test::Random;

struct BladeField {
    std::vector<PlantKey> keys;
    std::vector<glm::vec4> roots, winds, loads;
    std::vector<float> heights{0.0f, 0.3f, 0.7f, 1.0f};
    std::vector<glm::vec4> positions, normals;

    explicit BladeField(std::size_t count)
        : keys(count), roots(count), winds(count), loads(count), positions(8 * count), normals(8 * count) {
        Random random(1);
        for (std::size_t n = 0; n < count; ++n) {
            keys[n] = {random.bits(), random.bits()};
            roots[n] = glm::vec4(random.vector(10.0f), 0.0f);
            winds[n] = glm::vec4(random.vector(12.0f), 0.0f);
        }
    }
    void make(const Blades& grass, const ParallelFor& parallel_for = {}) {
        const auto loaded = grass.loads(keys, winds, loads, parallel_for);
        EXPECT_TRUE(loaded) << loaded.error();
        const auto made = grass.vertices(keys, roots, loads, heights, {positions, normals}, {0.0f, -0.6f, 0.8f}, parallel_for);
        EXPECT_TRUE(made) << made.error();
    }
};

TEST(PlantBatch, BladesAreTheSingleOnes) {
    const auto grass = Blades::create({.view_bend = 0.4f});
    ASSERT_TRUE(grass);
    BladeField meadow(1003); // not a whole number of blocks
    meadow.make(*grass);
    double most = 0.0, normal_most = 0.0;
    for (std::size_t n = 0; n < meadow.keys.size(); ++n) {
        const glm::vec3 load = grass->load(meadow.keys[n], glm::vec3(meadow.winds[n]));
        ASSERT_EQ(glm::vec3(meadow.loads[n]), load);
        for (std::size_t v = 0; v < 8; ++v) {
            const float h = meadow.heights[v / 2];
            const PlantVertex one = grass->vertex(meadow.keys[n], load, h, v % 2 == 0 ? -1.0f : 1.0f, {0.0f, -0.6f, 0.8f});
            const glm::vec4 many = meadow.positions[8 * n + v];
            ASSERT_EQ(many.w, h);
            most = std::max(most, static_cast<double>(glm::length(glm::vec3(many) - glm::vec3(meadow.roots[n]) - one.position)));
            normal_most =
                std::max(normal_most, static_cast<double>(glm::length(glm::vec3(meadow.normals[8 * n + v]) - one.normal)));
        }
    }
    WINDROW_EXPECT_FIGURE("plants/batch/blade_difference_m", most, 2e-6); // roots of 10 m round by 5e-7
    WINDROW_EXPECT_FIGURE("plants/batch/normal_difference", normal_most, 1e-6);
}

TEST(PlantBatch, TheNumberOfThreadsChangesNoBit) {
    const auto grass = Blades::create({});
    ASSERT_TRUE(grass);
    BladeField one(5000), three(5000);
    ThreadPool pool(3);
    one.make(*grass);
    three.make(*grass, pool.parallel_for());
    EXPECT_EQ(one.positions, three.positions);
    EXPECT_EQ(one.normals, three.normals);
    EXPECT_EQ(one.loads, three.loads);
}

TEST(PlantBatch, ShellsAreTheSingleOnes) {
    const auto fur = Shells::create({.droop = 0.01f});
    ASSERT_TRUE(fur);
    constexpr std::size_t k_count = 700;
    Random random(2);
    std::vector<glm::vec4> skin(k_count), normals(k_count), winds(k_count), loads(k_count), bent(k_count), pushed(k_count);
    for (std::size_t n = 0; n < k_count; ++n) {
        skin[n] = glm::vec4(random.vector(1.0f), random.uniform(0.0f, 1.0f));
        normals[n] = glm::vec4(glm::vec3(random.direction()), 0.0f);
        winds[n] = glm::vec4(random.vector(9.0f), 0.0f);
    }
    ThreadPool pool(2);
    ASSERT_TRUE(fur->loads({skin, normals}, winds, loads, pool.parallel_for()));
    ASSERT_TRUE(fur->bent({skin, normals}, 0.6f, loads, bent, pool.parallel_for()));
    ASSERT_TRUE(fur->translated({skin, normals}, 0.6f, winds, pushed, pool.parallel_for()));
    for (std::size_t n = 0; n < k_count; ++n) {
        const glm::vec3 p(skin[n]), normal(normals[n]);
        ASSERT_EQ(glm::vec3(loads[n]), fur->load(normal, skin[n].w, glm::vec3(winds[n])));
        ASSERT_EQ(glm::vec3(bent[n]), fur->bent(p, normal, 0.6f, skin[n].w, glm::vec3(loads[n])));
        ASSERT_EQ(glm::vec3(pushed[n]), fur->translated(p, normal, 0.6f, skin[n].w, glm::vec3(winds[n])));
    }
}

TEST(PlantBatch, RejectsSizesThatDoNotFitAndTouchesNothing) {
    const auto grass = Blades::create({});
    const auto fur = Shells::create({});
    ASSERT_TRUE(grass);
    ASSERT_TRUE(fur);
    BladeField meadow(10);
    const std::vector<glm::vec4> untouched = meadow.positions;
    std::vector<glm::vec4> few(9), some(10);
    const auto rejected = [](const Result<void>& result, const char* field) {
        ASSERT_FALSE(result);
        EXPECT_NE(result.error().find(field), std::string::npos) << result.error();
    };
    rejected(grass->loads(meadow.keys, few, meadow.loads), "winds");
    rejected(grass->loads(meadow.keys, meadow.winds, few), "loads");
    rejected(grass->vertices(meadow.keys, few, meadow.loads, meadow.heights, {meadow.positions, {}}), "roots");
    rejected(grass->vertices(meadow.keys, meadow.roots, few, meadow.heights, {meadow.positions, {}}), "loads");
    rejected(grass->vertices(meadow.keys, meadow.roots, meadow.loads, meadow.heights, {few, {}}), "positions");
    rejected(grass->vertices(meadow.keys, meadow.roots, meadow.loads, meadow.heights, {meadow.positions, few}), "normals");
    for (const float h : {-0.1f, 1.1f, std::nanf("")}) {
        meadow.heights[2] = h;
        rejected(grass->vertices(meadow.keys, meadow.roots, meadow.loads, meadow.heights, {meadow.positions, {}}), "heights");
    }
    EXPECT_EQ(meadow.positions, untouched);
    rejected(fur->bent({some, few}, 0.5f, some, some), "normals");
    rejected(fur->bent({some, some}, 2.0f, some, some), ".h");
    rejected(fur->translated({some, some}, 0.5f, few, some), "directions");
    rejected(fur->loads({some, few}, some, some), "normals");
    rejected(fur->loads({some, some}, few, some), "winds");
    rejected(fur->loads({some, some}, some, few), "loads");
}

} // namespace
} // namespace windrow
