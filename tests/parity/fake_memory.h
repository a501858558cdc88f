// A device of memory alone, with heaps and types as GPUs have them and a software driver has not; it grants, counts and rejects.
#pragma once

#include "gpu/functions.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace windrow::vulkan {

/// Vulkan's calls carry no pointer of ours, so that the one fake that lives is known by a static.
class FakeMemory {
  public:
    struct Type {
        VkMemoryPropertyFlags properties;
        std::uint32_t heap;
    };
    struct Allocation {
        VkDeviceSize bytes = 0;
        std::uint32_t type = 0;
        std::unique_ptr<std::byte[]> host{}; ///< once mapped
    };

    FakeMemory(std::vector<VkDeviceSize> heaps, std::vector<Type> types) : heaps_(std::move(heaps)), types_(std::move(types)) {
        self() = this;
    }
    ~FakeMemory() { self() = nullptr; }
    FakeMemory(const FakeMemory&) = delete;
    FakeMemory& operator=(const FakeMemory&) = delete;

    [[nodiscard]] static Functions functions() {
        Functions table;
        table.vkGetPhysicalDeviceMemoryProperties = &tell_types;
        table.vkGetPhysicalDeviceProperties2 = &tell_limits;
        table.vkAllocateMemory = &allocate;
        table.vkFreeMemory = &free;
        table.vkMapMemory = &map;
        return table;
    }

    [[nodiscard]] const Allocation& of(VkDeviceMemory memory) const { return allocations_.at(memory); }
    [[nodiscard]] std::size_t count() const { return allocations_.size(); }
    [[nodiscard]] VkDeviceSize bytes() const {
        VkDeviceSize sum = 0;
        for (const auto& [memory, allocation] : allocations_)
            sum += allocation.bytes;
        return sum;
    }

    static constexpr VkDeviceSize k_atom = 64;
    static constexpr VkDeviceSize k_granularity = 1024;
    static constexpr VkDeviceSize k_largest = VkDeviceSize{64} << 20;

    VkResult rejection = VK_SUCCESS;     ///< of vkAllocateMemory
    VkResult map_rejection = VK_SUCCESS; ///< of vkMapMemory
    int grants = 0;                      ///< allocations so far
    int maps = 0;                        ///< mappings so far

  private:
    static FakeMemory*& self() {
        static FakeMemory* living = nullptr;
        return living;
    }
    static VKAPI_ATTR void VKAPI_CALL tell_types(VkPhysicalDevice, VkPhysicalDeviceMemoryProperties* properties) {
        *properties = {};
        for (const VkDeviceSize bytes : self()->heaps_)
            properties->memoryHeaps[properties->memoryHeapCount++].size = bytes;
        for (const Type& type : self()->types_)
            properties->memoryTypes[properties->memoryTypeCount++] = {type.properties, type.heap};
    }
    static VKAPI_ATTR void VKAPI_CALL tell_limits(VkPhysicalDevice, VkPhysicalDeviceProperties2* properties) {
        properties->properties.limits.nonCoherentAtomSize = k_atom;
        properties->properties.limits.bufferImageGranularity = k_granularity;
        static_cast<VkPhysicalDeviceMaintenance3Properties*>(properties->pNext)->maxMemoryAllocationSize = k_largest;
    }
    static VKAPI_ATTR VkResult VKAPI_CALL allocate(VkDevice, const VkMemoryAllocateInfo* info, const VkAllocationCallbacks*,
                                                   VkDeviceMemory* memory) {
        if (self()->rejection != VK_SUCCESS)
            return self()->rejection;
        *memory = reinterpret_cast<VkDeviceMemory>(++self()->last_);
        self()->allocations_[*memory] = {.bytes = info->allocationSize, .type = info->memoryTypeIndex};
        ++self()->grants;
        return VK_SUCCESS;
    }
    static VKAPI_ATTR void VKAPI_CALL free(VkDevice, VkDeviceMemory memory, const VkAllocationCallbacks*) {
        if (self()->allocations_.erase(memory) != 1)
            std::abort(); // freed twice
    }
    static VKAPI_ATTR VkResult VKAPI_CALL map(VkDevice, VkDeviceMemory memory, VkDeviceSize, VkDeviceSize, VkMemoryMapFlags,
                                              void** address) {
        if (self()->map_rejection != VK_SUCCESS)
            return self()->map_rejection;
        ++self()->maps;
        Allocation& allocation = self()->allocations_.at(memory);
        allocation.host = std::make_unique_for_overwrite<std::byte[]>(allocation.bytes);
        *address = allocation.host.get();
        return VK_SUCCESS;
    }

    std::vector<VkDeviceSize> heaps_;
    std::vector<Type> types_;
    std::map<VkDeviceMemory, Allocation> allocations_;
    std::uintptr_t last_ = 0;
};

} // namespace windrow::vulkan
