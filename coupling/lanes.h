// Blocks of plants for SIMD: each quantity in an array of its own, so that the compiler vectorises the shared source, one plant
// per lane.
//
// WINDROW_LEVELS before a function compiles it once for each level of x86's vectors, and the program takes the widest that the
// machine has when it starts. No product is fused into a sum, so that each level gives the same bits. Functions that are called
// stay at the baseline unless they are inlined; hence `flatten`.
#pragma once

#include "fluid/core/validation.h"

#include <algorithm>
#include <cstddef>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

// The choice at the start is glibc's (ifunc); sanitizers run before it is made.
#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) &&   \
    !defined(__SANITIZE_THREAD__)
#define WINDROW_LEVELS __attribute__((flatten, target_clones("default", "avx2", "avx512f")))
#else
#define WINDROW_LEVELS
#endif

namespace windrow::detail {

/// Spans of one call, each with an entry a plant.
inline void check_size(Reasons& reasons, const FieldPath& span, std::size_t size, std::size_t wanted) {
    if (size != wanted)
        reasons.add(span, " has ", size, " entries: give ", wanted, ".");
}

constexpr std::size_t k_lanes = 64; ///< plants of a block: their numbers fit the first cache

struct Lanes {
    float at[k_lanes];
};
struct Lanes3 {
    Lanes x, y, z;

    [[nodiscard]] glm::vec3 operator[](std::size_t i) const { return {x.at[i], y.at[i], z.at[i]}; }
    void set(std::size_t i, const glm::vec3& value) {
        x.at[i] = value.x;
        y.at[i] = value.y;
        z.at[i] = value.z;
    }
};

/// Lanes beyond `count` keep what they have: they are computed too, and never read.
inline void gather(Lanes3& lanes, const glm::vec4* from, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
        lanes.set(i, glm::vec3(from[i]));
}
inline void scatter(glm::vec4* to, const Lanes3& lanes, float w, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
        to[i] = {lanes.x.at[i], lanes.y.at[i], lanes.z.at[i], w};
}

/// Runs body(first, size) for each block of `count` plants, by the host's loop.
template <class ParallelFor, class Body>
void for_blocks(std::size_t count, const ParallelFor& parallel_for, const Body& body) {
    constexpr std::size_t k_blocks = 16; // of a task: an empty one costs the pool more than a block
    const auto tasks = (count + k_blocks * k_lanes - 1) / (k_blocks * k_lanes);
    parallel_for(static_cast<int>(tasks), [&](int task) {
        const std::size_t begin = static_cast<std::size_t>(task) * k_blocks * k_lanes;
        const std::size_t end = std::min(begin + k_blocks * k_lanes, count);
        for (std::size_t first = begin; first < end; first += k_lanes)
            body(first, std::min(k_lanes, end - first));
    });
}

} // namespace windrow::detail
