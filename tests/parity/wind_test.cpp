// windrow::vulkan::Wind against windrow::Wind through their public calls: the same config, the same story, frame by frame.
#include "fluid/vulkan/wind.h"
#include "shader_words/sample_wind.h"
#include "tests/figure.h"
#include "tests/parity/gpu.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace windrow::vulkan {
namespace {

class WindParity : public Gpu {
  protected:
    // Both winds, told the same. One frame in flight: what a recording leaves is read by the next.
    struct Pair {
        windrow::Wind cpu;
        Wind device;
        std::vector<glm::vec4> cpu_frame{}; // of the last frame
        double largest = 0.0;               // difference so far, over the largest component
    };

    Pair make(const Config& config) {
        auto cpu = windrow::Wind::create(config);
        auto gpu = Wind::create(own->host(), config, {.texel = Texel::single, .frames_in_flight = 1});
        EXPECT_TRUE(cpu) << cpu.error();
        EXPECT_TRUE(gpu) << gpu.error();
        return {*std::move(cpu), *std::move(gpu)};
    }

    void frame(Pair& pair, double dt) {
        Advance recorded;
        run([&](VkCommandBuffer commands) { recorded = pair.device.record(commands, {.dt = dt}); });
        compare(pair);
        const Advance cpu = pair.cpu.advance(dt);
        EXPECT_EQ(cpu.ticks, recorded.ticks);
        EXPECT_EQ(cpu.factor, recorded.factor);
        const auto now = pair.cpu.view().field();
        pair.cpu_frame.assign(now.begin(), now.end());
    }

    // What was read back of the last frame against the CPU's.
    static void compare(Pair& pair) {
        const auto view = pair.device.queried();
        if (!view || pair.cpu_frame.empty())
            return;
        const auto device = view->field();
        ASSERT_EQ(device.size(), pair.cpu_frame.size());
        double worst = 0.0, largest = 1e-30;
        for (std::size_t n = 0; n < device.size(); ++n)
            for (int axis = 0; axis < 3; ++axis) {
                const double a = device[n][axis], b = pair.cpu_frame[n][axis];
                ASSERT_TRUE(std::isfinite(a));
                worst = std::max(worst, std::abs(a - b));
                largest = std::max(largest, std::abs(b));
            }
        pair.largest = std::max(pair.largest, worst / largest);
    }

    // Three winds a place (now, before, felt) by sample_wind.comp.
    std::vector<glm::vec4> sampled(Wind& wind, std::span<const glm::vec4> places, glm::dvec3 anchor, const Sampling& sampling) {
        constexpr VkDescriptorType storage = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                                   texture = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
        const std::vector<VkDescriptorType> kinds = {
            storage, storage, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, texture, texture, texture, texture, texture, texture, storage};
        Pipeline pipeline = *Pipeline::create(
            *device, {.code = shader_words::sample_wind, .bindings = kinds, .constants = {}, .name = "sample_wind"});
        Buffer in = *Buffer::create(*device, places.size_bytes(), Place::upload);
        Buffer out = *Buffer::create(*device, 3 * places.size_bytes(), Place::readback);
        Buffer block = *Buffer::create(*device, sizeof(FrameBlock), Place::upload, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
        std::memcpy(in.mapped(), places.data(), places.size_bytes());
        const FrameBlock told = wind.frame_block(anchor, sampling);
        std::memcpy(block.mapped(), &told, sizeof(told));
        EXPECT_TRUE(in.flush() == VK_SUCCESS && block.flush() == VK_SUCCESS);
        VkSamplerCreateInfo nearest{};
        nearest.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
        VkSampler sampler = VK_NULL_HANDLE;
        EXPECT_EQ(device->functions().vkCreateSampler(device->host().device, &nearest, nullptr, &sampler), VK_SUCCESS);
        std::vector<Binding> bindings = {{.type = storage, .buffer = in.handle()},
                                         {.type = storage, .buffer = out.handle()},
                                         {.type = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, .buffer = block.handle()}};
        for (const Textures& frame : {wind.textures(), wind.previous_textures()})
            for (const VkImageView view : frame.views)
                bindings.push_back({.type = texture, .view = view, .sampler = sampler});
        bindings.push_back({.type = storage, .buffer = wind.gust_buffer()});
        const Sets::Content content{&pipeline, bindings};
        Sets sets = *Sets::create(*device, {&content, 1});
        run([&](VkCommandBuffer commands) {
            const VkDescriptorSet set = sets.at(0);
            const Functions& call = device->functions();
            call.vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.handle());
            call.vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.layout(), 0, 1, &set, 0, nullptr);
            call.vkCmdDispatch(commands, static_cast<std::uint32_t>(places.size() + 63) / 64, 1, 1);
            barrier(commands);
        });
        device->functions().vkDestroySampler(device->host().device, sampler, nullptr);
        return read<glm::vec4>(out, 3 * places.size());
    }

