#include "fluid/files/opened_file.h"

#if !defined(_WIN32)

#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace windrow::detail {

// No controlling terminal either.
OpenedFile::OpenedFile(const std::filesystem::path& file)
    : name_(file), file_(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)) {
    struct stat opened {};
    if (file_ < 0 || ::fstat(static_cast<int>(file_), &opened) != 0) {
        error_ = errno;
        return;
    }
    kind_ = S_ISREG(opened.st_mode) ? Kind::regular : S_ISDIR(opened.st_mode) ? Kind::folder : Kind::other;
    size_ = static_cast<std::uintmax_t>(opened.st_size);
    volume_ = opened.st_dev;
    number_ = opened.st_ino;
}

OpenedFile::~OpenedFile() {
    if (file_ >= 0)
        ::close(static_cast<int>(file_));
}

bool OpenedFile::is_inside(const std::filesystem::path& folder) const {
    std::error_code fault, none;
    const std::filesystem::path real = std::filesystem::canonical(name_, fault);
    const std::filesystem::path home = std::filesystem::canonical(folder.empty() ? "." : folder, none);
    struct stat found {};
    return !fault && !none && *real.lexically_relative(home).begin() != ".." && ::stat(real.c_str(), &found) == 0 &&
           found.st_dev == volume_ && found.st_ino == number_;
}

std::ptrdiff_t OpenedFile::read(char* bytes, std::size_t most) {
    for (;;) {
        const ssize_t got = ::read(static_cast<int>(file_), bytes, most);
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0)
            error_ = errno;
        return got;
    }
}

} // namespace windrow::detail

#endif
