#include "fluid/files/new_file.h"

#include "fluid/core/message.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

namespace windrow::detail {
namespace {

constexpr std::string_view k_part_suffix = ".windrow-part";
constexpr std::size_t k_max_name_bytes = 200; // a part's name has at most 255

// The first bytes of a name in UTF-8, no letter cut.
std::string shortened(std::string name) {
    std::size_t length = std::min(name.size(), k_max_name_bytes);
    while (length > 0 && length < name.size() && (static_cast<unsigned char>(name[length]) & 0xc0) == 0x80)
        --length;
    name.resize(length);
    return name;
}

std::filesystem::path next_part(const std::filesystem::path& name) {
    static std::atomic<unsigned> count{0};
    const std::string part =
        message(shortened(name.filename().string()), ".", PartFile::process(), ".", count.fetch_add(1), k_part_suffix);
    return name.parent_path() /
           std::u8string(part.begin(), part.end()); // a path of bytes would take each for a letter on Windows
}

} // namespace

NewFile::NewFile(const std::filesystem::path& name) : name_(name) {
    std::error_code fault;
    if (std::filesystem::is_symlink(name_, fault))
        if (auto target = std::filesystem::weakly_canonical(name_, fault); !fault)
            name_ = std::move(target);
    // A rename would replace a device or pipe, and would report a folder or a long name too late.
    if (check(PartFile::check_name(name_)))
        open_part();
}

// Takes the next name where a part exists: from another process, an ended process, or another machine on a shared disk.
void NewFile::open_part() {
    constexpr int k_max_attempts = 1000;
    for (int attempt = 0; attempt < k_max_attempts; ++attempt)
        if (const int error = part_.open(next_part(name_)); error != EEXIST) {
            (void)check(error);
            return;
        }
    error_ = EEXIST;
}

bool NewFile::write(std::string_view bytes) {
    return error_ == 0 && check(part_.write(bytes.data(), bytes.size()));
}

std::streamoff NewFile::seek(std::streamoff offset, std::ios_base::seekdir from) {
    std::streamoff position = -1;
    return error_ == 0 && check(part_.seek(offset, from, position)) ? position : -1;
}

bool NewFile::publish() {
    return error_ == 0 && check(part_.publish(name_));
}

bool NewFile::check(int error) {
    if (error_ == 0)
        error_ = error;
    return error == 0;
}

Result<void> write_file(std::string_view what, const std::filesystem::path& file, std::string_view bytes) {
    NewFile out(file);
    if (out.write(bytes) && out.publish())
        return {};
    return Error{message(what, " ", file.string(), " cannot be written (", reason_of(out.error()),
                         "); name a file in a folder that you may write to, on a disk with room."),
                 machine_lacks(out.error()) ? Fault::system_lacks : Fault::rejected};
}

std::string reason_of(int error) {
    if (error == ENXIO)
        return "not a regular file";
    return std::generic_category().message(error);
}

bool machine_lacks(int error) {
    switch (error) {
#if defined(EDQUOT) // Windows has none
    case EDQUOT:
#endif
    case ENOSPC:
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
         !fault && entry != std::filesystem::directory_iterator(); entry.increment(fault))
        if (entry->path().extension() == k_part_suffix)
            PartFile::remove_dead(entry->path());
}

} // namespace windrow::detail
