// Owning handle of a Vulkan object, as std::unique_ptr for memory.
#pragma once

#include "gpu/functions.h"

#include <utility>

namespace windrow::vulkan {

/// Move-only. `Destroy` is the call that ends the object: &Functions::vkDestroyBuffer. The table outlives it.
template <class Object, auto Destroy>
class Handle {
  public:
    Handle() = default;
    Handle(const Functions& functions, const Host& host, Object object)
        : functions_(&functions), device_(host.device), callbacks_(host.allocation_callbacks), object_(object) {}
    Handle(Handle&& other) noexcept { swap(other); }
    Handle& operator=(Handle&& other) noexcept {
        Handle(std::move(other)).swap(*this);
        return *this;
    }
    ~Handle() {
        if (object_ != VK_NULL_HANDLE)
            (functions_->*Destroy)(device_, object_, callbacks_);
    }

    [[nodiscard]] const Object& get() const { return object_; }

  private:
    void swap(Handle& other) noexcept {
        std::swap(functions_, other.functions_);
        std::swap(device_, other.device_);
        std::swap(callbacks_, other.callbacks_);
        std::swap(object_, other.object_);
    }

    const Functions* functions_ = nullptr;
    VkDevice device_ = VK_NULL_HANDLE;
    const VkAllocationCallbacks* callbacks_ = nullptr;
    Object object_ = VK_NULL_HANDLE;
};

/// Makes an object with one of the calls vkCreate...(device, info, callbacks, object). `made` stays as it was where that fails.
template <class Create, class Info, class Object, auto Destroy>
[[nodiscard]] VkResult make(const Functions& functions, const Host& host, Create create, const Info& info,
                            Handle<Object, Destroy>& made) {
    Object object = VK_NULL_HANDLE;
    const VkResult result = create(host.device, &info, host.allocation_callbacks, &object);
    if (result == VK_SUCCESS)
        made = Handle<Object, Destroy>(functions, host, object);
    return result;
}

} // namespace windrow::vulkan