    static void add(Pair& pair, const Motor& motor) {
        ASSERT_TRUE(pair.cpu.motors().add(motor));
        ASSERT_TRUE(pair.device.motors().add(motor));
    }

    Diagnostics last_;

    static void report(const char* name, const Pair& pair, double bound) {
        WINDROW_EXPECT_FIGURE(std::string("wind_parity.") + name, pair.largest, bound);
        EXPECT_GT(pair.largest, 0.0) << name << ": nothing was compared";
    }
};

TEST_F(WindParity, AWalkWithGustsAFanAndATurningWind) {
    Pair pair = make({.cells = {24, 12, 20},
                      .sides = Sides::open_over_floor(),
                      .centre = {0.0, 6.0, 0.0},
                      .ambient = {3.0f, 0.0f, 1.0f},
                      .profile = LogProfile{},
                      .gusts = {.intensity = 0.25f}});
    add(pair, DirectionalMotor{.position = {4.0, 2.0, 1.0}, .direction = {-1.0f, 0.2f, 0.0f}});
    for (int n = 0; n < 90; ++n) {
        const glm::dvec3 player(0.05 * n, 0.0, -0.08 * n);
        ASSERT_TRUE(pair.cpu.follow(player) && pair.device.follow(player));
        if (n == 40) {
            ASSERT_TRUE(pair.cpu.set_ambient({2.0f, 0.0f, 2.0f}) && pair.device.set_ambient({2.0f, 0.0f, 2.0f}));
        }
        frame(pair, 1.0 / 60.0);
    }
    report("walk", pair, 1e-4);
}

TEST_F(WindParity, ABlastAVentAndAWakeInABoxThatFollows) {
    Pair pair = make({.cells = {16, 16, 16}, .ambient = {1.0f, 0.0f, 0.0f}});
    add(pair, OmniMotor{.position = {2.0, 0.5, 0.0}});
    add(pair, PressureMotor{.position = {-3.0, 0.0, 2.0}});
    const auto cpu_wake = pair.cpu.motors().add(WakeMotor{.position = {-4.0, 0.0, -2.0}, .radius = 1.0f});
    const auto device_wake = pair.device.motors().add(WakeMotor{.position = {-4.0, 0.0, -2.0}, .radius = 1.0f});
    ASSERT_TRUE(cpu_wake && device_wake);
    for (int n = 0; n < 90; ++n) {
        const glm::dvec3 body(-4.0 + 0.2 * n, std::sin(0.1 * n), -2.0);
        ASSERT_TRUE(pair.cpu.motors().move(*cpu_wake, body) && pair.device.motors().move(*device_wake, body));
        const glm::dvec3 player(0.1 * n, 0.03 * n, 0.0);
        ASSERT_TRUE(pair.cpu.follow(player) && pair.device.follow(player));
        frame(pair, 1.0 / 45.0);
    }
    report("blast", pair, 1e-4);
}

