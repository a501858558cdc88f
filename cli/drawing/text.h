// Words and figures as they stand on a picture.
#pragma once

#include <string>
#include <string_view>

namespace windrow::cli {

/// A figure with a fixed number of decimals, a real minus sign and no minus before zero, whatever the locale.
[[nodiscard]] std::string fixed(double value, int decimals);

/// A figure with at most `digits` significant digits and no trailing zeros.
[[nodiscard]] std::string brief(double value, int digits = 3);

/// The text with bytes that are no UTF-8 replaced by U+FFFD and control characters by spaces: names come from users' files, and
/// Cairo stops drawing for good at the first byte that it cannot read.
[[nodiscard]] std::string printable(std::string_view text);

/// The text without its last character (not byte); the text must be valid UTF-8.
[[nodiscard]] std::string_view without_last(std::string_view text);

} // namespace windrow::cli
