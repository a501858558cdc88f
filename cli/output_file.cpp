#include "cli/output_file.h"

#include "fluid/core/message.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace windrow::cli {

using detail::message;

Fault write_fault(const std::filesystem::path& file, int reason, std::string_view flag) {
    const std::string name = file.string();
    const char* const place = flag == "--out" ? "folder" : "file";
    switch (reason) {
    case 0:
        return {};
    case ENOSPC:
    case EDQUOT:
        return {
            message(name, ": does not fit on the disk: free some space, or give a ", place, " on another disk with ", flag, "."),
            true};
    case EFBIG:
        return {message(name, ": is larger than the system allows a file to be: raise the limit (ulimit -f)."), true};
    case EACCES:
    case EPERM:
        return {message(name, ": permission denied: allow writing, or give another ", place, " with ", flag, ".")};
    case EROFS:
        return {message(name, ": is on a read-only file system: give another ", place, " with ", flag, ".")};
    case EISDIR:
        return {message(name, ": is a folder where a file is needed: remove it, or give another ", place, " with ", flag, ".")};
    case ENOTDIR:
    case EEXIST:
        return {message(name, ": is a file where a folder is needed: remove it, or give another ", place, " with ", flag, ".")};
    case ENXIO:
        return {message(name, ": is not a regular file: give another ", place, " with ", flag, ".")};
    case ENAMETOOLONG:
        return {message(name, ": the name is too long for the system: give a shorter one with ", flag, ".")};
    default:
        return {message(name, ": cannot be written (", detail::reason_of(reason), "): give another ", place, " with ", flag, "."),
                detail::machine_lacks(reason)};
    }
}

OutputFolder::~OutputFolder() {
    if (lock_ >= 0)
        ::close(lock_);
}

Fault OutputFolder::open(const std::filesystem::path& folder) {
    std::error_code fault;
    std::filesystem::create_directories(folder, fault);
    if (fault)
        return write_fault(folder, fault.value());
    if (!std::filesystem::is_directory(folder, fault))
        return write_fault(folder, ENOTDIR);
    lock_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    // A file system without locks takes any number of runs, as before there were any.
    if (lock_ >= 0 && ::flock(lock_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
        return {message(folder.string(),
                        ": another windrow writes into this folder: wait for it, or give another folder with --out.")};
    detail::clear_dead_parts(folder);
    // Rights alone do not tell: a full disk lets a file be made and rejects its first byte.
    detail::NewFile trial(folder / ".windrow-trial");
    const char block[4096] = {};
    (void)trial.write({block, sizeof block});
    return write_fault(folder, trial.error());
}

OutputFile::OutputFile(std::filesystem::path file, const char* flag) : file_(std::move(file)), flag_(flag), out_(file_) {}

OutputFile::OutputFile(std::filesystem::path file, KeepText keep, std::string_view begun) : OutputFile(std::move(file)) {
    if (keep == KeepText::yes)
        text_.emplace();
    write(begun);
}

Fault OutputFile::fault() const {
    return write_fault(file_, out_.error(), flag_);
}

void OutputFile::write(std::string_view text) {
    if (text_)
        *text_ += text;
    if (out_.error() == 0)
        out_.sputn(text.data(), static_cast<std::streamsize>(text.size()));
}

Fault OutputFile::publish() {
    if (out_.error() == 0 && out_.publish())
        return {};
    return fault();
}

} // namespace windrow::cli
