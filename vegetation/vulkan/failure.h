// Calls that fail while objects are made: an exception within the library, a Result for those who call it.
//
// The makers of this folder throw. `guarded` stands around them in each function that a user calls:
//
//     return guarded([&] { return std::unique_ptr<Bodies>(new Bodies(device, targets, shapes)); });
#pragma once

#include "../../fluid/vulkan/host.h"

#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

namespace windrow::vegetation::engine {

/// Exception of the makers: one sentence.
class Failure final : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Throws unless a call of Vulkan succeeded.
inline void must(VkResult result, const char* call) {
    if (result != VK_SUCCESS)
        throw Failure(std::string(call) + " failed: " + vulkan::name_of(result) + ".");
}

/// The value of a result; throws its sentence where it has none.
template <class Value>
Value must(Result<Value> result) {
    if (!result)
        throw Failure(result.error());
    return *std::move(result);
}
inline void must(const Result<void>& result) {
    if (!result)
        throw Failure(result.error());
}

/// Result of `make`, or the sentence of the failure that it throws.
template <class Make>
[[nodiscard]] Result<std::invoke_result_t<Make>> guarded(const Make& make) {
    try {
        if constexpr (std::is_void_v<std::invoke_result_t<Make>>) {
            make();
            return {};
        } else {
            return make();
        }
    } catch (const Failure& failure) {
        return Error{failure.what()};
    }
}

} // namespace windrow::vegetation::engine
