#include "vegetation/bench/counted_memory.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <map>
#include <mutex>
#include <vulkan/vulkan.h>

namespace {

std::mutex mutex;
std::map<VkDeviceMemory, VkDeviceSize> sizes;
VkDeviceSize sum = 0;

template <class Function>
Function of_the_loader(const char* name) {
    void* const found = dlsym(RTLD_NEXT, name);
    if (found == nullptr) {
        std::fprintf(stderr, "Vulkan's loader has no %s: link it as a shared library.\n", name);
        std::exit(3);
    }
    Function function{};
    std::memcpy(&function, &found, sizeof function);
    return function;
}

PFN_vkVoidFunction counted(const char* name) {
    if (std::strcmp(name, "vkAllocateMemory") == 0)
        return reinterpret_cast<PFN_vkVoidFunction>(&vkAllocateMemory);
    if (std::strcmp(name, "vkFreeMemory") == 0)
        return reinterpret_cast<PFN_vkVoidFunction>(&vkFreeMemory);
    if (std::strcmp(name, "vkGetDeviceProcAddr") == 0)
        return reinterpret_cast<PFN_vkVoidFunction>(&vkGetDeviceProcAddr);
    return nullptr;
}

} // namespace

std::uint64_t windrow::vegetation::bench::allocated_bytes() {
    const std::lock_guard lock(mutex);
    return sum;
}

extern "C" {

VKAPI_ATTR VkResult VKAPI_CALL vkAllocateMemory(VkDevice device, const VkMemoryAllocateInfo* info,
                                                const VkAllocationCallbacks* callbacks, VkDeviceMemory* memory) {
    static const auto real = of_the_loader<PFN_vkAllocateMemory>("vkAllocateMemory");
    const VkResult result = real(device, info, callbacks, memory);
    if (result == VK_SUCCESS) {
        const std::lock_guard lock(mutex);
        sizes[*memory] = info->allocationSize;
        sum += info->allocationSize;
    }
    return result;
}

VKAPI_ATTR void VKAPI_CALL vkFreeMemory(VkDevice device, VkDeviceMemory memory, const VkAllocationCallbacks* callbacks) {
    static const auto real = of_the_loader<PFN_vkFreeMemory>("vkFreeMemory");
    {
        const std::lock_guard lock(mutex);
        if (const auto found = sizes.find(memory); found != sizes.end()) {
            sum -= found->second;
            sizes.erase(found);
        }
    }
    real(device, memory, callbacks);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL vkGetDeviceProcAddr(VkDevice device, const char* name) {
    static const auto real = of_the_loader<PFN_vkGetDeviceProcAddr>("vkGetDeviceProcAddr");
    const PFN_vkVoidFunction ours = counted(name);
    return ours != nullptr ? ours : real(device, name);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL vkGetInstanceProcAddr(VkInstance instance, const char* name) {
    static const auto real = of_the_loader<PFN_vkGetInstanceProcAddr>("vkGetInstanceProcAddr");
    const PFN_vkVoidFunction ours = counted(name);
    return ours != nullptr ? ours : real(instance, name);
}

} // extern "C"
