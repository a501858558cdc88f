// Placement mask: size by alpha, painted and erased by function, saved as an image.
#include "tests/figure.h"
#include "vegetation/tests/grass/fields.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

namespace windrow::vegetation::grass {
namespace {

using windrow::test::Random;

PlacementMask even_mask(float alpha) {
    return *PlacementMask::create({65, 65}, {32.0f, 32.0f}, alpha);
}

std::string file_at(const char* name) {
    return (std::filesystem::path(testing::TempDir()) / name).string();
}

TEST(GrassMask, AlphaIsTheSize) {
    const HeightMap ground = *HeightMap::create({33, 33}, 1.0f, [](glm::vec2) { return 0.0f; });
    // From 0 at x = 8 m to 1 at x = 24 m.
    PlacementMask mask = even_mask(0.0f);
    (void)mask.apply([](glm::vec2 p, float) { return (p.x - 8.0f) / 16.0f; });
    const GrassSettings settings;
    const Block block = block_of(settings, ground, mask);
    double off = 0.0;
    int bare = 0, blades = 0;
    for (int z = 0; z < block.cells.y; ++z)
        for (int x = 0; x < block.cells.x; ++x) {
            const BladeRecord blade = blade_at(block, ground, mask, {x, z});
            const double wanted = std::clamp((static_cast<double>(blade.x) - 8.0) / 16.0, 0.0, 1.0);
            off = std::max(off, std::abs(static_cast<double>(blade.w) - wanted));
            bare += blade.x < 7.9f;
            blades += blade.x < 7.9f && blade.w > 0.0f;
        }
    ASSERT_GT(bare, 0);
    EXPECT_EQ(blades, 0); // alpha 0: no blade
    // Alpha is stored to 1/65535.
    WINDROW_EXPECT_FIGURE("grass/mask/size_less_alpha", off, 1.0 / 65535.0);
    // The drawn length is linear in it.
    const float whole = windrow::numerics::windrow_grass_class(block, 1.0f, 1.0f).size.x;
    for (const float size : {0.25f, 0.5f, 0.75f})
        EXPECT_FLOAT_EQ(windrow::numerics::windrow_grass_class(block, size, 1.0f).size.x, size * whole);
}

TEST(GrassMask, IsPaintedAndErased) {
    PlacementMask mask = even_mask(0.0f);
    const auto painted = mask.paint({.centre = {16.0f, 12.0f}, .radius = 6.0f, .hardness = 0.5f});
    ASSERT_TRUE(painted);
    EXPECT_EQ(mask.alpha({16.0f, 12.0f}), 1.0f);
    EXPECT_EQ(mask.alpha({16.0f, 14.5f}), 1.0f); // within the hard half
    float before = 1.0f;
    for (float r = 3.0f; r <= 7.0f; r += 0.1f) { // falls off, and never rises
        const float alpha = mask.alpha({16.0f + r, 12.0f});
        EXPECT_LE(alpha, before);
        before = alpha;
    }
    EXPECT_EQ(before, 0.0f);
    EXPECT_NEAR(mask.alpha({16.0f + 4.5f, 12.0f}), (1.0f - 0.25f) * (1.0f - 0.25f), 1e-4f);
    Random random(2);
    for (int n = 0; n < 10'000; ++n) { // what was not touched is as it was
        const glm::vec2 p{random.uniform(0.0f, 32.0f), random.uniform(0.0f, 32.0f)};
        if (glm::any(glm::lessThan(p, painted->low)) || glm::any(glm::greaterThan(p, painted->high))) {
            ASSERT_EQ(mask.alpha(p), 0.0f);
        }
    }
    // Half a stroke twice is one; erasing is painting backwards.
    PlacementMask twice = even_mask(0.0f);
    for (int n = 0; n < 2; ++n)
        ASSERT_TRUE(twice.paint({.centre = {16.0f, 12.0f}, .radius = 6.0f, .strength = 0.5f}));
    double off = 0.0;
    for (std::size_t n = 0; n < mask.values().size(); ++n)
        off = std::max(off, std::abs(static_cast<double>(twice.values()[n]) - static_cast<double>(mask.values()[n])));
    WINDROW_EXPECT_FIGURE("grass/mask/two_halves_of_a_stroke", off, 2.0 / 65535.0);
    ASSERT_TRUE(mask.erase({.centre = {16.0f, 12.0f}, .radius = 6.0f}));
    for (const float value : mask.values())
        ASSERT_EQ(value, 0.0f);
    EXPECT_FALSE(mask.grows({0.0f, 0.0f}, {32.0f, 32.0f}));
    // By a function: NaN is no grass.
    (void)mask.apply([](glm::vec2 p, float) { return p.x > 30.0f ? std::numeric_limits<float>::quiet_NaN() : 2.0f; });
    EXPECT_EQ(mask.alpha({3.0f, 3.0f}), 1.0f);
    EXPECT_EQ(mask.alpha({31.0f, 3.0f}), 0.0f);
}

TEST(GrassMask, ComesBackFromItsImageToTheBit) {
    PlacementMask mask = even_mask(0.0f);
    Random random(4);
    (void)mask.apply([&](glm::vec2, float) { return random.uniform(-0.1f, 1.1f); });
    const std::string path = file_at("grass_mask.pgm");
    ASSERT_TRUE(mask.save(path));
    const auto again = PlacementMask::load(path, mask.extent());
    ASSERT_TRUE(again) << again.error();
    EXPECT_EQ(again->grid().corners, mask.grid().corners);
    int changed = 0;
    for (std::size_t n = 0; n < mask.values().size(); ++n)
        changed += again->values()[n] != mask.values()[n];
    WINDROW_EXPECT_FIGURE("grass/mask/values_changed_by_its_image", changed, 0);
    // 8 bits and a comment, as image programs write them.
    const std::string small = file_at("grass_small.pgm");
    std::ofstream(small, std::ios::binary) << "P5\n# by hand\n2 2\n255\n" << std::string("\x00\xff\x33\x66", 4);
    const auto coarse = PlacementMask::load(small, {1.0f, 1.0f});
    ASSERT_TRUE(coarse) << coarse.error();
    EXPECT_EQ(coarse->alpha({0.0f, 0.0f}), 0.0f);
    EXPECT_EQ(coarse->alpha({1.0f, 0.0f}), 1.0f);
    EXPECT_NEAR(coarse->alpha({0.0f, 1.0f}), 0.2f, 1e-5f);
    std::filesystem::remove(path);
    std::filesystem::remove(small);
}

TEST(GrassMask, RejectsWhatItCannotUse) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    PlacementMask mask = even_mask(0.5f);
    for (const Brush& wrong : {Brush{.centre = {nan, 0.0f}}, Brush{.radius = 0.0f}, Brush{.radius = nan}, Brush{.strength = 1.5f},
                               Brush{.hardness = -1.0f}}) {
        EXPECT_FALSE(mask.paint(wrong));
        EXPECT_FALSE(mask.erase(wrong));
    }
    for (const float value : mask.values())
        ASSERT_EQ(value, even_mask(0.5f).values()[0]);
    EXPECT_FALSE(PlacementMask::create({1, 9}, {1.0f, 1.0f}));
    EXPECT_FALSE(PlacementMask::create({9, 9}, {nan, 1.0f}));
    EXPECT_FALSE(PlacementMask::create({9, 9}, {1.0f, 1.0f}, 2.0f));
    EXPECT_FALSE(mask.save(file_at("no/such/folder/mask.pgm")));
    EXPECT_FALSE(PlacementMask::load(file_at("no_such_mask.pgm"), {1.0f, 1.0f}));
    const std::string path = file_at("grass_wrong.pgm");
    for (const char* text :
         {"", "P6\n2 2\n255\nabcd", "P5\n2 x\n255\nabcd", "P5\n2 2\n70000\nabcd", "P5\n2 2\n255\nabc", "P5\n-2 2\n255\nabcd"}) {
        std::ofstream(path, std::ios::binary) << text;
        const auto outcome = PlacementMask::load(path, {1.0f, 1.0f});
        ASSERT_FALSE(outcome) << text;
        EXPECT_NE(outcome.error().find(path), std::string::npos) << outcome.error();
    }
    std::filesystem::remove(path);
}

} // namespace
} // namespace windrow::vegetation::grass
