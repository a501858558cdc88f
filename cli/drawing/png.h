// PNG files, whole or not at all.
#pragma once

#include "cli/drawing/image.h"
#include "fluid/result.h"

#include <filesystem>
#include <string>

namespace windrow::cli {

struct PngWords {
    std::string title;       ///< PNG text "Title"
    std::string description; ///< PNG text "Description"; a frame's time
};

/// What stands under the name stays until the new file is whole. Where the disk is to blame the error begins with k_disk_fault.
[[nodiscard]] Result<void> write_png(const Image& image, const PngWords& words, const std::filesystem::path& file);

/// Any PNG of at most 8 bits a channel's worth of colour, without its alpha; refuses one above 16384 pixels a side.
[[nodiscard]] Result<Image> read_png(const std::filesystem::path& file, PngWords* words = nullptr);

/// The image in another size, filtered so that thin lines stay; refused only without memory.
[[nodiscard]] Result<Image> resized(const Image& image, int width, int height);

} // namespace windrow::cli
