// The bytes of the files that a mesh's file names, none of them outside of its folder.
#pragma once

#include "fluid/files/input_budget.h"
#include "vegetation/fur/mesh.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace windrow::vegetation::fur {

/// The file that `name` in the file `path` means. Rejects what detail::read_input rejects, names that lead out of the folder, and
/// backslashes and colons, which lead out on other systems.
[[nodiscard]] Result<std::string> read_beside(const std::filesystem::path& path, std::string_view name,
                                              windrow::detail::InputBudget& budget);

} // namespace windrow::vegetation::fur
