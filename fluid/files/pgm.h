// PGM pictures of 8 or 16 bits, which every image program writes: heights, masks. Binary ones (P5) and those in words (P2).
#pragma once

#include "fluid/api.h"
#include "fluid/result.h"
#include "fluid/shapes/height_map.h"

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace windrow {

/// Heights of a file, a pixel a metre, with what it says of them.
struct HeightPicture {
    HeightData data{};
    bool metres = false;               ///< else 0 is black and 1 white
    double unit = 1.0;                 ///< of the file's own numbers in a height
    std::optional<double> nodata{};    ///< own number of a place without data
    std::optional<glm::dvec2> pixel{}; ///< size of a pixel, in metres or in degrees
};

namespace detail {

/// A picture within a file's bytes, which must live longer.
struct WINDROW_INTERNAL Pgm {
    glm::ivec2 size{0};      ///< pixels
    std::uint32_t white = 1; ///< the highest level; more than 255: two bytes a pixel
    std::string_view bytes{};
    std::vector<std::uint16_t> levels{}; ///< of one in words

    [[nodiscard]] std::size_t pixels() const { return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y); }
    /// 0 is black, 1 white; a level beyond white is white.
    [[nodiscard]] float value(std::size_t pixel) const;
};

/// `name` begins the sentence that says why a file is none. Rejects more than `max_pixels`.
[[nodiscard]] WINDROW_INTERNAL Result<Pgm> read_pgm(std::string_view bytes, const std::string& name, std::size_t max_pixels);

} // namespace detail
} // namespace windrow
