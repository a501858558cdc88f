// Pictures as PNG, JPEG, WebP and EXR files, by OpenImageIO.
//
//     if (auto written = pictures::write_png(picture, "frame.png"); !written)
//         std::fprintf(stderr, "%s\n", written.error().c_str());
//
// A file is encoded in memory, written beside its name and renamed: what was under the name stays until the new file is whole.
#pragma once

#include "fluid/files/pgm.h"
#include "fluid/result.h"
#include "pictures/picture.h"

#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace windrow::pictures {

struct PngWords {
    std::string title;       ///< PNG text "Title"
    std::string description; ///< PNG text "Description"; a frame's time
};

/// How a PNG's rows are prepared for compression.
enum class PngRows {
    filtered, ///< as libpng chooses: the smallest files of renderings
    plain     ///< as they are: half the time and no larger where a picture is mostly even paper and few colours
};

/// The bytes of a PNG file. `file` is what an error calls it.
[[nodiscard]] Result<std::vector<unsigned char>> encode_png(const Picture8& picture, const PngWords& words, PngRows rows,
                                                            const std::filesystem::path& file);
[[nodiscard]] Result<void> write_png(const Picture8& picture, const std::filesystem::path& file);
/// The bytes of a WebP file of a quality of 1 to 100, without loss at 100.
[[nodiscard]] Result<std::vector<unsigned char>> encode_webp(const Picture8& picture, int quality,
                                                             const std::filesystem::path& file);
/// JPEG of a quality of 1 to 100.
[[nodiscard]] Result<void> write_jpeg(const Picture8& picture, int quality, const std::filesystem::path& file);
/// Half floats, ZIP. Three channels are R, G, B; beside them `motion`, of the same size, as motion.x and motion.y in pixels since
/// the frame before, x right and y down; an empty one: none.
[[nodiscard]] Result<void> write_exr(const PictureF& light, const PictureF& motion, const std::filesystem::path& file);

/// Any PNG of at most 8 bits a channel's worth of colour, without its alpha; rejects one above 16384 pixels a side.
[[nodiscard]] Result<Picture8> read_png(const std::filesystem::path& file, PngWords* words = nullptr);

/// Heights of a picture, a pixel a metre, of a PNG or a TIFF. Whole numbers without a sign are 0 m for black and 1 m for white, of 8
/// or 16 bits; floats, and numbers with a sign as surveys have them, are metres. Rejects pictures of colours. `name` begins an error's
/// sentence. What a GeoTIFF says beside its pixels is not read here (scene/height_files.h).
/// A picture of more than `max_pixels` is rejected by its header, before memory is taken for it.
[[nodiscard]] Result<HeightPicture> read_heights(std::string_view bytes, const std::string& name,
                                                 std::size_t max_pixels = std::numeric_limits<std::size_t>::max());

/// The picture in another size, filtered so that thin lines stay; rejected only without memory.
[[nodiscard]] Result<Picture8> resized(const Picture8& picture, int width, int height);

} // namespace windrow::pictures
