// Input file: opened without blocking, checked to be a regular file, and read up to a limit.
//
//     const auto bytes = detail::read_input("walk.csv", {.folder = scene_folder, .max_bytes = 64 << 20}, budget);
//     if (!bytes)
//         return bytes.failure();
//
// A scene may come from somebody else. It must not hang on a pipe, read a device without an end, or read outside of its folder.
#pragma once

#include "fluid/api.h"
#include "fluid/files/input_budget.h"
#include "fluid/result.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace windrow::detail {

struct InputRule {
    /// The file must be in this folder when all links are followed. Default: anywhere, for a file that the user named.
    std::optional<std::filesystem::path> folder{};
    std::size_t max_bytes = 0;
};

/// The whole file. The checks and the reading use one descriptor, so that nobody can exchange the file in between. Errors begin
/// with the file's name: missing, unreadable, no regular file, a link out of the folder, longer than `max_bytes` or than what
/// `budget` has left. No memory is taken for a file that is too long.
[[nodiscard]] WINDROW_INTERNAL Result<std::string> read_input(const std::filesystem::path& file, const InputRule& rule,
                                                              InputBudget& budget);
/// The same of a file that the program itself wrote, at the cost of no scene.
[[nodiscard]] WINDROW_INTERNAL Result<std::string> read_input(const std::filesystem::path& file, const InputRule& rule);

/// Whether a name that a file gives stays in that file's folder as it is written: relative, and without `..` that leads out.
[[nodiscard]] WINDROW_INTERNAL bool is_name_inside(const std::filesystem::path& name);

} // namespace windrow::detail
