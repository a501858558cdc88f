// Device memory of a wind: known before it is made, and no more than it needs.
#include "fluid/vulkan/wind.h"
#include "tests/figure.h"
#include "tests/parity/gpu.h"

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
