#include "fluid/files/input_file.h"

#include "fluid/core/message.h"
#include "fluid/files/new_file.h"
#include "fluid/files/opened_file.h"

#include <cerrno>
#include <cstdint>

namespace windrow::detail {
namespace {

Error unreadable(const std::string& name, int reason, const InputRule& rule) {
    if (reason == ENOENT || reason == ENOTDIR)
        return Error{message(name, rule.folder ? ": no such file: check the name, which is sought beside the file that gives it."
                                               : ": no such file: check the name and the current folder.")};
    if (reason == EACCES)
        return Error{message(name, ": permission denied: allow reading with chmod +r, or name another file.")};
    return Error{message(name, ": cannot be read (", reason_of(reason), "): name another file.")};
}

Error too_long(const std::string& name, std::size_t most) {
    return Error{message(name, ": is larger than ", most >> 20, " MiB, the most that is read: give a smaller file.")};
}

/// `budget` may be null.
Result<std::string> read_whole(const std::filesystem::path& file, const InputRule& rule, InputBudget* budget) {
    const std::string name = file.string();
    if (budget != nullptr)
        if (auto taken = budget->take_file(name); !taken)
            return taken.failure();
    OpenedFile opened(file);
    if (opened.error() != 0)
        return unreadable(name, opened.error(), rule);
    if (rule.folder && !opened.is_inside(*rule.folder))
        return Error{message(name, ": is a link out of its folder: put the file itself there.")};
    if (opened.kind() == OpenedFile::Kind::folder)
        return Error{message(name, ": is a folder: name a file in it.")};
    if (opened.kind() != OpenedFile::Kind::regular)
        return Error{message(name, ": is a pipe or a device: name a regular file.")};
    const std::uintmax_t size = opened.size();
    if (size > rule.max_bytes)
        return too_long(name, rule.max_bytes);
    if (budget != nullptr)
        if (auto taken = budget->take_bytes(name, static_cast<std::size_t>(size)); !taken)
            return taken.failure();
    // Files of /proc have the size 0, and any file may grow: the end is where a read returns 0 bytes.
    std::string bytes;
    bytes.reserve(static_cast<std::size_t>(size));
    char block[65536];
    while (bytes.size() <= rule.max_bytes) {
        const std::ptrdiff_t got = opened.read(block, sizeof block);
        if (got < 0)
            return unreadable(name, opened.error(), rule);
        if (got == 0)
            return bytes;
        bytes.append(block, static_cast<std::size_t>(got));
    }
    return too_long(name, rule.max_bytes);
}

} // namespace

Result<std::string> read_input(const std::filesystem::path& file, const InputRule& rule, InputBudget& budget) {
    return read_whole(file, rule, &budget);
}

Result<std::string> read_input(const std::filesystem::path& file, const InputRule& rule) {
    return read_whole(file, rule, nullptr);
}

bool is_name_inside(const std::filesystem::path& name) {
    const std::filesystem::path plain = name.lexically_normal();
    return !plain.empty() && plain.is_relative() && *plain.begin() != ".." && plain != ".";
}

} // namespace windrow::detail
