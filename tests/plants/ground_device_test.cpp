// windrow::vulkan::GroundMemory against windrow::GroundMemory through their public calls: the same story, read as a renderer
// reads it.
#include "coupling/ground_memory.h"
#include "coupling/vulkan/ground_memory.h"
#include "shader_words/fill_leans.h"
#include "shader_words/sample_ground.h"
#include "tests/figure.h"
#include "tests/parity/gpu.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <random>

namespace windrow::vulkan {
namespace {

constexpr VkDescriptorType k_storage = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, k_texture = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;

bool says(const auto& result, const char* sentence) {
    return !result && result.error().find(sentence) != std::string::npos;
}

class GroundDevice : public Gpu {
  protected:
    struct TwoGrounds {
        windrow::GroundMemory cpu;
        GroundMemory gpu;
    };

    TwoGrounds make(const GroundConfig& config, Texel texel) {
        auto cpu = windrow::GroundMemory::create(config);
        auto gpu = GroundMemory::create(own->host(), config, texel);
        EXPECT_TRUE(cpu) << cpu.error();
        EXPECT_TRUE(gpu) << gpu.error();
        return {*std::move(cpu), *std::move(gpu)};
    }

    void follow(TwoGrounds& pair, glm::dvec3 point) {
        ASSERT_TRUE(pair.cpu.follow(point));
        ASSERT_TRUE(pair.gpu.follow(point));
    }

    void shift_origin(TwoGrounds& pair, glm::dvec3 offset) {
        ASSERT_TRUE(pair.cpu.shift_origin(offset));
        ASSERT_TRUE(pair.gpu.shift_origin(offset));
    }

    void advance(TwoGrounds& pair, const GroundStep& step) {
        ASSERT_TRUE(pair.cpu.advance(step));
        run([&](VkCommandBuffer commands) {
            const auto recorded = pair.gpu.record(commands, step);
            ASSERT_TRUE(recorded) << recorded.error();
        });
    }

