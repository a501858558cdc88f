#include "vegetation/files/coat_picture_files.h"

#include <OpenImageIO/imageio.h>
#include <cmath>
#include <exception>

namespace windrow::vegetation::fur {
namespace {

using windrow::Error;
using windrow::Result;

float linear(float encoded) {
    return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

Result<CoatPicture> read(const std::filesystem::path& file, const std::filesystem::path& folder, bool colour) {
    const std::string name = file.string();
    std::error_code fault;
    const std::filesystem::path real = std::filesystem::canonical(file, fault);
    if (!fault) { // what is not there, the reader tells
        const std::filesystem::path home = std::filesystem::canonical(folder.empty() ? "." : folder, fault);
        if (fault || *real.lexically_relative(home).begin() == "..")
            return Error{name + " is a link out of its folder; put the picture itself there."};
        if (!std::filesystem::is_regular_file(real, fault))
            return Error{name + " is not a file; give a PNG, PGM or EXR."};
    }
    std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(name);
    if (!input) {
        const std::string why = OIIO::geterror();
        return Error{name + " cannot be read as a picture (" + why.substr(0, why.find('\n')) + "); give a PNG, PGM or EXR."};
    }
    const OIIO::ImageSpec& spec = input->spec();
    if (spec.width < 1 || spec.height < 1 || spec.width > k_most_picture_side || spec.height > k_most_picture_side ||
        spec.depth > 1 || spec.nchannels < 1 || spec.nchannels > 16)
        return Error{name + " is " + std::to_string(spec.width) + " x " + std::to_string(spec.height) + " texels of " +
                     std::to_string(spec.nchannels) + " channels; give 1 to " + std::to_string(k_most_picture_side) + " a side."};
    const auto channels = static_cast<std::size_t>(spec.nchannels);
    const auto count = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
    std::vector<float> values(channels * count);
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, values.data()))
        return Error{name + " cannot be read to its end (" + input->geterror() + "); write it anew."};
    const bool encoded =
        colour && spec.format.basetype == OIIO::TypeDesc::UINT8 && spec.get_string_attribute("oiio:ColorSpace") != "Linear";
    CoatPicture made{spec.width, spec.height, {}};
    made.texels.reserve(count);
    for (std::size_t n = 0; n < count; ++n) {
        glm::vec4 texel(0.0f, 0.0f, 0.0f, 1.0f);
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const float value = values[channels * n + (channels < 3 ? 0 : channel)];
            if (!std::isfinite(value))
                return Error{name + " has a texel that is not finite; give finite numbers."};
            texel[static_cast<int>(channel)] = encoded ? linear(value) : value;
        }
        made.texels.push_back(texel);
    }
    return made;
}

} // namespace

Result<CoatPictures> read_pictures(const CoatMaps& maps, const std::filesystem::path& folder) {
    CoatPictures pictures;
    struct Wanted {
        const std::string& file;
        CoatPicture& into;
        bool colour;
    };
    try {
        for (const Wanted& each :
             {Wanted{maps.length, pictures.length, false}, Wanted{maps.colour, pictures.colour, true},
              Wanted{maps.noise_a, pictures.noise_a, false}, Wanted{maps.noise_b, pictures.noise_b, false}}) {
            if (each.file.empty())
                continue;
            Result<CoatPicture> picture = read(folder / each.file, folder, each.colour);
            if (!picture)
                return Error{picture.error()};
            each.into = *std::move(picture);
        }
    } catch (const std::exception& fault) { // of a codec, or of memory that a damaged file asks for
        return Error{"A picture of the coat cannot be read (" + std::string(fault.what()) + "); give another file."};
    }
    return pictures;
}

} // namespace windrow::vegetation::fur
