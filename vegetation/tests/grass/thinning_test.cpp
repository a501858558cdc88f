// Fewer and wider blades afar, and clumps: what is covered stays, the count falls, nothing jumps; clumps only ever make smaller.
#include "tests/figure.h"
#include "vegetation/tests/grass/fields.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace windrow::vegetation::grass {
namespace {

using namespace windrow::numerics;

GrassSettings thinning_field() {
    return {
        .density = 12.0f, .cut_distance = 60.0f, .fade_from = 0.99f, .min_width = 0.0f, .thin_from = 4.0f, .thin_power = 1.6f};
}

Block block_of_level_ground(const GrassSettings& settings, float size = 16.0f) {
    const HeightMap ground = *HeightMap::create({17, 17}, size / 16.0f, [](glm::vec2) { return 0.0f; });
    return block_of(settings, ground, *PlacementMask::create({17, 17}, ground.extent(), 1.0f));
}

// Area of a blade over that of its class.
double area(const Block& block, float distance, float chance) {
    const WindrowBlade blade = windrow_grass_thinned(block, 1.0f, distance, chance);
    return static_cast<double>(blade.size.x) * static_cast<double>(blade.size.z) /
           (static_cast<double>(block.blade.size.x) * static_cast<double>(block.blade.size.z));
}

TEST(GrassThinning, KeepsTheAreaThatBladesCover) {
    const Block block = block_of_level_ground(thinning_field());
    double worst = 0.0;
    for (float distance = 0.5f; distance < 59.0f; distance *= 1.07f) {
        constexpr int k_chances = 20'000; // evenly: an integral, no draw of lots
        double sum = 0.0;
        for (int n = 0; n < k_chances; ++n)
            sum += area(block, distance, (static_cast<float>(n) + 0.5f) / k_chances);
        worst = std::max(worst, std::abs(sum / k_chances - 1.0));
    }
    // The integrand is a ramp's square between two corners: the rule of the middle errs by less than its step there.
    WINDROW_EXPECT_FIGURE("grass/thinning/area_less_1", worst, 1e-3);
}

// The blades of a field, ring by ring around an eye: their areas by their own chances, and how many they are.
TEST(GrassThinning, RingsOfAFieldAreAsCoveredByFewerBlades) {
    const GrassSettings settings = thinning_field();
    const Block block = block_of_level_ground(settings, 100.0f);
    double worst = 0.0;
    int before = 0;
    for (const float ring : {6.0f, 12.0f, 24.0f, 46.0f}) {
        double covered = 0.0;
        int all = 0, kept = 0;
        for (int z = 0; z < block.cells.y; ++z)
            for (int x = 0; x < block.cells.x; ++x) {
                const glm::ivec2 cell(x, z);
                const glm::vec2 place = windrow_grass_place(cell, block.ground.x, block.ground.y, 0u);
                const float distance = glm::length(place - glm::vec2(50.0f));
                if (distance < ring || distance > 1.07f * ring)
                    continue;
                const double share = area(block, distance, windrow_grass_chance(cell, 0u));
                covered += share;
                kept += share > 0.0;
                ++all;
            }
        // Each kept blade stands for all / kept of them: the sum's own scatter, of which four are allowed.
        worst = std::max(worst, std::abs(covered / all - 1.0) / (4.0 / std::sqrt(static_cast<double>(kept))));
        const double share = static_cast<double>(kept) / all;
        const double wanted = std::min(1.0, static_cast<double>(windrow_grass_fraction(block.thin, 1.03f * ring)));
        windrow::test::figure("grass/thinning/share_of_the_ring", share);
        EXPECT_NEAR(share, wanted, 0.05 * wanted + 4.0 * std::sqrt(wanted / all)); // the share over the ring's width
        const int a_thousand = static_cast<int>(1000.0 * share);
        EXPECT_TRUE(before == 0 || a_thousand < before);
        before = a_thousand;
    }
    WINDROW_EXPECT_FIGURE("grass/thinning/cover_of_rings_over_four_scatters", worst, 1.0);
}

// An eye that comes nearer by 5 cm, a frame of a walker's way, changes a blade's length by the slope of s(d) at most, and blades
// that come in begin at nothing.
TEST(GrassThinning, NothingJumpsAsTheEyeMoves) {
    const GrassSettings settings = thinning_field();
    const Block block = block_of_level_ground(settings);
    constexpr float k_step = 0.05f; // [m]
    double length = 0.0, first = 0.0;
    for (int n = 0; n < 200; ++n) {
        const float chance = (static_cast<float>(n) + 0.5f) / 200.0f;
        double before = -1.0;
        for (float distance = 58.0f; distance > 1.0f; distance -= k_step) {
            const double now =
                static_cast<double>(windrow_grass_thinned(block, 1.0f, distance, chance).size.x / block.blade.size.x);
            if (before >= 0.0)
                length = std::max(length, std::abs(now - before));
            if (before == 0.0 && now > 0.0)
                first = std::max(first, now);
            before = now;
        }
    }
    // q = (s - c) / w with w = s b / (1 + b): dq/dd <= p / d (1 + b) / b, the largest where thinning begins.
    const double b = static_cast<double>(WINDROW_GRASS_SHRINK);
    const double bound = 1.6 / 3.9 * static_cast<double>(k_step) * (1.0 + b) / b;
    WINDROW_EXPECT_FIGURE("grass/thinning/length_step_over_5_cm_of_way", length, bound);
    WINDROW_EXPECT_FIGURE("grass/thinning/first_length_that_is_seen", first, bound);
}

TEST(GrassThinning, OfNoneLeavesTheClassAsItWas) {
    GrassSettings settings = thinning_field();
    settings.thin_power = 0.0f;
    const Block block = block_of_level_ground(settings);
    for (const float distance : {0.1f, 7.0f, 50.0f}) {
        const WindrowBlade plain = windrow_grass_class(block, 0.7f, distance);
        const WindrowBlade thinned = windrow_grass_thinned(block, 0.7f, distance, 0.99f);
        EXPECT_EQ(plain.size, thinned.size);
        EXPECT_EQ(plain.drag.load, thinned.drag.load);
    }
}

// Devices have arctangents of their own: what differs in the last bits may turn a blade by as little, but not redraw its length.
TEST(GrassClumps, AreTheSameOnAnotherDevice) {
    const Block block = block_of_level_ground({.clump_size = 0.5f, .clump_lean = 0.5f, .clump_fan = 0.4f});
    int blades = 0, others = 0;
    for (int z = 0; z < block.cells.y; ++z)
        for (int x = 0; x < block.cells.x; ++x) {
            const glm::uvec2 hash = windrow_plant_hash(windrow_grass_key({x, z}, 0u, 0u));
            const WindrowClump clump =
                windrow_grass_clump(block, windrow_grass_place({x, z}, block.ground.x, block.ground.y, 0u));
            WindrowClump another = clump; // some units in the last place of the angle
            another.offset *= 1.0f + 1e-6f;
            const auto length = [&](const WindrowClump& around) {
                return windrow_blade_length_fraction(block.blade, windrow_grass_facing(block, hash, around));
            };
            ++blades;
            others += std::abs(length(another) - length(clump)) > 1e-3f ? 1 : 0;
        }
    // An angle of 1e-6 rad passes one of 256 steps of the circle: 4e-5 of the blades.
    WINDROW_EXPECT_FIGURE("grass/clumps/blades_of_another_length", static_cast<double>(others) / blades, 1e-3);
    EXPECT_GT(blades, 9000);
}

TEST(GrassClumps, MakeBladesSmallerAndFaceOneWay) {
    GrassSettings settings{.clump_size = 0.5f, .clump_height = 0.4f, .clump_lean = 0.9f, .patch_height = 0.3f};
    const Block block = block_of_level_ground(settings);
    float least = 2.0f, most = 0.0f;
    double within = 0.0, between = 0.0;
    int pairs = 0, strangers = 0;
    struct Blade {
        WindrowClump clump;
        glm::vec2 facing;
    };
    std::vector<Blade> blades;
    for (int z = 0; z < block.cells.y; ++z)
        for (int x = 0; x < block.cells.x; ++x) {
            const glm::vec2 place = windrow_grass_place({x, z}, block.ground.x, block.ground.y, 0u);
            const float grown = windrow_grass_growth(block, place);
            least = std::min(least, grown);
            most = std::max(most, grown);
            const WindrowClump clump = windrow_grass_clump(block, place);
            const glm::uvec2 hash = windrow_plant_hash(windrow_grass_key({x, z}, 0u, 0u));
            blades.push_back({clump, windrow_yaw_vector(windrow_plant_yaw(windrow_grass_facing(block, hash, clump)))});
            EXPECT_LE(glm::length(clump.offset), 1.5f); // a middle lies in each cell, within 0.9 of a side of its far corner
        }
    for (std::size_t n = 1; n < blades.size(); ++n) {
        const bool same = blades[n].clump.chance == blades[n - 1].clump.chance;
        const double agree = static_cast<double>(glm::dot(blades[n].facing, blades[n - 1].facing));
        (same ? within : between) += agree;
        ++(same ? pairs : strangers);
    }
    EXPECT_LE(most, 1.0f); // culling's balls hold
    EXPECT_GE(least, 0.6f * 0.7f - 1e-5f);
    windrow::test::figure("grass/clumps/min_growth", static_cast<double>(least));
    windrow::test::figure("grass/clumps/facing_of_neighbours_within", within / pairs);
    windrow::test::figure("grass/clumps/facing_of_neighbours_between", between / strangers);
    EXPECT_GT(within / pairs, 0.9);
    EXPECT_LT(std::abs(between / strangers), 0.1);
}

} // namespace
} // namespace windrow::vegetation::grass
