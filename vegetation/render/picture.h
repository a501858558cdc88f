// Pictures in memory, and as PNG and EXR files that are whole or not there.
#pragma once

#include "fluid/result.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace windrow::vegetation::render {

/// 8-bit sRGB, three bytes a pixel, row by row from the top.
struct Picture8 {
    int width = 0, height = 0;
    std::vector<std::uint8_t> values{};

    Picture8() = default;
    Picture8(int columns, int rows)
        : width(columns), height(rows), values(3 * static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {}
};

/// Floats, linear, `channels` a pixel.
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

/// What stands under the name stays until the new file is whole.
[[nodiscard]] windrow::Result<void> write_png(const Picture8& picture, const std::filesystem::path& file);
/// JPEG of a quality of 1 to 100.
[[nodiscard]] windrow::Result<void> write_jpeg(const Picture8& picture, int quality, const std::filesystem::path& file);
/// Half floats, ZIP. Three channels are R, G, B; beside them `motion`, of the same size, as motion.x and motion.y in pixels since
/// the frame before, x right and y down; an empty one: none.
[[nodiscard]] windrow::Result<void> write_exr(const PictureF& light, const PictureF& motion, const std::filesystem::path& file);

} // namespace windrow::vegetation::render
