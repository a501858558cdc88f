// The system's Vulkan loader, opened while the program runs: a program without one starts, and reports an error. Only this file's
// .cpp calls the operating system.
#pragma once

#include "fluid/api.h"
#include "fluid/result.h"

#include <span>
#include <utility>
#include <vulkan/vulkan_core.h>

namespace windrow::vulkan {

/// Move-only. Closes the library at its end.
class WINDROW_INTERNAL Loader {
  public:
    /// Closed.
    Loader() = default;
    /// The first of `names` that has vkGetInstanceProcAddr; else an error that lists them.
    [[nodiscard]] static Result<Loader> open();
    /// Files that are tried, in order: libvulkan.so.1 and folders that a search leaves out, vulkan-1.dll, or on macOS
    /// libvulkan.1.dylib and MoltenVK itself.
    [[nodiscard]] static std::span<const char* const> names();
    Loader(Loader&& other) noexcept { swap(other); }
    Loader& operator=(Loader&& other) noexcept {
        Loader(std::move(other)).swap(*this);
        return *this;
    }
    ~Loader();

    /// Null where it is closed.
    [[nodiscard]] PFN_vkGetInstanceProcAddr get_instance_proc_addr() const { return get_instance_proc_addr_; }

  private:
    void swap(Loader& other) noexcept {
        std::swap(library_, other.library_);
        std::swap(get_instance_proc_addr_, other.get_instance_proc_addr_);
    }

    void* library_ = nullptr;
    PFN_vkGetInstanceProcAddr get_instance_proc_addr_ = nullptr;
};

} // namespace windrow::vulkan
