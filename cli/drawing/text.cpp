#include "cli/drawing/text.h"

#include <charconv>
#include <cmath>
#include <cstddef>

namespace windrow::cli {
namespace {

constexpr std::string_view k_minus = "\xe2\x88\x92";       // U+2212
constexpr std::string_view k_replacement = "\xef\xbf\xbd"; // U+FFFD

std::string with_real_minus(std::string_view digits) {
    const bool negative = digits.starts_with('-');
    if (negative)
        digits.remove_prefix(1);
    const bool zero = digits.find_first_not_of("0.") == std::string_view::npos;
    return (negative && !zero ? std::string(k_minus) : std::string()) + std::string(digits);
}

/// Bytes of the character that begins `text`, or 0 where it is no valid UTF-8 (overlong forms and surrogates included).
std::size_t character_length(std::string_view text) {
    const auto byte = [&](std::size_t index) { return static_cast<unsigned char>(text[index]); };
    const unsigned char lead = byte(0);
    if (lead < 0x80)
        return 1;
    const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || text.size() < length)
        return 0;
    for (std::size_t index = 1; index < length; ++index)
        if ((byte(index) & 0xC0) != 0x80)
            return 0;
    const unsigned char second = byte(1);
    const bool overlong = (lead == 0xE0 && second < 0xA0) || (lead == 0xF0 && second < 0x90);
    const bool beyond = (lead == 0xED && second >= 0xA0) || (lead == 0xF4 && second >= 0x90);
    return overlong || beyond ? 0 : length;
}

} // namespace

std::string fixed(double value, int decimals) {
    if (!std::isfinite(value))
        return "?";
    char digits[400]; // the largest double has 309 digits before the point
    const auto end = std::to_chars(digits, digits + sizeof digits, value, std::chars_format::fixed, decimals).ptr;
    return with_real_minus({digits, static_cast<std::size_t>(end - digits)});
}

std::string brief(double value, int digits) {
    if (!std::isfinite(value))
        return "?";
    char text[64];
    const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits).ptr;
    return with_real_minus({text, static_cast<std::size_t>(end - text)});
}

std::string printable(std::string_view text) {
    std::string clean;
    clean.reserve(text.size());
    while (!text.empty()) {
        const std::size_t length = character_length(text);
        const auto lead = static_cast<unsigned char>(text.front());
        if (length == 0)
            clean += k_replacement;
        else if (lead < 0x20 || lead == 0x7F)
            clean += ' ';
        else
            clean += text.substr(0, length);
        text.remove_prefix(length == 0 ? 1 : length);
    }
    return clean;
}

std::string_view without_last(std::string_view text) {
    while (!text.empty()) {
        const bool continues = (static_cast<unsigned char>(text.back()) & 0xC0) == 0x80;
        text.remove_suffix(1);
        if (!continues)
            break;
    }
    return text;
}

} // namespace windrow::cli
