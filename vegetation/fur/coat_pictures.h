// The pictures of a coat in memory: linear floats in a list of texels that shaders blend by hand.
//
//     fur::CoatPictures pictures;                                       // none: a coat without maps
//     pictures.length = {.columns = 64, .rows = 64, .texels = lengths};
//     auto coat = fur::Coat::create(device, targets, mesh, {}, settings, pictures, body, anchor);
#pragma once

#include "coat_settings.h"

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

namespace windrow::vegetation::fur {

/// Row by row from the top, linear; grey ones have the same in all three.
struct CoatPicture {
    int columns = 0, rows = 0; ///< 0: none
    std::vector<glm::vec4> texels{};
};
/// [texels] 16 million texels of 8 bytes each, and a third more for their levels
inline constexpr int k_max_picture_side = 4096;

struct CoatPictures {
    CoatPicture length{}, colour{}, noise_a{}, noise_b{};
};

/// Rejects pictures whose texels are not columns times rows, are too many or not finite.
[[nodiscard]] windrow::Result<void> validate(const CoatPictures& pictures);

/// All levels of all pictures as texels of four halves, each level half as wide as the one before, by the mean of four.
struct PackedPictures {
    std::array<glm::ivec4, 4> places{}; ///< length, colour, noise a, noise b: x first texel; y columns; z rows; w levels, 0: none
    std::vector<glm::uvec2> texels{};   ///< at least one
};
[[nodiscard]] PackedPictures packed(const CoatPictures& pictures);
/// [bytes] Of them, without making them.
[[nodiscard]] std::uint64_t packed_bytes(const CoatPictures& pictures);

} // namespace windrow::vegetation::fur
