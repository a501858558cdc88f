// Memory of chunks: 28 bytes a blade at most, and bounded over a long walk.
#include "tests/figure.h"
#include "vegetation/grass/chunk_cache.h"
#include "vegetation/tests/grass/fields.h"

#include <algorithm>
#include <set>
#include <vector>

namespace windrow::vegetation::grass {
namespace {

TEST(GrassMemory, OfAChunkIsBounded) {
    const GrassSettings settings;
    ASSERT_EQ(settings.chunk_cells * settings.chunk_cells, 9216);
    // Records and one index list, 28 bytes a blade; the shadow's own list is within it.
    WINDROW_EXPECT_FIGURE("grass/memory/bytes_of_a_chunk_of_9216", static_cast<double>(chunk_bytes(settings)), 258'048);
}

TEST(GrassMemory, StaysOverALongWalk) {
    const HeightMap heights = *HeightMap::create({251, 251}, 2.0f, [](glm::vec2 p) { return 5.0f * std::sin(0.03f * p.y); });
    const PlacementMask mask = *PlacementMask::create({65, 65}, heights.extent(), 1.0f);
    const GrassSettings settings;
    const ChunkTree tree(heights, mask, settings, blade_reach(settings));
    ChunkCache cache(tree.chunks(), settings.max_chunks);
    std::vector<Chunk> found;
    std::size_t rejected = 0, shared = 0, made = 0, asked = 0;
    int most = 0;
    for (int step = 0; step < 1000; ++step) { // a loop through the field, turning
        const float way = static_cast<float>(step) * 0.00628f;
        const glm::vec2 place = heights.extent() * (0.5f + 0.4f * glm::vec2(std::cos(way), std::sin(way)));
        const float yaw = 5.0f * way;
        const test::Eye eye =
            test::eye_at({place.x, heights.height(place) + 1.7f, place.y}, {std::cos(yaw), -0.1f, std::sin(yaw)});
        tree.visible(frustum_planes(eye.view_projection, glm::dvec3(0.0)), eye.at, settings.cut_distance, found);
        cache.begin_frame();
        std::set<int> slots;
        for (const Chunk chunk : found) {
            const ChunkCache::Given given = cache.ask(chunk);
            ++asked;
            rejected += given.slot < 0;
            made += given.made;
            shared += !slots.insert(given.slot).second; // two chunks of one frame in one slot
            rejected += given.slot >= settings.max_chunks || cache.slot_of(chunk) != given.slot;
        }
        most = std::max(most, cache.resident());
    }
    windrow::test::figure("grass/memory/walk_most_chunks", most);
    WINDROW_EXPECT_FIGURE("grass/memory/walk_rejected", static_cast<double>(rejected), 0);
    WINDROW_EXPECT_FIGURE("grass/memory/walk_slots_shared", static_cast<double>(shared), 0);
    windrow::test::figure("grass/memory/walk_most_bytes", static_cast<double>(most) * static_cast<double>(chunk_bytes(settings)));
    windrow::test::figure("grass/memory/walk_made_over_asked", static_cast<double>(made) / static_cast<double>(asked));
}

TEST(GrassMemory, GivesTheNearestASlotWhereThereAreTooFew) {
    ChunkCache cache({8, 8}, 3);
    cache.begin_frame();
    const Chunk chunks[] = {{{0, 0}}, {{1, 0}}, {{2, 0}}, {{3, 0}}};
    for (int n = 0; n < 3; ++n)
        EXPECT_EQ(cache.ask(chunks[n]).slot, n);
    EXPECT_EQ(cache.ask(chunks[3]).slot, -1);
    EXPECT_FALSE(cache.ask(chunks[1]).made);
    cache.begin_frame();
    EXPECT_FALSE(cache.ask(chunks[1]).made); // as it was
    EXPECT_FALSE(cache.ask(chunks[2]).made);
    const ChunkCache::Given given = cache.ask(chunks[3]); // takes the slot of the one that was not asked for
    EXPECT_TRUE(given.made);
    EXPECT_EQ(given.slot, 0);
    EXPECT_EQ(cache.slot_of(chunks[0]), -1);
    cache.forget({-5, -5}, {2, 50});
    EXPECT_EQ(cache.resident(), 1);
    EXPECT_EQ(cache.slot_of(chunks[3]), 0);
    EXPECT_TRUE(cache.ask(chunks[1]).made);
}

} // namespace
} // namespace windrow::vegetation::grass
