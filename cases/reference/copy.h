// A plain copy of a field of cells: the floor that memory sets for any step, and the unit in which steps are counted.
//
// Based on: McCalpin 1995, Memory Bandwidth and Machine Balance in Current High Performance Computers (STREAM, "copy").
#pragma once

#include "fluid/parallel.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

namespace windrow::reference {

/// Copies cells.x * cells.y * cells.z values of 16 bytes, a plane of constant z a task. The arrays do not overlap and are not
/// smaller than that. The copy is made whether or not anyone reads it.
void copy_cells(glm::ivec3 cells, std::span<const glm::vec4> from, std::span<glm::vec4> to, const ParallelFor& parallel_for);

} // namespace windrow::reference
