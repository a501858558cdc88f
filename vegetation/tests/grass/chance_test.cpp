// Random traits of a blade are independent of one another, its jitter in x and z too.
#include "coupling/blade.h"
#include "tests/figure.h"
#include "vegetation/tests/grass/fields.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace windrow::vegetation::grass {
namespace {

using namespace windrow::numerics;

constexpr int k_side = 1200; // of a field of 200 m at 6 a metre: 1.44e6 blades, whose chance correlation is 8e-4
constexpr std::size_t k_traits = 7;
constexpr std::array<const char*, k_traits> k_names{"x", "z", "yaw", "length", "stiffness", "rest_bend", "looks"};

std::array<double, k_traits> traits_of(glm::ivec2 cell, std::uint32_t seed) {
    const glm::vec2 place = windrow_grass_place(cell, 6.0f, 1.0f, seed) * 6.0f - glm::vec2(cell);
    const glm::uvec2 hash = windrow_plant_hash(windrow_grass_key(cell, seed, 0u));
    const glm::uvec2 looks = windrow_plant_hash(windrow_grass_key(cell, seed, 2u));
    WindrowBlade kind{};
    kind.size = {1.0f, 0.5f, 0.0f, 0.0f};
    return {static_cast<double>(place.x),
            static_cast<double>(place.y),
            static_cast<double>(windrow_plant_yaw(hash)),
            static_cast<double>(windrow_blade_length(kind, hash)),
            static_cast<double>(windrow_plant_factor(hash, 0.5f)),
            static_cast<double>(windrow_plant_chance(hash)),
            static_cast<double>(windrow_fraction(looks.x))};
}

double correlation(const std::vector<double>& a, const std::vector<double>& b, std::size_t shift) {
    const std::size_t count = a.size() - shift;
    double sum_a = 0.0, sum_b = 0.0;
    for (std::size_t n = 0; n < count; ++n) {
        sum_a += a[n];
        sum_b += b[n + shift];
    }
    const double mean_a = sum_a / static_cast<double>(count), mean_b = sum_b / static_cast<double>(count);
    double ab = 0.0, aa = 0.0, bb = 0.0;
    for (std::size_t n = 0; n < count; ++n) {
        const double from_a = a[n] - mean_a, from_b = b[n + shift] - mean_b;
        ab += from_a * from_b;
        aa += from_a * from_a;
        bb += from_b * from_b;
    }
    return ab / std::sqrt(aa * bb);
}

std::array<std::vector<double>, k_traits> field(std::uint32_t seed) {
    std::array<std::vector<double>, k_traits> traits;
    for (int z = 0; z < k_side; ++z)
        for (int x = 0; x < k_side; ++x) {
            const auto found = traits_of({x, z}, seed);
            for (std::size_t n = 0; n < k_traits; ++n)
                traits[n].push_back(found[n]);
        }
    return traits;
}

TEST(GrassChance, TraitsDoNotFollowOneAnother) {
    for (const std::uint32_t seed : {0u, 7u}) {
        const auto traits = field(seed);
        double largest = 0.0;
        for (std::size_t a = 0; a < k_traits; ++a)
            for (std::size_t b = a + 1; b < k_traits; ++b) {
                const double found = std::abs(correlation(traits[a], traits[b], 0));
                EXPECT_LT(found, 0.01) << k_names[a] << " and " << k_names[b];
                largest = std::max(largest, found);
            }
        const std::string name = "grass/chance/seed_" + std::to_string(seed);
        WINDROW_EXPECT_FIGURE(name + "/x_to_z_correlation", std::abs(correlation(traits[0], traits[1], 0)), 0.01);
        WINDROW_EXPECT_FIGURE(name + "/largest_of_21_correlations", largest, 0.01);
        // Nor a blade its neighbours along x and along z.
        double neighbours = 0.0;
        for (const std::size_t shift : {std::size_t{1}, std::size_t{k_side}, std::size_t{k_side + 1}})
            for (std::size_t a = 0; a < k_traits; ++a)
                for (std::size_t b = 0; b < k_traits; ++b)
                    neighbours = std::max(neighbours, std::abs(correlation(traits[a], traits[b], shift)));
        WINDROW_EXPECT_FIGURE(name + "/largest_of_147_neighbour_correlations", neighbours, 0.01);
    }
}

// The yaw of a blade and its jitter are even over their range, in one chunk too.
TEST(GrassChance, TraitsAreEven) {
    std::array<std::vector<int>, 3> bins;
    bins.fill(std::vector<int>(16));
    constexpr int k_wide = 316, k_count = k_wide * k_wide; // 1e5 blades
    for (int z = 0; z < k_wide; ++z)
        for (int x = 0; x < k_wide; ++x) {
            const auto traits = traits_of({x, z}, 0);
            const double shares[] = {traits[0], traits[1], traits[2] / 6.283185307179586};
            for (std::size_t n = 0; n < 3; ++n)
                ++bins[n][static_cast<std::size_t>(std::clamp(shares[n], 0.0, 0.999999) * 16.0)];
        }
    const char* names[] = {"x", "z", "yaw"};
    for (std::size_t n = 0; n < 3; ++n) {
        double chi = 0.0;
        for (const int count : bins[n])
            chi += (count - k_count / 16.0) * (count - k_count / 16.0) / (k_count / 16.0);
        // 30.58: 1 % of random fields are beyond it.
        WINDROW_EXPECT_FIGURE(std::string("grass/chance/") + names[n] + "_chi_squared", chi, 30.58);
    }
}

TEST(GrassChance, SeedsAndStreamsAreFieldsOfTheirOwn) {
    EXPECT_NE(windrow_grass_key({3, 4}, 0u, 0u), windrow_grass_key({3, 4}, 1u, 0u));
    EXPECT_NE(windrow_grass_key({3, 4}, 0u, 0u), windrow_grass_key({3, 4}, 0u, 1u));
    EXPECT_NE(windrow_grass_key({3, 4}, 9u, 0u), windrow_grass_key({4, 3}, 9u, 0u));
    // No jitter: the grid.
    EXPECT_EQ(windrow_grass_place({5, 7}, 2.0f, 0.0f, 3u), glm::vec2(2.75f, 3.75f));
}

} // namespace
} // namespace windrow::vegetation::grass
