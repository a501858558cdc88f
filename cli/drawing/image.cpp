#include "cli/drawing/image.h"

#include "cli/output_file.h"
#include "cli/pictures.h"

namespace windrow::cli {

Result<void> write_png(const Image& image, const PngWords& words, const std::filesystem::path& file) {
    // Plain rows: a frame is mostly even paper and few colours; the filters that libpng would try take twice the time and make
    // the file no smaller.
    const auto bytes = pictures::encode_png(image, words, pictures::PngRows::plain, file);
    if (!bytes)
        return Error{bytes.error()};
    OutputFile output(file);
    output.write({reinterpret_cast<const char*>(bytes->data()), bytes->size()});
    if (const Fault fault = output.publish())
        return Error{(fault.machine ? std::string(k_disk_fault) : std::string()) + fault.sentence};
    return {};
}

} // namespace windrow::cli
