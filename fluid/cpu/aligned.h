// Owned arrays, aligned to a cache line (large ones to a huge page), initially zero.
#pragma once

#include "fluid/allocator.h"

#include <cstddef>
#include <cstring>
#include <memory>
#include <span>

namespace windrow::cpu {

/// A fixed-size zeroed array on a 64-byte boundary. Move-only.
template <class T>
class Buffer {
  public:
    Buffer() = default;
    explicit Buffer(std::size_t size) : size_(size) {
        if (size == 0)
            return;
        data_ =
            std::unique_ptr<T[], Release>(static_cast<T*>(detail::allocate_aligned(size * sizeof(T))), Release{size * sizeof(T)});
        std::memset(static_cast<void*>(data_.get()), 0, size * sizeof(T));
    }

    [[nodiscard]] T* data() { return data_.get(); }
    [[nodiscard]] const T* data() const { return data_.get(); }
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] bool empty() const { return size_ == 0; }
    [[nodiscard]] std::size_t bytes() const { return size_ * sizeof(T); }
    T& operator[](std::size_t n) { return data_.get()[n]; }
    const T& operator[](std::size_t n) const { return data_.get()[n]; }
    operator std::span<T>() { return {data_.get(), size_}; }
    operator std::span<const T>() const { return {data_.get(), size_}; }

  private:
    struct Release {
        std::size_t bytes = 0;
        void operator()(T* data) const { detail::release_aligned(data, bytes); }
    };
    std::unique_ptr<T[], Release> data_;
    std::size_t size_ = 0;
};

} // namespace windrow::cpu
