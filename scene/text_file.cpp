#include "scene/text_file.h"

#include "fluid/message.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

namespace windrow::scene {
namespace {

using detail::message;

bool is_continuation(char byte) {
    return (static_cast<unsigned char>(byte) & 0xc0u) == 0x80u;
}

/// Offset of the first byte that no UTF-8 text holds, or npos. Overlong forms, surrogates and points beyond U+10FFFF count.
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

Error unreadable(const std::string& name, int reason) {
    if (reason == ENOENT || reason == ENOTDIR)
        return Error{message(name, ": there is no such file: check the name and the folder that you run from.")};
    if (reason == EISDIR)
        return Error{message(name, ": is a folder: name a file in it.")};
    if (reason == EACCES)
        return Error{message(name, ": may not be read: give yourself the right with chmod +r, or name another file.")};
    return Error{message(name, ": cannot be read (", std::generic_category().message(reason), ").")};
}

} // namespace

Result<std::string> read_text_file(const std::filesystem::path& file, std::size_t most_bytes) {
    const std::string name = file.string();
    errno = 0;
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(file.c_str(), "rb"), &std::fclose);
    if (!stream)
        return unreadable(name, errno);
    std::string text;
    char block[65536];
    // Read by blocks and not by the size that the system tells: a pipe has none, and a device may have no end.
    while (text.size() <= most_bytes) {
        errno = 0;
        const std::size_t got = std::fread(block, 1, sizeof block, stream.get());
        text.append(block, got);
        if (got < sizeof block) {
            if (std::ferror(stream.get()) != 0)
                return unreadable(name, errno);
            break;
        }
    }
    if (text.size() > most_bytes)
        return Error{
            message(name, ": is larger than ", most_bytes / (1024 * 1024), " MiB, the most that is read: give a smaller file.")};
    if (text.starts_with("\xef\xbb\xbf"))
        text.erase(0, 3);
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
