// The lines of a text file, their words, and the numbers that these spell, for all readers of text. A line ends with \n or \r\n; a byte
// order mark before the first is no part of it.
#pragma once

#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace windrow::detail {

/// Of UTF-8 text.
[[nodiscard]] inline std::string_view without_mark(std::string_view text) {
    constexpr std::string_view k_mark = "\xef\xbb\xbf";
    return text.substr(text.starts_with(k_mark) ? k_mark.size() : 0);
}

class TextLines {
  public:
    explicit TextLines(std::string_view text) : rest_(without_mark(text)) {}

    /// Takes the next line; false at the end.
    bool next(std::string_view& line) {
        if (rest_.empty())
            return false;
        const std::size_t end = rest_.find('\n');
        line = rest_.substr(0, end);
        rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
        if (!line.empty() && line.back() == '\r')
            line.remove_suffix(1);
        ++number_;
        return true;
    }
    /// Of the line last taken, from 1.
    [[nodiscard]] std::size_t number() const { return number_; }

  private:
    std::string_view rest_;
    std::size_t number_ = 0;
};

/// Without blanks at both ends.
[[nodiscard]] inline std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// Takes the first word off `line`; empty at its end.
[[nodiscard]] inline std::string_view take_word(std::string_view& line) {
    line = trimmed(line);
    const std::string_view word = line.substr(0, line.find_first_of(" \t"));
    line.remove_prefix(word.size());
    return word;
}

/// The finite number that the whole of `word` spells, in every locale; nothing for anything else. It may begin with +. What is too
/// small for a number of the kind is 0.
template <class Number>
[[nodiscard]] std::optional<Number> number_of(std::string_view word) {
    if (word.starts_with('+') && !word.starts_with("+-"))
        word.remove_prefix(1);
    Number value{};
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (word.empty() || end != word.data() + word.size() || fault == std::errc::invalid_argument)
        return std::nullopt;
    if constexpr (std::is_floating_point_v<Number>) {
        // from_chars reports both ends of the range alike; of a number this short only a negative exponent makes it too small.
        if (fault == std::errc::result_out_of_range && word.size() <= 64 && word.find_first_of("eE") != word.npos &&
            word[word.find_first_of("eE") + 1] == '-')
            return Number{};
        if (!std::isfinite(value))
            return std::nullopt;
    }
    return fault == std::errc{} ? std::optional(value) : std::nullopt;
}

} // namespace windrow::detail
