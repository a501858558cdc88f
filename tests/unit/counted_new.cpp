#include "tests/unit/counted_new.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace windrow::test {

std::atomic<std::int64_t> live_bytes{0}, allocations{0};

namespace {

extern "C" const char __executable_start, etext; // of the linker

bool is_in_program(const void* code) {
    return code >= &__executable_start && code < &etext;
}

// What this thread's next allocations do: `left` succeed, then one fails, or all.
struct FailurePlan {
    bool armed = false, onward = false, failed = false, all = true;
    int left = 0;

    bool fails(const void* caller) {
        if (!armed || !(all || is_in_program(caller)) || left-- > 0)
            return false;
        armed = onward;
        left = 0;
        failed = true;
        return true;
    }
};
thread_local FailurePlan plan;

} // namespace

FailingMemory::FailingMemory(int after, Failing failing, Whose whose) {
    plan = {.armed = true, .onward = failing == Failing::from_then_on, .all = whose == Whose::all, .left = after};
}
FailingMemory::~FailingMemory() {
    plan = {};
}
bool FailingMemory::failed() const {
    return plan.failed;
}

} // namespace windrow::test

namespace {

using windrow::test::allocations;
using windrow::test::live_bytes;

// The block's size and its true start are stored before it.
struct Header {
    void* start;
    std::size_t size;
};

void* allocate(std::size_t size, std::size_t alignment, const void* caller) noexcept {
    if (windrow::test::plan.fails(caller))
        return nullptr;
    alignment = std::max(alignment, alignof(std::max_align_t));
    void* const start = std::malloc(size + alignment + sizeof(Header));
    if (start == nullptr)
        return nullptr;
    const auto first = reinterpret_cast<std::uintptr_t>(start) + sizeof(Header);
    auto* const block = reinterpret_cast<void*>((first + alignment - 1) / alignment * alignment);
    static_cast<Header*>(block)[-1] = {start, size};
    live_bytes += static_cast<std::int64_t>(size);
    ++allocations;
    return block;
}

void* allocate_or_throw(std::size_t size, std::size_t alignment, const void* caller) {
    if (void* const block = allocate(size, alignment, caller))
        return block;
    throw std::bad_alloc();
}

void release(void* block) noexcept {
    if (block == nullptr)
        return;
    const Header header = static_cast<Header*>(block)[-1];
    live_bytes -= static_cast<std::int64_t>(header.size);
    std::free(header.start);
}

} // namespace

void* operator new(std::size_t size) {
    return allocate_or_throw(size, 0, __builtin_return_address(0));
}
void* operator new[](std::size_t size) {
    return allocate_or_throw(size, 0, __builtin_return_address(0));
}
void* operator new(std::size_t size, std::align_val_t at) {
    return allocate_or_throw(size, static_cast<std::size_t>(at), __builtin_return_address(0));
}
void* operator new[](std::size_t size, std::align_val_t at) {
    return allocate_or_throw(size, static_cast<std::size_t>(at), __builtin_return_address(0));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    return allocate(size, 0, __builtin_return_address(0));
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
    return allocate(size, 0, __builtin_return_address(0));
}
void* operator new(std::size_t size, std::align_val_t at, const std::nothrow_t&) noexcept {
    return allocate(size, static_cast<std::size_t>(at), __builtin_return_address(0));
}
void* operator new[](std::size_t size, std::align_val_t at, const std::nothrow_t&) noexcept {
    return allocate(size, static_cast<std::size_t>(at), __builtin_return_address(0));
}
void operator delete(void* block) noexcept {
    release(block);
}
void operator delete[](void* block) noexcept {
    release(block);
}
void operator delete(void* block, std::size_t) noexcept {
    release(block);
}
void operator delete[](void* block, std::size_t) noexcept {
    release(block);
}
void operator delete(void* block, std::align_val_t) noexcept {
    release(block);
}
void operator delete[](void* block, std::align_val_t) noexcept {
    release(block);
}
void operator delete(void* block, std::size_t, std::align_val_t) noexcept {
    release(block);
}
void operator delete[](void* block, std::size_t, std::align_val_t) noexcept {
    release(block);
}
void operator delete(void* block, const std::nothrow_t&) noexcept {
    release(block);
}
void operator delete[](void* block, const std::nothrow_t&) noexcept {
    release(block);
}
void operator delete(void* block, std::align_val_t, const std::nothrow_t&) noexcept {
    release(block);
}
void operator delete[](void* block, std::align_val_t, const std::nothrow_t&) noexcept {
    release(block);
}
