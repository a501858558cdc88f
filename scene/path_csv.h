// A path as a table: one line a point, `t,x,y,z` in seconds and metres.
//
//     # the player's walk, recorded in the editor
//     t,x,y,z
//     0.0,-30.0,0.0,0.0
//     0.5,-28.5,0.0,0.1
//
// The line of names is optional. Lines that begin with # and empty lines are skipped; spaces around a number do not matter; the
// decimal sign is the point, whatever the locale.
#pragma once

#include "fluid/input_budget.h"
#include "fluid/result.h"
#include "scene/motion_path.h"

#include <filesystem>
#include <string_view>

namespace windrow::scene {

/// Parses a table; `name` is the file's, for the sentence, which carries the line: "player.csv:17: ...". Refuses at the first
/// fault.
[[nodiscard]] Result<MotionPath> parse_path_csv(std::string_view text, const std::string& name);

/// Reads a file of at most 64 MiB in `folder`.
[[nodiscard]] Result<MotionPath> read_path_csv(const std::filesystem::path& file, const std::filesystem::path& folder,
                                               detail::InputBudget& budget);

} // namespace windrow::scene
