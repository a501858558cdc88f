// Chunks of a view cover the grass once, hold every visible blade and none beyond the cut: against every blade of the field.
#include "tests/figure.h"
#include "tests/tier.h"
#include "vegetation/grass/chunk_tree.h"
#include "vegetation/tests/grass/fields.h"

#include <algorithm>
#include <map>
#include <vector>

namespace windrow::vegetation::grass {
namespace {

using windrow::test::Random;

const Planes k_everything{glm::vec4(0.0f, 0.0f, 0.0f, 1.0f), glm::vec4(0.0f, 0.0f, 0.0f, 1.0f),
                          glm::vec4(0.0f, 0.0f, 0.0f, 1.0f), glm::vec4(0.0f, 0.0f, 0.0f, 1.0f),
                          glm::vec4(0.0f, 0.0f, 0.0f, 1.0f), glm::vec4(0.0f, 0.0f, 0.0f, 1.0f)};

// The field once: blades of all cells.
struct ChunkField {
    explicit ChunkField(const GrassSettings& wanted = test::small_field())
        : settings(wanted), tree(heights, mask, settings, blade_reach(settings)), block(block_of(settings, heights, mask)) {
        for (int z = 0; z < tree.cells().y; ++z)
            for (int x = 0; x < tree.cells().x; ++x)
                blades.push_back(blade_at(block, heights, mask, {x, z}));
    }
    [[nodiscard]] const BladeRecord& blade(glm::ivec2 cell) const {
        return blades[static_cast<std::size_t>(cell.y) * tree.cells().x + cell.x];
    }
    /// Cells of a chunk that lie in the field.
    template <class Visit>
    void each_cell(Chunk chunk, const Visit& visit) const {
        const glm::ivec2 low = chunk.at * settings.chunk_cells, high = glm::min(low + settings.chunk_cells, tree.cells());
        for (int z = low.y; z < high.y; ++z)
            for (int x = low.x; x < high.x; ++x)
                visit(glm::ivec2(x, z));
    }

