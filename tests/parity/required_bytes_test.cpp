// Device memory of a wind: known before it is made, and no more than it needs.
#include "fluid/vulkan/wind.h"
#include "tests/figure.h"
#include "tests/parity/gpu.h"

#include <string_view>

namespace windrow::vulkan {
namespace {

using RequiredMemory = Gpu;

struct MemoryCase {
    Config config;
    Settings settings{};
};

TEST_F(RequiredMemory, IsThatOfTheWindThatIsMade) {
    const MemoryCase cases[] = {
        {{.cells = {32, 16, 32}}},
        {{.cells = {64, 32, 64}}, {.texel = Texel::single, .frames_in_flight = 3, .queries = ReadBack::cells}},
        {{.cells = {128, 64, 128}}},
        {{.cells = {17, 9, 23}, .gusts = {.intensity = 0.3f}, .viscosity = 1.0f}, {.queries = ReadBack::none}},
        {{.cells = {28, 6, 28}}, {.frames_in_flight = 1, .gusts = true}}, // tables of more than 64 KiB
        {{.cells = {1, 1, 1}}, {.frames_in_flight = 8}},
        {{.cells = {24, 10, 24}},
         {.textures = TextureSet::both, .timestamps = true, .queries = ReadBack::points, .read_points = 4096}},
        {{.cells = {16, 8, 16}, .max_substeps = 64}, {.queries = ReadBack::box, .read_cells = {16, 4, 4}}},
    };
    for (const MemoryCase& each : cases) {
        const auto required = required_bytes(own->host(), each.config, each.settings);
        ASSERT_TRUE(required) << required.error();
        const auto wind = Wind::create(own->host(), each.config, each.settings);
        ASSERT_TRUE(wind) << wind.error();
        EXPECT_EQ(required->memory, wind->memory_bytes());
        EXPECT_EQ(required->reserved, wind->reserved_bytes());
        const glm::ivec3 cells = each.config.cells;
        test::figure("MiB of a wind of " + std::to_string(cells.x) + "x" + std::to_string(cells.y) + "x" +
                         std::to_string(cells.z),
                     static_cast<double>(wind->memory_bytes()) / 1048576.0);
        WINDROW_EXPECT_FIGURE("bytes reserved over bytes in use",
                              static_cast<double>(wind->reserved_bytes()) / static_cast<double>(wind->memory_bytes()), 1.15);
    }
}

// What the calls below know; Vulkan's calls carry no pointer of ours.
struct Calls {
    PFN_vkGetInstanceProcAddr instance_call = nullptr;
    Functions real;
    int allocations = 0, pipelines = 0, images = 0;
};
Calls g_calls;

VkResult VKAPI_CALL count_allocation(VkDevice device, const VkMemoryAllocateInfo* info, const VkAllocationCallbacks* callbacks,
                                     VkDeviceMemory* made) {
    ++g_calls.allocations;
    return g_calls.real.vkAllocateMemory(device, info, callbacks, made);
}
VkResult VKAPI_CALL count_pipelines(VkDevice device, VkPipelineCache cache, std::uint32_t count,
                                    const VkComputePipelineCreateInfo* infos, const VkAllocationCallbacks* callbacks,
                                    VkPipeline* made) {
    ++g_calls.pipelines;
    return g_calls.real.vkCreateComputePipelines(device, cache, count, infos, callbacks, made);
}
VkResult VKAPI_CALL count_image(VkDevice device, const VkImageCreateInfo* info, const VkAllocationCallbacks* callbacks,
                                VkImage* made) {
    ++g_calls.images;
    return g_calls.real.vkCreateImage(device, info, callbacks, made);
}

PFN_vkVoidFunction VKAPI_CALL counted_device_call(VkDevice device, const char* name) {
    const std::string_view call = name;
    if (call == "vkAllocateMemory")
        return reinterpret_cast<PFN_vkVoidFunction>(&count_allocation);
    if (call == "vkCreateComputePipelines")
        return reinterpret_cast<PFN_vkVoidFunction>(&count_pipelines);
    if (call == "vkCreateImage")
        return reinterpret_cast<PFN_vkVoidFunction>(&count_image);
    return g_calls.real.vkGetDeviceProcAddr(device, name);
}
PFN_vkVoidFunction VKAPI_CALL counted_instance_call(VkInstance instance, const char* name) {
    return std::string_view(name) == "vkGetDeviceProcAddr" ? reinterpret_cast<PFN_vkVoidFunction>(&counted_device_call)
                                                           : g_calls.instance_call(instance, name);
}

// To ask is cheap: no memory and no pipeline, and no object that stays (the layer would report it).
TEST_F(RequiredMemory, IsKnownWithoutMemoryOrPipelines) {
    Host host = own->host();
    g_calls = {.instance_call = host.get_instance_proc_addr, .real = device->functions()};
    host.get_instance_proc_addr = &counted_instance_call;
    const auto required = required_bytes(host, {.cells = {16, 8, 16}});
    ASSERT_TRUE(required) << required.error();
    EXPECT_EQ(g_calls.allocations, 0);
    EXPECT_EQ(g_calls.pipelines, 0);
    EXPECT_EQ(g_calls.images, 2);
    EXPECT_TRUE(Wind::create(host, {.cells = {16, 8, 16}}));
    EXPECT_GT(g_calls.allocations, 0);
    EXPECT_GT(g_calls.pipelines, 10);
}

// Memory of the host's own is counted as it is asked for.
TEST_F(RequiredMemory, OfAHostsAllocatorIsWhatItIsAskedFor) {
    Host host = own->host();
    VkPhysicalDeviceMemoryProperties types{};
    device->functions().vkGetPhysicalDeviceMemoryProperties(host.physical_device, &types);
    std::uint64_t asked = 0;
    Memory behind(own->host(), device->functions());
    host.memory.allocate = [&](const VkMemoryRequirements& wanted, std::uint32_t type, MemoryPiece& piece) {
        asked += wanted.size;
        auto given = behind.allocate({.size = wanted.size, .alignment = wanted.alignment, .memoryTypeBits = 1u << type},
                                     VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT & types.memoryTypes[type].propertyFlags, 0, true);
        if (!given)
            return VK_ERROR_OUT_OF_DEVICE_MEMORY;
        piece = *given;
        return VK_SUCCESS;
    };
    host.memory.release = [&](const MemoryPiece& piece) { behind.release(piece); };
    const Config config{.cells = {16, 8, 16}};
    const auto required = required_bytes(host, config);
    ASSERT_TRUE(required) << required.error();
    EXPECT_EQ(asked, 0u); // nothing is allocated to find out
    const auto wind = Wind::create(host, config);
    ASSERT_TRUE(wind) << wind.error();
    EXPECT_EQ(required->memory, asked);
    EXPECT_EQ(wind->memory_bytes(), asked);
}

TEST_F(RequiredMemory, OfWhatCannotBeMadeIsAReason) {
    expect_error(required_bytes(own->host(), {.cells = {0, 4, 4}}), "cells");
    expect_error(required_bytes(own->host(), {}, {.frames_in_flight = 9}), "frames_in_flight is 9");
    expect_error(required_bytes(own->host(), {.cells = {1024, 1024, 1024}}), "cells");
    expect_error(required_bytes({}, {}), "get_instance_proc_addr");
}

} // namespace
} // namespace windrow::vulkan
