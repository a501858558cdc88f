// A text file as a whole, or one sentence why not.
#pragma once

#include "fluid/files/input_file.h"
#include "fluid/result.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace windrow::scene {

/// Reads a file of UTF-8 text; a byte-order mark is dropped. Rejects what detail::read_input rejects, an empty file, and bytes that
/// are not UTF-8. Every sentence begins with the file's name.
[[nodiscard]] Result<std::string> read_text_file(const std::filesystem::path& file, const detail::InputRule& rule,
                                                 detail::InputBudget& budget);

/// Where a byte stands, as an editor counts: lines and columns from 1, columns in characters.
struct TextPlace {
    std::size_t line = 1;
    std::size_t column = 1;
};
[[nodiscard]] TextPlace place_in_text(std::string_view text, std::size_t offset);

} // namespace windrow::scene
