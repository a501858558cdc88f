// A plain copy of a field of cells: the floor that memory sets for any step, and the unit in which steps are counted. One memcpy a
// plane, the fastest that the machine's C library knows.
//
// Based on: McCalpin 1995, Memory Bandwidth and Machine Balance in Current High Performance Computers (STREAM, "copy").
#pragma once

#include "fluid/parallel.h"

#include <cassert>
#include <cstddef>
#include <cstring>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

namespace windrow::reference {

/// Copies cells.x * cells.y * cells.z values of 16 bytes, a plane of constant z a task. The arrays do not overlap and are not
/// smaller than that. The copy is made whether or not anyone reads it.
inline void copy_cells(glm::ivec3 cells, std::span<const glm::vec4> from, std::span<glm::vec4> to,
                       const ParallelFor& parallel_for) {
    const std::size_t plane = static_cast<std::size_t>(cells.x) * static_cast<std::size_t>(cells.y);
    assert(from.size() >= plane * cells.z && to.size() >= plane * cells.z);
    parallel_for(cells.z, [&](int k) {
        glm::vec4* const target = to.data() + plane * k;
        std::memcpy(static_cast<void*>(target), from.data() + plane * k, plane * sizeof(glm::vec4));
        // Tells the compiler that someone reads the plane, also where it sees that nobody does.
        asm volatile("" : : "r"(target) : "memory");
    });
}

} // namespace windrow::reference
