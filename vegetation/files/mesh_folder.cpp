#include "vegetation/files/mesh_folder.h"

#include "fluid/core/message.h"
#include "fluid/files/input_file.h"
#include "vegetation/files/mesh_file.h"

namespace windrow::vegetation::fur {

using windrow::detail::message;

Result<std::string> read_beside(const std::filesystem::path& path, std::string_view name, windrow::detail::InputBudget& budget) {
    if (!windrow::detail::is_name_inside(name) || name.find_first_of(std::string_view("\\:\0", 3)) != std::string_view::npos)
        return windrow::Error{
            message(path.string(), " names the file '", name, "': name one in its own folder, relative to it.")};
    const std::filesystem::path folder = path.parent_path();
    auto bytes = windrow::detail::read_input(folder / name, {.folder = folder, .max_bytes = k_max_bytes}, budget);
    if (!bytes)
        return bytes.failure().after(message(path.string(), " names the file '", name, "': "));
    return bytes;
}

} // namespace windrow::vegetation::fur
