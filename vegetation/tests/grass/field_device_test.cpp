// The passes of a field against the CPU: blades, counts and lists; memory over a walk; a mask that changes.
#include "tests/figure.h"
#include "vegetation/tests/grass/device.h"

#include <algorithm>
#include <limits>
#include <string>

namespace windrow::vegetation::grass {
namespace {

using test::GrassOnTheDevice;
using windrow::test::Random;

// What a view of a chunk should draw, in order.
struct Expected {
    std::vector<std::uint32_t> levels[2];
};

TEST_F(GrassOnTheDevice, MakesTheBladesOfTheCpu) {
    GrassSettings settings = test::small_field();
    settings.cut_distance = 250.0f; // the whole field
    make_field(settings);
    const Block block = block_of(field->settings(), heights, mask);
    const test::Eye eye = test::eye_at({40.0f, 30.0f, -40.0f}, {0.0f, -0.3f, 1.0f}, 1.6f);
    const GrassReport report = cull({.view_projection = eye.view_projection, .eye = eye.at});
    EXPECT_GT(report.made_chunks, 20);
    EXPECT_EQ(report.left_out, 0);
    const auto blades = values_of<BladeRecord>(field->blade_buffer(), slots() * places());
    double place = 0.0, size = 0.0;
    std::size_t compared = 0, apart = 0;
    const int side = field->settings().chunk_cells;
    for (int z = 0; z < field->tree().chunks().y; ++z)
        for (int x = 0; x < field->tree().chunks().x; ++x) {
            const int slot = field->slot_of({{x, z}});
            for (int n = 0; slot >= 0 && n < side * side; ++n) {
                const BladeRecord cpu = blade_at(block, heights, mask, glm::ivec2(x, z) * side + glm::ivec2(n % side, n / side));
                const BladeRecord gpu = blades[static_cast<std::size_t>(slot) * places() + static_cast<std::size_t>(n)];
                ++compared;
                apart += cpu != gpu;
                place = std::max(place, static_cast<double>(glm::length(glm::vec3(cpu) - glm::vec3(gpu))));
                size = std::max(size, static_cast<double>(std::abs(cpu.w - gpu.w)));
                ASSERT_EQ(cpu.w > 0.0f, gpu.w > 0.0f);
            }
        }
    EXPECT_GT(compared, 50'000u);
    WINDROW_EXPECT_FIGURE("grass/gpu/blade_place_error_m", place, 1e-4); // places to 112 m in floats, products that may fuse
    WINDROW_EXPECT_FIGURE("grass/gpu/blade_size_error", size, 1e-5);
    windrow::test::figure("grass/gpu/blades_that_differ_in_a_bit", static_cast<double>(apart));
}

TEST_F(GrassOnTheDevice, KeepsTheBladesOfTheCpuInOrder) {
    make_field();
    const Block block = block_of(field->settings(), heights, mask);
    Random random(23);
    std::size_t kept = 0, wrong = 0;
    for (int camera = 0; camera < 6; ++camera) {
        const test::Eye eye = test::random_eye(random, heights);
        const test::Eye sun = test::eye_at(eye.at + glm::vec3(5.0f, 25.0f, 5.0f), {-0.2f, -1.0f, -0.2f}, 0.8f);
        (void)cull({.view_projection = eye.view_projection, .eye = eye.at, .shadow_view_projection = sun.view_projection});
        const auto blades = values_of<BladeRecord>(field->blade_buffer(), slots() * places());
        const auto lists = values_of<std::uint32_t>(field->list_buffer(), 2 * slots() * places());
        const auto commands = draws();
        const Planes planes[] = {frustum_planes(eye.view_projection, glm::dvec3(0.0)),
                                 frustum_planes(sun.view_projection, glm::dvec3(0.0))};
        for (std::size_t view = 0; view < 2; ++view) {
            std::vector<Chunk> chunks;
            field->tree().visible(planes[view], eye.at, view == 0 ? block.reach.w : block.ground.z, chunks);
            for (const Chunk chunk : chunks) {
                const auto slot = static_cast<std::size_t>(field->slot_of(chunk));
                Expected expected;
                for (std::size_t n = 0; n < places(); ++n) {
                    const BladeRecord& blade = blades[slot * places() + n];
                    const int level = test::level_of(block, planes[view], eye.at, blade);
                    const bool near_enough = view == 0 || glm::length(glm::vec3(blade) - eye.at) < block.ground.z;
                    if (level < 2 && near_enough)
                        expected.levels[level].push_back(static_cast<std::uint32_t>(n));
                }
                const std::size_t list = 2 * slot + view;
                for (std::size_t level = 0; level < 2; ++level) {
                    const VkDrawIndirectCommand& command = commands[2 * list + level];
                    const auto& levels = expected.levels[level];
                    kept += command.instanceCount;
                    wrong += command.instanceCount != levels.size() || command.vertexCount != (level == 0 ? 15u : 7u) ||
                             command.firstVertex != 0 || command.firstInstance != 0;
                    for (std::size_t n = 0; n < levels.size(); ++n)
                        wrong += lists[level == 0 ? list * places() + n : (list + 1) * places() - 1 - n] != levels[n];
                }
            }
        }
    }
    windrow::test::figure("grass/gpu/blades_kept_by_six_cameras", static_cast<double>(kept));
    EXPECT_GT(kept, 10'000u);
    WINDROW_EXPECT_FIGURE("grass/gpu/list_entries_unlike_the_cpus", static_cast<double>(wrong), 0);
}

TEST_F(GrassOnTheDevice, NeedsNoMoreMemoryOverAWalk) {
    GrassSettings settings = test::small_field();
    settings.max_chunks = 60; // fewer than the field has, so that slots change hands
    make_field(settings);
    const std::uint64_t before = field->memory_bytes();
    Random random(29);
    int made = 0, left_out = 0;
    test::Eye eye;
    for (int step = 0; step < 150; ++step) {
        const float way = 0.0419f * static_cast<float>(step);
        const glm::vec2 place = heights.extent() * (0.5f + 0.4f * glm::vec2(std::cos(way), std::sin(way)));
        eye = test::eye_at({place.x, heights.height(place) + 1.7f, place.y}, {std::cos(3.0f * way), -0.1f, std::sin(3.0f * way)});
        const GrassReport report = cull({.view_projection = eye.view_projection, .eye = eye.at});
        made += report.made_chunks;
        left_out += report.left_out;
    }
    EXPECT_GT(made, 60);
    WINDROW_EXPECT_FIGURE("grass/gpu/walk_left_out", left_out, 0);
    WINDROW_EXPECT_FIGURE("grass/gpu/walk_bytes_grown", static_cast<double>(field->memory_bytes() - before), 0);
    // Chunks and orders, frame, heights and mask; allocations round up.
    const double accounted =
        60.0 * (static_cast<double>(chunk_bytes(settings)) + 32.0) + sizeof(Block) + 4.0 * (81 * 113 + 129 * 129);
    WINDROW_EXPECT_FIGURE("grass/gpu/bytes_over_own_accounting", static_cast<double>(field->memory_bytes()) - accounted,
                          8 * 4096);
    // What the slots hold after changing hands is what a fresh field makes.
    const auto walked = draws();
    std::vector<Chunk> chunks;
    field->tree().visible(frustum_planes(eye.view_projection, glm::dvec3(0.0)), eye.at, settings.cut_distance, chunks);
    std::vector<std::uint32_t> counts;
    for (const Chunk chunk : chunks)
        counts.push_back(walked[4 * static_cast<std::size_t>(field->slot_of(chunk))].instanceCount);
    make_field(settings);
    (void)cull({.view_projection = eye.view_projection, .eye = eye.at});
    const auto fresh = draws();
    for (std::size_t n = 0; n < chunks.size(); ++n)
        EXPECT_EQ(fresh[4 * static_cast<std::size_t>(field->slot_of(chunks[n]))].instanceCount, counts[n]);
}

TEST_F(GrassOnTheDevice, LeavesTheFarthestOutWhereSlotsAreFew) {
    GrassSettings settings = test::small_field();
    settings.max_chunks = 5;
    make_field(settings);
    const test::Eye eye = test::eye_at({40.0f, 8.0f, 20.0f}, {0.0f, -0.2f, 1.0f}, 1.2f);
    std::vector<Chunk> chunks;
    field->tree().visible(frustum_planes(eye.view_projection, glm::dvec3(0.0)), eye.at, settings.cut_distance, chunks);
    ASSERT_GT(chunks.size(), 5u);
    for (int frame = 0; frame < 3; ++frame) {
        const GrassReport report = cull({.view_projection = eye.view_projection, .eye = eye.at});
        EXPECT_EQ(report.colour_chunks, 5);
        EXPECT_EQ(report.left_out, static_cast<int>(chunks.size()) - 5);
    }
    for (std::size_t n = 0; n < 5; ++n)
        EXPECT_GE(field->slot_of(chunks[n]), 0) << n;
}

TEST_F(GrassOnTheDevice, FollowsAMaskThatChanges) {
    make_field();
    const test::Eye eye = test::eye_at({20.0f, 20.0f, 25.0f}, {0.01f, -1.0f, 0.01f}, 1.4f);
    const GrassCamera camera{.view_projection = eye.view_projection, .eye = eye.at};
    (void)cull(camera);
    const Block block = block_of(field->settings(), heights, mask);
    const auto touched = mask.erase({.centre = {20.0f, 20.0f}, .radius = 9.0f, .hardness = 1.0f});
    ASSERT_TRUE(touched);
    ASSERT_TRUE(field->repaint(mask, *touched));
    const GrassReport report = cull(camera);
    EXPECT_GT(report.made_chunks, 0);
    EXPECT_LT(report.made_chunks, 16); // those that the stroke touched, not all
    const auto blades = values_of<BladeRecord>(field->blade_buffer(), slots() * places());
    std::size_t wrong = 0, seen = 0;
    const int side = field->settings().chunk_cells;
    for (int z = 0; z < field->tree().chunks().y; ++z)
        for (int x = 0; x < field->tree().chunks().x; ++x) {
            const int slot = field->slot_of({{x, z}});
            for (int n = 0; slot >= 0 && n < side * side; ++n, ++seen) {
                const BladeRecord cpu = blade_at(block, heights, mask, glm::ivec2(x, z) * side + glm::ivec2(n % side, n / side));
                const BladeRecord gpu = blades[static_cast<std::size_t>(slot) * places() + static_cast<std::size_t>(n)];
                wrong += std::abs(cpu.w - gpu.w) > 1e-5f;
            }
        }
    EXPECT_GT(seen, 10'000u);
    WINDROW_EXPECT_FIGURE("grass/gpu/sizes_wrong_after_a_stroke", static_cast<double>(wrong), 0);
}

TEST_F(GrassOnTheDevice, RejectsWhatItCannotUse) {
    make_field();
    const auto other = *PlacementMask::create({9, 9}, {10.0f, 10.0f});
    const auto unfit = GrassField::create(*renders, heights, other, {.density = -1.0f});
    ASSERT_FALSE(unfit);
    EXPECT_NE(unfit.error().find("grass.density"), std::string::npos);
    EXPECT_NE(unfit.error().find("heights.extent()"), std::string::npos);
    GrassSettings huge;
    huge.max_chunks = 32767; // 4.8 GB of blades
    huge.chunk_cells = 256;
    const auto too_large = GrassField::create(*renders, heights, mask, huge);
    ASSERT_FALSE(too_large);
    EXPECT_NE(too_large.error().find("grass.max_chunks"), std::string::npos);
    const auto steppe = *HeightMap::create({2, 2}, 1e3f, [](glm::vec2) { return 0.0f; });
    const auto endless = GrassField::create(*renders, steppe, *PlacementMask::create({2, 2}, steppe.extent()),
                                            {.density = 64.0f, .chunk_cells = 8});
    ASSERT_FALSE(endless);
    EXPECT_NE(endless.error().find("at most 2^22 chunks"), std::string::npos);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(field->place({0.0, nan, 0.0}));
    EXPECT_FALSE(field->repaint(other, {glm::vec2(0.0f), glm::vec2(1.0f)}));
    EXPECT_FALSE(field->record_cull(VK_NULL_HANDLE, {}));
    run([&](VkCommandBuffer commands) {
        EXPECT_FALSE(field->record_cull(commands, {.anchor = {nan, 0.0, 0.0}}));
        EXPECT_FALSE(field->record_cull(commands, {.view_projection = glm::mat4(std::numeric_limits<float>::infinity())}));
    });
}

} // namespace
} // namespace windrow::vegetation::grass
