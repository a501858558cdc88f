#include "pictures/picture_files.h"

#include "fluid/core/message.h"
#include "fluid/files/input_file.h"
#include "fluid/files/new_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>
#include <algorithm>
#include <cmath>

namespace windrow::pictures {
namespace {

using detail::message;
using Bytes = std::vector<unsigned char>;

// Of what the library says: the lines behind are its own stack of causes.
std::string first_line(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

constexpr int k_largest_side = 16384;
constexpr std::size_t k_max_file_bytes = std::size_t{512} << 20;

Result<void> check_size(const std::filesystem::path& file, std::size_t has, int width, int height, int channels) {
    if (width > 0 && height > 0 &&
        has == static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * static_cast<std::size_t>(channels))
        return {};
    return Error{message("picture ", file.string(), " of ", width, " x ", height, " px with ", has,
                         " values cannot be written; give it width * height * ", channels, " values.")};
}

OIIO::ImageSpec spec_of(const Picture8& picture) {
    OIIO::ImageSpec spec(picture.width, picture.height, 3, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    return spec;
}

Result<Bytes> encode(const char* format, const OIIO::ImageSpec& spec, OIIO::TypeDesc type, const void* values,
                     const std::filesystem::path& file) {
    Bytes bytes;
    OIIO::Filesystem::IOVecOutput proxy(bytes);
    const auto output = OIIO::ImageOutput::create(format, &proxy);
    if (!output || !output->open(file.filename().string(), spec) || !output->write_image(type, values) || !output->close())
        return Error{message("picture ", file.string(), " cannot be encoded as ", format, " (",
                             output ? output->geterror() : OIIO::geterror(), "); draw a smaller picture")};
    return bytes;
}

Result<void> publish(const Result<Bytes>& bytes, const std::filesystem::path& file) {
    if (!bytes)
        return bytes.failure();
    return detail::write_file("picture", file, {reinterpret_cast<const char*>(bytes->data()), bytes->size()});
}

OIIO::ImageBuf wrap(const Picture8& picture) {
    const OIIO::ImageSpec spec(picture.width, picture.height, 3, OIIO::TypeDesc::UINT8);
    return OIIO::ImageBuf(spec, const_cast<std::uint8_t*>(picture.values.data()));
}

} // namespace

Result<Bytes> encode_png(const Picture8& picture, const PngWords& words, PngRows rows, const std::filesystem::path& file) {
    if (auto fits = check_size(file, picture.values.size(), picture.width, picture.height, 3); !fits)
        return fits.failure();
    OIIO::ImageSpec spec = spec_of(picture);
    if (rows == PngRows::plain) {
        spec.attribute("png:filter", 0x08); // PNG_FILTER_NONE
        spec.attribute("png:compressionLevel", 6);
    }
    if (!words.title.empty())
        spec.attribute("DocumentName", words.title);
    if (!words.description.empty())
        spec.attribute("ImageDescription", words.description);
    return encode("png", spec, OIIO::TypeDesc::UINT8, picture.values.data(), file);
}

Result<void> write_png(const Picture8& picture, const std::filesystem::path& file) {
    return publish(encode_png(picture, {}, PngRows::filtered, file), file);
}

Result<void> write_jpeg(const Picture8& picture, int quality, const std::filesystem::path& file) {
    if (auto fits = check_size(file, picture.values.size(), picture.width, picture.height, 3); !fits)
        return fits;
    OIIO::ImageSpec spec = spec_of(picture);
    spec.attribute("Compression", "jpeg:" + std::to_string(quality));
    return publish(encode("jpeg", spec, OIIO::TypeDesc::UINT8, picture.values.data(), file), file);
}

Result<Bytes> encode_webp(const Picture8& picture, int quality, const std::filesystem::path& file) {
    if (auto fits = check_size(file, picture.values.size(), picture.width, picture.height, 3); !fits)
        return fits.failure();
    OIIO::ImageSpec spec = spec_of(picture);
    spec.attribute("Compression", "webp:" + std::to_string(quality));
    return encode("webp", spec, OIIO::TypeDesc::UINT8, picture.values.data(), file);
}

Result<void> write_exr(const PictureF& light, const PictureF& motion, const std::filesystem::path& file) {
    if (auto fits = check_size(file, light.values.size(), light.width, light.height, 3); !fits)
        return fits;
    const bool moves = !motion.values.empty();
    if (moves && (motion.width != light.width || motion.height != light.height || motion.channels != 2))
        return Error{message("picture ", file.string(), ": motion is ", motion.width, " x ", motion.height, " px of ",
                             motion.channels, " channels; give it the size of light and two channels.")};
    OIIO::ImageSpec spec(light.width, light.height, moves ? 5 : 3, OIIO::TypeDesc::HALF);
    spec.channelnames = {"R", "G", "B"};
    if (moves)
        spec.channelnames.insert(spec.channelnames.end(), {"motion.x", "motion.y"});
    spec.attribute("compression", "zip");
    spec.attribute("DateTime", "1970:01:01 00:00:00"); // the library writes the clock's else: a picture drawn again has its bytes
    std::vector<float> values;
    const std::size_t pixels = static_cast<std::size_t>(light.width) * static_cast<std::size_t>(light.height);
    values.reserve(pixels * static_cast<std::size_t>(spec.nchannels));
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        values.insert(values.end(), light.values.begin() + 3 * static_cast<std::ptrdiff_t>(pixel),
                      light.values.begin() + 3 * static_cast<std::ptrdiff_t>(pixel) + 3);
        if (moves) {
            values.push_back(motion.values[2 * pixel] * static_cast<float>(light.width));
            values.push_back(motion.values[2 * pixel + 1] * static_cast<float>(light.height));
        }
    }
    return publish(encode("openexr", spec, OIIO::TypeDesc::FLOAT, values.data(), file), file);
}

Result<Picture8> read_png(const std::filesystem::path& file, PngWords* words) {
    const std::string name = file.string();
    detail::InputBudget budget;
    const auto bytes = detail::read_input(file, {.max_bytes = k_max_file_bytes}, budget);
    if (!bytes)
        return bytes.failure().after(message("picture "));
    OIIO::Filesystem::IOMemReader memory(const_cast<char*>(bytes->data()), bytes->size());
    const auto input = OIIO::ImageInput::open(name, nullptr, &memory);
    if (!input)
        return Error{message("picture ", name, " cannot be read (", first_line(OIIO::geterror()), "); draw it again")};
    const OIIO::ImageSpec spec = input->spec();
    // Checked before anything is allocated: a header may promise what no file holds.
    if (spec.width < 1 || spec.height < 1 || spec.width > k_largest_side || spec.height > k_largest_side)
        return Error{message("picture ", name, " of ", spec.width, " x ", spec.height, " px is beyond ", k_largest_side,
                             " px a side; draw a smaller one")};
    Picture8 picture(spec.width, spec.height);
    const int channels = spec.nchannels < 3 ? 1 : 3;
    if (!input->read_image(0, 0, 0, channels, OIIO::TypeDesc::UINT8, picture.values.data(), 3))
        return Error{message("picture ", name, " is damaged (", first_line(input->geterror()), "); draw it again")};
    for (std::size_t grey = 0; channels == 1 && grey < picture.values.size(); grey += 3)
        picture.values[grey + 1] = picture.values[grey + 2] = picture.values[grey];
    if (words != nullptr) {
        words->title = spec.get_string_attribute("DocumentName");
        words->description = spec.get_string_attribute("ImageDescription");
    }
    return picture;
}

Result<HeightPicture> read_heights(std::string_view bytes, const std::string& name, std::size_t max_pixels) {
    OIIO::Filesystem::IOMemReader memory(const_cast<char*>(bytes.data()), bytes.size());
    OIIO::ImageSpec wanted;
    wanted.attribute("oiio:UnassociatedAlpha", 1); // else heights come multiplied by their alpha
    const auto input = OIIO::ImageInput::open(name, &wanted, &memory);
    if (!input)
        return Error{message(name, " is no picture of heights (", first_line(OIIO::geterror()), "): give a PGM, PNG or TIFF.")};
    const OIIO::ImageSpec spec = input->spec();
    const std::string_view format = input->format_name();
    if ((format != "png" && format != "tiff") || spec.deep || spec.depth > 1 || spec.nchannels < 1)
        return Error{message(name, " is no flat picture but one of format ", format, ": give a PGM, PNG or TIFF.")};
    if (spec.width < 2 || spec.height < 2 || spec.width > HeightMap::k_max_corners || spec.height > HeightMap::k_max_corners)
        return Error{
            message(name, " is ", spec.width, " x ", spec.height, " px: give 2 to ", HeightMap::k_max_corners, " each.")};
    const std::size_t pixels = static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height),
                      most = spec.nchannels >= 3 ? max_pixels / 2 : max_pixels; // colours are compared, channel by channel
    if (pixels > most)
        return Error{message(name, " is ", spec.width, " x ", spec.height, " px: the scene has room for ", most,
                             " in all; give a smaller picture.")};
    // A header may promise what no file holds: both formats pack a row of zeros into a thousandth at best.
    if (pixels / 2'000 > bytes.size())
        return Error{
            message(name, " has ", bytes.size(), " bytes for ", spec.width, " x ", spec.height, " px: give a whole file.")};
    return detail::where_memory_lasts([&]() -> Result<HeightPicture> {
        HeightPicture picture{.data = {.corners = {spec.width, spec.height}, .spacing = 1.0f}};
        std::vector<float>& heights = picture.data.heights;
        heights.resize(pixels);
        const auto read_channel = [&](int channel, std::vector<float>& to) {
            return input->read_image(0, 0, channel, channel + 1, OIIO::TypeDesc::FLOAT, to.data());
        };
        bool whole = read_channel(0, heights);
        if (std::vector<float> other(spec.nchannels >= 3 ? heights.size() : 0); !other.empty())
            for (int channel = 1; channel < 3 && whole; ++channel) {
                whole = read_channel(channel, other);
                if (const auto apart = std::ranges::mismatch(heights, other); whole && apart.in1 != heights.end()) {
                    const auto pixel = static_cast<int>(apart.in1 - heights.begin());
                    return Error{message(name, " is a picture of colours, first at row ", pixel / spec.width + 1, ", column ",
                                         pixel % spec.width + 1,
                                         ": give heights in one channel, not coded in red, green and blue.")};
                }
            }
        if (!whole)
            return Error{message(name, " is damaged (", first_line(input->geterror()), "): give a whole file.")};
        // As floats, whole numbers are a part of the largest; those with a sign are metres.
        const auto base = static_cast<OIIO::TypeDesc::BASETYPE>(spec.format.basetype);
        picture.metres = base != OIIO::TypeDesc::UINT8 && base != OIIO::TypeDesc::UINT16 && base != OIIO::TypeDesc::UINT32;
        const double largest = base == OIIO::TypeDesc::UINT8    ? 255.0
                               : base == OIIO::TypeDesc::UINT16 ? 65535.0
                               : base == OIIO::TypeDesc::INT8   ? 127.0
                               : base == OIIO::TypeDesc::INT16  ? 32767.0
                               : base == OIIO::TypeDesc::INT32  ? 2147483647.0
                                                                : 1.0;
        picture.unit = picture.metres ? 1.0 : largest;
        if (largest != 1.0) // the library multiplies by a rounded reciprocal
            for (float& height : heights)
                height = static_cast<float>(std::round(largest * static_cast<double>(height)) / picture.unit);
        return picture;
    });
}

Result<Picture8> resized(const Picture8& picture, int width, int height) {
    Picture8 smaller(width, height);
    OIIO::ImageBuf target = wrap(smaller);
    if (!OIIO::ImageBufAlgo::resize(target, wrap(picture), "lanczos3", 0.0f, OIIO::ROI(0, width, 0, height, 0, 1, 0, 3)))
        return Error{message("a picture cannot be resized to ", width, " x ", height, " px (", target.geterror(),
                             "); draw a smaller one")};
    return smaller;
}

} // namespace windrow::pictures
