// The calls of a device with a count of what lives, one of which can be made to fail.
#pragma once

#include "gpu/functions.h"

#include <gtest/gtest.h>
#include <map>
#include <string>

namespace windrow::vulkan {

/// What the calls know. They carry no pointer of ours, so there is one of it.
struct CountedCalls {
    Functions real;
    /// The call that fails, counted from 0 over all that return a VkResult; -1: none.
    int fail_at = -1;
    VkResult code = VK_ERROR_UNKNOWN; ///< what it returns
    int made = 0;                     ///< calls that return a VkResult, so far
    std::string failed;               ///< the one that failed
    std::map<std::string, int> live;  ///< kind of object to those made and not destroyed
    /// The host's callbacks, which each call that makes or ends an object must hand on; the real call gets none.
    const VkAllocationCallbacks* callbacks = nullptr;
    int without_callbacks = 0; ///< calls that handed on others
};

[[nodiscard]] CountedCalls& counted_calls();

/// A table whose calls go to `real`, counted. Forgets what was counted before.
[[nodiscard]] Functions counted(const Functions& real);

inline void expect_none_lives() {
    for (const auto& [kind, count] : counted_calls().live)
        EXPECT_EQ(count, 0) << kind << " after " << counted_calls().failed << " failed";
}

} // namespace windrow::vulkan
