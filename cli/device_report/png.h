// PNG files without a library: the portable command has none.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace windrow::cli {

/// The bytes of a PNG file of 8 bits for red, green and blue. `pixels`: four bytes a pixel, of which the last is left out, rows from
/// the top, width * height of them; both from 1 to 65535.
[[nodiscard]] std::string png_of(int width, int height, std::span<const std::byte> pixels);

} // namespace windrow::cli
