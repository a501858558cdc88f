// Heights in files, as surveys and terrain tools write them: pictures (PGM, and what the program reads besides: PNG, TIFF), ESRI ASCII
// grids (.asc), squares of whole numbers of 16 bits (.raw, .r16). One reader for grounds, lengths by place and the picture's ground.
#pragma once

#include "fluid/files/pgm.h"
#include "scene/json_object.h"

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace windrow::scene {

/// Of whole numbers of 16 bits in a raw file.
enum class ByteOrder : std::uint8_t { low_first, high_first };

/// What an object that names a file of heights says of it.
struct HeightKeys {
    ByteOrder byte_order = ByteOrder::low_first;
    std::optional<double> nodata{}; ///< in the file's own numbers; none: as the file says
};
[[nodiscard]] HeightKeys height_keys(JsonObject& object);

/// Heights, a pixel a metre. Places without data are filled from their neighbours. A line of the log's warnings reports them, and another
/// one a pixel of another size than a metre. Rejects files of colours, files of which a fifth has no data, and raw files that the other
/// byte order makes smooth. `scaled`: the scene gives the size of a pixel.
[[nodiscard]] Result<HeightPicture> read_height_file(std::string_view bytes, const std::string& name, const HeightKeys& keys,
                                                     bool scaled, ReadLog& log);

/// Holes of a mask: white, above half. Rejects what is no such picture.
[[nodiscard]] Result<HoleMask> read_holes(std::string_view bytes, const std::string& name, ReadLog& log);

/// What a TIFF says beside its pixels, of GDAL's tags.
struct TiffTags {
    std::optional<double> nodata{};    ///< 42113
    std::optional<glm::dvec2> pixel{}; ///< 33550, of the coordinates: metres, or degrees
};
/// None where the bytes are no TIFF, or its directory cannot be read.
[[nodiscard]] TiffTags tiff_tags(std::string_view bytes);

} // namespace windrow::scene
