#include "gpu/memory.h"

#include "fluid/core/message.h"
#include "gpu/free_ranges.h"
#include "gpu/functions.h"
#include "gpu/handle.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace windrow::vulkan {
namespace {

/// [bytes] Of a block for pieces that come one by one; small against a device's memory.
constexpr VkDeviceSize k_block_bytes = VkDeviceSize{16} << 20;
/// [bytes] The same for pieces after a measured set, such as tables of new boundaries.
constexpr VkDeviceSize k_later_block_bytes = VkDeviceSize{1} << 20;

/// Memory that needs a feature to be enabled, or that is for other uses.
constexpr VkMemoryPropertyFlags k_unfit = VK_MEMORY_PROPERTY_LAZILY_ALLOCATED_BIT | VK_MEMORY_PROPERTY_PROTECTED_BIT |
                                          VK_MEMORY_PROPERTY_DEVICE_COHERENT_BIT_AMD |
                                          VK_MEMORY_PROPERTY_DEVICE_UNCACHED_BIT_AMD | VK_MEMORY_PROPERTY_RDMA_CAPABLE_BIT_NV;

struct MemoryBlock {
    Handle<VkDeviceMemory, &Functions::vkFreeMemory> memory;
    FreeRanges ranges;
    VkDeviceSize bytes;
    std::uint32_t type;
    bool linear;
    std::uint64_t id;
    bool dedicated = false; ///< to one image
    std::byte* mapped = nullptr;
};

/// A newly allocated range of a block.
struct Taken {
    MemoryBlock* block = nullptr;
    VkDeviceSize offset = 0;
};

/// Pieces that lie in one block, measured.
struct ExpectedBlock {
    std::uint32_t type;
    bool linear;
    VkDeviceSize bytes;
};

struct HostPiece {
    MemoryPiece piece;
    VkDeviceSize bytes;
};

VkDeviceSize rounded_up(VkDeviceSize size, VkDeviceSize multiple) {
    return (size + multiple - 1) / multiple * multiple;
}

std::string kind_of(VkMemoryPropertyFlags wanted) {
    return (wanted & VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT) != 0 ? "host-visible memory" : "device memory";
}

} // namespace

struct WINDROW_HIDDEN Memory::State {
    Host host;
    Functions functions;
    VkPhysicalDeviceMemoryProperties properties{};
    VkDeviceSize largest_allocation = 0;
    VkDeviceSize atom = 1;        ///< nonCoherentAtomSize
    VkDeviceSize granularity = 1; ///< bufferImageGranularity
    std::vector<MemoryBlock> blocks{};
    std::vector<HostPiece> host_pieces{};
    std::uint64_t last_id = 0;
    VkDeviceSize given = 0;
    bool measuring = false;
    std::optional<std::vector<ExpectedBlock>> expected{}; ///< blocks of the measured pieces that are still to be made
    Measured measured{};

    void measure(const VkMemoryRequirements& asked, std::uint32_t type, bool linear) {
        measured.given += asked.size;
        if (host.memory.allocate) {
            measured.taken += asked.size;
            return;
        }
        auto block = std::find_if(expected->begin(), expected->end(),
                                  [&](const ExpectedBlock& other) { return other.type == type && other.linear == linear; });
        if (block == expected->end())
            block = expected->insert(block, {.type = type, .linear = linear, .bytes = 0});
        const VkDeviceSize end = rounded_up(block->bytes, asked.alignment) + asked.size;
        measured.taken += end - block->bytes;
        block->bytes = end;
    }
    /// [bytes] Of the next block, where a piece needs no more.
    [[nodiscard]] VkDeviceSize next_block(std::uint32_t type, bool linear) {
        const VkDeviceSize usual =
            std::min(expected ? k_later_block_bytes : k_block_bytes, rounded_up(heap_bytes(type) / 8, atom));
        if (!expected)
            return usual;
        const auto block = std::find_if(expected->begin(), expected->end(),
                                        [&](const ExpectedBlock& other) { return other.type == type && other.linear == linear; });
        if (block == expected->end())
            return usual;
        const VkDeviceSize bytes = block->bytes;
        expected->erase(block);
        return bytes;
    }

