// The host's memory for the large arrays of all winds.
//
//     windrow::set_allocator({.allocate = engine_allocate, .release = engine_release, .user = &heap});   // before the first wind
//
// Covered: cells, scratch and tables of the solver on the CPU, rasterised obstacles, tiles of gusts; together at least 99 % of
// Wind::memory_bytes.
// Not covered: objects themselves, lists, strings, geometry (meshes, voxels, height maps), snapshots and logs, which are from
// operator new; and the memory of a device, for which vulkan::Host::memory is the hook.
#pragma once

#include "api.h"
#include "result.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace windrow {
namespace detail {
[[nodiscard]] WINDROW_API void* allocate_aligned(std::size_t bytes); // throws std::bad_alloc
WINDROW_API void release_aligned(void* memory, std::size_t bytes);
} // namespace detail

/// Two functions of the host with their context. Any thread that makes or destroys objects calls them.
struct Allocator {
    /// Memory of so many bytes at an address that is a multiple of `alignment`, a power of two from 64 on. Null is out of memory. Must
    /// not throw.
    void* (*allocate)(std::size_t bytes, std::size_t alignment, void* user) = nullptr;
    /// Takes back what `allocate` gave, with the same size and alignment.
    void (*release)(void* memory, std::size_t bytes, std::size_t alignment, void* user) = nullptr;
    void* user = nullptr;
};

/// Sets the allocator of the whole process; both functions null: the library's own. Call it before the first object. Rejects one
/// function without the other, any change while memory is held, and memory that is not aligned: `allocate` is tried once. Later such
/// memory is given back and counts as none.
WINDROW_API Result<void> set_allocator(const Allocator& allocator);
/// [bytes] Held from the allocator now.
[[nodiscard]] WINDROW_API std::uint64_t allocated_bytes();

namespace detail {
template <class T>
struct HostMemory {
    using value_type = T;
    HostMemory() = default;
    template <class U>
    HostMemory(const HostMemory<U>&) {}

    [[nodiscard]] T* allocate(std::size_t count) { return static_cast<T*>(allocate_aligned(count * sizeof(T))); }
    void deallocate(T* memory, std::size_t count) { release_aligned(memory, count * sizeof(T)); }
    friend bool operator==(const HostMemory&, const HostMemory&) { return true; }
};
template <class T>
using HostVector = std::vector<T, HostMemory<T>>;
} // namespace detail

} // namespace windrow