TEST_F(WindParity, SidesThatChangeAndAJumpBeyondTheBox) {
    Pair pair = make({.cells = {12, 10, 14}, .ambient = {2.0f, 0.0f, 1.0f}});
    add(pair, VortexMotor{.position = {0.0, 0.0, 0.0}, .radius = 3.0f});
    const auto both = [&](const Sides& sides) { ASSERT_TRUE(pair.cpu.set_sides(sides) && pair.device.set_sides(sides)); };
    for (int n = 0; n < 80; ++n) {
        if (n == 20)
            both(Sides::open_over_floor());
        if (n == 35)
            both(Sides::all(SideKind::periodic));
        if (n == 50)
            both(Sides::all(SideKind::free_slip));
        if (n == 60)
            both({});
        if (n == 70) {
            ASSERT_TRUE(pair.cpu.follow({1e6, 0.0, 5.0}) && pair.device.follow({1e6, 0.0, 5.0}));
        }
        frame(pair, 1.0 / 30.0);
    }
    report("sides", pair, 1e-4);
}

// The device counts its own sub-steps, and cuts speeds as the CPU does.
TEST_F(WindParity, AStormInSubStepsThatTheDeviceChooses) {
    for (const int most : {8, 2}) {
        Pair pair = make({.cells = {16, 12, 16}, .ambient = {4.0f, 0.0f, 0.0f}, .max_substeps = most});
        add(pair, DirectionalMotor{.position = {0.0, 0.0, 0.0},
                                   .direction = {0.0f, 0.0f, 1.0f},
                                   .law = Drive{.speed = 900.0f, .rate = 30.0f}});
        add(pair, DirectionalMotor{
                      .position = {3.0, 1.0, 2.0}, .direction = {1.0f, 0.5f, 0.0f}, .law = Force{.acceleration = 3000.0f}});
        int most_cpu = 0;
        for (int n = 0; n < 12; ++n) {
            Advance recorded;
            run([&](VkCommandBuffer commands) { recorded = pair.device.record(commands, {.dt = 1.0 / 30.0}); });
            compare(pair);
            const Advance cpu = pair.cpu.advance(1.0 / 30.0);
            if (n > 0) {
                EXPECT_EQ(recorded.last.substeps, last_.substeps);
                EXPECT_EQ(recorded.last.substeps_capped, last_.substeps_capped);
                EXPECT_NEAR(recorded.last.cfl, last_.cfl, 1e-4f * last_.cfl);
                EXPECT_NEAR(recorded.last.max_speed, last_.max_speed, 1e-4f * last_.max_speed);
                EXPECT_NEAR(recorded.last.energy, last_.energy, 1e-4 * last_.energy);
                EXPECT_NEAR(recorded.last.divergence_rms, last_.divergence_rms, 1e-3 * last_.divergence_rms);
            }
            last_ = cpu.last;
            most_cpu = std::max(most_cpu, cpu.last.substeps);
            const auto now = pair.cpu.view().field();
            pair.cpu_frame.assign(now.begin(), now.end());
        }
        EXPECT_GE(most_cpu, most == 8 ? 4 : 2);
        report(most == 8 ? "storm" : "storm_capped", pair, 1e-4);
    }
}

TEST_F(WindParity, CellsThatAreNoNumberBecomeAmbient) {
    const Config config{.cells = {12, 12, 12}, .ambient = {1.0f, 0.0f, 0.5f}};
    Pair pair = make(config);
    std::vector<glm::vec4> field(12 * 12 * 12, glm::vec4(1.5f, 0.2f, 0.0f, 0.0f));
    field[100].x = std::numeric_limits<float>::quiet_NaN();
    field[777].z = std::numeric_limits<float>::infinity();
    ASSERT_TRUE(pair.cpu.set_velocity(field) && pair.device.set_velocity(field));
    for (int n = 0; n < 20; ++n)
        frame(pair, 1.0 / 30.0);
    report("repaired", pair, 1e-4);
}

