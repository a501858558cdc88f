// The bytes of a mesh's file and of the files that it names, none of them outside of its folder.
#pragma once

#include "vegetation/fur/mesh.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace windrow::vegetation::fur {

/// The whole file. Refuses what does not exist, is no plain file, or is longer than k_most_bytes; its length is asked before any
/// memory is taken.
[[nodiscard]] Result<std::string> read_bytes(const std::filesystem::path& path);

/// Where the file lies that `name` in the file `path` means. Refuses absolute names, `..`, backslashes and colons (which lead out
/// on other systems), what does not exist, and links that lead out of the folder.
[[nodiscard]] Result<std::filesystem::path> beside(const std::filesystem::path& path, std::string_view name);

} // namespace windrow::vegetation::fur
