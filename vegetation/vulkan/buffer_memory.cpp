#include "vegetation/vulkan/buffer_memory.h"

namespace windrow::vegetation::engine {
namespace {

constexpr VkMemoryPropertyFlags k_own = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
constexpr VkMemoryPropertyFlags k_visible = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT;
constexpr VkMemoryPropertyFlags k_coherent = VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
constexpr VkMemoryPropertyFlags k_cached = VK_MEMORY_PROPERTY_HOST_CACHED_BIT;

struct Wish {
    VkMemoryPropertyFlags wanted = 0, preferred = 0, avoided = 0;
};

// | use           | memory                                        | avoided                                              |
// | fixed, work   | the device's own                              | the window, which is small and is for what is written |
// | frame         | the device's own that the host sees           | cached: the host only writes                         |
// | staging       | the host's                                    | the window, cached                                   |
// | readback      | cached; else any that the host sees           | the window: reads over the bus are slow              |
Wish wish_of(Use use, bool in_place) {
    switch (use) {
    case Use::fixed:
    case Use::frame:
        if (in_place)
            return {k_visible | k_coherent, k_own, k_cached};
        break;
    case Use::staging:
        return {k_visible | k_coherent, 0, k_own | k_cached};
    case Use::readback:
        return {k_visible, k_cached, k_own};
    case Use::work:
        break;
    }
    return {0, k_own, k_visible};
}

} // namespace

BufferMemory::BufferMemory(const vulkan::Host& host, const vulkan::Functions& functions, bool staged)
    : memory_(host, functions), staged_(staged) {}

bool BufferMemory::in_place(Use use) const {
    const bool window = !staged_ && memory_.has(k_own | k_visible | k_coherent, 0);
    // Where all of the device's own memory is visible, nothing is won by a copy.
    return use == Use::frame ? window : use == Use::fixed ? window && !memory_.has(k_own, k_visible) : use != Use::work;
}

Result<vulkan::MemoryPiece> BufferMemory::allocate(const VkMemoryRequirements& needs, Use use) {
    const Wish wish = wish_of(use, in_place(use));
    return memory_.allocate(needs, wish.wanted, wish.preferred, true, wish.avoided);
}

Result<vulkan::MemoryPiece> BufferMemory::allocate_image(const VkMemoryRequirements& needs) {
    return memory_.allocate(needs, 0, k_own, false, k_visible);
}

} // namespace windrow::vegetation::engine
