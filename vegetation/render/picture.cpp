#include "vegetation/render/picture.h"

#include <cerrno>
#include <fstream>
#include <string>
#include <system_error>

namespace windrow::vegetation::render {

windrow::Result<void> write_ppm(const Picture8& picture, const std::filesystem::path& file) {
    const std::string size = std::to_string(picture.width) + " " + std::to_string(picture.height);
    if (picture.width < 1 || picture.height < 1 || picture.values.size() != Picture8(picture.width, picture.height).values.size())
        return windrow::Error{"picture " + file.string() + " of " + size + " px has " + std::to_string(picture.values.size()) +
                              " values; give it 3 * width * height of them."};
    std::filesystem::path part = file;
    part += ".part";
    std::error_code fault;
    {
        std::ofstream stream(part, std::ios::binary);
        stream << "P6\n" << size << "\n255\n";
        stream.write(reinterpret_cast<const char*>(picture.values.data()), static_cast<std::streamsize>(picture.values.size()));
        if (!stream.flush())
            fault.assign(errno, std::generic_category());
    }
    if (!fault)
        std::filesystem::rename(part, file, fault);
    if (!fault)
        return {};
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    return windrow::Error{"picture " + file.string() + " cannot be written (" + fault.message() +
                          "); name a file in a folder that you may write to, on a disk with room."};
}

} // namespace windrow::vegetation::render
