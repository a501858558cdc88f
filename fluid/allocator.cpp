#include "fluid/allocator.h"

#include "fluid/core/message.h"

#include <atomic>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace windrow {
namespace {

constexpr std::size_t k_cache_line = 64;
constexpr std::size_t k_huge_page = std::size_t{1} << 21;

// Arrays of several huge pages start on one: row-by-row reads in many planes at once then need far fewer TLB entries.
std::size_t alignment_of(std::size_t bytes) {
    return bytes >= 2 * k_huge_page ? k_huge_page : k_cache_line;
}

bool is_aligned(const void* memory, std::size_t alignment) {
    return reinterpret_cast<std::uintptr_t>(memory) % alignment == 0;
}

void* own_allocate(std::size_t bytes, std::size_t alignment, void*) {
    return ::operator new[](bytes, std::align_val_t(alignment), std::nothrow);
}
void own_release(void* memory, std::size_t, std::size_t alignment, void*) {
    ::operator delete[](memory, std::align_val_t(alignment));
}

constexpr Allocator k_own{own_allocate, own_release, nullptr};
constinit Allocator in_use = k_own; // written only while `held` is 0
constinit std::atomic<std::uint64_t> held{0};

} // namespace

Result<void> set_allocator(const Allocator& allocator) {
    if ((allocator.allocate == nullptr) != (allocator.release == nullptr))
        return Error{"allocator has one function of two: give allocate and release, or neither."};
    if (const std::uint64_t bytes = held; bytes > 0)
        return Error{detail::message("allocator cannot change while ", bytes,
                                     " bytes are held: set it before the first wind, or destroy all winds and tiles first.")};
    if (allocator.allocate != nullptr)
        if (void* const memory = allocator.allocate(k_cache_line, k_cache_line, allocator.user); memory != nullptr) {
            const bool aligned = is_aligned(memory, k_cache_line);
            allocator.release(memory, k_cache_line, k_cache_line, allocator.user);
            if (!aligned)
                return Error{
                    "allocator.allocate gave an address that is no multiple of 64: keep to the alignment that it is given."};
        }
    in_use = allocator.allocate != nullptr ? allocator : k_own;
    return {};
}

std::uint64_t allocated_bytes() {
    return held;
}

namespace detail {

void* allocate_aligned(std::size_t bytes) {
    void* const memory = in_use.allocate(bytes, alignment_of(bytes), in_use.user);
    if (memory != nullptr && !is_aligned(memory, alignment_of(bytes))) {
        in_use.release(memory, bytes, alignment_of(bytes), in_use.user);
        throw std::bad_alloc(); // it would end in a fault of the vector units
    }
    if (memory == nullptr)
        throw std::bad_alloc();
    held += bytes;
#if defined(__linux__)
    if (bytes >= 2 * k_huge_page)
        static_cast<void>(madvise(memory, bytes / k_huge_page * k_huge_page, MADV_HUGEPAGE)); // a hint; not required
#endif
    return memory;
}

void release_aligned(void* memory, std::size_t bytes) {
    in_use.release(memory, bytes, alignment_of(bytes), in_use.user);
    held -= bytes;
}

} // namespace detail
} // namespace windrow