    /// Types that fit: those with the most preferred properties first, then those with the fewest avoided ones. Equal types keep
    /// their order: drivers list the better first.
    [[nodiscard]] std::vector<std::uint32_t> types_for(std::uint32_t allowed, VkMemoryPropertyFlags wanted,
                                                       VkMemoryPropertyFlags preferred, VkMemoryPropertyFlags avoided) const {
        std::vector<std::uint32_t> types;
        for (std::uint32_t type = 0; type < properties.memoryTypeCount; ++type) {
            const VkMemoryPropertyFlags has = properties.memoryTypes[type].propertyFlags;
            if ((allowed >> type & 1u) != 0 && (has & wanted) == wanted && (has & k_unfit) == 0)
                types.push_back(type);
        }
        const auto score = [&](std::uint32_t type) {
            const VkMemoryPropertyFlags has = properties.memoryTypes[type].propertyFlags;
            return 32 * std::popcount(has & preferred) - std::popcount(has & avoided);
        };
        std::stable_sort(types.begin(), types.end(), [&](std::uint32_t a, std::uint32_t b) { return score(a) > score(b); });
        return types;
    }

    [[nodiscard]] VkDeviceSize heap_bytes(std::uint32_t type) const {
        return properties.memoryHeaps[properties.memoryTypes[type].heapIndex].size;
    }
    /// Bytes of the heap of `type` outside our blocks. Computed here, since a software driver grants memory that it lacks.
    [[nodiscard]] VkDeviceSize heap_left(std::uint32_t type) const {
        VkDeviceSize left = heap_bytes(type);
        for (const MemoryBlock& block : blocks)
            if (properties.memoryTypes[block.type].heapIndex == properties.memoryTypes[type].heapIndex)
                left -= std::min(left, block.bytes);
        return left;
    }

    [[nodiscard]] VkResult map(MemoryBlock& block) {
        if (block.mapped != nullptr)
            return VK_SUCCESS;
        void* address = nullptr;
        const VkResult result = functions.vkMapMemory(host.device, block.memory.get(), 0, VK_WHOLE_SIZE, 0, &address);
        if (result == VK_SUCCESS)
            block.mapped = static_cast<std::byte*>(address);
        return result;
    }

    /// One more block, the last of `blocks`. `dedicated`: for one image, with what VkMemoryAllocateInfo is chained to; else null.
    [[nodiscard]] VkResult add_block(std::uint32_t type, bool linear, VkDeviceSize piece_bytes, const void* dedicated = nullptr) {
        VkDeviceSize bytes = dedicated != nullptr ? piece_bytes : std::max(piece_bytes, next_block(type, linear));
        if (bytes > heap_left(type) || bytes > largest_allocation)
            bytes = piece_bytes;
        if (bytes > heap_left(type))
            return VK_ERROR_OUT_OF_DEVICE_MEMORY;
        const VkMemoryAllocateInfo info{.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO,
                                        .pNext = dedicated,
                                        .allocationSize = bytes,
                                        .memoryTypeIndex = type};
        Handle<VkDeviceMemory, &Functions::vkFreeMemory> memory;
        const VkResult result = make(functions, host, functions.vkAllocateMemory, info, memory);
        if (result == VK_SUCCESS)
            blocks.push_back({.memory = std::move(memory),
                              .ranges = FreeRanges(bytes),
                              .bytes = bytes,
                              .type = type,
                              .linear = linear,
                              .id = ++last_id,
                              .dedicated = dedicated != nullptr});
        return result;
    }

    /// From a block of this type and use that has room, else from a new one.
    [[nodiscard]] VkResult take(const VkMemoryRequirements& asked, std::uint32_t type, bool linear, Taken& taken) {
        for (MemoryBlock& block : blocks)
            if (block.type == type && block.linear == linear && !block.dedicated)
                if (const auto offset = block.ranges.take(asked.size, asked.alignment)) {
                    taken = {&block, *offset};
                    return VK_SUCCESS;
                }
        const VkResult result = add_block(type, linear, asked.size);
        if (result == VK_SUCCESS)
            taken = {&blocks.back(), *blocks.back().ranges.take(asked.size, asked.alignment)};
        return result;
    }
};

