// Random numbers of strands: even, without correlation of neighbours, without repeats.
#include "tests/figure.h"
#include "vegetation/fur/strand_field.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace windrow::vegetation::fur {
namespace {

constexpr int k_side = 1000;

std::vector<double> field_of(const std::function<double(glm::uvec2)>& chance, glm::ivec2 corner) {
    std::vector<double> values;
    values.reserve(k_side * k_side);
    for (int y = 0; y < k_side; ++y)
        for (int x = 0; x < k_side; ++x)
            values.push_back(chance(numerics::windrow_strand_key(7u, corner + glm::ivec2(x, y))));
    return values;
}

double mean(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values)
        sum += value;
    return sum / static_cast<double>(values.size());
}

// Of a field with itself, or with another, `lag` on.
double correlation(const std::vector<double>& a, const std::vector<double>& b, glm::ivec2 lag) {
    const double mean_a = mean(a), mean_b = mean(b);
    double both = 0.0, squares_a = 0.0, squares_b = 0.0;
    for (int y = 0; y + lag.y < k_side; ++y)
        for (int x = 0; x + lag.x < k_side; ++x) {
            const double first = a[static_cast<std::size_t>(y * k_side + x)] - mean_a;
            const double second = b[static_cast<std::size_t>((y + lag.y) * k_side + x + lag.x)] - mean_b;
            both += first * second;
            squares_a += first * first;
            squares_b += second * second;
        }
    return both / std::sqrt(squares_a * squares_b);
}

TEST(StrandChance, IsEvenAndNoNeighboursFollowOneAnother) {
    const std::function<double(glm::uvec2)> kinds[] = {
        [](glm::uvec2 key) { return static_cast<double>(numerics::windrow_fraction(key.x)); },
        [](glm::uvec2 key) { return static_cast<double>(numerics::windrow_fraction(key.y)); },
        [](glm::uvec2 key) { return static_cast<double>(numerics::windrow_strand_chance(key)); },
        [](glm::uvec2 key) { return static_cast<double>(numerics::windrow_strand_other_chance(key)); }};
    for (const glm::ivec2 corner : {glm::ivec2(0, 0), glm::ivec2(-500, -500), glm::ivec2(123456, -654321)}) {
        std::vector<std::vector<double>> fields;
        for (const auto& kind : kinds)
            fields.push_back(field_of(kind, corner));
        double off_mean = 0.0, lagged = 0.0, crossed = 0.0;
        for (std::size_t a = 0; a < 4; ++a) {
            off_mean = std::max(off_mean, std::abs(mean(fields[a]) - 0.5));
            for (const glm::ivec2 lag : {glm::ivec2(1, 0), glm::ivec2(0, 1), glm::ivec2(1, 1)})
                lagged = std::max(lagged, std::abs(correlation(fields[a], fields[a], lag)));
            for (std::size_t b = 0; b < a; ++b)
                crossed = std::max(crossed, std::abs(correlation(fields[a], fields[b], {0, 0})));
        }
        const std::string name = "shells/chance/" + std::to_string(corner.x);
        WINDROW_EXPECT_FIGURE(name + "/mean_off_half", off_mean, 0.005);
        WINDROW_EXPECT_FIGURE(name + "/lag_1_correlation", lagged, 0.01);
        WINDROW_EXPECT_FIGURE(name + "/between_chances", crossed, 0.01);
    }
}

// 000's seed x + 100 y gave 90 % of the cells at density 1000 a number that other cells had.
TEST(StrandChance, NoKeyRepeatsAmongAMillionCells) {
    std::vector<std::uint64_t> keys;
    std::vector<std::uint32_t> lengths;
    for (int y = -k_side / 2; y < k_side / 2; ++y)
        for (int x = -k_side / 2; x < k_side / 2; ++x) {
            const glm::uvec2 key = numerics::windrow_strand_key(0u, {x, y});
            keys.push_back(static_cast<std::uint64_t>(key.x) << 32u | key.y);
            lengths.push_back(static_cast<std::uint32_t>(numerics::windrow_strand_chance(key) * 16777216.0f));
        }
    std::sort(keys.begin(), keys.end());
    EXPECT_EQ(std::adjacent_find(keys.begin(), keys.end()), keys.end());
    // Lengths have 2^24 values, so that 1 - exp(-1e6 / 2^24) = 5.8 % of random ones equal that of another cell.
    std::sort(lengths.begin(), lengths.end());
    std::size_t shared = 0;
    for (std::size_t n = 0; n < lengths.size(); ++n)
        shared += (n > 0 && lengths[n] == lengths[n - 1]) || (n + 1 < lengths.size() && lengths[n] == lengths[n + 1]);
    const double expected = 1.0 - std::exp(-static_cast<double>(lengths.size()) / 16777216.0);
    WINDROW_EXPECT_FIGURE("shells/chance/shared_lengths_off_chance",
                          std::abs(static_cast<double>(shared) / static_cast<double>(lengths.size()) - expected), 0.002);
}

// No stretch of a row stands anywhere else: a repeat by any shift, also a diagonal one, would show.
TEST(StrandChance, NoTwoCellsHaveTheSameNeighbours) {
    std::vector<std::uint64_t> pairs;
    for (int y = 0; y < k_side; ++y)
        for (int x = 0; x < k_side; ++x) {
            const auto coarse = [&](int dx, int dy) {
                const float chance = numerics::windrow_strand_chance(numerics::windrow_strand_key(0u, {x + dx, y + dy}));
                return static_cast<std::uint64_t>(chance * 2097152.0f);
            };
            pairs.push_back(coarse(0, 0) << 42u | coarse(1, 0) << 21u | coarse(0, 1));
        }
    std::sort(pairs.begin(), pairs.end());
    EXPECT_EQ(std::adjacent_find(pairs.begin(), pairs.end()), pairs.end());
}

// In space: layers of a lattice are as foreign to one another as cells of one layer.
TEST(StrandChance, InSpaceHasNoRepeatsAndNoLags) {
    constexpr int k_edge = 100;
    std::vector<std::uint64_t> keys;
    std::vector<double> lengths;
    for (int z = 0; z < k_edge; ++z)
        for (int y = 0; y < k_edge; ++y)
            for (int x = 0; x < k_edge; ++x) {
                const glm::uvec2 key = numerics::windrow_space_hash(3u, glm::ivec3(x, y, z) - 50);
                keys.push_back(static_cast<std::uint64_t>(key.x) << 32u | key.y);
                lengths.push_back(static_cast<double>(numerics::windrow_strand_chance(key)) - 0.5);
            }
    double largest = 0.0, squares = 0.0;
    for (const double value : lengths)
        squares += value * value;
    for (const int lag : {1, k_edge, k_edge * k_edge}) {
        double both = 0.0;
        for (std::size_t n = static_cast<std::size_t>(lag); n < lengths.size(); ++n)
            both += lengths[n] * lengths[n - static_cast<std::size_t>(lag)];
        largest = std::max(largest, std::abs(both / squares));
    }
    WINDROW_EXPECT_FIGURE("shells/chance/space_lag_1_correlation", largest, 0.01);
    std::sort(keys.begin(), keys.end());
    EXPECT_EQ(std::adjacent_find(keys.begin(), keys.end()), keys.end());
}

} // namespace
} // namespace windrow::vegetation::fur
