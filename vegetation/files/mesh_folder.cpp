#include "vegetation/files/mesh_folder.h"

#include "vegetation/files/mesh_file.h"
#include "vegetation/fur/refusal.h"

#include <fstream>
#include <system_error>

namespace windrow::vegetation::fur {

namespace fs = std::filesystem;

Result<std::string> read_bytes(const fs::path& path) {
    std::error_code fault;
    const fs::file_status status = fs::status(path, fault);
    if (!fs::exists(status))
        return refusal(path.string(), " does not exist: give a mesh's file.");
    if (!fs::is_regular_file(status))
        return refusal(path.string(), " is not a file: give a mesh's file.");
    const std::uintmax_t size = fs::file_size(path, fault);
    if (fault)
        return refusal(path.string(), " cannot be read: ", fault.message(), "; give a file that can.");
    if (size > k_most_bytes)
        return refusal(path.string(), " has ", size, " bytes: give at most ", k_most_bytes, ".");
    std::string bytes(static_cast<std::size_t>(size), '\0');
    std::ifstream file(path, std::ios::binary);
    if (!file.read(bytes.data(), static_cast<std::streamsize>(size)))
        return refusal(path.string(), " cannot be read to its end: give a file that can.");
    return bytes;
}

Result<fs::path> beside(const fs::path& path, std::string_view name) {
    const fs::path relative = fs::path(name).lexically_normal();
    const bool leaves = name.empty() || relative.is_absolute() || relative.begin()->string() == ".." || relative == "." ||
                        name.find_first_of(std::string_view("\\:\0", 3)) != std::string_view::npos;
    if (leaves)
        return refusal(path.string(), " names the file '", name, "': name one in its own folder, relative to it.");
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    std::error_code fault;
    const fs::path real = fs::canonical(folder / relative, fault);
    if (fault)
        return refusal(path.string(), " names the file '", name, "', which does not exist in its folder: put it there.");
    const fs::path home = fs::canonical(folder, fault);
    if (fault || *real.lexically_relative(home).begin() == "..")
        return refusal(path.string(), " names the file '", name, "', a link out of its folder: put the file itself there.");
    return real;
}

} // namespace windrow::vegetation::fur
