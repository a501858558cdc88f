// Binary PGM pictures (P5) of 8 or 16 bits, which every image program writes: heights, masks.
#pragma once

#include "fluid/api.h"
#include "fluid/result.h"

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <string>
#include <string_view>

namespace windrow::detail {

/// A picture within a file's bytes, which must live longer.
struct WINDROW_INTERNAL Pgm {
    glm::ivec2 size{0};      ///< pixels
    std::uint32_t white = 1; ///< the highest level; more than 255: two bytes a pixel
    std::string_view bytes{};

    [[nodiscard]] std::size_t pixels() const { return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y); }
    /// 0 is black, 1 white; a level beyond white is white.
    [[nodiscard]] float value(std::size_t pixel) const;
};

/// `name` begins the sentence that says why a file is none. Rejects more than `max_pixels`.
[[nodiscard]] WINDROW_INTERNAL Result<Pgm> read_pgm(std::string_view bytes, const std::string& name, std::size_t max_pixels);

} // namespace windrow::detail