// Still air costs nothing: nothing is recorded. What wakes it finds the wind as a fresh one.
TEST_F(WindParity, StillAirSleepsAndWakes) {
    const Config config{.cells = {12, 12, 12}, .ambient = {0.0f, 0.0f, 0.0f}, .settling_time = 0.3f};
    Pair pair = make(config);
    std::vector<glm::vec4> field(12 * 12 * 12, glm::vec4(0.5f, 0.1f, 0.0f, 0.0f));
    ASSERT_TRUE(pair.cpu.set_velocity(field) && pair.device.set_velocity(field));
    int asleep_after = 0;
    for (int n = 0; n < 240 && asleep_after == 0; ++n) {
        Advance done;
        run([&](VkCommandBuffer commands) { done = pair.device.record(commands, {.dt = 1.0 / 30.0}); });
        asleep_after = done.last.asleep ? n : 0;
    }
    ASSERT_GT(asleep_after, 0);
    for (int n = 0; n < 4; ++n)
        run([&](VkCommandBuffer commands) { (void)pair.device.record(commands, {.dt = 1.0 / 30.0}); });
    EXPECT_EQ(pair.device.dispatches(), 0);
    EXPECT_EQ(pair.device.barriers(), 0);
    for (int n = 0; n < 300; ++n)
        (void)pair.cpu.advance(1.0 / 30.0);
    add(pair, DirectionalMotor{.position = {0.0, 0.0, 0.0}});
    pair.cpu_frame.clear();
    for (int n = 0; n < 10; ++n)
        frame(pair, 1.0 / 30.0);
    report("woken", pair, 1e-4);
}

// What the host asks for between two frames acts in the order of asking, each with the wind of its moment.
TEST_F(WindParity, AskedForBetweenTwoFrames) {
    Pair pair = make({.cells = {12, 10, 12}, .ambient = {1.0f, 0.0f, 0.0f}, .gusts = {.intensity = 0.3f}});
    add(pair, VortexMotor{.position = {0.0, 0.0, 0.0}, .radius = 3.0f});
    for (int n = 0; n < 40; ++n) {
        if (n == 10) { // no mean wind carries no gusts
            ASSERT_TRUE(pair.cpu.set_ambient({}) && pair.device.set_ambient({}));
        }
        if (n == 20) {
            ASSERT_TRUE(pair.cpu.set_ambient({5.0f, 0.0f, 1.0f}) && pair.device.set_ambient({5.0f, 0.0f, 1.0f}));
        }
        if (n == 25) {
            ASSERT_TRUE(pair.cpu.follow({3.0, 0.0, 2.0}) && pair.device.follow({3.0, 0.0, 2.0}));
            ASSERT_TRUE(pair.cpu.set_ambient({2.0f, 0.0f, -1.0f}) && pair.device.set_ambient({2.0f, 0.0f, -1.0f}));
            ASSERT_TRUE(pair.cpu.set_gusts({.intensity = 0.2f, .seed = 5}) &&
                        pair.device.set_gusts({.intensity = 0.2f, .seed = 5}));
        }
        frame(pair, 1.0 / 30.0);
    }
    report("asked_between_frames", pair, 1e-4);
}

// Walls that open on sleeping air let the wind in; they do not throw it.
TEST_F(WindParity, WallsThatOpenWakeTheAir) {
    const Sides walls = Sides::all(SideKind::free_slip);
    Pair pair = make({.cells = {10, 8, 10}, .sides = walls, .ambient = {3.0f, 0.0f, 0.0f}, .settling_time = 5.0f});
    for (int n = 0; n < 10; ++n)
        frame(pair, 1.0 / 30.0);
    ASSERT_TRUE(pair.cpu.set_sides({}) && pair.device.set_sides({}));
    pair.cpu_frame.clear();
    for (int n = 0; n < 30; ++n)
        frame(pair, 1.0 / 30.0);
    report("walls_that_open", pair, 1e-4);
}

// Boxes of one cell along one axis or two, which some devices run in groups of another shape.
TEST_F(WindParity, ThinBoxes) {
    for (const glm::ivec3 cells : {glm::ivec3(1, 1, 70), glm::ivec3(24, 1, 1), glm::ivec3(1, 40, 2), glm::ivec3(1, 1, 1)}) {
        Pair pair = make({.cells = cells, .ambient = {1.0f, 0.2f, 2.0f}});
        add(pair, DirectionalMotor{.direction = {0.0f, 1.0f, 0.3f}});
        for (int n = 0; n < 12; ++n)
            frame(pair, 1.0 / 30.0);
        WINDROW_EXPECT_FIGURE("wind_parity.thin_" + std::to_string(cells.x) + "_" + std::to_string(cells.y) + "_" +
                                  std::to_string(cells.z),
                              pair.largest, 1e-4);
    }
}

