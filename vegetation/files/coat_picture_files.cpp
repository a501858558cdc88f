#include "vegetation/files/coat_picture_files.h"

#include "fluid/core/message.h"
#include "fluid/files/input_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <cmath>
#include <exception>

namespace windrow::vegetation::fur {
namespace {

using windrow::Error;
using windrow::Result;

// [byte] Of a file: the largest picture of four floats a texel, uncompressed.
constexpr std::size_t k_max_picture_bytes = std::size_t{320} << 20;
// [byte] Of a picture as its file holds it, decoded.
constexpr std::size_t k_max_decoded_bytes = std::size_t{512} << 20;
// [texels] 64 MB of 16 floats each.
constexpr int k_max_tile_side = 1024;

float linear(float encoded) {
    return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

Result<CoatPicture> read(const std::filesystem::path& file, const std::filesystem::path& folder, bool colour,
                         windrow::detail::InputBudget& budget) {
    const std::string name = file.string();
    const auto bytes = windrow::detail::read_input(file, {.folder = folder, .max_bytes = k_max_picture_bytes}, budget);
    if (!bytes)
        return bytes.failure();
    // From memory: OpenImageIO opens no file by itself.
    OIIO::Filesystem::IOMemReader memory(const_cast<char*>(bytes->data()), bytes->size());
    const auto input = OIIO::ImageInput::open(name, nullptr, &memory);
    if (!input) {
        const std::string why = OIIO::geterror();
        return Error{name + " cannot be read as a picture (" + why.substr(0, why.find('\n')) + "); give a PNG, PGM or EXR."};
    }
    const OIIO::ImageSpec& spec = input->spec();
    if (spec.width < 1 || spec.height < 1 || spec.width > k_max_picture_side || spec.height > k_max_picture_side ||
        spec.depth > 1 || spec.nchannels < 1 || spec.nchannels > 16)
        return Error{detail::message(name, " is ", spec.width, " x ", spec.height, " texels of ", spec.nchannels,
                                     " channels; give 1 to ", k_max_picture_side, " a side, of 1 to 16 channels.")};
    // Some codecs decode all channels of a tile, or of the whole picture, at once.
    if (spec.image_bytes(true) > k_max_decoded_bytes)
        return Error{detail::message(name, " holds ", spec.image_bytes(true) >> 20, " MiB; give at most ",
                                     k_max_decoded_bytes >> 20, " MiB, by fewer texels or channels.")};
    if (spec.deep || spec.tile_width > k_max_tile_side || spec.tile_height > k_max_tile_side)
        return Error{detail::message(name, " has deep texels or tiles of more than ", k_max_tile_side,
                                     " texels a side; save it as scan lines.")};
    const auto count = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
    // A coat keeps 8 bytes a texel.
    if (auto taken = budget.take_memory(name, 8 * count); !taken)
        return taken.failure();
    CoatPicture made{spec.width, spec.height, std::vector<glm::vec4>(count, glm::vec4(0.0f, 0.0f, 0.0f, 1.0f))};
    const int channels = spec.nchannels < 3 ? 1 : 3;
    // No more channels than are used, each in its place.
    if (!input->read_image(0, 0, 0, channels, OIIO::TypeDesc::FLOAT, made.texels.data(), sizeof(glm::vec4)))
        return Error{name + " cannot be read completely (" + input->geterror() + "); write it again."};
    const bool encoded =
        colour && spec.format.basetype == OIIO::TypeDesc::UINT8 && spec.get_string_attribute("oiio:ColorSpace") != "Linear";
    for (glm::vec4& texel : made.texels)
        for (int channel = 0; channel < 3; ++channel) {
            const float value = texel[channel < channels ? channel : 0];
            if (!std::isfinite(value))
                return Error{name + " has a texel that is not finite; give finite numbers."};
            texel[channel] = channel < channels && encoded ? linear(value) : value;
        }
    return made;
}

} // namespace

Result<CoatPictures> read_pictures(const CoatMaps& maps, const std::filesystem::path& folder,
                                   windrow::detail::InputBudget& budget) {
    CoatPictures pictures;
    struct PictureRequest {
        const std::string& file;
        CoatPicture& into;
        bool colour;
    };
    try {
        for (const PictureRequest& each :
             {PictureRequest{maps.length, pictures.length, false}, PictureRequest{maps.colour, pictures.colour, true},
              PictureRequest{maps.noise_a, pictures.noise_a, false}, PictureRequest{maps.noise_b, pictures.noise_b, false}}) {
            if (each.file.empty())
                continue;
            Result<CoatPicture> picture = read(folder / each.file, folder, each.colour, budget);
            if (!picture)
                return picture.failure();
            each.into = *std::move(picture);
        }
    } catch (const std::exception& fault) { // of a codec, or of memory that a damaged file asks for
        return Error{"A picture of the coat cannot be read (" + std::string(fault.what()) + "); give another file."};
    }
    return pictures;
}

Result<CoatPictures> read_pictures(const CoatMaps& maps, const std::filesystem::path& folder) {
    windrow::detail::InputBudget budget;
    return read_pictures(maps, folder, budget);
}

} // namespace windrow::vegetation::fur