    HeightMap heights = test::hills();
    PlacementMask mask = test::glades(heights);
    GrassSettings settings;
    ChunkTree tree;
    Block block;
    std::vector<BladeRecord> blades;
};

TEST(GrassChunks, CoverTheGrassOnce) {
    const ChunkField field;
    std::vector<Chunk> found;
    field.tree.visible(k_everything, {40.0f, 0.0f, 56.0f}, 1e4f, found);
    std::vector<int> drawn(field.blades.size());
    for (const Chunk chunk : found)
        field.each_cell(chunk,
                        [&](glm::ivec2 cell) { ++drawn[static_cast<std::size_t>(cell.y) * field.tree.cells().x + cell.x]; });
    double drawn_area = 0.0, grass_area = 0.0;
    int bare_chunks = field.tree.chunks().x * field.tree.chunks().y - static_cast<int>(found.size());
    for (std::size_t n = 0; n < drawn.size(); ++n)
        if (field.blades[n].w > 0.0f) {
            drawn_area += drawn[n];
            grass_area += 1.0;
        }
    const double ratio = drawn_area / grass_area;
    WINDROW_EXPECT_FIGURE("grass/chunks/drawn_area_over_grass_area_less_1", std::abs(ratio - 1.0), 0.0);
    windrow::test::figure("grass/chunks/drawn_area_over_grass_area", ratio);
    windrow::test::figure("grass/chunks/share_of_chunks_without_grass",
                          bare_chunks / (bare_chunks + static_cast<double>(found.size())));
    EXPECT_GT(bare_chunks, 0); // the tree is where grass is
    // A chunk without a blade may be drawn where the mask is above 0 between the places: none here.
    for (const Chunk chunk : found) {
        int blades = 0;
        field.each_cell(chunk, [&](glm::ivec2 cell) { blades += field.blade(cell).w > 0.0f; });
        EXPECT_GT(blades, 0) << chunk.at.x << " " << chunk.at.y;
    }
}

TEST(GrassChunks, OfRandomCamerasHoldEveryBladeThatIsSeenOnce) {
    const ChunkField field;
    Random random(11);
    std::vector<Chunk> found;
    const int k_cameras = windrow::test::sampled(300, 80);
    std::size_t kept = 0, visible = 0, in_chunks = 0, missed = 0, twice = 0, beyond = 0;
    double largest_ratio = 0.0;
    for (int camera = 0; camera < k_cameras; ++camera) {
        const test::Eye eye = test::random_eye(random, field.heights);
        const Planes planes = frustum_planes(eye.view_projection, glm::dvec3(0.0));
        field.tree.visible(planes, eye.at, field.block.reach.w, found);
        std::map<std::pair<int, int>, int> times;
        for (const Chunk chunk : found) {
            twice += ++times[{chunk.at.x, chunk.at.y}] > 1;
            beyond += !(distance_to(field.tree.box(chunk), eye.at) < field.block.reach.w);
            field.each_cell(chunk, [&](glm::ivec2 cell) { in_chunks += field.blade(cell).w > 0.0f; });
        }
        std::size_t kept_here = 0, visible_here = 0;
        for (int z = 0; z < field.tree.cells().y; ++z)
            for (int x = 0; x < field.tree.cells().x; ++x) {
                const glm::ivec2 cell{x, z};
                const BladeRecord& blade = field.blade(cell);
                const bool keeps = test::level_of(field.block, planes, eye.at, blade) !=
                                   windrow::numerics::windrow_grass_level(1e9f, field.block.reach);
                if (!keeps) // nothing that shows is dropped: checked on a tenth of the blades, which is 30 of 300 cameras' worth
                    missed += (x + 7 * z) % 10 == 0 && test::shows(field.block, eye, cell, blade);
                else {
                    ++kept_here;
                    visible_here += test::shows(field.block, eye, cell, blade);
                    missed += !times.contains({x / field.settings.chunk_cells, z / field.settings.chunk_cells});
                }
            }
        kept += kept_here;
        visible += visible_here;
        if (visible_here > 1000)
            largest_ratio = std::max(largest_ratio, static_cast<double>(kept_here) / static_cast<double>(visible_here));
    }
    WINDROW_EXPECT_FIGURE("grass/chunks/drawn_twice", static_cast<double>(twice), 0.0);
    WINDROW_EXPECT_FIGURE("grass/chunks/blades_missed", static_cast<double>(missed), 0.0);
    WINDROW_EXPECT_FIGURE("grass/chunks/beyond_the_cut", static_cast<double>(beyond), 0.0);
    // Culling: blades kept over blades visible, of all cameras and of the worst one.
    WINDROW_EXPECT_FIGURE("grass/culling/kept_over_visible", static_cast<double>(kept) / static_cast<double>(visible), 1.3);
    windrow::test::figure("grass/culling/kept_over_visible_of_one_camera", largest_ratio);
    windrow::test::figure("grass/chunks/in_chunks_over_kept", static_cast<double>(in_chunks) / static_cast<double>(kept));
    EXPECT_GT(visible, 333u * static_cast<std::size_t>(k_cameras));
}

TEST(GrassChunks, AreCutByTheDistanceToTheirBoxAndComeNearestFirst) {
    const ChunkField field;
    Random random(13);
    std::vector<Chunk> found;
    std::size_t wrong = 0;
    for (int n = 0; n < 200; ++n) {
        const glm::vec3 eye{random.uniform(-40.0f, 120.0f), random.uniform(-20.0f, 60.0f), random.uniform(-40.0f, 150.0f)};
        const float cut = random.uniform(1.0f, 80.0f);
        field.tree.visible(k_everything, eye, cut, found);
        float before = 0.0f;
        std::size_t there = 0;
        for (const Chunk chunk : found) {
            const float distance = distance_to(field.tree.box(chunk), eye);
            wrong += distance < before;
            before = distance;
        }
        for (int z = 0; z < field.tree.chunks().y; ++z)
            for (int x = 0; x < field.tree.chunks().x; ++x)
                there += field.tree.grows({{x, z}}) && distance_to(field.tree.box({{x, z}}), eye) < cut;
        wrong += there != found.size();
    }
    WINDROW_EXPECT_FIGURE("grass/chunks/wrong_by_distance", static_cast<double>(wrong), 0.0);
}

TEST(GrassChunks, FollowTheMask) {
    ChunkField field;
    std::vector<Chunk> found;
    const auto touched = field.mask.erase({.centre = {22.0f, 25.0f}, .radius = 60.0f, .hardness = 1.0f});
    ASSERT_TRUE(touched);
    field.tree.refresh(field.heights, field.mask, *touched);
    const ChunkTree fresh(field.heights, field.mask, field.settings, blade_reach(field.settings));
    std::vector<Chunk> wanted;
    field.tree.visible(k_everything, glm::vec3(0.0f), 1e4f, found);
    fresh.visible(k_everything, glm::vec3(0.0f), 1e4f, wanted);
    EXPECT_EQ(found, wanted);
    EXPECT_FALSE(found.empty());
    (void)field.mask.apply([](glm::vec2, float) { return 0.0f; });
    field.tree.refresh(field.heights, field.mask, {glm::vec2(-1e3f), glm::vec2(1e3f)});
    field.tree.visible(k_everything, glm::vec3(0.0f), 1e4f, found);
    EXPECT_TRUE(found.empty());
}

// 500 m x 500 m at 6 a metre: 9e6 places. A frame visits a few hundred nodes on the CPU.
TEST(GrassChunks, OfALargeFieldAreFew) {
    const auto heights = HeightMap::create({251, 251}, 2.0f, [](glm::vec2 p) { return 10.0f * std::sin(0.02f * p.x); });
    ASSERT_TRUE(heights);
    const auto mask = PlacementMask::create({257, 257}, heights->extent(), 1.0f);
    ASSERT_TRUE(mask);
    const GrassSettings settings;
    const ChunkTree tree(*heights, *mask, settings, blade_reach(settings));
    windrow::test::figure("grass/large/places", static_cast<double>(tree.cells().x) * tree.cells().y);
    EXPECT_EQ(tree.cells(), glm::ivec2(3000, 3000));
    Random random(17);
    std::vector<Chunk> found;
    std::size_t most = 0;
    for (int n = 0; n < 2000; ++n) {
        const test::Eye eye = test::random_eye(random, *heights);
        tree.visible(frustum_planes(eye.view_projection, glm::dvec3(0.0)), eye.at, settings.cut_distance, found);
        most = std::max(most, found.size());
    }
    // The default slots hold any of these views.
    WINDROW_EXPECT_FIGURE("grass/large/max_chunks_of_a_view", static_cast<double>(most), settings.max_chunks);
}

} // namespace
} // namespace windrow::vegetation::grass
