// Voxel grids: exact distances to their closed cells, what a segment passes through, and what is rejected.
#include "tests/shapes.h"
#include "tests/winds.h"

namespace windrow::test {
namespace {

VoxelData noise(glm::ivec3 cells, double closed, std::uint32_t seed) {
    Random random(seed);
    VoxelData data{.cells = cells, .closed = std::vector<std::uint8_t>(cell_count(cells))};
    for (std::uint8_t& value : data.closed)
        value = random.real(0.0, 1.0) < closed ? static_cast<std::uint8_t>(random.integer(1, 255)) : 0;
    data.closed[0] = 1;
    return data;
}

// Nearest box of the other kind, one by one.
float exact_distance(const VoxelGrid& grid, glm::vec3 p) {
    const glm::ivec3 cells = grid.data().cells, here(glm::floor(p));
    bool within = true;
    for (int axis = 0; axis < 3; ++axis)
        within = within && here[axis] >= 0 && here[axis] < cells[axis];
    const bool inside = within && grid.closed(here);
    float nearest = k_infinity;
    if (inside)
        for (int axis = 0; axis < 3; ++axis)
            nearest = std::min({nearest, p[axis], static_cast<float>(cells[axis]) - p[axis]});
    for_each_cell(cells, [&](int i, int j, int k) {
        if (grid.closed({i, j, k}) == inside)
            return;
        const glm::vec3 low(i, j, k), away = glm::max(glm::max(low - p, p - low - 1.0f), glm::vec3(0.0f));
        nearest = std::min(nearest, glm::length(away));
    });
    return inside ? -nearest : nearest;
}

TEST(VoxelGrid, DistancesAreExact) {
    const glm::ivec3 sizes[] = {{1, 1, 1}, {5, 3, 9}, {16, 16, 16}, {17, 2, 31}};
    for (const glm::ivec3 size : sizes)
        for (const double closed : {0.02, 0.5, 0.97}) {
            const auto grid = grid_of(noise(size, closed, 8));
            Random random(9);
            for (int n = 0; n < 500; ++n) {
                const glm::vec3 p = glm::vec3(size) * (0.5f + random.vector(0.8f));
                const float exact = exact_distance(*grid, p);
                ASSERT_NEAR(grid->distance_to(p), exact, 1e-5f) << size.x;
                ASSERT_NEAR(std::clamp(grid->distance_to(p, 1.5f), -1.5f, 1.5f), std::clamp(exact, -1.5f, 1.5f), 1e-5f);
            }
        }
}

TEST(VoxelGrid, IsCentredAndOfItsSize) {
    const VoxelShape block{grid_of({.cells = {4, 2, 6}, .closed = std::vector<std::uint8_t>(48, 1)}), 0.5f};
    const Block same{{1.0f, 0.5f, 1.5f}};
    Random random(10);
    for (int n = 0; n < 2'000; ++n) {
        const glm::vec3 p = random.vector(2.0f);
        ASSERT_NEAR(detail::distance_to(block, p), detail::distance_to(same, p), 1e-5f);
    }
    EXPECT_EQ(detail::half_extent(block), same.half_size);
    EXPECT_EQ(detail::thickness(block), 1.0f);
}

TEST(VoxelGrid, ASegmentIsBlockedByTheCellsItPasses) {
    const glm::ivec3 size(7, 9, 5);
    const auto grid = grid_of(noise(size, 0.15, 11));
    Random random(12);
    int blocked = 0;
    for (int n = 0; n < 400; ++n) {
        const glm::vec3 from = glm::vec3(size) * (0.5f + random.vector(0.7f)),
                        to = glm::vec3(size) * (0.5f + random.vector(0.7f));
        bool passes = false;
        double nearest = 1.0; // to a cell's surface: steps may miss a corner that is cut
        for (int k = 0; k <= 1'000; ++k) {
            const float d = exact_distance(*grid, glm::mix(from, to, static_cast<float>(k) / 1'000.0f));
            passes = passes || d < 0.0f;
            nearest = std::min(nearest, double(std::abs(d)));
            if (passes)
                break;
        }
        if (!passes && nearest < 0.04)
            continue;
        ASSERT_EQ(grid->crosses(from, to), passes) << n;
        blocked += passes ? 1 : 0;
    }
    EXPECT_GT(blocked, 100);
    EXPECT_LT(blocked, 380);
    // Straight through and along an edge where two cells meet at a corner.
    const auto corner = grid_of({.cells = {2, 2, 1}, .closed = {1, 0, 0, 1}});
    EXPECT_TRUE(corner->crosses({-1.0f, 3.0f, 0.5f}, {3.0f, -1.0f, 0.5f}))
        << "between two closed cells through their common edge";
    const auto gap = grid_of({.cells = {3, 1, 1}, .closed = {1, 0, 1}});
    EXPECT_FALSE(gap->crosses({1.5f, -2.0f, 0.5f}, {1.5f, 3.0f, 0.5f}));
    EXPECT_TRUE(gap->crosses({0.5f, -2.0f, 0.5f}, {0.5f, 3.0f, 0.5f}));
    EXPECT_FALSE(gap->crosses({0.5f, -2.0f, 0.5f}, {0.5f, -1.0f, 0.5f})) << "it ends before";
}

TEST(VoxelGrid, ThicknessIsTheShortestRow) {
    VoxelData room{.cells = {10, 8, 10}, .closed = std::vector<std::uint8_t>(800, 1)};
    for_each_cell({6, 4, 6},
                  [&](int i, int j, int k) { room.closed[static_cast<std::size_t>(((k + 2) * 8 + j + 2) * 10 + i + 2)] = 0; });
    EXPECT_EQ(grid_of(room)->thickness(), 2);
    room.closed[0] = 0;
    room.closed[static_cast<std::size_t>((1 * 8 + 1) * 10 + 1)] = 0;
    EXPECT_EQ(grid_of(room)->thickness(), 1);
}

TEST(VoxelGrid, WhatIsNoGridIsRejected) {
    const std::vector<std::uint8_t> eight(8, 1);
    const std::pair<VoxelData, std::string> bad[] = {
        {{}, "the voxel grid has (0, 0, 0) cells: give 1 to 4096 along each axis."},
        {{.cells = {2, -2, 2}, .closed = eight}, "the voxel grid has (2, -2, 2) cells: give 1 to 4096 along each axis."},
        {{.cells = {5000, 1, 1}}, "the voxel grid has (5000, 1, 1) cells: give 1 to 4096 along each axis."},
        {{.cells = {512, 512, 512}},
         "the voxel grid has (512, 512, 512) cells, 134217728 in all: give at most 16777216, by larger cells or by several "
         "grids."},
        {{.cells = {2, 2, 3}, .closed = eight}, "the voxel grid has (2, 2, 3) cells and 8 values: give 12, one a cell."},
        {{.cells = {2, 2, 2}, .closed = std::vector<std::uint8_t>(8)}, "the voxel grid has no closed cell: close one at least."},
    };
    for (const auto& [data, reason] : bad) {
        const auto made = VoxelGrid::create(data);
        ASSERT_FALSE(made) << reason;
        EXPECT_EQ(made.error(), reason);
    }
}

TEST(VoxelGrid, IsWhatItHolds) {
    const VoxelData data = noise({6, 7, 8}, 0.5, 13);
    const auto one = grid_of(data), again = grid_of(data), back = grid_of(one->data());
    EXPECT_TRUE(*one == *again);
    EXPECT_TRUE(*one == *back) << "closed cells are 1";
    VoxelData other = data;
    other.closed[77] = other.closed[77] == 0 ? 1 : 0;
    EXPECT_FALSE(*one == *grid_of(other));
    EXPECT_FALSE(*grid_of({.cells = {2, 3, 1}, .closed = std::vector<std::uint8_t>(6, 1)}) ==
                 *grid_of({.cells = {3, 2, 1}, .closed = std::vector<std::uint8_t>(6, 1)}));
}

} // namespace
} // namespace windrow::test
