#include "fluid/input_file.h"

#include "fluid/message.h"
#include "fluid/new_file.h"

#include <cerrno>
#include <cstdint>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace windrow::detail {
namespace {

class Descriptor {
  public:
    // No wait for the other end of a pipe, and no controlling terminal.
    explicit Descriptor(const std::filesystem::path& file)
        : number_(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)) {}
    ~Descriptor() {
        if (number_ >= 0)
            ::close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    [[nodiscard]] int number() const { return number_; }

  private:
    int number_;
};

Error unreadable(const std::string& name, int reason) {
    if (reason == ENOENT || reason == ENOTDIR)
        return Error{message(name, ": no such file: check the name and the current folder.")};
    if (reason == EACCES)
        return Error{message(name, ": permission denied: allow reading with chmod +r, or name another file.")};
    return Error{message(name, ": cannot be read (", reason_of(reason), "): name another file.")};
}

/// Whether the opened file is the one in the folder, links followed.
bool is_inside(const std::filesystem::path& file, const std::filesystem::path& folder, const struct stat& opened) {
    std::error_code fault, none;
    const std::filesystem::path real = std::filesystem::canonical(file, fault);
    const std::filesystem::path home = std::filesystem::canonical(folder.empty() ? "." : folder, none);
    struct stat found {};
    return !fault && !none && *real.lexically_relative(home).begin() != ".." && ::stat(real.c_str(), &found) == 0 &&
           found.st_dev == opened.st_dev && found.st_ino == opened.st_ino;
}

Error too_long(const std::string& name, std::size_t most) {
    return Error{message(name, ": is larger than ", most >> 20, " MiB, the most that is read: give a smaller file.")};
}

} // namespace

Result<std::string> read_input(const std::filesystem::path& file, const InputRule& rule, InputBudget& budget) {
    const std::string name = file.string();
    if (auto taken = budget.take_file(name); !taken)
        return Error{taken.error()};
    const Descriptor descriptor(file);
    struct stat opened {};
    if (descriptor.number() < 0 || ::fstat(descriptor.number(), &opened) != 0)
        return unreadable(name, errno);
    if (rule.folder && !is_inside(file, *rule.folder, opened))
        return Error{message(name, ": is a link out of its folder: put the file itself there.")};
    if (S_ISDIR(opened.st_mode))
        return Error{message(name, ": is a folder: name a file in it.")};
    if (!S_ISREG(opened.st_mode))
        return Error{message(name, ": is a pipe or a device: name a regular file.")};
    const auto size = static_cast<std::uintmax_t>(opened.st_size);
    if (size > rule.max_bytes)
        return too_long(name, rule.max_bytes);
    if (auto taken = budget.take_bytes(name, static_cast<std::size_t>(size)); !taken)
        return Error{taken.error()};
    // Files of /proc have the size 0, and any file may grow: the end is where a read returns 0 bytes.
    std::string bytes;
    bytes.reserve(static_cast<std::size_t>(size));
    char block[65536];
    while (bytes.size() <= rule.max_bytes) {
        const ssize_t got = ::read(descriptor.number(), block, sizeof block);
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0)
            return unreadable(name, errno);
        if (got == 0)
            return bytes;
        bytes.append(block, static_cast<std::size_t>(got));
    }
    return too_long(name, rule.max_bytes);
}

bool is_name_inside(const std::filesystem::path& name) {
    const std::filesystem::path plain = name.lexically_normal();
    return !plain.empty() && plain.is_relative() && *plain.begin() != ".." && plain != ".";
}

} // namespace windrow::detail
