#include "fluid/new_file.h"

#include "fluid/message.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <fcntl.h>
#include <string>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace windrow::detail {
namespace {

constexpr std::size_t k_buffer_bytes = std::size_t{1} << 16;
constexpr std::string_view k_part_suffix = ".windrow-part";
constexpr std::size_t k_max_name_bytes = 200; // a part's name has at most 255

std::filesystem::path next_part(const std::filesystem::path& name) {
    static std::atomic<unsigned> count{0};
    std::string own = name.filename().string();
    own.resize(std::min(own.size(), k_max_name_bytes));
    return name.parent_path() / message(own, ".", ::getpid(), ".", count.fetch_add(1), k_part_suffix);
}

} // namespace

NewFile::NewFile(const std::filesystem::path& name) : name_(name), buffer_(k_buffer_bytes) {
    setp(buffer_.data(), buffer_.data() + buffer_.size());
    std::error_code fault;
    if (std::filesystem::is_symlink(name_, fault))
        if (auto target = std::filesystem::weakly_canonical(name_, fault); !fault)
            name_ = std::move(target);
    // A rename would replace a device or pipe, and would report a folder or a long name too late.
    struct stat existing {};
    if (::stat(name_.c_str(), &existing) == 0) {
        if (!S_ISREG(existing.st_mode))
            error_ = S_ISDIR(existing.st_mode) ? EISDIR : ENXIO;
    } else if (errno == ENAMETOOLONG) {
        error_ = errno;
    }
    if (error_ == 0)
        open_part();
}

// Takes the next name where a part exists: from another process, an ended process, or another machine on a shared disk.
void NewFile::open_part() {
    constexpr int k_max_attempts = 1000;
    for (int attempt = 0; attempt < k_max_attempts; ++attempt) {
        part_ = next_part(name_);
        descriptor_ = ::open(part_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0666);
        if (descriptor_ < 0 && errno == EEXIST)
            continue;
        if (!check(descriptor_ >= 0))
            return;
        // Until the part is locked, clear_dead_parts() of another process may treat it as dead.
        struct stat own {};
        const bool locked = ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
        if (locked && ::fstat(descriptor_, &own) == 0 && own.st_nlink > 0) {
            part_exists_ = true;
            return;
        }
        ::close(std::exchange(descriptor_, -1));
    }
    error_ = EEXIST;
}

NewFile::~NewFile() {
    if (part_exists_)
        ::unlink(part_.c_str());
    if (descriptor_ >= 0)
        ::close(descriptor_);
}

bool NewFile::publish() {
    if (!flush())
        return false;
    // Some file systems cannot confirm; the file is still valid.
    if (!check(::fsync(descriptor_) == 0 || errno == EINVAL || errno == ENOTSUP))
        return false;
    // A file system may report only at the end that it is full. The lock is kept until the part has its name: an
    // unlocked part could be removed.
    const int lock = ::dup(descriptor_);
    part_exists_ = !(check(::close(std::exchange(descriptor_, -1)) == 0) && check(::rename(part_.c_str(), name_.c_str()) == 0));
    if (lock >= 0)
        ::close(lock);
    return !part_exists_;
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

Result<void> write_file(std::string_view what, const std::filesystem::path& file, std::string_view bytes) {
    NewFile out(file);
    const auto count = static_cast<std::streamsize>(bytes.size());
    if (out.error() == 0 && out.sputn(bytes.data(), count) == count && out.publish())
        return {};
    return Error{message(what, " ", file.string(), " cannot be written (", reason_of(out.error()),
                         "); name a file in a folder that you may write to, on a disk with room.")};
}

std::string reason_of(int error) {
    if (error == ENXIO)
        return "not a regular file";
    return std::generic_category().message(error);
}

bool machine_lacks(int error) {
    switch (error) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
    case EIO:
    case ENOMEM:
    case EMFILE:
    case ENFILE:
        return true;
    default:
        return false;
    }
}

void clear_dead_parts(const std::filesystem::path& folder) {
    std::error_code fault;
    for (auto entry = std::filesystem::directory_iterator(folder, fault);
         !fault && entry != std::filesystem::directory_iterator(); entry.increment(fault)) {
        if (!entry->path().filename().string().ends_with(k_part_suffix))
            continue;
        const int part = ::open(entry->path().c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
        if (part < 0)
            continue;
        if (::flock(part, LOCK_EX | LOCK_NB) == 0)
            ::unlink(entry->path().c_str());
        ::close(part);
    }
}

} // namespace windrow::detail
