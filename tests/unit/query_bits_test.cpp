// The bits of queries, pinned: the same on every machine, with every compiler, on every SIMD level. The kernels are asked alone, with
// cells and texels that need no function of a C library. Seen so with g++ and clang++ on x86, and with g++ for ARM64.

#include "fluid/cpu/kernels/kernels.h"
#include "fluid/cpu/point_tasks.h"
#include "tests/fields.h"

#include <array>
#include <cstdint>
#include <cstdio>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace {

using namespace windrow;
using namespace windrow::cpu;
using namespace windrow::test;

constexpr int k_cells[3] = {20, 12, 16};
constexpr std::size_t k_points = 20'000;

std::uint64_t hash_of(const std::vector<float>& values) { // FNV-1a
    std::uint64_t hash = 14695981039346656037u;
    for (const float value : values)
        for (int byte = 0; byte < 4; ++byte)
            hash = (hash ^ ((__builtin_bit_cast(std::uint32_t, value) >> (8 * byte)) & 0xffu)) * 1099511628211u;
    return hash;
}

std::vector<float> noise(std::size_t vectors, float size, std::uint32_t seed) {
    Random random(seed);
    std::vector<float> values(4 * vectors);
    for (std::size_t n = 0; n < values.size(); ++n)
        values[n] = n % 4 < 3 ? random.uniform(-size, size) : 0.0f;
    return values;
}

enum class Kind { blended, walled, periodic, in_rows };

struct Asked {
    std::vector<float> field = noise(20 * 12 * 16, 5.0f, 1), tile = noise(128 * 16 * 128, 1.0f, 2);
    std::vector<double> rows{-0.2}, points;
    PointTask task{};
    FeltTask felt{};

    explicit Asked(Kind kind) {
        for (int row = 0; row < 13; ++row)
            rows.push_back(0.2 + 0.4 * row + 0.03 * row * row);
        task.per_cell = 1.0 / 0.3;
        task.field = field.data();
        for (int a = 0; a < 3; ++a) {
            PointAxis& axis = task.axis[a];
            axis.cells = k_cells[a];
            axis.low_kind = axis.high_kind = kind == Kind::walled ? 1.0f : kind == Kind::periodic ? 2.0f : 0.0f;
            axis.reach = kind == Kind::blended ? 0.45f * static_cast<float>(k_cells[a]) : 0.0f;
            axis.per_width = 0.37f;
            axis.origin = 3333.0 * a;
            axis.point = axis.origin + 0.51 * k_cells[a];
            axis.period = period_of(k_cells[a]);
        }
        if (kind == Kind::in_rows) {
            task.row_heights = rows.data();
            task.rows = k_cells[1];
            task.bottom = 3333.0 * 0.3;
            task.top = 9.0;
        }
        task.ambient = {.mean = {5.0f, 0.3f, -2.0f, 0.0f},
                        .roughness_length = 0.03f,
                        .reference_height = 10.0f,
                        .gust_strength = 1.7f,
                        .gust_axes = {1.0f, 1.0f, 1.0f, 0.0f},
                        .tile = tile.data(),
                        .ground = 990.0,
                        .lowest = -1e12,
                        .highest = 1e12,
                        .gusts = {axis_of(0), axis_of(1), axis_of(2)}};
        felt = {.strength = 1.2f,
                .limit = 7.0f,
                .detail_amount = 0.4f,
                .longest = 1.7f,
                .tile = tile.data(),
                .detail = {axis_of(0, 10.0), axis_of(1, 10.0), axis_of(2, 10.0)}};
        Random random(3);
        for (std::size_t n = 0; n < k_points; ++n)
            for (int a = 0; a < 3; ++a) {
                const double way = n % 171 == 0 ? 1e15 : n % 17 == 0 ? 1e5 : 0.0;
                points.push_back(0.3 * (3333.0 * a + k_cells[a] * random.real(-0.2, 1.2)) + way * random.real(-1.0, 1.0));
            }
        points[300] = std::numeric_limits<double>::quiet_NaN();
        points[601] = std::numeric_limits<double>::infinity();
    }

    static TileAxis axis_of(int axis, double repeats = 1.0) {
        const int texels = axis == 1 ? 2 * k_tile_height : k_tile_side;
        const double texel = 7.3 / 12.0;
        return {.origin = axis == 1 ? 990.0 : 0.0,
                .phase = axis == 1 ? 0.0 : 13.7,
                .texel = texel,
                .repeats = repeats,
                .period = period_of(texels * texel),
                .texels = period_of(texels)};
    }
};

struct Pinned {
    Kind kind;
    std::uint64_t wind, felt, ambient;
};
constexpr Pinned k_pinned[] = {
    {Kind::blended, 0x7e39c58804878711, 0xbe8793ff663fdada, 0x4bbe9239c5cec647},
    {Kind::walled, 0x5f0c7f133ccfa0e9, 0x5ad2e86cfccc154c, 0x4bbe9239c5cec647},
    {Kind::periodic, 0xf8ee3620d8794850, 0x4db81b765a7e860c, 0x4bbe9239c5cec647},
    {Kind::in_rows, 0xbec7b75dc9eb42bc, 0xb40e30b9e26efe1a, 0x4bbe9239c5cec647},
};

TEST(QueryBits, AreTheSameOnEveryMachineAndLevel) {
    for (const Pinned& pinned : k_pinned) {
        const Asked asked(pinned.kind);
        for (const Simd level : {Simd::baseline, Simd::avx2, Simd::avx512}) {
            if (!runs(level))
                continue;
            const Kernels& kernels = *kernels_for(level);
            std::vector<float> winds(3 * k_points), ambient(3 * k_points);
            kernels.sample_points(asked.task, asked.points.data(), k_points, 3, winds.data());
            kernels.sample_ambient(asked.task.ambient, asked.points.data(), k_points, 3, ambient.data());
            std::vector<float> felt = winds;
            kernels.feel(asked.felt, asked.points.data(), k_points, 3, felt.data());
            const std::array<std::uint64_t, 3> found{hash_of(winds), hash_of(felt), hash_of(ambient)},
                expected{pinned.wind, pinned.felt, pinned.ambient};
            std::printf("kind %d, %s: 0x%016llx, 0x%016llx, 0x%016llx\n", static_cast<int>(pinned.kind), name_of(level),
                        static_cast<unsigned long long>(found[0]), static_cast<unsigned long long>(found[1]),
                        static_cast<unsigned long long>(found[2]));
            EXPECT_EQ(found, expected) << name_of(level);
        }
    }
}

} // namespace
