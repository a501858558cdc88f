// A face of any number of corners, cut into triangles by its ears: corners whose neighbours see each other within the face.
//
// Based on: Meisters 1975, "Polygons have ears", The American Mathematical Monthly 82.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace windrow::scene {

/// `outline`: the face's corners in order, at least 3. Returns two fewer triangles, as numbers of corners, within the outline as
/// it is seen along the axis that the face's normal is nearest to. Throws std::bad_alloc.
[[nodiscard]] std::vector<glm::uvec3> cut_face(std::span<const glm::vec3> outline);

} // namespace windrow::scene
