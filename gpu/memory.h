// Device memory allocator: a few large blocks, divided, since a driver allows only some thousand allocations.
#pragma once

#include "fluid/api.h"
#include "fluid/result.h"
#include "gpu/functions.h"

#include <memory>
#include <utility>

namespace windrow::vulkan {

/// Gives memory and takes it back; through the host's callbacks where it has them. All of it is freed on destruction.
class WINDROW_INTERNAL Memory {
  public:
    Memory(const Host& host, const Functions& functions);
    ~Memory();
    Memory(const Memory&) = delete;
    Memory& operator=(const Memory&) = delete;

    /// Memory with the `wanted` properties; of the types that have them the one with the most `preferred` ones and, among
    /// equals, the fewest `avoided` ones. `linear`: buffers, not images (kept apart, bufferImageGranularity). The error names
    /// size, kind and VkResult.
    [[nodiscard]] Result<MemoryPiece> allocate(const VkMemoryRequirements& requirements, VkMemoryPropertyFlags wanted,
                                               VkMemoryPropertyFlags preferred, bool linear, VkMemoryPropertyFlags avoided = 0);
    /// Memory of its own for an image, which can be exported as `handle_type`; not from the host's callbacks.
    [[nodiscard]] Result<MemoryPiece> allocate_exported(const VkMemoryRequirements& requirements, VkImage image,
                                                        VkExternalMemoryHandleTypeFlagBits handle_type);
    void release(const MemoryPiece& piece);

    /// Bytes of pieces, and of the blocks that hold them.
    struct Measured {
        VkDeviceSize given = 0, taken = 0;
    };
    /// From now on `allocate` gives pieces without memory and adds them up; objects are made and not bound.
    void measure();
    [[nodiscard]] bool measuring() const;
    /// Ends it. The next blocks have the sizes that were measured, so that what is made once more fits exactly; further ones are
    /// small.
    Measured expect_measured();

    /// Whether the device has a type with all of `wanted` and none of `without`.
    [[nodiscard]] bool has(VkMemoryPropertyFlags wanted, VkMemoryPropertyFlags without) const;

    /// [bytes] Taken from the driver, and given out.
    [[nodiscard]] VkDeviceSize taken() const;
    [[nodiscard]] VkDeviceSize given() const;
    /// Allocations from the driver that live.
    [[nodiscard]] int blocks() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Move-only. A piece that goes back by itself. The memory outlives it.
class OwnedPiece {
  public:
    OwnedPiece() = default;
    OwnedPiece(Memory& memory, const MemoryPiece& piece) : memory_(&memory), piece_(piece) {}
    OwnedPiece(OwnedPiece&& other) noexcept { swap(other); }
    OwnedPiece& operator=(OwnedPiece&& other) noexcept {
        OwnedPiece(std::move(other)).swap(*this);
        return *this;
    }
    ~OwnedPiece() {
        if (memory_ != nullptr)
            memory_->release(piece_);
    }

    [[nodiscard]] const MemoryPiece& get() const { return piece_; }

  private:
    void swap(OwnedPiece& other) noexcept {
        std::swap(memory_, other.memory_);
        std::swap(piece_, other.piece_);
    }

    Memory* memory_ = nullptr;
    MemoryPiece piece_{};
};

} // namespace windrow::vulkan
