// A whole life of a wind in which each call that can fail does so once, with each code: the failure is told by name, nothing is
// left behind, and the host goes on with the CPU from the last field that it has.
#include "fluid/vulkan/wind.h"
#include "tests/figure.h"
#include "tests/parity/counted_functions.h"
#include "tests/parity/gpu.h"
#include "tests/tier.h"

#include <cstring>
#include <glm/geometric.hpp>
#include <map>
#include <set>
#include <utility>

namespace windrow::vulkan {
namespace {

Functions g_table; // what the host below hands out; Vulkan's calls carry no pointer of ours

// A host's own vkGetInstanceProcAddr, which puts the counted calls in place of the device's.
PFN_vkVoidFunction VKAPI_CALL counted_device_call(VkDevice device, const char* name) {
#define WINDROW_GIVE(call)                                                                                                       \
    if (std::strcmp(name, #call) == 0)                                                                                           \
        return reinterpret_cast<PFN_vkVoidFunction>(g_table.call);
    WINDROW_DEVICE_FUNCTIONS(WINDROW_GIVE)
#undef WINDROW_GIVE
    return counted_calls().real.vkGetDeviceProcAddr(device, name);
}

PFN_vkGetInstanceProcAddr g_real_proc_addr = nullptr;

PFN_vkVoidFunction VKAPI_CALL counted_instance_call(VkInstance instance, const char* name) {
    if (std::strcmp(name, "vkGetDeviceProcAddr") == 0)
        return reinterpret_cast<PFN_vkVoidFunction>(&counted_device_call);
    return g_real_proc_addr(instance, name);
}

class WindFaults : public Gpu {
  protected:
    // Without the layer, whose watch over hundreds of lives takes minutes; it watches the same calls in the other tests.
    void SetUp() override { make_own({}); }

    static constexpr glm::ivec3 k_cells{40, 6, 40}; // tables of more than 64 KiB, which new sides bring in a piece of memory

    // Made, given a wind, recorded for some frames, given other sides, forgotten once; the error of the first thing that failed.
    Result<void> live(const Host& host, int& frames) {
        frames = 0;
        auto wind = Wind::create(host, {.cells = k_cells, .ambient = {2.0f, 0.0f, 0.0f}, .viscosity = 1.0f},
                                 {.gusts = true, .timestamps = true, .queries = ReadBack::cells});
        if (!wind)
            return wind.failure();
        const std::vector<glm::vec4> start(static_cast<std::size_t>(k_cells.x * k_cells.y * k_cells.z),
                                           glm::vec4(1.0f, 0.5f, 0.0f, 0.0f));
        if (auto set = wind->set_velocity(start); !set)
            return set;
        if (!wind->motors().add(DirectionalMotor{}) || !wind->motors().add(OmniMotor{.position = {1.0, 0.0, 1.0}}))
            return Error{"a motor was rejected"};
        for (; frames < 4; ++frames) {
            (void)wind->follow({0.7 * frames, 0.0, 0.0});
            const std::uint64_t bytes = wind->memory_bytes();
            if (frames == 1) {
                if (auto changed = wind->set_boundaries(Boundaries::open_over_floor()); !changed)
                    return changed;
                if (wind->memory_bytes() <= bytes)
                    return Error{"the tables of new boundaries took no memory: give the box more cells"};
            }
            Result<Advance> recorded = Advance{};
            run([&](VkCommandBuffer commands) { recorded = wind->record(commands, {.dt = 1.0 / 30.0, .slot = frames % 2}); });
            if (!recorded)
                return recorded.failure();
            if (frames == 0)
                wind->forget(); // as if it had not run: its read-back and its times are not taken
            if (frames == 2)
                (void)wind->collect(frames % 2);
        }
        if (!wind->queried())
            return Error{"nothing was read back"};
        return {};
    }
};

TEST_F(WindFaults, AtEachCallOfALifeAreToldAndLeaveNothingBehind) {
    Host host = own->host();
    const auto real = load_functions(host);
    ASSERT_TRUE(real) << real.error();
    g_real_proc_addr = host.get_instance_proc_addr;
    host.get_instance_proc_addr = &counted_instance_call;

    int frames = 0;
    g_table = counted(*real);
    const auto well = live(host, frames);
    ASSERT_TRUE(well) << well.error();
    ASSERT_EQ(frames, 4);
    expect_none_lives();
    const int calls = counted_calls().made;
    ASSERT_GT(calls, 100);

    // Calls that may fail in silence: `collect` and the times of a recording are passed over, and another is taken. Where the device has more
    // than one type of memory, a full one may have a neighbour that serves.
    std::set<std::string> silent = {"vkInvalidateMappedMemoryRanges", "vkGetQueryPoolResults"};
    VkPhysicalDeviceMemoryProperties memory{};
    real->vkGetPhysicalDeviceMemoryProperties(host.physical_device, &memory);
    if (memory.memoryTypeCount > 1)
        silent.insert("vkAllocateMemory");
    std::map<std::string, int> survived;
    int points = 0, outlived = 0, first = 0;
    // Each call fails with each of the three codes in the whole sweep; else one of `stride` with each, and others with each code.
    const int stride = test::k_sanitized ? 23 : test::whole_sweeps() ? 1 : 13;
    for (const VkResult code : {VK_ERROR_OUT_OF_HOST_MEMORY, VK_ERROR_OUT_OF_DEVICE_MEMORY, VK_ERROR_DEVICE_LOST})
        for (int n = std::exchange(first, first + stride / 3 + 1) % stride; n < calls; n += stride) {
            g_table = counted(*real);
            counted_calls().fail_at = n;
            counted_calls().code = code;
            const auto lived = live(host, frames);
            const std::string failed = counted_calls().failed;
            ASSERT_FALSE(failed.empty()) << n;
            ++points;
            expect_none_lives();
            if (lived) {
                ++outlived;
                ++survived[failed];
                EXPECT_TRUE(silent.contains(failed)) << failed << ", call " << n << ", failed and nobody was told";
                continue;
            }
            EXPECT_NE(lived.error().find(failed), std::string::npos) << lived.error();
            EXPECT_NE(lived.error().find(name_of(code)), std::string::npos) << lived.error();
            EXPECT_EQ(lived.failure().fault, code == VK_ERROR_DEVICE_LOST ? Fault::device_lost : Fault::out_of_memory)
                << lived.error();
        }
    test::figure("faults tried in a life of a wind", points);
    test::figure("of which the wind outlived", outlived);
    // One frame is taken by `collect`, with its times; `record` reports what fails.
    for (const char* const call : {"vkInvalidateMappedMemoryRanges", "vkGetQueryPoolResults"}) {
        EXPECT_LE(survived[call], 3) << call;
        EXPECT_TRUE(stride > 1 || survived[call] == 3) << call;
    }
    for (const auto& [call, count] : survived)
        test::figure("of which by " + call, count);
    counted_calls() = {};
}

// A read-back that cannot be made visible stops the recording that needs its slot; the next one takes it.
TEST_F(WindFaults, OfAReadBackStopTheRecordingAndNothingIsLost) {
    Host host = own->host();
    const auto real = load_functions(host);
    ASSERT_TRUE(real) << real.error();
    g_real_proc_addr = host.get_instance_proc_addr;
    host.get_instance_proc_addr = &counted_instance_call;
    g_table = counted(*real);
    {
        auto wind = Wind::create(host, {.cells = k_cells, .ambient = {2.0f, 0.0f, 0.0f}},
                                 {.frames_in_flight = 1, .queries = ReadBack::cells});
        ASSERT_TRUE(wind) << wind.error();
        run([&](VkCommandBuffer commands) {
            held(wind->record(commands, {.dt = 1.0 / 30.0}));
            counted_calls().fail_at = counted_calls().made;
            counted_calls().code = VK_ERROR_OUT_OF_HOST_MEMORY;
            expect_error(wind->record(commands, {.dt = 1.0 / 30.0}),
                         "vkInvalidateMappedMemoryRanges for the read-back of slot 0 returned VK_ERROR_OUT_OF_HOST_MEMORY");
        });
        EXPECT_FALSE(wind->queried());
        run([&](VkCommandBuffer commands) { held(wind->record(commands, {.dt = 1.0 / 30.0})); });
        ASSERT_TRUE(wind->queried());
        EXPECT_NEAR(wind->query_age(), 1.0 / 30.0, 1e-9);
    }
    counted_calls() = {};
}

// The device is gone: what was read back last goes on on the CPU.
TEST_F(WindFaults, TheHostGoesOnWithTheCpu) {
    const Config config{.cells = k_cells, .ambient = {2.0f, 0.0f, 0.0f}};
    auto wind = Wind::create(own->host(), config, {.queries = ReadBack::cells});
    ASSERT_TRUE(wind) << wind.error();
    ASSERT_TRUE(wind->motors().add(DirectionalMotor{}));
    for (int frame = 0; frame < 12; ++frame)
        run([&](VkCommandBuffer commands) { held(wind->record(commands, {.dt = 1.0 / 30.0, .slot = frame % 2})); });
    const auto last = wind->queried();
    ASSERT_TRUE(last);
    auto rescue = windrow::Wind::create(config);
    ASSERT_TRUE(rescue);
    (void)rescue->follow(last->blend_zone().point);
    ASSERT_TRUE(rescue->set_velocity(last->field()));
    for (const MotorId motor : {*rescue->motors().add(DirectionalMotor{})})
        EXPECT_NE(rescue->motors().find(motor), nullptr);
    const glm::dvec3 place(0.3, 0.2, -0.4);
    EXPECT_LE(glm::length(rescue->velocity(place) - last->velocity(place)), 1e-6f);
    EXPECT_TRUE(rescue->advance(1.0 / 30.0).last.stepped);
}

} // namespace
} // namespace windrow::vulkan
