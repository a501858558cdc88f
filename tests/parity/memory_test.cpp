// The block allocator: pieces that do not overlap, the right kind of memory, and all of it given back.
#include "gpu/free_ranges.h"
#include "gpu/memory.h"
#include "tests/parity/fake_memory.h"

#include <algorithm>
#include <cstring>
#include <gtest/gtest.h>
#include <random>
#include <string>

namespace windrow::vulkan {
namespace {

constexpr VkDeviceSize k_mebi = VkDeviceSize{1} << 20;
constexpr VkMemoryPropertyFlags k_local = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
constexpr VkMemoryPropertyFlags k_visible = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT;
constexpr VkMemoryPropertyFlags k_coherent = VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
constexpr VkMemoryPropertyFlags k_cached = VK_MEMORY_PROPERTY_HOST_CACHED_BIT;

VkMemoryRequirements of_bytes(VkDeviceSize bytes, VkDeviceSize alignment = 16, std::uint32_t types = ~0u) {
    return {.size = bytes, .alignment = alignment, .memoryTypeBits = types};
}

/// As a graphics card has them: its own memory, the system's, and a window of 256 MiB in which the host sees the card's.
class ACard : public testing::Test {
  protected:
    FakeMemory fake{{1024 * k_mebi, 1024 * k_mebi, 256 * k_mebi},
                    {{k_local | VK_MEMORY_PROPERTY_PROTECTED_BIT, 0},
                     {k_local, 0},
                     {k_visible | k_coherent, 1},
                     {k_visible | k_cached, 1},
                     {k_local | k_visible | k_coherent, 2}}};
    Memory memory{Host{}, FakeMemory::functions()};
};

// --- Which bytes are free ----------------------------------------------------------------------------------------------

// Against a map of each byte.
TEST(FreeRanges, GiveEachByteOnce) {
    constexpr std::size_t size = 2000;
    std::mt19937 random(3);
    FreeRanges ranges(size);
    std::vector<int> owner(size, 0);
    std::map<std::uint64_t, std::uint64_t> held;
    int rejected = 0;
    for (int n = 1; n <= 20'000; ++n) {
        if (random() % 2 == 0 && !held.empty()) {
            auto piece = held.begin();
            std::advance(piece, random() % held.size());
            ASSERT_EQ(ranges.give_back(piece->first), piece->second);
            std::fill_n(owner.begin() + static_cast<std::ptrdiff_t>(piece->first), piece->second, 0);
            held.erase(piece);
            continue;
        }
        const std::uint64_t bytes = 1 + random() % 100, alignment = std::uint64_t{1} << random() % 6;
        // The lowest place where it fits, by looking at every byte.
        std::uint64_t wanted = 0;
        const auto fits = [&](std::uint64_t at) {
            return std::all_of(owner.begin() + static_cast<std::ptrdiff_t>(at),
                               owner.begin() + static_cast<std::ptrdiff_t>(at + bytes), [](int o) { return o == 0; });
        };
        while (wanted + bytes <= size && !fits(wanted))
            wanted += alignment;
        const auto offset = ranges.take(bytes, alignment);
        ASSERT_EQ(offset.has_value(), wanted + bytes <= size);
        if (!offset) {
            ++rejected;
            continue;
        }
        ASSERT_EQ(*offset, wanted);
        std::fill_n(owner.begin() + static_cast<std::ptrdiff_t>(*offset), bytes, n);
        held[*offset] = bytes;
    }
    EXPECT_GT(rejected, 100); // it was full now and then
    for (const auto& [offset, bytes] : held)
        ranges.give_back(offset);
    EXPECT_TRUE(ranges.all_free());
    EXPECT_EQ(ranges.take(size, 1), 0u); // all in one piece again
}

// --- Pieces ------------------------------------------------------------------------------------------------------------

TEST_F(ACard, GivesPiecesThatDoNotOverlap) {
    struct Held {
        MemoryPiece piece;
        VkDeviceSize bytes;
        bool linear;
    };
    std::mt19937 random(4);
    std::vector<Held> all;
    VkDeviceSize given = 0;
    for (int n = 0; n < 2000; ++n) {
        if (random() % 3 == 0 && !all.empty()) {
            const auto at = all.begin() + static_cast<std::ptrdiff_t>(random() % all.size());
            memory.release(at->piece);
            given -= at->bytes;
            all.erase(at);
            continue;
        }
        const VkDeviceSize bytes = 1 + random() % (512 * 1024), alignment = VkDeviceSize{1} << random() % 13;
        const bool visible = random() % 2 == 0, linear = visible || random() % 2 == 0;
        const auto piece =
            memory.allocate(of_bytes(bytes, alignment), visible ? k_visible : 0, visible ? k_cached : k_local, linear);
        ASSERT_TRUE(piece) << piece.error();
        const VkDeviceSize held = visible ? (bytes + FakeMemory::k_atom - 1) / FakeMemory::k_atom * FakeMemory::k_atom : bytes;
        ASSERT_EQ(piece->offset % alignment, 0u);
        ASSERT_EQ(piece->mapped != nullptr, visible);
        if (visible) {
            ASSERT_EQ(piece->offset % FakeMemory::k_atom, 0u);
            ASSERT_EQ(piece->mapped, fake.of(piece->memory).host.get() + piece->offset);
        }
        ASSERT_LE(piece->offset + held, fake.of(piece->memory).bytes);
        for (const Held& other : all)
            if (other.piece.memory == piece->memory) {
                ASSERT_TRUE(other.piece.offset + other.bytes <= piece->offset || piece->offset + held <= other.piece.offset);
                ASSERT_EQ(other.linear, linear); // a buffer and an image in one block would need bufferImageGranularity
            }
        all.push_back({*piece, held, linear});
        given += held;
        ASSERT_EQ(memory.given(), given);
        ASSERT_EQ(memory.taken(), fake.bytes());
        ASSERT_EQ(static_cast<std::size_t>(memory.blocks()), fake.count());
    }
    EXPECT_LE(fake.maps, fake.grants); // a block is mapped once, not for each piece
    for (const Held& held : all)
        memory.release(held.piece);
    EXPECT_EQ(memory.given(), 0u);
    EXPECT_EQ(memory.taken(), 0u);
    EXPECT_EQ(fake.count(), 0u);
}

TEST_F(ACard, GivesTheKindThatIsAskedFor) {
    const auto type_of = [&](VkMemoryPropertyFlags wanted, VkMemoryPropertyFlags preferred, std::uint32_t types = ~0u) {
        const auto piece = memory.allocate(of_bytes(100, 16, types), wanted, preferred, true);
        EXPECT_TRUE(piece) << piece.error();
        return piece ? fake.of(piece->memory).type : ~0u;
    };
    EXPECT_EQ(type_of(0, k_local), 1u); // not the protected one
    EXPECT_EQ(type_of(k_visible | k_coherent, k_local), 4u);
    EXPECT_EQ(type_of(k_visible, k_cached), 3u);
    EXPECT_EQ(type_of(k_visible, k_cached, 0b00100), 2u); // the only one that the buffer may lie in
    const auto none = memory.allocate(of_bytes(100, 16, 0b00010), k_visible, 0, true);
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().find("host-visible"), std::string::npos) << none.error();
}

TEST_F(ACard, MapsABlockOnce) {
    for (int n = 0; n < 10; ++n)
        ASSERT_TRUE(memory.allocate(of_bytes(1000), k_visible, 0, true));
    EXPECT_EQ(fake.count(), 1u);
    EXPECT_EQ(fake.maps, 1);
}

TEST_F(ACard, GivesALargePieceABlockOfItsSize) {
    const auto large = memory.allocate(of_bytes(20 * k_mebi + 8), 0, k_local, true);
    ASSERT_TRUE(large) << large.error();
    EXPECT_EQ(fake.of(large->memory).bytes, 20 * k_mebi + 8);
    const auto small = memory.allocate(of_bytes(8), 0, k_local, true);
    ASSERT_TRUE(small) << small.error();
    EXPECT_EQ(fake.of(small->memory).bytes, 16 * k_mebi);
}

// --- Limits, which a software driver does not keep --------------------------------------------------------------------

TEST_F(ACard, RejectsMoreAtOnceThanTheDeviceGrants) {
    const auto rejected = memory.allocate(of_bytes(FakeMemory::k_largest + 1), 0, k_local, true);
    ASSERT_FALSE(rejected);
    EXPECT_NE(rejected.error().find("maxMemoryAllocationSize"), std::string::npos) << rejected.error();
    EXPECT_EQ(fake.count(), 0u);
}

TEST_F(ACard, TakesTheNextHeapWhereOneIsFullAndRejectsWhereAllAre) {
    std::vector<std::uint32_t> types;
    for (;;) {
        const auto piece = memory.allocate(of_bytes(60 * k_mebi), k_visible | k_coherent, k_local, true);
        if (!piece) {
            EXPECT_NE(piece.error().find("do not fit"), std::string::npos) << piece.error();
            break;
        }
        types.push_back(fake.of(piece->memory).type);
    }
    // 4 pieces of 60 MiB in the window of 256 MiB, 17 in the system's 1024 MiB.
    std::vector<std::uint32_t> wanted(4, 4);
    wanted.insert(wanted.end(), 17, 2);
    EXPECT_EQ(types, wanted);
}

TEST_F(ACard, LeavesNothingBehindWhereACallFails) {
    for (const VkResult code : {VK_ERROR_OUT_OF_HOST_MEMORY, VK_ERROR_OUT_OF_DEVICE_MEMORY, VK_ERROR_DEVICE_LOST}) {
        fake.rejection = code;
        const auto rejected = memory.allocate(of_bytes(1000), 0, k_local, true);
        ASSERT_FALSE(rejected);
        for (const std::string word : {"1000 bytes of device memory", "vkAllocateMemory", name_of(code)})
            EXPECT_NE(rejected.error().find(word), std::string::npos) << rejected.error();
        fake.rejection = VK_SUCCESS;
        fake.map_rejection = code;
        const auto unmapped = memory.allocate(of_bytes(1000), k_visible, 0, true);
        ASSERT_FALSE(unmapped);
        for (const std::string word : {"host-visible", "vkMapMemory", name_of(code)})
            EXPECT_NE(unmapped.error().find(word), std::string::npos) << unmapped.error();
        fake.map_rejection = VK_SUCCESS;
        EXPECT_EQ(memory.given(), 0u);
        EXPECT_EQ(fake.count(), 0u);
    }
}

// --- The host's own allocator ------------------------------------------------------------------------------------------

TEST(HostsAllocator, IsAskedInPlaceOfOurs) {
    FakeMemory fake{{1024 * k_mebi}, {{k_local, 0}, {k_visible | k_cached, 0}}};
    std::vector<VkMemoryRequirements> asked;
    std::vector<std::uint32_t> types;
    std::vector<std::uint64_t> released;
    VkResult answer = VK_SUCCESS;
    Host host;
    host.memory.allocate = [&](const VkMemoryRequirements& requirements, std::uint32_t type, MemoryPiece& piece) {
        if (answer != VK_SUCCESS)
            return answer;
        asked.push_back(requirements);
        types.push_back(type);
        piece.memory = reinterpret_cast<VkDeviceMemory>(std::uintptr_t{7});
        piece.offset = 4096 * asked.size();
        piece.user = asked.size();
        return VK_SUCCESS;
    };
    host.memory.release = [&](const MemoryPiece& piece) { released.push_back(piece.user); };
    {
        Memory memory(host, FakeMemory::functions());
        const auto first = memory.allocate(of_bytes(100), k_visible, k_cached, true);
        const auto second = memory.allocate(of_bytes(2000), 0, k_local, false);
        ASSERT_TRUE(first && second);
        EXPECT_EQ(types, (std::vector<std::uint32_t>{1, 0}));
        for (const VkMemoryRequirements& requirements : asked) {
            EXPECT_EQ(requirements.alignment, FakeMemory::k_granularity);
            EXPECT_EQ(requirements.size % FakeMemory::k_granularity, 0u);
        }
        EXPECT_EQ(memory.given(), 3 * FakeMemory::k_granularity);
        EXPECT_EQ(memory.taken(), memory.given());
        EXPECT_EQ(memory.blocks(), 0);
        answer = VK_ERROR_OUT_OF_DEVICE_MEMORY;
        const auto rejected = memory.allocate(of_bytes(100), 0, k_local, true);
        ASSERT_FALSE(rejected);
        EXPECT_NE(rejected.error().find("Host::memory.allocate"), std::string::npos) << rejected.error();
        memory.release(*second);
        EXPECT_EQ(released, std::vector<std::uint64_t>{2});
    }
    EXPECT_EQ(released, (std::vector<std::uint64_t>{2, 1})); // the rest with the memory
    EXPECT_EQ(fake.count(), 0u);
}

} // namespace
} // namespace windrow::vulkan
