// How much light reaches a place within a crown: leaves absorb along rays through a grid of their area.
//
//   T(p, d) = exp(-1/2 int a(p + s d) ds)    a [1/m] leaf area a volume; 1/2: leaves of all directions (Ross, Nilson)
//   T(p, d) ~ w + xyz . d                    fitted over 26 directions: w is its mean, xyz points out of the crown
//
// The fit is what a vertex carries, so that shade within the crown follows the sun without a shadow map, at any distance.
// Based on: Nilson 1971, A theoretical analysis of the frequency of gaps in plant stands; Ross 1981, The radiation regime and
// architecture of plant stands.
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

namespace windrow::vegetation::trees {

/// A leaf as the grid has it: w [m2] its area.
using Absorber = glm::vec4;

class CrownLight {
  public:
    explicit CrownLight(std::span<const Absorber> leaves);

    /// xyz and w of the fit at p [m]; w 0 to 1.
    [[nodiscard]] glm::vec4 fit(glm::vec3 p) const;
    /// T(p, direction), 0 to 1.
    [[nodiscard]] float transmittance(glm::vec3 p, glm::vec3 direction) const;

  private:
    static constexpr int k_cells = 24; // an axis
    [[nodiscard]] float density(glm::vec3 p) const;

    glm::vec3 low_{0.0f}, cell_{1.0f}; // [m]
    std::vector<float> density_;       // [1/m]
};

} // namespace windrow::vegetation::trees
