// An image of 8-bit RGB pixels: what the drawing makes and the PNG holds.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace windrow::cli {

using Rgb8 = std::array<std::uint8_t, 3>;

/// Row by row from the top, three bytes a pixel, no padding; colours are sRGB.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> pixels;

    Image() = default;
    Image(int columns, int rows)
        : width(columns), height(rows), pixels(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows) * 3) {}

    [[nodiscard]] std::size_t offset(int column, int row) const {
        return (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)) * 3;
    }
    [[nodiscard]] Rgb8 at(int column, int row) const {
        const std::size_t first = offset(column, row);
        return {pixels[first], pixels[first + 1], pixels[first + 2]};
    }
    void set(int column, int row, Rgb8 colour) {
        const std::size_t first = offset(column, row);
        for (std::size_t channel = 0; channel < 3; ++channel)
            pixels[first + channel] = colour[channel];
    }
};

} // namespace windrow::cli
