// The pictures of a coat, read: linear floats in a list of texels that shaders blend by hand.
//
//     auto pictures = shells::read_pictures(settings.maps, folder_of_the_scene);   // PNG, PGM, EXR ..., by OpenImageIO
//     auto coat = shells::Coat::create(device, targets, mesh, {}, settings, *pictures, body, anchor);
#pragma once

#include "vegetation/fur/coat_settings.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

namespace shells {

/// Row by row from the top, linear; grey ones have the same in all three.
struct CoatPicture {
    int columns = 0, rows = 0; ///< 0: none
    std::vector<glm::vec4> texels{};
};
/// [texels] 16 million texels of 8 bytes each, and a third more for their levels
inline constexpr int k_most_picture_side = 4096;

struct CoatPictures {
    CoatPicture length{}, colour{}, noise_a{}, noise_b{};
};

/// Files are beside `folder`; a colour is turned linear where its file says or is of 8 bits. Refuses what is no picture, has no
/// texel, more than k_most_picture_side of them along a side, or a texel that is not finite, with the file's name.
[[nodiscard]] windrow::Result<CoatPictures> read_pictures(const CoatMaps& maps, const std::filesystem::path& folder);

/// Refuses pictures whose texels are not columns times rows, are too many or not finite.
[[nodiscard]] windrow::Result<void> validate(const CoatPictures& pictures);

/// All levels of all pictures as texels of four halves, each level half as wide as the one before, by the mean of four.
struct PackedPictures {
    std::array<glm::ivec4, 4> places{}; ///< length, colour, noise a, noise b: x first texel; y columns; z rows; w levels, 0: none
    std::vector<glm::uvec2> texels{};   ///< at least one
};
[[nodiscard]] PackedPictures packed(const CoatPictures& pictures);
/// [bytes] Of them, without making them.
[[nodiscard]] std::uint64_t packed_bytes(const CoatPictures& pictures);

} // namespace shells
