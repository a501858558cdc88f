#include "fluid/cpu/aligned.h"

#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace windrow::cpu {
namespace {

constexpr std::size_t k_cache_line = 64;
constexpr std::size_t k_huge_page = std::size_t{1} << 21;

// Arrays of several huge pages start on one: row-by-row reads in many planes at once then need far fewer TLB entries.
std::align_val_t alignment_of(std::size_t bytes) {
    return std::align_val_t(bytes >= 2 * k_huge_page ? k_huge_page : k_cache_line);
}

} // namespace

void* allocate_aligned(std::size_t bytes) {
    void* const memory = ::operator new[](bytes, alignment_of(bytes));
#if defined(__linux__)
    if (bytes >= 2 * k_huge_page)
        static_cast<void>(madvise(memory, bytes / k_huge_page * k_huge_page, MADV_HUGEPAGE)); // a hint; not required
#endif
    return memory;
}

void release_aligned(void* memory, std::size_t bytes) {
    ::operator delete[](memory, alignment_of(bytes));
}

} // namespace windrow::cpu
