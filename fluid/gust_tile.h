// The gust tile: a periodic block of turbulence, made once and read by all gusts and by the detail.
//
// A sum of waves on the tile's own lattice, so it has no seam. Each wave is free of divergence by itself: one part turns about
// the vertical, one rises and sinks. The ground is a mirror: horizontal components are even about it, the vertical one is odd. So
// the tile stores half a period along y, and no gust blows through the ground.
//
//     z 128 texels     index = (z * 16 + y) * 128 + x, four floats a texel (x, y, z, 0): 4 MiB
//     y  16 texels     texel i is at i + 1/2; x and z wrap at 128, y is mirrored at 0 and at 16
//     x 128 texels
#pragma once

#include "allocator.h"
#include "api.h"

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <vector>

namespace windrow {

/// Constant after creation: any number of winds and threads may read one.
class WINDROW_API GustTile {
  public:
    static constexpr int k_side = 128;  ///< texels along x and z, a whole period
    static constexpr int k_height = 16; ///< texels along y, half a period
    /// Texels from one gust to the next: the wavelength that carries most. Trilinear blending resolves it.
    static constexpr int k_gust_texels = 12;
    /// The longest wavelength that it holds.
    static constexpr int k_longest_texels = 40;

    /// Makes a tile: some 5 ms. The same seed gives the same bits on every machine. Null where memory is missing.
    [[nodiscard]] static std::shared_ptr<const GustTile> bake(std::uint32_t seed);
    /// The tile of seed 1, one object for all its users: the source of motors' eddies where the wind has no tile. Null without
    /// memory.
    [[nodiscard]] static std::shared_ptr<const GustTile> standard();

    /// All texels. Blended, each level component has standard deviation 1 over the tile (about 1.2 at the ground, where mirror
    /// images add up), the vertical one 0.5 (0 at the ground). w is 0.
    [[nodiscard]] std::span<const glm::vec4> texels() const { return texels_; }
    /// Length that no texel exceeds, hence no blend of texels.
    [[nodiscard]] float bound() const { return bound_; }
    /// The tile at a place counted in texels, as a plant's shader blends it. Any finite place.
    [[nodiscard]] glm::vec3 sample(glm::dvec3 place) const;
    /// Exact sum of the waves at a place in texels, which the texels sample. Slow (tens of
    /// microseconds).
    [[nodiscard]] glm::vec3 procedural(glm::dvec3 place) const;
    [[nodiscard]] std::uint32_t seed() const { return seed_; }
    /// Bytes of this object and of what it has allocated.
    [[nodiscard]] std::size_t memory_bytes() const;

  private:
    /// One wave: level components Re(c exp(i 2 pi (a x + c z) / 128)) cos(pi b y / 16), the vertical one with sin instead of cos.
    struct Mode {
        int a = 0, b = 0, c = 0;
        glm::dvec3 real{0.0}, imaginary{0.0};
    };

    explicit GustTile(std::uint32_t seed);
    void make_modes();
    void bake_texels();

    std::uint32_t seed_;
    detail::HostVector<Mode> modes_;
    detail::HostVector<glm::vec4> texels_;
    float bound_ = 0.0f;
};

} // namespace windrow
