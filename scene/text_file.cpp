#include "scene/text_file.h"

#include "fluid/core/message.h"
#include "fluid/files/text_lines.h"

#include <algorithm>

namespace windrow::scene {
namespace {

using detail::message;

bool is_continuation(char byte) {
    return (static_cast<unsigned char>(byte) & 0xc0u) == 0x80u;
}

/// Offset of the first byte that is invalid in UTF-8, or npos. Overlong forms, surrogates and points beyond U+10FFFF are invalid.
std::size_t first_bad_byte(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        const auto lead = static_cast<unsigned char>(text[i]);
        const int length = lead < 0x80 ? 1 : lead < 0xc2 ? 0 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : lead < 0xf5 ? 4 : 0;
        if (length == 0 || lead == 0 || i + static_cast<std::size_t>(length) > text.size())
            return i;
        for (int k = 1; k < length; ++k)
            if (!is_continuation(text[i + static_cast<std::size_t>(k)]))
                return i;
        if (length > 2) {
            const auto second = static_cast<unsigned char>(text[i + 1]);
            if ((lead == 0xe0 && second < 0xa0) || (lead == 0xed && second >= 0xa0) || (lead == 0xf0 && second < 0x90) ||
                (lead == 0xf4 && second >= 0x90))
                return i;
        }
        i += static_cast<std::size_t>(length);
    }
    return std::string_view::npos;
}

} // namespace

Result<std::string> read_text_file(const std::filesystem::path& file, const detail::InputRule& rule,
                                   detail::InputBudget& budget) {
    auto read = detail::read_input(file, rule, budget);
    if (!read)
        return read;
    const std::string name = file.string();
    std::string text(detail::without_mark(*read));
    if (text.find_first_not_of(" \t\r\n") == std::string::npos)
        return Error{message(name, ": is empty: name the right file, or write something in it.")};
    if (const std::size_t bad = first_bad_byte(text); bad != std::string_view::npos)
        return Error{message(name, ":", place_in_text(text, bad).line, ": byte ", bad + 1, " (value ",
                             static_cast<int>(static_cast<unsigned char>(text[bad])),
                             ") is not UTF-8 text: save the file as UTF-8, or name the right file.")};
    return text;
}

TextPlace place_in_text(std::string_view text, std::size_t offset) {
    const std::string_view before = text.substr(0, std::min(offset, text.size()));
    TextPlace place;
    place.line += static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
    const std::size_t line_break = before.rfind('\n');
    const std::string_view line = line_break == before.npos ? before : before.substr(line_break + 1);
    place.column +=
        static_cast<std::size_t>(std::count_if(line.begin(), line.end(), [](char byte) { return !is_continuation(byte); }));
    return place;
}

} // namespace windrow::scene
