// Shapes of things that do not bend: lathed bodies, boxes and rings of triangles, for figures in a scene.
// A body of several parts has one placement a part: limbs that move, or the points of a cloth.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

namespace windrow::vegetation::render {

/// A corner of a triangle, as shaders have it (std430).
struct SolidVertex {
    glm::vec4 position{0.0f}; ///< xyz [m] in its part's own space; w the part, 0, 1, ... of the body
    glm::vec4 normal{0.0f};   ///< xyz unit vector, w 0
    glm::vec4 colour{0.0f};   ///< rgb linear albedo, w 0
};

/// Triangles, three vertices each.
using Solid = std::vector<SolidVertex>;

/// A profile (x [m] from the axis, y [m] along it, upward) turned about y, smooth across, `sides` flat faces around, 3 or more.
[[nodiscard]] Solid lathe(std::span<const glm::vec2> profile, int sides, glm::vec3 colour);
/// A box of these half edges [m].
[[nodiscard]] Solid box(glm::vec3 half, glm::vec3 colour);
/// A ring about z: radius of its circle and of its tube [m].
[[nodiscard]] Solid ring(float radius, float tube, int sides, glm::vec3 colour);
/// Adds `part`, placed by a matrix without shear, to `whole`.
void add(Solid& whole, const Solid& part, const glm::mat4& placed = glm::mat4(1.0f));
/// Parts of a body: one more than the highest of its vertices.
[[nodiscard]] std::size_t parts_of(const Solid& solid);

/// A fan that stands: hub at the origin, blowing along +z, down to the ground `height` [m] below. The blades apart, since they
/// turn.
[[nodiscard]] Solid fan_stand(float radius, float height);
[[nodiscard]] Solid fan_blades(float radius);

} // namespace windrow::vegetation::render
