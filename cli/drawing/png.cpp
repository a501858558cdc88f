#include "cli/drawing/png.h"

#include "cli/output_file.h"
#include "cli/pictures.h"
#include "fluid/message.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

namespace windrow::cli {
namespace {

using detail::message;

constexpr int k_largest_side = 16384;

OIIO::ImageBuf wrap(const Image& image) {
    const OIIO::ImageSpec spec(image.width, image.height, 3, OIIO::TypeDesc::UINT8);
    return OIIO::ImageBuf(spec, const_cast<std::uint8_t*>(image.pixels.data()));
}

Result<std::vector<unsigned char>> encode(const Image& image, const PngWords& words, const std::filesystem::path& file) {
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput proxy(bytes);
    const auto output = OIIO::ImageOutput::create("png", &proxy);
    OIIO::ImageSpec spec(image.width, image.height, 3, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    // Rows as they are (PNG_FILTER_NONE): a frame is mostly even paper and few colours; the filters that libpng would try take
    // twice the time and make the file no smaller.
    spec.attribute("png:filter", 0x08);
    spec.attribute("png:compressionLevel", 6);
    if (!words.title.empty())
        spec.attribute("DocumentName", words.title);
    if (!words.description.empty())
        spec.attribute("ImageDescription", words.description);
    if (!output || !output->open(file.filename().string(), spec) ||
        !output->write_image(OIIO::TypeDesc::UINT8, image.pixels.data()) || !output->close())
        return Error{message("picture ", file.string(), " cannot be encoded as PNG (",
                             output ? output->geterror() : OIIO::geterror(), "); draw a smaller picture")};
    return bytes;
}

} // namespace

Result<void> write_png(const Image& image, const PngWords& words, const std::filesystem::path& file) {
    const auto bytes = encode(image, words, file);
    if (!bytes)
        return Error{bytes.error()};
    OutputFile output(file);
    output.write({reinterpret_cast<const char*>(bytes->data()), bytes->size()});
    if (const Fault fault = output.publish())
        return Error{(fault.machine ? std::string(k_disk_fault) : std::string()) + fault.sentence};
    return {};
}

Result<Image> read_png(const std::filesystem::path& file, PngWords* words) {
    const std::string name = file.string();
    const auto input = OIIO::ImageInput::open(name);
    if (!input)
        return Error{message("picture ", name, " cannot be read (", OIIO::geterror(), "); draw it again")};
    const OIIO::ImageSpec spec = input->spec();
    // Checked before anything is allocated: a header may promise what no file holds.
    if (spec.width < 1 || spec.height < 1 || spec.width > k_largest_side || spec.height > k_largest_side)
        return Error{message("picture ", name, " of ", spec.width, " x ", spec.height, " px is beyond ", k_largest_side,
                             " px a side; draw it smaller")};
    Image image(spec.width, spec.height);
    std::vector<std::uint8_t> all(static_cast<std::size_t>(spec.width) * spec.height * spec.nchannels);
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, all.data()))
        return Error{message("picture ", name, " is damaged (", input->geterror(), "); draw it again")};
    const int channels = spec.nchannels;
    for (std::size_t pixel = 0; pixel < image.pixels.size() / 3; ++pixel)
        for (int channel = 0; channel < 3; ++channel)
            image.pixels[pixel * 3 + channel] = all[pixel * channels + (channels >= 3 ? channel : 0)];
    if (words != nullptr) {
        words->title = spec.get_string_attribute("DocumentName");
        words->description = spec.get_string_attribute("ImageDescription");
    }
    return image;
}

Result<Image> resized(const Image& image, int width, int height) {
    Image smaller(width, height);
    OIIO::ImageBuf target = wrap(smaller);
    if (!OIIO::ImageBufAlgo::resize(target, wrap(image), "lanczos3", 0.0f, OIIO::ROI(0, width, 0, height, 0, 1, 0, 3)))
        return Error{
            message("a picture cannot be resized to ", width, " x ", height, " px (", target.geterror(), "); draw it smaller")};
    return smaller;
}

} // namespace windrow::cli
