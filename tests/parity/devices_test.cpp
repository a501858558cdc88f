// What the machine's devices are told to be, and what is rejected before anything is made.
#include "fluid/vulkan/wind.h"
#include "gpu/functions.h"
#include "tests/parity/gpu.h"

#include <algorithm>

namespace windrow::vulkan {
namespace {

TEST(Devices, AreListedWithTheirDrivers) {
    const auto devices = list_devices();
    ASSERT_TRUE(devices) << devices.error() << "\nA software driver will do (Debian: mesa-vulkan-drivers).";
    ASSERT_FALSE(devices->empty());
    for (const DeviceFacts& facts : *devices) {
        EXPECT_FALSE(facts.name.empty());
        EXPECT_FALSE(facts.driver.empty());
        EXPECT_TRUE(facts.api_version.starts_with("1.")) << facts.api_version;
        std::printf("%s, %s, Vulkan %s%s%s\n", facts.name.c_str(), facts.driver.c_str(), facts.api_version.c_str(),
                    facts.software ? ", software" : "", facts.trouble.c_str());
    }
}

TEST(Devices, APlaceThatThereIsNotIsRejected) {
    const auto devices = list_devices();
    ASSERT_TRUE(devices) << devices.error();
    expect_error(OwnDevice::create({.device = static_cast<int>(devices->size())}), "give one from 0 to ");
    expect_error(OwnDevice::create({.device = -2}), "device is -2");
}

TEST(Devices, TheDefaultIsOneThatCanRunTheWind) {
    const auto own = OwnDevice::create({});
    ASSERT_TRUE(own) << own.error();
    EXPECT_EQ((*own)->facts().trouble, "");
    const auto devices = list_devices();
    ASSERT_TRUE(devices) << devices.error();
    bool hardware = false;
    for (const DeviceFacts& facts : *devices)
        hardware = hardware || (!facts.software && facts.trouble.empty());
    EXPECT_EQ((*own)->facts().software, !hardware);
}

// Each slot waits for its own work alone, and `wait` for all.
TEST_F(Gpu, SlotsAreSubmittedWithoutWaiting) {
    constexpr VkDeviceSize bytes = 64;
    std::vector<Buffer> targets;
    for (std::uint32_t n = 0; n < 6; ++n) {
        targets.push_back(*Buffer::create(*device, bytes, MemoryUse::readback));
        const auto submitted = own->submit(static_cast<int>(n % 3), [&](VkCommandBuffer commands) {
            device->functions().vkCmdFillBuffer(commands, targets.back().handle(), 0, bytes, n + 1);
            barrier(commands);
        });
        ASSERT_TRUE(submitted) << submitted.error();
    }
    ASSERT_TRUE(own->wait());
    for (std::uint32_t n = 0; n < 6; ++n)
        EXPECT_EQ(read<std::uint32_t>(targets[n], 1)[0], n + 1);
}

TEST(Devices, AQueueOrAnExtensionThatThereIsNotIsRejected) {
    expect_error(OwnDevice::create({.queue_without = VK_QUEUE_COMPUTE_BIT}), "has no queue");
    expect_error(OwnDevice::create({.extensions = {"VK_KHR_none"}}), "VK_ERROR_EXTENSION_NOT_PRESENT");
}

class AHost : public Gpu {};

// For tools: what is divided where shared memory is short, and each pipeline with its name.
TEST_F(AHost, BoundsSharedMemoryAndSeesPipelines) {
    Host host = own->host();
    std::vector<std::string> names;
    host.pipelines.created = [&](const char* name, VkPipeline pipeline) {
        EXPECT_NE(pipeline, VkPipeline{VK_NULL_HANDLE});
        names.push_back(name);
    };
    const Config config{.cells = {16, 8, 16}, .max_substeps = 1};
    int dispatches[2] = {};
    for (const bool split : {false, true}) {
        host.shared_bytes = split ? 256 : 0; // half a plane, and no slab
        auto wind = Wind::create(host, config);
        ASSERT_TRUE(wind) << wind.error();
        ASSERT_TRUE(wind->motors().add(VortexMotor{}));
        for (int n = 0; n < 3; ++n)
            run([&](VkCommandBuffer commands) { (void)wind->record_step(commands, {.dt = 0.01}); });
        dispatches[split ? 1 : 0] = wind->dispatches();
    }
    EXPECT_EQ(dispatches[1], dispatches[0] + 2) << "the second axis, there and back";
    EXPECT_EQ(std::count(names.begin(), names.end(), "modes_between"), 2);
    EXPECT_EQ(std::count(names.begin(), names.end(), "slabs"), 1);
    EXPECT_GE(names.size(), 30u);
}

TEST_F(AHost, ThatIsNotWholeIsRejected) {
    Host host = own->host();
    host.device = VK_NULL_HANDLE;
    expect_error(Device::create(host), "device is null");
    host = own->host();
    host.physical_device = VK_NULL_HANDLE;
    expect_error(Device::create(host), "physical_device is null");
    host = own->host();
    host.get_instance_proc_addr = nullptr;
    expect_error(Device::create(host), "get_instance_proc_addr is null");
    host = own->host();
    host.queue_family = 1000;
    expect_error(Device::create(host), "queue_family is 1000");
    host = own->host();
    host.memory.release = [](const MemoryPiece&) {};
    expect_error(Device::create(host), "give both or neither");
}

PFN_vkVoidFunction VKAPI_CALL only_of_the_instance(VkInstance, const char* name) {
    return std::string(name) == "vkGetDeviceProcAddr"
               ? reinterpret_cast<PFN_vkVoidFunction>(+[](VkDevice, const char*) { return PFN_vkVoidFunction{}; })
               : nullptr;
}

TEST_F(AHost, WithoutCallsIsToldEachThatIsMissing) {
    Host host = own->host();
    host.get_instance_proc_addr = &only_of_the_instance;
    const auto functions = load_functions(host);
    ASSERT_FALSE(functions);
#define WINDROW_EXPECT(name)                                                                                                     \
    EXPECT_EQ(functions.error().find(#name ",") != std::string::npos || functions.error().find(#name ":") != std::string::npos,  \
              std::string(#name) != "vkGetDeviceProcAddr")                                                                       \
        << #name;
    WINDROW_INSTANCE_FUNCTIONS(WINDROW_EXPECT)
    WINDROW_DEVICE_FUNCTIONS(WINDROW_EXPECT)
#undef WINDROW_EXPECT
}

// --- Limits, which a software driver does not ask ----------------------------------------------------------------------

class Limits : public Gpu {};

TEST_F(Limits, OfBuffersAreAsked) {
    const VkDeviceSize largest = device->limits().maxStorageBufferRange;
    expect_error(Buffer::create(*device, largest + 1, MemoryUse::device), "maxStorageBufferRange");
    EXPECT_FALSE(Buffer::create(*device, 0, MemoryUse::device));
    const auto block = Buffer::create(*device, device->limits().maxUniformBufferRange + VkDeviceSize{1}, MemoryUse::upload,
                                      VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
    // Rejected by one limit or the other where they are equal.
    ASSERT_FALSE(block);
    EXPECT_NE(block.error().find("BufferRange"), std::string::npos) << block.error();
}

TEST_F(Limits, OfImagesAreAsked) {
    const std::uint32_t most = device->limits().maxImageDimension3D;
    for (const VkExtent3D extent : {VkExtent3D{most + 1, 1, 1}, VkExtent3D{1, most + 1, 1}, VkExtent3D{1, 1, most + 1}}) {
        expect_error(Image3D::create(*device, extent, VK_FORMAT_R16_SFLOAT), "maxImageDimension3D");
    }
    EXPECT_FALSE(Image3D::create(*device, {0, 4, 4}, VK_FORMAT_R32_SFLOAT));
    EXPECT_FALSE(Image3D::create(*device, {4, 4, 0}, VK_FORMAT_R32_SFLOAT));
    const auto no_format = Image3D::create(*device, {4, 4, 4}, VK_FORMAT_R64G64B64A64_SFLOAT); // no texture unit reads doubles
    ASSERT_FALSE(no_format);
    EXPECT_NE(no_format.error().find("VK_ERROR_FORMAT_NOT_SUPPORTED"), std::string::npos) << no_format.error();
}

TEST_F(Limits, OfDispatchesAreAsked) {
    const VkPhysicalDeviceLimits& limits = device->limits();
    EXPECT_TRUE(device->check({.groups = {1, 1, 1}, .local_size = {64, 1, 1}, .shared_bytes = 1024, .name = "a"}));
    const auto rejected = device->check({.groups = {1, 1, limits.maxComputeWorkGroupCount[2] + 1},
                                         .local_size = {limits.maxComputeWorkGroupInvocations, 2, 1},
                                         .shared_bytes = limits.maxComputeSharedMemorySize + 4,
                                         .name = "advection"});
    const bool expressible = limits.maxComputeWorkGroupCount[2] != UINT32_MAX;
    ASSERT_FALSE(rejected);
    for (const char* limit : {"maxComputeWorkGroupInvocations", "maxComputeSharedMemorySize", "the pass advection"})
        EXPECT_NE(rejected.error().find(limit), std::string::npos) << rejected.error();
    EXPECT_EQ(rejected.error().find("maxComputeWorkGroupCount") != std::string::npos, expressible) << rejected.error();
}

TEST_F(Limits, OfPipelinesAreAsked) {
    const std::uint32_t code[] = {0}; // rejected before it is read
    expect_error(Pipeline::create(*device, {.code = code,
                                            .bindings = {},
                                            .constants = {},
                                            .push_bytes = device->limits().maxPushConstantsSize + 4,
                                            .name = "advection"}),
                 "the pass advection pushes");
}

} // namespace
} // namespace windrow::vulkan
