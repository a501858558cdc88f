// An image of 8-bit RGB pixels, as the drawing makes it, and its PNG file, whole or not at all.
//
// pictures/picture_files.h encodes and reads. The file is written as all of the command's files are: an error names the disk
// where that is at fault.
#pragma once

#include "fluid/result.h"
#include "pictures/picture_files.h"

#include <filesystem>

namespace windrow::cli {

using Image = pictures::Picture8;
using pictures::PngWords;
using pictures::read_png;
using pictures::Rgb8;

/// What stands under the name stays until the new file is whole. Where the disk is to blame the error begins with k_disk_fault.
[[nodiscard]] Result<void> write_png(const Image& image, const PngWords& words, const std::filesystem::path& file);

} // namespace windrow::cli
