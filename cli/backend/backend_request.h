// What a command is asked to run the air on.
#pragma once

#include <cstdint>

namespace windrow::cli {

enum class BackendKind : std::uint8_t {
    cpu,   ///< the default
    vulkan ///< a Vulkan device
};

[[nodiscard]] inline const char* name_of(BackendKind kind) {
    return kind == BackendKind::vulkan ? "vulkan" : "cpu";
}

struct BackendRequest {
    BackendKind kind = BackendKind::cpu;
    int device = -1; ///< place in the list that `windrow info` tells; -1: the first that is no software, else the first
};

} // namespace windrow::cli