Memory::Memory(const Host& host, const Functions& functions)
    : state_(std::make_unique<State>(State{.host = host, .functions = functions})) {
    functions.vkGetPhysicalDeviceMemoryProperties(host.physical_device, &state_->properties);
    VkPhysicalDeviceMaintenance3Properties maintenance{};
    maintenance.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_3_PROPERTIES;
    VkPhysicalDeviceProperties2 properties{};
    properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
    properties.pNext = &maintenance;
    functions.vkGetPhysicalDeviceProperties2(host.physical_device, &properties);
    state_->largest_allocation = maintenance.maxMemoryAllocationSize;
    state_->atom = properties.properties.limits.nonCoherentAtomSize;
    state_->granularity = properties.properties.limits.bufferImageGranularity;
}

Memory::~Memory() {
    for (const HostPiece& left : state_->host_pieces)
        state_->host.memory.release(left.piece);
}

Result<MemoryPiece> Memory::allocate(const VkMemoryRequirements& requirements, VkMemoryPropertyFlags wanted,
                                     VkMemoryPropertyFlags preferred, bool linear, VkMemoryPropertyFlags avoided) {
    State& state = *state_;
    const bool visible = (wanted & VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT) != 0;
    const std::string what = detail::message(requirements.size, " bytes of ", kind_of(wanted));
    if (requirements.size > state.largest_allocation)
        return Error{detail::message(what, " are more than the device allocates at once (", state.largest_allocation,
                                     ", maxMemoryAllocationSize): use a smaller box.")};
    const std::vector<std::uint32_t> types = state.types_for(requirements.memoryTypeBits, wanted, preferred, avoided);
    if (types.empty())
        return Error{detail::message(what, " are needed, and the device has no such memory type: use another device.")};

    // Whole atoms, so that flushing one allocation never touches its neighbour.
    VkMemoryRequirements asked = requirements;
    if (visible) {
        asked.alignment = std::max(asked.alignment, state.atom);
        asked.size = rounded_up(asked.size, state.atom);
    }
    if (state.host.memory.allocate) {
        asked.alignment = std::max(asked.alignment, state.granularity);
        asked.size = rounded_up(asked.size, state.granularity);
    }
    if (state.measuring) {
        state.measure(asked, types.front(), linear);
        return MemoryPiece{};
    }
    VkResult result = VK_ERROR_OUT_OF_DEVICE_MEMORY;
    if (state.host.memory.allocate) {
        for (const std::uint32_t type : types) {
            MemoryPiece piece;
            state.host_pieces.reserve(state.host_pieces.size() + 1); // before any allocation that a failure would lose
            result = state.host.memory.allocate(asked, type, piece);
            if (result == VK_SUCCESS) {
                state.host_pieces.push_back({piece, asked.size});
                state.given += asked.size;
                return piece;
            }
            if (result != VK_ERROR_OUT_OF_DEVICE_MEMORY)
                break;
        }
        return call_error("Host::memory.allocate", what, result);
    }

    for (const std::uint32_t type : types) {
        Taken taken;
        result = state.take(asked, type, linear, taken);
        if (result == VK_ERROR_OUT_OF_DEVICE_MEMORY)
            continue; // another heap may have room
        if (result != VK_SUCCESS)
            break;
        state.given += asked.size;
        MemoryPiece piece{
            .memory = taken.block->memory.get(), .offset = taken.offset, .mapped = nullptr, .user = taken.block->id};
        if (!visible)
            return piece;
        if (result = state.map(*taken.block); result != VK_SUCCESS) {
            release(piece);
            return call_error("vkMapMemory", what, result);
        }
        piece.mapped = taken.block->mapped + taken.offset;
        return piece;
    }
    const auto is_full = [&](std::uint32_t type) { return state.heap_left(type) < asked.size; };
    if (std::all_of(types.begin(), types.end(), is_full))
        return Error{what + " do not fit into the device's memory: free device memory or use a smaller box."};
    return call_error("vkAllocateMemory", what, result);
}

