#include "vegetation/render/picture.h"

#include <OpenImageIO/imageio.h>
#include <memory>
#include <system_error>

namespace windrow::vegetation::render {
namespace {

// Writes beside the name and renames: a full disk loses nothing.
windrow::Result<void> publish(const std::filesystem::path& file, const OIIO::ImageSpec& spec, OIIO::TypeDesc type,
                              const void* values) {
    std::filesystem::path part = file;
    part.replace_extension(".part" + file.extension().string()); // the library tells the format by its ending
    const auto refused = [&](const std::string& why) {
        std::error_code ignored;
        std::filesystem::remove(part, ignored);
        return windrow::Error{"picture " + file.string() + " cannot be written (" + why +
                              "); name a file in a folder that you may write to, on a disk with room."};
    };
    const auto output = OIIO::ImageOutput::create(part.string());
    if (!output)
        return refused(OIIO::geterror());
    if (!output->open(part.string(), spec) || !output->write_image(type, values) || !output->close())
        return refused(output->geterror());
    std::error_code error;
    std::filesystem::rename(part, file, error);
    if (error)
        return refused(error.message());
    return {};
}

windrow::Result<void> check_size(const std::filesystem::path& file, std::size_t has, int width, int height, int channels) {
    if (width > 0 && height > 0 &&
        has == static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * static_cast<std::size_t>(channels))
        return {};
    return windrow::Error{"picture " + file.string() + " of " + std::to_string(width) + " x " + std::to_string(height) +
                          " px with " + std::to_string(has) + " values cannot be written; give it width * height * " +
                          std::to_string(channels) + " values."};
}

} // namespace

windrow::Result<void> write_png(const Picture8& picture, const std::filesystem::path& file) {
    if (auto fits = check_size(file, picture.values.size(), picture.width, picture.height, 3); !fits)
        return fits;
    OIIO::ImageSpec spec(picture.width, picture.height, 3, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    return publish(file, spec, OIIO::TypeDesc::UINT8, picture.values.data());
}

windrow::Result<void> write_jpeg(const Picture8& picture, int quality, const std::filesystem::path& file) {
    if (auto fits = check_size(file, picture.values.size(), picture.width, picture.height, 3); !fits)
        return fits;
    OIIO::ImageSpec spec(picture.width, picture.height, 3, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("Compression", "jpeg:" + std::to_string(quality));
    return publish(file, spec, OIIO::TypeDesc::UINT8, picture.values.data());
}

windrow::Result<void> write_exr(const PictureF& light, const PictureF& motion, const std::filesystem::path& file) {
    if (auto fits = check_size(file, light.values.size(), light.width, light.height, 3); !fits)
        return fits;
    const bool moves = !motion.values.empty();
    if (moves && (motion.width != light.width || motion.height != light.height || motion.channels != 2))
        return windrow::Error{"picture " + file.string() + ": motion is " + std::to_string(motion.width) + " x " +
                              std::to_string(motion.height) + " px of " + std::to_string(motion.channels) +
                              " channels; give it light's size and two."};
    OIIO::ImageSpec spec(light.width, light.height, moves ? 5 : 3, OIIO::TypeDesc::HALF);
    spec.channelnames = {"R", "G", "B"};
    if (moves)
        spec.channelnames.insert(spec.channelnames.end(), {"motion.x", "motion.y"});
    spec.attribute("compression", "zip");
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
    return publish(file, spec, OIIO::TypeDesc::FLOAT, values.data());
}

} // namespace windrow::vegetation::render
