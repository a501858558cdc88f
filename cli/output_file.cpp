#include "cli/output_file.h"

#include "fluid/message.h"

#include <cerrno>
#include <system_error>
#include <unistd.h>

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
        return {message(name, ": may not be written: give yourself the right, or another ", place, " with ", flag, ".")};
    case EROFS:
        return {message(name, ": lies on a file system that is read-only: give another ", place, " with ", flag, ".")};
    case EISDIR:
        return {
            message(name, ": a folder stands where the file should go: remove it, or give another ", place, " with ", flag, ".")};
    case ENOTDIR:
    case EEXIST:
        return {
            message(name, ": a file stands where a folder is needed: remove it, or give another ", place, " with ", flag, ".")};
    case ENXIO:
        return {message(name, ": is no ordinary file: give another ", place, " with ", flag, ".")};
    case ENAMETOOLONG:
        return {message(name, ": the name is too long for the system: give a shorter one with ", flag, ".")};
    default:
        return {message(name, ": cannot be written (", std::generic_category().message(reason), "): give another ", place,
                        " with ", flag, "."),
                reason == EIO || reason == ENOMEM || reason == EMFILE || reason == ENFILE};
    }
}

Fault prepare_folder(const std::filesystem::path& folder) {
    std::error_code fault;
    std::filesystem::create_directories(folder, fault);
    if (fault)
        return write_fault(folder, fault.value());
    if (!std::filesystem::is_directory(folder, fault))
        return write_fault(folder, ENOTDIR);
    // Rights alone do not tell: a full disk lets a file be made and refuses its first byte.
    const std::filesystem::path trial = folder / message(".windrow-", ::getpid(), ".tmp");
    std::FILE* const stream = std::fopen(trial.c_str(), "wb");
    int reason = stream == nullptr ? errno : 0;
    if (stream != nullptr) {
        const char block[4096] = {};
        if (std::fwrite(block, 1, sizeof block, stream) != sizeof block || std::fflush(stream) != 0)
            reason = errno;
        if (std::fclose(stream) != 0 && reason == 0)
            reason = errno;
        std::filesystem::remove(trial, fault);
    }
    return write_fault(folder, reason);
}

OutputFile::OutputFile(std::filesystem::path file, const char* flag) : file_(std::move(file)), flag_(flag) {
    std::error_code fault;
    // A link stays one, and what it leads to is written.
    if (std::filesystem::is_symlink(file_, fault))
        if (const auto target = std::filesystem::weakly_canonical(file_, fault); !fault)
            file_ = target;
    // The rename at the end would tell of a folder too late, and put a file in the place of a pipe or a device.
    if (std::filesystem::is_directory(file_, fault))
        reason_ = EISDIR;
    else if (std::filesystem::exists(file_, fault) && !std::filesystem::is_regular_file(file_, fault))
        reason_ = ENXIO;
    if (reason_ != 0)
        return;
    part_ = file_;
    part_ += message(".", ::getpid(), ".tmp"); // nobody else's
    stream_ = std::fopen(part_.c_str(), "wbx");
    if (stream_ == nullptr)
        reason_ = errno;
}

OutputFile::~OutputFile() {
    if (stream_ == nullptr)
        return;
    std::fclose(stream_);
    std::error_code ignored;
    std::filesystem::remove(part_, ignored);
}

Fault OutputFile::fault() const {
    return write_fault(file_, reason_, flag_);
}

void OutputFile::write(std::string_view text) {
    if (stream_ != nullptr && reason_ == 0 && std::fwrite(text.data(), 1, text.size(), stream_) != text.size())
        reason_ = errno;
}

Fault OutputFile::publish() {
    if (stream_ == nullptr)
        return write_fault(file_, reason_, flag_);
    if (reason_ == 0 && std::fflush(stream_) != 0)
        reason_ = errno;
    // Some file systems cannot confirm; that is no failure of the file.
    if (reason_ == 0 && ::fsync(::fileno(stream_)) != 0 && errno != EINVAL && errno != ENOTSUP)
        reason_ = errno;
    if (reason_ != 0)
        return write_fault(file_, reason_, flag_);
    std::FILE* const stream = stream_;
    stream_ = nullptr;
    std::error_code fault;
    if (std::fclose(stream) != 0)
        reason_ = errno;
    else {
        std::filesystem::rename(part_, file_, fault);
        reason_ = fault.value();
    }
    if (reason_ != 0)
        std::filesystem::remove(part_, fault);
    return write_fault(file_, reason_, flag_);
}

} // namespace windrow::cli