// What is too large for the device is refused before anything of its size is made.
TEST_F(WindParity, ABoxThatNoDeviceHoldsIsRefused) {
    const auto wind = Wind::create(own->host(), {.cells = {2048, 16, 2048}});
    ASSERT_FALSE(wind);
    EXPECT_NE(wind.error().find("2048 x 16 x 2048"), std::string::npos) << wind.error();
    const auto slots = Wind::create(own->host(), {}, {.frames_in_flight = 0});
    ASSERT_FALSE(slots);
    EXPECT_NE(slots.error().find("frames_in_flight is 0"), std::string::npos) << slots.error();
}

// C1: what a shader that includes windrow_wind.glsl finds, against the CPU's query of the same cells.
TEST_F(WindParity, AnOutsideShaderSamplesWhatAQueryFinds) {
    const std::array<Config, 3> configs = {{
        {.cells = {20, 12, 16},
         .sides = Sides::open_over_floor(),
         .centre = {1e6, 6.0, -1e6},
         .ambient = {3.0f, 0.0f, 1.0f},
         .profile = LogProfile{},
         .gusts = {.intensity = 0.25f}},
        {.cells = {9, 7, 11}, .cell_size = 0.5f, .sides = Sides::all(SideKind::periodic), .ambient = {1.0f, 0.5f, -2.0f}},
        {.cells = {12, 12, 12},
         .ambient = {0.0f, 0.0f, 2.0f},
         .gusts = {.tile = GustTile::bake(3)},
         .rim = 0.0f}, // for detail alone
    }};
    for (const Config& config : configs) {
        Pair pair = make(config);
        add(pair, VortexMotor{.position = config.centre, .radius = 3.0f});
        for (int n = 0; n < 20; ++n) {
            const glm::dvec3 player = config.centre + glm::dvec3(0.3 * n, 0.0, 0.1 * n);
            ASSERT_TRUE(pair.cpu.follow(player) && pair.device.follow(player));
            frame(pair, 1.0 / 50.0);
        }
        const std::uint32_t count = 10000;
        const glm::dvec3 anchor = config.centre + glm::dvec3(12.3, -4.5, 6.7);
        std::vector<glm::vec4> places(count);
        std::mt19937 random(7);
        std::uniform_real_distribution<float> along(-1.0f, 1.0f);
        const glm::vec3 reach = 0.9f * config.cell_size * glm::vec3(config.cells);
        for (glm::vec4& place : places)
            place = glm::vec4(glm::vec3(config.centre - anchor) + reach * glm::vec3(along(random), along(random), along(random)),
                              0.0f);
        const Sampling sampling{.strength = 1.3f, .limit = 20.0f, .detail = 0.2f};
        const std::vector<glm::vec4> winds = sampled(pair.device, places, anchor, sampling);
        // The cells of the last frame are read by an empty one.
        run([&](VkCommandBuffer commands) { (void)pair.device.record(commands, {.dt = 0.0}); });
        const auto view = *pair.device.queried();
        const auto before = pair.cpu.previous_view();
        double worst = 0.0, worst_before = 0.0, worst_felt = 0.0;
        const auto apart = [](glm::vec4 a, glm::vec3 b) {
            return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
        };
        for (std::uint32_t n = 0; n < count; ++n) {
            const glm::dvec3 world = anchor + glm::dvec3(places[n]);
            worst = std::max(worst, static_cast<double>(apart(winds[3 * n], view.velocity(world))));
            worst_before = std::max(worst_before, static_cast<double>(apart(winds[3 * n + 1], before.velocity(world))));
            worst_felt = std::max(worst_felt, static_cast<double>(apart(winds[3 * n + 2], view.felt(world, sampling))));
        }
        WINDROW_EXPECT_FIGURE("shader_query.now", worst, 1e-5);
        WINDROW_EXPECT_FIGURE("shader_query.before", worst_before, 3e-5); // of the CPU's own cells
        WINDROW_EXPECT_FIGURE("shader_query.felt", worst_felt, 2e-5);
    }
}

} // namespace
} // namespace windrow::vulkan