Result<MemoryPiece> Memory::allocate_exported(const VkMemoryRequirements& requirements, VkImage image,
                                              VkExternalMemoryHandleTypeFlagBits handle_type) {
    State& state = *state_;
    const std::string what = detail::message(requirements.size, " bytes of memory to be exported");
    if (state.host.memory.allocate)
        return Error{what + " cannot come from Host::memory: leave one of Host::memory and Settings::export_textures out."};
    const std::vector<std::uint32_t> types =
        state.types_for(requirements.memoryTypeBits, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, 0);
    if (types.empty())
        return Error{what + " are needed, and the device has no such memory type: use another device."};
    if (state.measuring) {
        state.measured.given += requirements.size;
        state.measured.taken += requirements.size;
        return MemoryPiece{};
    }
    const VkMemoryDedicatedAllocateInfo alone{
        .sType = VK_STRUCTURE_TYPE_MEMORY_DEDICATED_ALLOCATE_INFO, .pNext = nullptr, .image = image, .buffer = VK_NULL_HANDLE};
    const VkExportMemoryAllocateInfo exported{.sType = VK_STRUCTURE_TYPE_EXPORT_MEMORY_ALLOCATE_INFO,
                                              .pNext = &alone,
                                              .handleTypes = static_cast<VkExternalMemoryHandleTypeFlags>(handle_type)};
    const VkResult result = state.add_block(types.front(), false, requirements.size, &exported);
    if (result != VK_SUCCESS)
        return call_error("vkAllocateMemory", what, result);
    MemoryBlock& block = state.blocks.back();
    (void)block.ranges.take(requirements.size, 1);
    state.given += requirements.size;
    return MemoryPiece{.memory = block.memory.get(), .offset = 0, .mapped = nullptr, .user = block.id};
}

void Memory::release(const MemoryPiece& piece) {
    if (piece.memory == VK_NULL_HANDLE)
        return;
    State& state = *state_;
    if (state.host.memory.allocate) {
        const auto held = std::find_if(state.host_pieces.begin(), state.host_pieces.end(), [&](const HostPiece& other) {
            return other.piece.memory == piece.memory && other.piece.offset == piece.offset;
        });
        assert(held != state.host_pieces.end());
        state.given -= held->bytes;
        state.host.memory.release(held->piece);
        state.host_pieces.erase(held);
        return;
    }
    const auto block =
        std::find_if(state.blocks.begin(), state.blocks.end(), [&](const MemoryBlock& other) { return other.id == piece.user; });
    assert(block != state.blocks.end());
    state.given -= block->ranges.give_back(piece.offset);
    if (block->ranges.all_free())
        state.blocks.erase(block);
}

void Memory::measure() {
    state_->measuring = true;
    state_->expected.emplace();
    state_->measured = {};
}

bool Memory::measuring() const {
    return state_->measuring;
}

Memory::Measured Memory::expect_measured() {
    state_->measuring = false;
    return state_->measured;
}

bool Memory::has(VkMemoryPropertyFlags wanted, VkMemoryPropertyFlags without) const {
    const std::vector<std::uint32_t> types = state_->types_for(~0u, wanted, 0, 0);
    return std::any_of(types.begin(), types.end(),
                       [&](std::uint32_t type) { return (state_->properties.memoryTypes[type].propertyFlags & without) == 0; });
}

VkDeviceSize Memory::taken() const {
    VkDeviceSize bytes = 0;
    for (const MemoryBlock& block : state_->blocks)
        bytes += block.bytes;
    for (const HostPiece& held : state_->host_pieces)
        bytes += held.bytes;
    return bytes;
}

VkDeviceSize Memory::given() const {
    return state_->given;
}

int Memory::blocks() const {
    return static_cast<int>(state_->blocks.size());
}

} // namespace windrow::vulkan