    // Now and before of each place, by sample_ground.comp.
    std::vector<glm::vec4> sampled(const GroundMemory& ground, std::span<const glm::vec4> places, glm::dvec3 anchor) {
        const GroundBlock of_ground = ground.block(anchor);
        const Buffer in = uploaded(places), out = buffer(2 * places.size_bytes(), MemoryUse::readback),
                     block = uploaded(std::span(&of_ground, 1), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
        const Sampler sampler = nearest_sampler();
        dispatch(shader_words::sample_ground,
                 {{.type = k_storage, .buffer = in.handle()},
                  {.type = k_storage, .buffer = out.handle()},
                  {.type = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, .buffer = block.handle()},
                  {.type = k_texture, .view = ground.texture().view, .sampler = sampler.get()},
                  {.type = k_texture, .view = ground.previous_texture().view, .sampler = sampler.get()}},
                 places.size());
        return read<glm::vec4>(out, 2 * places.size());
    }

    struct GroundsApart {
        double worst = 0.0;   ///< largest difference of a component
        double largest = 0.0; ///< largest component
    };

    // Both at random places about `anchor`, inside the window and around it.
    GroundsApart compare(TwoGrounds& pair, glm::dvec3 anchor, std::uint32_t seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<float> place(-14.0f, 14.0f);
        std::vector<glm::vec4> places(4096);
        for (glm::vec4& p : places)
            p = {place(random), 0.0f, place(random), 0.0f};
        const auto found = sampled(pair.gpu, places, anchor);
        GroundsApart apart;
        for (std::size_t n = 0; n < places.size(); ++n)
            for (const bool before : {false, true}) {
                const glm::dvec3 at = anchor + glm::dvec3(places[n]);
                const GroundSample wanted = before ? pair.cpu.previous_at(at) : pair.cpu.at(at);
                const glm::vec4 cpu(wanted.lean.x, wanted.lean.y, wanted.trample, wanted.trail);
                for (int c = 0; c < 4; ++c) {
                    const auto gpu = static_cast<double>(found[2 * n + (before ? 1 : 0)][c]);
                    EXPECT_TRUE(std::isfinite(gpu));
                    apart.worst = std::max(apart.worst, std::abs(gpu - static_cast<double>(cpu[c])));
                    apart.largest = std::max(apart.largest, std::abs(static_cast<double>(cpu[c])));
                }
            }
        return apart;
    }

    // Walkers who wander, leap and jump, in gusts, while the window follows one of them.
    GroundsApart story(Texel texel, glm::dvec3 origin) {
        TwoGrounds pair = make({.texels = 96}, texel);
        std::mt19937 random(21);
        std::uniform_real_distribution<double> unit(-1.0, 1.0);
        std::vector<GroundWalker> walkers(12);
        for (GroundWalker& walker : walkers)
            walker.position = walker.previous = origin + 10.0 * glm::dvec3(unit(random), 0.0, unit(random));
        GroundsApart worst;
        for (int frame = 0; frame < 120; ++frame) {
            for (GroundWalker& walker : walkers) {
                walker.previous = walker.position;
                walker.previous_foot_height = walker.foot_height;
                walker.position = walker.position + 0.3 * glm::dvec3(unit(random), 0.0, unit(random));
                walker.foot_height = static_cast<float>(std::max(0.0, unit(random)));
                if (unit(random) > 0.95)
                    walker.position = walker.previous = origin + 10.0 * glm::dvec3(unit(random), 0.0, unit(random));
            }
            if (frame % 40 == 30) { // the world's origin moves, by no whole number of texels
                const glm::dvec3 offset(-700.3, 0.0, 31.7);
                shift_origin(pair, offset);
                origin += offset;
                for (GroundWalker& walker : walkers) {
                    walker.position += offset;
                    walker.previous += offset;
                }
            }
            follow(pair, frame == 60 ? origin + glm::dvec3(1000.0) : walkers[0].position);
            advance(pair, {.duration = 1.0 / 60.0, .walkers = walkers, .wind_lean = {0.4 * unit(random), 0.4 * unit(random)}});
            if (frame % 10 == 0 || frame == 61) {
                const GroundsApart apart = compare(pair, walkers[0].position, static_cast<std::uint32_t>(frame));
                worst = {std::max(worst.worst, apart.worst), std::max(worst.largest, apart.largest)};
            }
        }
        return worst;
    }
};

// Bound: that of the CPU against Vulkan over 100 steps, 1e-4 of the largest value.
TEST_F(GroundDevice, AStoryOfWalkersInGusts) {
    const GroundsApart near = story(Texel::single, {0.0, 0.0, 0.0});
    WINDROW_EXPECT_FIGURE("ground_device/story", near.worst / near.largest, 1e-4);
    EXPECT_GT(near.largest, 0.5);
}

TEST_F(GroundDevice, AStoryFarAway) {
    const GroundsApart far = story(Texel::single, {1e6, 0.0, -2e6});
    WINDROW_EXPECT_FIGURE("ground_device/story_far_away", far.worst / far.largest, 1e-4);
}

// A half has 11 bits: 2^-11 of values up to 2.
TEST_F(GroundDevice, HalfTexelsHoldTheSame) {
    const GroundsApart half = story(Texel::half, {0.0, 0.0, 0.0});
    WINDROW_EXPECT_FIGURE("ground_device/half", half.worst, 0x1p-10 + 1e-4);
}

// The largest lean that is taken, to and fro at the frequency of plants that nothing damps: they swing beyond what a half holds,
// and every sample is a number.
TEST_F(GroundDevice, HalfTexelsHoldTheLargestLean) {
    TwoGrounds pair = make({.texels = 64, .spring = {1.0, 0.0}}, Texel::half);
    run([&](VkCommandBuffer commands) { EXPECT_FALSE(pair.gpu.record(commands, {.duration = 0.5, .wind_lean = {1e5f, 0.0f}})); });
    for (int frame = 0; frame < 80; ++frame)
        advance(pair, {.duration = 0.5, .wind_lean = {frame % 2 == 0 ? 1e3f : -1e3f, -1e3f}});
    const GroundsApart apart = compare(pair, {0.0, 0.0, 0.0}, 7);
    WINDROW_EXPECT_FIGURE("ground_device/half_of_the_largest", apart.worst / apart.largest, 0x1p-10);
    EXPECT_EQ(apart.largest, 1e3); // shown, of more than is shown
}

// A pass of the host's gives each texel its own wind; the record that follows waits for it.
TEST_F(GroundDevice, EachTexelFollowsItsOwnWind) {
    TwoGrounds pair = make({.texels = 64}, Texel::single);
    const VkDescriptorType kinds[] = {k_storage};
    auto pipeline = Pipeline::create(*device, {.code = shader_words::fill_leans,
                                               .bindings = kinds,
                                               .constants = {},
                                               .push_bytes = sizeof(GroundPlaceBlock),
                                               .name = "fill_leans"});
    ASSERT_TRUE(pipeline) << pipeline.error();
    const Sets::Content content{&*pipeline, {{.type = k_storage, .buffer = pair.gpu.lean_buffer()}}};
    auto sets = Sets::create(*device, {&content, 1});
    ASSERT_TRUE(sets) << sets.error();
    const glm::dvec3 anchor(100.0, 0.0, -50.0);
    for (int frame = 0; frame < 40; ++frame) {
        follow(pair, anchor + glm::dvec3(0.11 * frame, 0.0, -0.2 * frame));
        std::vector<glm::vec2> leans(64 * 64);
        for (int j = 0; j < 64; ++j)
            for (int i = 0; i < 64; ++i)
                leans[static_cast<std::size_t>(64 * j + i)] =
                    glm::vec2(0.02 * (pair.cpu.next_centre({i, j}) - glm::dvec2(anchor.x, anchor.z)));
        ASSERT_TRUE(pair.cpu.advance({.duration = 0.05}, leans));
        run([&](VkCommandBuffer commands) {
            const GroundPlaceBlock next = pair.gpu.next_place(anchor);
            const Functions& call = device->functions();
            pipeline->bind(call, commands, sets->at(0));
            call.vkCmdPushConstants(commands, pipeline->layout(), VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(next), &next);
            call.vkCmdDispatch(commands, 8, 8, 1);
            ASSERT_TRUE(pair.gpu.record(commands, {.duration = 0.05}, WindLeans::each_texel));
        });
    }
    const GroundsApart apart = compare(pair, anchor, 5);
    WINDROW_EXPECT_FIGURE("ground_device/own_wind", apart.worst / apart.largest, 1e-4);
    EXPECT_GT(apart.largest, 0.2);
}

// Several steps recorded before any is run, as a host does that catches up.
TEST_F(GroundDevice, StepsInOneCommandBufferFollowEachOther) {
    TwoGrounds pair = make({.texels = 64}, Texel::single);
    GroundWalker walker{.radius = 1.0f};
    run([&](VkCommandBuffer commands) {
        for (int n = 0; n < 5; ++n) {
            walker.previous = walker.position;
            walker.position.x += 0.5;
            follow(pair, walker.position);
            const GroundStep step{
                .duration = 0.1, .walkers = std::span(&walker, 1), .wind_lean = {0.1f * static_cast<float>(n), 0.2f}};
            ASSERT_TRUE(pair.cpu.advance(step));
            ASSERT_TRUE(pair.gpu.record(commands, step));
        }
    });
    const GroundsApart apart = compare(pair, walker.position, 6);
    WINDROW_EXPECT_FIGURE("ground_device/five_steps_at_once", apart.worst / apart.largest, 1e-4);
    EXPECT_GT(apart.largest, 0.5);
}

// Saved in the middle of a walk and loaded: the next frames, and the frame before the first of them, are those of the memory that was
// saved, on a device to the bit and on the CPU to rounding. So are bytes of the CPU, loaded on a device.
TEST_F(GroundDevice, GoesOnFromItsBytesOnBothBackends) {
    for (const Texel texel : {Texel::single, Texel::half}) {
        TwoGrounds pair = make({.texels = 64}, texel);
        EXPECT_TRUE(says(pair.gpu.saved(), "has nothing: record a step"));
        run([&](VkCommandBuffer commands) { EXPECT_TRUE(says(pair.gpu.record_save(commands), "before the first step")); });
        GroundWalker walker{.radius = 1.0f};
        const auto walk = [&](auto&& grounds, int frames) {
            for (int n = 0; n < frames; ++n) {
                walker.previous = walker.position;
                walker.position += glm::dvec3(0.4, 0.0, -0.1);
                for (TwoGrounds* const each : grounds) {
                    follow(*each, walker.position);
                    advance(
                        *each,
                        {.duration = 0.05, .walkers = std::span(&walker, 1), .wind_lean = {0.1f, 0.02f * static_cast<float>(n)}});
                }
            }
        };
        walk(std::array{&pair}, 20);
        run([&](VkCommandBuffer commands) { ASSERT_TRUE(pair.gpu.record_save(commands)); });
        const auto bytes = pair.gpu.saved();
        ASSERT_TRUE(bytes) << bytes.error();
        EXPECT_TRUE(says(pair.gpu.saved(), "has nothing")) << "once for each";
        const auto of_cpu = pair.cpu.save();
        ASSERT_TRUE(of_cpu);
        EXPECT_EQ(of_cpu->size(), bytes->size());
        const auto loaded = [&](const std::vector<std::byte>& from) -> TwoGrounds {
            auto cpu = windrow::GroundMemory::load(from);
            auto gpu = GroundMemory::load(own->host(), from, texel);
            EXPECT_TRUE(cpu) << cpu.error();
            EXPECT_TRUE(gpu) << gpu.error();
            return {*std::move(cpu), *std::move(gpu)};
        };
        TwoGrounds again = loaded(*bytes), other = loaded(*of_cpu);
        const double bound = texel == Texel::single ? 1e-4 : 0x1p-10 + 1e-4;
        for (const int frames : {1, 15}) {
            walk(std::array{&pair, &again, &other}, frames);
            for (TwoGrounds* const each : {&pair, &again, &other}) {
                const GroundsApart apart = compare(*each, walker.position, 3);
                EXPECT_LE(apart.worst, bound) << frames;
                EXPECT_GT(apart.largest, 0.3);
            }
            std::vector<glm::vec4> places;
            for (int n = 0; n < 1024; ++n)
                places.emplace_back(0.2f * static_cast<float>(n % 32) - 3.2f, 0.0f, 0.2f * static_cast<float>(n / 32) - 3.2f,
                                    0.0f);
            const auto now = sampled(again.gpu, places, walker.position), wanted = sampled(pair.gpu, places, walker.position);
            for (std::size_t n = 0; n < now.size(); ++n) { // in turn now and before; a loaded half may be rounded otherwise
                const bool rounds = n % 2 == 1 && frames == 1 && texel == Texel::half;
                EXPECT_TRUE(rounds ? glm::distance(now[n], wanted[n]) <= 2e-3f : now[n] == wanted[n]) << n << ", " << frames;
            }
        }
        std::vector<std::byte> damaged = *bytes;
        damaged[damaged.size() / 2] ^= std::byte{1};
        EXPECT_FALSE(GroundMemory::load(own->host(), damaged, texel));
    }
}

TEST_F(GroundDevice, RejectsWhatTheCpuRejects) {
    const auto bad = GroundMemory::create(own->host(), {.texels = 3});
    ASSERT_FALSE(bad);
    EXPECT_NE(bad.error().find("texels"), std::string::npos);
    auto ground = GroundMemory::create(own->host(), {.texels = 16, .blend_width = 0.5f});
    ASSERT_TRUE(ground) << ground.error();
    EXPECT_FALSE(ground->record(VK_NULL_HANDLE, {}));
    run([&](VkCommandBuffer commands) { EXPECT_FALSE(ground->record(commands, {.duration = -1.0})); });
    EXPECT_GT(ground->memory_bytes(), 16u * 16 * 48);
}

} // namespace
} // namespace windrow::vulkan
