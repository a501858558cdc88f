#include "fluid/files/part_file.h"

#if !defined(_WIN32)

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace windrow::detail {
namespace {

int descriptor(std::intptr_t file) {
    return static_cast<int>(file);
}
int reason(bool succeeded) {
    return succeeded ? 0 : errno;
}

} // namespace

PartFile::~PartFile() {
    if (!part_.empty())
        ::unlink(part_.c_str());
    if (file_ >= 0)
        ::close(descriptor(file_));
}

int PartFile::open(std::filesystem::path part) {
    file_ = ::open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (file_ < 0)
        return errno;
    // Until the part is locked, remove_dead() of another process may treat it as dead.
    struct stat own {};
    const bool locked = ::flock(descriptor(file_), LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
    if (locked && ::fstat(descriptor(file_), &own) == 0 && own.st_nlink > 0) {
        part_ = std::move(part); // a copy could fail, and leave the file
        return 0;
    }
    ::close(descriptor(std::exchange(file_, -1)));
    return EEXIST;
}

int PartFile::write(const char* bytes, std::size_t count) {
    while (count > 0) {
        const ssize_t written = ::write(descriptor(file_), bytes, count);
        if (written > 0) {
            bytes += written;
            count -= static_cast<std::size_t>(written);
        } else if (written == 0 || errno != EINTR) {
            return written == 0 ? ENOSPC : errno;
        }
    }
    return 0;
}

int PartFile::seek(std::streamoff offset, std::ios_base::seekdir from, std::streamoff& position) {
    const int whence = from == std::ios_base::beg ? SEEK_SET : from == std::ios_base::cur ? SEEK_CUR : SEEK_END;
    position = ::lseek(descriptor(file_), offset, whence);
    return reason(position >= 0);
}

int PartFile::publish(const std::filesystem::path& name) {
    // Some file systems cannot confirm; the file is still valid.
    if (::fsync(descriptor(file_)) != 0 && errno != EINVAL && errno != ENOTSUP)
        return errno;
    // A file system may report only at the end that it is full. The lock is kept until the part has its name: an
    // unlocked part could be removed.
    const int lock = ::dup(descriptor(file_));
    int error = reason(::close(descriptor(std::exchange(file_, -1))) == 0);
    if (error == 0)
        error = reason(::rename(part_.c_str(), name.c_str()) == 0);
    if (error == 0)
        part_.clear();
    if (lock >= 0)
        ::close(lock);
    return error;
}

int PartFile::check_name(const std::filesystem::path& name) {
    struct stat existing {};
    if (::stat(name.c_str(), &existing) != 0)
        return errno == ENAMETOOLONG ? errno : 0;
    return S_ISREG(existing.st_mode) ? 0 : S_ISDIR(existing.st_mode) ? EISDIR : ENXIO;
}

unsigned long PartFile::process() {
    return static_cast<unsigned long>(::getpid());
}

void PartFile::remove_dead(const std::filesystem::path& part) {
    const int file = ::open(part.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (file < 0)
        return;
    if (::flock(file, LOCK_EX | LOCK_NB) == 0)
        ::unlink(part.c_str());
    ::close(file);
}

} // namespace windrow::detail

#endif
