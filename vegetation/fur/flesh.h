// A body of tapered capsules, melted together: its signed distance.
//
// One capsule from a to b with radii ra and rb: d(p) = |p - a - t (b - a)| - (ra + t (rb - ra)), t the nearest point of the axis,
// 0 to 1. Not the exact distance where the capsule tapers, but 0 on its surface and as smooth. Two are joined by
// min(d1, d2) - h^2 k / 4, h = max(1 - |d1 - d2| / k, 0): a fillet of about k metres.
// Based on: Quilez 2013, smooth minimum (the quadratic one); Bloomenthal & Shoemake 1991, Convolution surfaces, for bodies of
// bones.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

namespace windrow::vegetation::fur {

struct Capsule {
    glm::vec3 a{0.0f}, b{0.0f};             ///< [m]
    float radius_a = 0.1f, radius_b = 0.1f; ///< [m]
    float melt = 0.05f;                     ///< [m] k, above 0: how it joins those before it
};

using Flesh = std::vector<Capsule>;

/// [m] Negative inside.
[[nodiscard]] double distance(const Flesh& flesh, const glm::dvec3& p);
/// Its gradient by central differences of a hundredth of a millimetre; outward, of about length 1.
[[nodiscard]] glm::dvec3 slope(const Flesh& flesh, const glm::dvec3& p);

} // namespace windrow::vegetation::fur
