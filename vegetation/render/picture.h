// Pictures that the renderer returns, and the one file format that needs no library: PPM.
//
//     const render::Picture8 picture = renderer->images().picture();
//     if (auto written = render::write_ppm(picture, "frame.ppm"); !written)
//         std::fprintf(stderr, "%s\n", written.error().c_str());
#pragma once

#include "../../fluid/result.h"
#include "../../pictures/picture.h"

#include <filesystem>

namespace windrow::vegetation::render {

using pictures::Picture8; ///< 8-bit sRGB, three bytes a pixel, row by row from the top
using pictures::PictureF; ///< linear floats

/// A binary PPM (P6) of the picture. The file is written beside its name and renamed: what was under the name stays until the
/// new file is whole. Rejects an empty picture, values that are not 3 * width * height, and a file that cannot be written.
[[nodiscard]] windrow::Result<void> write_ppm(const Picture8& picture, const std::filesystem::path& file);

} // namespace windrow::vegetation::render
