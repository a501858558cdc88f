// Places of blades from the size and the heightmap: their number, the ground between its corners, and rejected input.
#include "tests/figure.h"
#include "vegetation/tests/grass/fields.h"

#include <algorithm>
#include <limits>
#include <string>

namespace windrow::vegetation::grass {
namespace {

using windrow::test::Random;

struct Errors {
    double height = 0.0, normal = 0.0;
};

// A wave of 40 m along x and 60 m along z, seen through a grid of this spacing, away from the edge.
Errors errors_at(float spacing) {
    const int corners = static_cast<int>(std::lround(120.0f / spacing)) + 1;
    const auto wave = [](glm::dvec2 p) { return 3.0 * std::sin(p.x * 0.157) * std::cos(p.y * 0.105); };
    const auto map = HeightMap::create({corners, corners}, spacing, [&](glm::vec2 p) { return static_cast<float>(wave(p)); });
    EXPECT_TRUE(map) << map.error();
    Errors largest;
    Random random(3);
    for (int n = 0; n < 20'000; ++n) {
        const glm::vec2 p{random.uniform(10.0f, 110.0f), random.uniform(10.0f, 110.0f)};
        const glm::dvec2 at(p);
        const glm::dvec3 normal = glm::normalize(glm::dvec3(-3.0 * 0.157 * std::cos(at.x * 0.157) * std::cos(at.y * 0.105), 1.0,
                                                            3.0 * 0.105 * std::sin(at.x * 0.157) * std::sin(at.y * 0.105)));
        largest.height = std::max(largest.height, std::abs(static_cast<double>(map->height(p)) - wave(at)));
        largest.normal = std::max(largest.normal, glm::length(glm::dvec3(map->normal(p)) - normal));
    }
    return largest;
}

TEST(GrassHeights, ErrWithTheSquareOfTheSpacing) {
    const Errors at[] = {errors_at(4.0f), errors_at(2.0f), errors_at(1.0f), errors_at(0.5f)};
    const auto slope = [&](double Errors::*kind) { // least squares over four points, one apart in log2
        return -(3.0 * (std::log2(at[3].*kind) - std::log2(at[0].*kind)) + std::log2(at[2].*kind) - std::log2(at[1].*kind)) /
               10.0;
    };
    const Errors fine = at[2];
    const double height = slope(&Errors::height), normal = slope(&Errors::normal);
    windrow::test::figure("grass/heights/error_at_1_m", fine.height);
    windrow::test::figure("grass/heights/normal_error_at_1_m", fine.normal);
    WINDROW_EXPECT_FIGURE("grass/heights/order_less_2", std::abs(height - 2.0), 0.1);
    WINDROW_EXPECT_FIGURE("grass/heights/normal_order_less_2", std::abs(normal - 2.0), 0.1);
}

TEST(GrassHeights, AreTheCornersAndLevelGroundIsLevel) {
    const HeightMap map = test::hills();
    for (int z = 0; z < 113; z += 7)
        for (int x = 0; x < 81; x += 5) // on the last ones a + 1 (b - a) rounds
            ASSERT_NEAR(map.height({x, z}), map.heights()[static_cast<std::size_t>(z) * 81 + x],
                        x == 80 || z == 112 ? 1e-6f : 0.0f);
    const auto level = HeightMap::create({9, 5}, 0.37f, [](glm::vec2) { return 1.7f; });
    ASSERT_TRUE(level);
    Random random(5);
    for (int n = 0; n < 1000; ++n) {
        const glm::vec2 p{random.uniform(-3.0f, 6.0f), random.uniform(-3.0f, 6.0f)};
        ASSERT_EQ(level->height(p), 1.7f);
        ASSERT_EQ(level->normal(p), glm::vec3(0.0f, 1.0f, 0.0f));
    }
    // The normal has no crease: a thousandth of a texel turns it by a thousandth of a corner's change, also across a border.
    float most = 0.0f;
    for (int n = 1; n < 80'000; ++n)
        most = std::max(most, glm::length(map.normal({0.001f * static_cast<float>(n), 40.3f}) -
                                          map.normal({0.001f * static_cast<float>(n - 1), 40.3f})));
    WINDROW_EXPECT_FIGURE("grass/heights/normal_step_over_1_mm", static_cast<double>(most), 1e-4);
}

TEST(GrassPlaces, AreAsManyAsSizeAndDensitySay) {
    // 16 m x 16 m at 6 a metre: exactly 9,216 candidates.
    const auto map = HeightMap::create({17, 17}, 1.0f, [](glm::vec2 p) { return 0.5f * p.x + 3.0f * std::sin(0.4f * p.y); });
    ASSERT_TRUE(map);
    const auto mask = PlacementMask::create({17, 17}, map->extent(), 1.0f);
    ASSERT_TRUE(mask);
    const GrassSettings settings;
    const Block block = block_of(settings, *map, *mask);
    EXPECT_EQ(glm::ivec2(block.cells.x, block.cells.y), glm::ivec2(96, 96));
    double largest = 0.0, step = 0.0;
    int placed = 0;
    for (int z = 0; z < block.cells.y; ++z)
        for (int x = 0; x < block.cells.x; ++x) {
            const BladeRecord blade = blade_at(block, *map, *mask, {x, z});
            placed += blade.w == 1.0f;
            // Within its own cell.
            ASSERT_TRUE(blade.x >= static_cast<float>(x) / 6.0f - 1e-5f && blade.x <= static_cast<float>(x + 1) / 6.0f + 1e-5f);
            ASSERT_TRUE(blade.z >= static_cast<float>(z) / 6.0f - 1e-5f && blade.z <= static_cast<float>(z + 1) / 6.0f + 1e-5f);
            largest =
                std::max(largest, std::abs(static_cast<double>(blade.y) - (0.5 * static_cast<double>(blade.x) +
                                                                           3.0 * std::sin(0.4 * static_cast<double>(blade.z)))));
        }
    for (int z = 1; z < 17; ++z)
        step = std::max(step, std::abs(3.0 * std::sin(0.4 * z) - 3.0 * std::sin(0.4 * (z - 1))));
    EXPECT_EQ(placed, 9216);
    windrow::test::figure("grass/places/candidates_of_16_m_at_6", placed);
    WINDROW_EXPECT_FIGURE("grass/places/height_error_over_a_texel_step", largest / step, 1.0);
}

TEST(GrassHeights, RejectWhatIsNoGround) {
    const auto flat = [](glm::vec2) { return 0.0f; };
    const auto says = [](const auto& result, const char* field) {
        return !result && result.error().find(field) != std::string::npos;
    };
    EXPECT_TRUE(says(HeightMap::create({1, 5}, 1.0f, flat), "heightmap.corners is (1, 5)"));
    EXPECT_TRUE(says(HeightMap::create({5, 1 << 20}, 1.0f, flat), "heightmap.corners is (5, 1048576)"));
    for (const float spacing :
         {0.0f, -1.0f, 1e9f, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()})
        EXPECT_TRUE(says(HeightMap::create({5, 5}, spacing, flat), "heightmap.spacing")) << spacing;
    EXPECT_TRUE(says(HeightMap::create({2, 2}, 1.0f, std::vector<float>(3)), "has 3 values: give 4"));
    for (const float height : {1e6f, std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::infinity()})
        EXPECT_TRUE(says(HeightMap::create({2, 2}, 1.0f, {0.0f, 0.0f, height, 0.0f}), "heightmap.heights[2]")) << height;
}

TEST(GrassSettingsRejection, NamesEveryField) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const GrassSettings wrong{.density = nan,
                              .jitter = 1.5f,
                              .chunk_cells = 4,
                              .split_distance = 50.0f,
                              .cut_distance = 20.0f,
                              .morph_from = 1.0f,
                              .fade_from = -1.0f,
                              .shadow_distance = nan,
                              .min_width = 1.0f,
                              .max_chunks = 0};
    const auto outcome = validate(wrong);
    ASSERT_FALSE(outcome);
    for (const char* field : {"density", "jitter", "chunk_cells", "split_distance", "morph_from", "fade_from", "shadow_distance",
                              "min_width", "max_chunks"})
        EXPECT_NE(outcome.error().find("grass." + std::string(field)), std::string::npos) << field;
    EXPECT_TRUE(validate(GrassSettings{}));
    EXPECT_FALSE(validate(GrassSettings{.blade = {.width = -1.0f}}));
}

} // namespace
} // namespace windrow::vegetation::grass
