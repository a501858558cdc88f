// Pictures in memory: what is drawn, read and written. pictures/picture_files.h has their files.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace windrow::pictures {

using Rgb8 = std::array<std::uint8_t, 3>;

/// 8-bit sRGB, three bytes a pixel, row by row from the top, no padding.
struct Picture8 {
    int width = 0, height = 0; ///< [px]
    std::vector<std::uint8_t> values{};

    Picture8() = default;
    Picture8(int columns, int rows)
        : width(columns), height(rows), values(3 * static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {}

    [[nodiscard]] std::size_t offset(int column, int row) const {
        return (static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)) * 3;
    }
    [[nodiscard]] Rgb8 at(int column, int row) const {
        const std::size_t first = offset(column, row);
        return {values[first], values[first + 1], values[first + 2]};
    }
    void set(int column, int row, Rgb8 colour) {
        const std::size_t first = offset(column, row);
        for (std::size_t channel = 0; channel < 3; ++channel)
            values[first + channel] = colour[channel];
    }
};

/// Linear floats, `channels` a pixel, row by row from the top.
struct PictureF {
    int width = 0, height = 0, channels = 0;
    std::vector<float> values{};

    PictureF() = default;
    PictureF(int columns, int rows, int of_each)
        : width(columns), height(rows), channels(of_each),
          values(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows) * static_cast<std::size_t>(of_each)) {}
    [[nodiscard]] float at(int column, int row, int channel) const {
        return values[(static_cast<std::size_t>(row) * width + column) * channels + channel];
    }
};

} // namespace windrow::pictures
