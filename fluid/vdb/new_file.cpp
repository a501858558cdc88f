#include "fluid/vdb/new_file.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace windrow::vdb {

namespace {

constexpr std::size_t k_buffer_bytes = std::size_t{1} << 16;

} // namespace

NewFile::NewFile(const std::filesystem::path& name) : name_(name), temporary_(name), buffer_(k_buffer_bytes) {
    temporary_ += ".tmp";
    setp(buffer_.data(), buffer_.data() + buffer_.size());

    // A rename would put the file in the place of a device or pipe.
    struct stat existing {};
    if (::stat(name_.c_str(), &existing) == 0 && !S_ISREG(existing.st_mode)) {
        error_ = S_ISDIR(existing.st_mode) ? EISDIR : EEXIST;
        return;
    }
    descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0666);
    temporary_exists_ = check(descriptor_ >= 0);
}

NewFile::~NewFile() {
    if (descriptor_ >= 0)
        ::close(descriptor_);
    if (temporary_exists_)
        ::unlink(temporary_.c_str());
}

bool NewFile::publish() {
    if (!flush())
        return false;
    // Some file systems cannot confirm; that is no failure of the file.
    if (!check(::fsync(descriptor_) == 0 || errno == EINVAL || errno == ENOTSUP))
        return false;
    const int descriptor = std::exchange(descriptor_, -1);
    if (!check(::close(descriptor) == 0) || !check(::rename(temporary_.c_str(), name_.c_str()) == 0))
        return false;
    temporary_exists_ = false;
    return true;
}

NewFile::int_type NewFile::overflow(int_type character) {
    if (!flush())
        return traits_type::eof();
    if (!traits_type::eq_int_type(character, traits_type::eof()))
        sputc(traits_type::to_char_type(character));
    return traits_type::not_eof(character);
}

int NewFile::sync() {
    return flush() ? 0 : -1;
}

NewFile::pos_type NewFile::seekoff(off_type offset, std::ios_base::seekdir from, std::ios_base::openmode) {
    if (!flush())
        return pos_type(off_type(-1));
    const int whence = from == std::ios_base::beg ? SEEK_SET : from == std::ios_base::cur ? SEEK_CUR : SEEK_END;
    const off_t position = ::lseek(descriptor_, offset, whence);
    return check(position >= 0) ? pos_type(position) : pos_type(off_type(-1));
}

NewFile::pos_type NewFile::seekpos(pos_type position, std::ios_base::openmode which) {
    return seekoff(off_type(position), std::ios_base::beg, which);
}

bool NewFile::flush() {
    const char* next = pbase();
    while (error_ == 0 && next < pptr()) {
        const ssize_t written = ::write(descriptor_, next, static_cast<std::size_t>(pptr() - next));
        if (written > 0)
            next += written;
        else if (written == 0 || errno != EINTR)
            error_ = written == 0 ? ENOSPC : errno;
    }
    setp(buffer_.data(), buffer_.data() + buffer_.size());
    return error_ == 0;
}

bool NewFile::check(bool succeeded) {
    if (!succeeded && error_ == 0)
        error_ = errno;
    return succeeded;
}

} // namespace windrow::vdb
