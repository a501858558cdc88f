// Placement mask of grass: an alpha image over the field. 0 is no blade; between 0 and 1 blades are as much smaller,
// so that a painted edge falls off by itself.
//
//     auto mask = grass::PlacementMask::create({257, 257}, hills->extent());
//     (void)mask->paint({.centre = {100.0f, 60.0f}, .radius = 30.0f});
//     (void)mask->erase({.centre = {100.0f, 60.0f}, .radius = 4.0f});          // a place for a tent
//     (void)mask->apply([](glm::vec2 p, float alpha) { return p.x < 20.0f ? 0.0f : alpha; });
//     (void)mask->save("meadow.pgm");
//
// Values are whole multiples of 1/65535: what a saved image gives back is the mask, to the bit.
#pragma once

#include "../../fluid/result.h"
#include "../../fluid/setting.h"
#include "grass_numerics.h"

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace windrow::vegetation::grass {

struct Brush {
    glm::vec2 centre{0.0f};
    float radius = 5.0f;
    float strength = 1.0f;
    float hardness = 0.5f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("centre", &Brush::centre, {-1e6, 1e6, "m"}, "From the ground's corner, along x and z; may lie outside."),
            Setting("radius", &Brush::radius, {0.001, 1e5, "m"}, "Of the stroke."),
            Setting("strength", &Brush::strength, k_fraction_range,
                    "Change by a stroke at its middle; falls to 0 at the radius."),
            Setting("hardness", &Brush::hardness, k_fraction_range,
                    "Fraction of the radius that has the whole strength; beyond it (1 - r^2)^2, which meets both ends level."),
        };
    }
};

/// Area of a stroke [m]; nothing where high < low.
struct Touched {
    glm::vec2 low{0.0f};
    glm::vec2 high{-1.0f};
};

class PlacementMask {
  public:
    /// An even mask. Rejects fewer than 2 corners or more than 16384 along an axis, an extent [m] that is not 1e-3 to 1e6, and an
    /// alpha that is not 0 to 1. Default: nothing painted.
    [[nodiscard]] static windrow::Result<PlacementMask> create(glm::ivec2 corners, glm::vec2 extent, float alpha = 0.0f);
    /// From a binary PGM of 8 or 16 bits, first row at z = 0. Says why a file is none.
    [[nodiscard]] static windrow::Result<PlacementMask> load(const std::string& path, glm::vec2 extent);
    /// The same from a file's bytes. `name` begins the sentence. Rejects more than `max_values` pixels before it takes memory.
    [[nodiscard]] static windrow::Result<PlacementMask> from_pgm(std::string_view bytes, glm::vec2 extent,
                                                                 const std::string& name, std::size_t max_values);
    /// [byte] Of a PGM's file: the largest mask of 16 bits, and its header.
    static constexpr std::size_t k_max_pgm_bytes = (std::size_t{512} << 20) + 4096;
    /// As a binary PGM of 16 bits, written beside its name and renamed.
    [[nodiscard]] windrow::Result<void> save(const std::string& path) const;

    /// Adds alpha up to 1, or takes it down to 0. Rejects brushes outside of the ranges above and touches nothing then.
    windrow::Result<Touched> paint(const Brush& brush);
    windrow::Result<Touched> erase(const Brush& brush);
    /// Each corner's alpha by a function of its place [m] and its alpha; results are held within 0 to 1, NaN as 0.
    Touched apply(const std::function<float(glm::vec2 place, float alpha)>& change);

    /// Bilinear.
    [[nodiscard]] float alpha(glm::vec2 place) const;
    /// Whether any place within a box [m] has alpha above 0.
    [[nodiscard]] bool grows(glm::vec2 low, glm::vec2 high) const;

    [[nodiscard]] glm::vec2 extent() const { return glm::vec2(grid_.corners - 1) * grid_.spacing; }
    [[nodiscard]] const windrow::numerics::WindrowGrid& grid() const { return grid_; }
    [[nodiscard]] std::span<const float> values() const { return values_; }

  private:
    PlacementMask(const windrow::numerics::WindrowGrid& grid, std::vector<float> values);
    windrow::Result<Touched> stroke(const Brush& brush, float sign);

    windrow::numerics::WindrowGrid grid_;
    std::vector<float> values_;
};

} // namespace windrow::vegetation::grass
