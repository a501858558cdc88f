// Each call that can fail does so once, with each code, while all kinds of objects are made: what was made is destroyed, and the
// sentence names the call.
#include "shader_words/fill_r32f.h"
#include "shader_words/scale.h"
#include "tests/figure.h"
#include "tests/parity/counted_functions.h"
#include "tests/parity/gpu.h"

#include <utility>

namespace windrow::vulkan {
namespace {

struct Everything {
    std::unique_ptr<Device> device; // goes last
    Buffer upload, on_device, readback;
    Image3D halves, floats;
    Pipeline scale, fill;
    Sets sets;
};

// Keeps the value of a result, or returns its error.
#define WINDROW_TRY(target, expression)                                                                                          \
    {                                                                                                                            \
        auto result = (expression);                                                                                              \
        if (!result)                                                                                                             \
            return result.failure();                                                                                             \
        (target) = *std::move(result);                                                                                           \
    }

Result<Everything> make_everything(const Host& host, const Functions& functions) {
    constexpr VkDescriptorType buffers[] = {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER};
    constexpr VkDescriptorType image[] = {VK_DESCRIPTOR_TYPE_STORAGE_IMAGE};
    constexpr std::uint32_t constants[] = {64, 0};
    Everything all;
    WINDROW_TRY(all.device, Device::create(host, functions))
    Device& device = *all.device;
    WINDROW_TRY(all.upload, Buffer::create(device, 4096, MemoryUse::upload))
    WINDROW_TRY(all.on_device, Buffer::create(device, VkDeviceSize{20} << 20, MemoryUse::device))
    WINDROW_TRY(all.readback, Buffer::create(device, 4096, MemoryUse::readback))
    WINDROW_TRY(all.halves, Image3D::create(device, {8, 8, 8}, VK_FORMAT_R16_SFLOAT))
    WINDROW_TRY(all.floats, Image3D::create(device, {8, 8, 8}, VK_FORMAT_R32_SFLOAT))
    WINDROW_TRY(
        all.scale,
        Pipeline::create(
            device, {.code = shader_words::scale, .bindings = buffers, .constants = constants, .push_bytes = 8, .name = "scale"}))
    WINDROW_TRY(
        all.fill,
        Pipeline::create(device,
                         {.code = shader_words::fill_r32f, .bindings = image, .constants = {}, .push_bytes = 0, .name = "fill"}))
    const Sets::Content contents[] = {{&all.scale,
                                       {{.type = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, .buffer = all.upload.handle()},
                                        {.type = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, .buffer = all.on_device.handle()}}},
                                      {&all.fill, {{.type = VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, .view = all.floats.view()}}}};
    WINDROW_TRY(all.sets, Sets::create(device, contents))
    return all;
}

using Faults = Gpu;

TEST_F(Faults, AtEachCallLeaveNothingBehindAndAreNamed) {
    const Host host = own->host();
    const auto real = load_functions(host);
    ASSERT_TRUE(real) << real.error();

    // Without a fault: how many calls there are, and that the count sees what lives.
    Functions table = counted(*real);
    {
        const auto all = make_everything(host, table);
        ASSERT_TRUE(all) << all.error();
        for (const auto& [kind, count] : std::map<std::string, int>{{"Buffer", 3},
                                                                    {"Image", 2},
                                                                    {"ImageView", 2},
                                                                    {"Pipeline", 2},
                                                                    {"PipelineLayout", 2},
                                                                    {"DescriptorSetLayout", 2},
                                                                    {"DescriptorPool", 1},
                                                                    {"ShaderModule", 0}})
            EXPECT_EQ(counted_calls().live[kind], count) << kind;
        EXPECT_GE(counted_calls().live["Memory"], 2);
    }
    expect_none_lives();
    const int calls = counted_calls().made;
    // A buffer takes 2, an image 4, a pipeline 4, all sets 2; memory of 2 kinds is allocated, and mapped once.
    ASSERT_GE(calls, 3 * 2 + 2 * 4 + 2 * 4 + 2 + 2 + 1);

    int points = 0;
    for (const VkResult code : {VK_ERROR_OUT_OF_HOST_MEMORY, VK_ERROR_OUT_OF_DEVICE_MEMORY, VK_ERROR_DEVICE_LOST})
        for (int n = 0; n < calls; ++n) {
            table = counted(*real);
            counted_calls().fail_at = n;
            counted_calls().code = code;
            const auto all = make_everything(host, table);
            const std::string failed = counted_calls().failed;
            ASSERT_FALSE(failed.empty()) << n;
            ++points;
            // Where a heap is full and the device has another of the same use, that one serves.
            if (all && failed == "vkAllocateMemory" && code == VK_ERROR_OUT_OF_DEVICE_MEMORY)
                continue;
            ASSERT_FALSE(all) << failed << " failed and was not told";
            EXPECT_NE(all.error().find(failed), std::string::npos) << all.error();
            EXPECT_NE(all.error().find(name_of(code)), std::string::npos) << all.error();
            EXPECT_EQ(all.failure().fault, code == VK_ERROR_DEVICE_LOST ? Fault::device_lost : Fault::out_of_memory)
                << all.error();
            expect_none_lives();
        }
    test::figure("faults tried while the backend's objects are made", points);
    counted_calls() = {};
}

TEST_F(Faults, AsideEachCallHandsOnTheHostsCallbacks) {
    const VkAllocationCallbacks callbacks{}; // known by its address
    Host host = own->host();
    host.allocation_callbacks = &callbacks;
    const auto real = load_functions(host);
    ASSERT_TRUE(real) << real.error();
    const Functions table = counted(*real);
    counted_calls().callbacks = &callbacks;
    const bool made = make_everything(host, table).has_value();
    EXPECT_TRUE(made);
    EXPECT_EQ(counted_calls().without_callbacks, 0);
    expect_none_lives();
    counted_calls() = {};
}

TEST(NamesOfResults, AreTheirOwn) {
    EXPECT_STREQ(name_of(VK_ERROR_DEVICE_LOST), "VK_ERROR_DEVICE_LOST");
    EXPECT_STREQ(name_of(VK_SUCCESS), "VK_SUCCESS");
    EXPECT_STREQ(name_of(static_cast<VkResult>(-12345)), "a VkResult without a name");
}

} // namespace
} // namespace windrow::vulkan
