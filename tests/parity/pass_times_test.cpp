// What the device's clock says of each pass, and what it costs where nobody asked for it.
#include "fluid/vulkan/wind.h"
#include "fluid/vulkan/wind_state.h"
#include "gpu/pipeline.h"
#include "gpu/timestamps.h"
#include "shader_words/scale.h"
#include "tests/figure.h"
#include "tests/parity/gpu.h"

#include <algorithm>
#include <map>

namespace windrow::vulkan {
namespace {

class PassTimesTest : public Gpu {
  protected:
    [[nodiscard]] Result<Wind> make(const Config& config, bool timestamps) {
        return Wind::create(sharing_host(), config,
                            {.frames_in_flight = 2, .timestamps = timestamps, .queries = ReadBack::cells});
    }

    void frame(Wind& wind, int n) {
        run([&](VkCommandBuffer commands) { held(wind.record_step(commands, {.dt = 1.0 / 30.0, .slot = n % 2})); });
    }

    static int dispatches(const PassTimes& times) {
        int sum = 0;
        for (const PassTimes::Pass& pass : times.passes)
            sum += pass.dispatches;
        return sum;
    }
};

constexpr glm::ivec3 k_cells{16, 12, 16};

TEST_F(PassTimesTest, EveryPassOfARecordingHasATimeAndTheirSumIsWithinTheWhole) {
    auto wind = make({.cells = k_cells, .ambient = {2.0f, 0.0f, 0.0f}, .viscosity = 1e-3f}, true);
    ASSERT_TRUE(wind) << wind.error();
    ASSERT_TRUE(wind->motors().add(DirectionalMotor{}));
    ASSERT_TRUE(wind->motors().add(PressureMotor{}));
    std::map<int, int> recorded; // dispatches by frame
    for (int n = 0; n < 12; ++n) {
        ASSERT_TRUE(wind->follow({0.9 * n, 0.0, 0.0}));
        frame(*wind, n);
        recorded[n] = wind->dispatches();
        const auto times = wind->pass_times();
        ASSERT_EQ(times.has_value(), n >= 2) << "the times of a slot come with its next recording";
        if (!times)
            continue;
        EXPECT_EQ(dispatches(*times), recorded[n - 2]);
        EXPECT_EQ(times->untimed, 0);
        double sum = 0.0;
        for (const PassTimes::Pass& pass : times->passes) {
            EXPECT_GT(pass.us, 0.0) << pass.name;
            sum += pass.us;
        }
        EXPECT_GT(times->read_back_us, 0.0);
        EXPECT_LE(std::max(sum, times->read_back_us), times->whole_us);
        const auto has = [&](const char* name) {
            return std::any_of(times->passes.begin(), times->passes.end(),
                               [&](const PassTimes::Pass& pass) { return std::string(pass.name) == name; });
        };
        for (const char* name : {"sources", "plan", "diffuse", "pad", "advect", "lines_forward", "slabs", "lines_back",
                                 "gradient", "source_flow", "show"})
            EXPECT_TRUE(has(name)) << name;
        if (n == 11)
            test::figure("pass_times.sum_over_whole", sum / times->whole_us);
    }
}

TEST_F(PassTimesTest, TheAirIsTheSameToTheBitWithTheClockOn) {
    const Config config{.cells = k_cells, .ambient = {2.0f, 0.0f, 1.0f}, .gusts = {.intensity = 0.2f}};
    std::vector<glm::vec4> fields[2];
    for (const bool timestamps : {false, true}) {
        auto wind = make(config, timestamps);
        ASSERT_TRUE(wind) << wind.error();
        ASSERT_TRUE(wind->motors().add(VortexMotor{}));
        for (int n = 0; n < 6; ++n)
            frame(*wind, n);
        const auto field = wind->queried()->field();
        fields[timestamps ? 1 : 0].assign(field.begin(), field.end());
        EXPECT_EQ(wind->pass_times().has_value(), timestamps);
    }
    EXPECT_EQ(fields[0], fields[1]);
}

// Recordings of thousands of dispatches: those without room are counted, not lost.
TEST_F(PassTimesTest, DispatchesBeyondTheRoomAreCounted) {
    auto clock = PassClock::create(*device, 1, 3);
    ASSERT_TRUE(clock) << clock.error();
    for (int frame = 0; frame < 2; ++frame)
        run([&](VkCommandBuffer commands) {
            clock->begin(commands, 0);
            for (int n = 0; n < 5; ++n)
                const PassClock::Lap lap(&*clock, commands, n < 2 ? Pass::pad : Pass::advect);
            clock->end(commands);
        });
    ASSERT_TRUE(clock->times());
    EXPECT_EQ(clock->times()->untimed, 2);
    ASSERT_EQ(clock->times()->passes.size(), 2u);
    EXPECT_STREQ(clock->times()->passes[0].name, "pad");
    EXPECT_EQ(clock->times()->passes[0].dispatches, 2);
    EXPECT_EQ(clock->times()->passes[1].dispatches, 1);
}

// As with read-backs: what is older than what was read already is not told.
TEST_F(PassTimesTest, TimesNeverGoBackToAnOlderRecording) {
    auto clock = PassClock::create(*device, 3, 3);
    ASSERT_TRUE(clock) << clock.error();
    const auto record = [&](int slot, Pass pass) {
        run([&](VkCommandBuffer commands) {
            clock->begin(commands, slot);
            { const PassClock::Lap lap(&*clock, commands, pass); }
            clock->end(commands);
        });
    };
    record(0, Pass::pad);
    record(1, Pass::advect);
    clock->collect(1);
    clock->collect(0);
    ASSERT_TRUE(clock->times());
    EXPECT_STREQ(clock->times()->passes.at(0).name, "advect");
}

// --- A queue that counts no time, and one whose counter is short: no device at hand has one --------------------------------

std::uint32_t g_valid_bits = 0;

void VKAPI_CALL short_families(VkPhysicalDevice, std::uint32_t* count, VkQueueFamilyProperties* families) {
    *count = 1;
    if (families != nullptr) {
        *families = {};
        families->queueFlags = VK_QUEUE_COMPUTE_BIT;
        families->timestampValidBits = g_valid_bits;
    }
}

VkResult VKAPI_CALL wrapped_moments(VkDevice, VkQueryPool, std::uint32_t, std::uint32_t, std::size_t, void* data, VkDeviceSize,
                                    VkQueryResultFlags) {
    auto* const moments = static_cast<std::uint64_t*>(data);
    moments[0] = 0xfffffff0u;
    moments[1] = 0x10u;
    return VK_SUCCESS;
}

TEST_F(PassTimesTest, AQueueThatCountsNoTimeIsRejectedAndAShortCounterRunsOver) {
    Functions functions = device->functions();
    functions.vkGetPhysicalDeviceQueueFamilyProperties = &short_families;
    functions.vkGetQueryPoolResults = &wrapped_moments;
    Host host = own->host();
    host.queue_family = 0;
    auto lent = Device::create(host, functions);
    ASSERT_TRUE(lent) << lent.error();
    g_valid_bits = 0;
    expect_error(Timestamps::create(**lent, 2), "timestampValidBits");

    g_valid_bits = 32;
    const auto some = Timestamps::create(**lent, 2);
    ASSERT_TRUE(some) << some.error();
    std::uint64_t moments[2] = {};
    ASSERT_TRUE(some->read(moments));
    EXPECT_DOUBLE_EQ(some->microseconds(moments[0], moments[1]),
                     0x20 * 1e-3 * static_cast<double>((*lent)->limits().timestampPeriod));
}

// --- Bytes -------------------------------------------------------------------------------------------------------------

TEST_F(PassTimesTest, BytesOfAPassAreThoseOfTheFieldsThatItReadsAndWrites) {
    auto wind = make({.cells = k_cells}, false);
    ASSERT_TRUE(wind) << wind.error();
    const Passes& passes = wind->state().cells.air->passes();
    const std::uint64_t n = 16 * 12 * 16, padded = 21 * 17 * 21;
    // velocity, force, drives, history, source_flow, arrived; R and V
    EXPECT_EQ(passes.bytes(Pass::advect), 6 * 16 * n + 32 * padded);
    EXPECT_EQ(passes.bytes(Pass::columns), 2 * 4 * n);    // hat, both ways
    EXPECT_EQ(passes.bytes(Pass::slabs), 2 * 4 * n);      // hat_x, hat
    EXPECT_EQ(passes.bytes(Pass::modes_back), 2 * 4 * n); // hat, potential
    EXPECT_EQ(passes.bytes(Pass::plan), 0u);
}

// What docs/performance.md states, by pass: a step of one sub-step without motors, viscosity or a shift.
TEST_F(PassTimesTest, AStepMovesTheBytesThatAreStated) {
    struct Stated {
        glm::ivec3 cells;
        const char* name;
        double bytes_a_cell;
    };
    for (const Stated& stated :
         {Stated{{32, 16, 32}, "32x16x32", 520.0}, {{64, 32, 64}, "64x32x64", 494.0}, {{128, 64, 128}, "128x64x128", 483.0}}) {
        const auto wind = Wind::create(sharing_host(), {.cells = stated.cells});
        ASSERT_TRUE(wind) << wind.error();
        const Passes& passes = wind->state().cells.air->passes();
        const double cells = static_cast<double>(wind->box().cell_count());
        std::vector<Pass> step;
        for (const Passes::Stage& stage : passes.substep(DiffusionMethod::none))
            step.push_back(stage.pass);
        step.push_back(Pass::show);
        double sum = 0.0;
        for (const Pass pass : step) {
            const double moved = static_cast<double>(passes.bytes(pass)) / cells;
            windrow::test::figure(std::string("bytes_a_cell.") + stated.name + "." + name_of(pass), moved);
            sum += moved;
        }
        EXPECT_NEAR(windrow::test::figure(std::string("bytes_a_cell.") + stated.name, sum), stated.bytes_a_cell, 1.0);
    }
}

TEST_F(PassTimesTest, AShaderTellsWhatItReadsAndWrites) {
    const std::vector<Access> access = access_of(shader_words::scale, 3);
    EXPECT_TRUE(access[0].reads && !access[0].writes);
    EXPECT_TRUE(!access[1].reads && access[1].writes);
    EXPECT_FALSE(access[2].reads || access[2].writes) << "the shader has no such binding";
}

} // namespace
} // namespace windrow::vulkan
