#include "vegetation/render/picture.h"

#include "fluid/core/message.h"
#include "fluid/files/new_file.h"

#include <string>

namespace windrow::vegetation::render {

windrow::Result<void> write_ppm(const Picture8& picture, const std::filesystem::path& file) {
    const std::string size = std::to_string(picture.width) + " " + std::to_string(picture.height);
    if (picture.width < 1 || picture.height < 1 || picture.values.size() != Picture8(picture.width, picture.height).values.size())
        return windrow::Error{detail::message("picture ", file.string(), " of ", size, " px has ", picture.values.size(),
                                              " values; give it 3 * width * height of them.")};
    std::string bytes = "P6\n" + size + "\n255\n";
    bytes.append(reinterpret_cast<const char*>(picture.values.data()), picture.values.size());
    return windrow::detail::write_file("picture", file, bytes);
}

} // namespace windrow::vegetation::render
