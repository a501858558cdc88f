// Names are wide: any letters, whatever the system's code page. The lock is that nobody else may open the part.
#include "fluid/files/part_file.h"

#if defined(_WIN32)

#include "fluid/files/windows_error.h"

#include <algorithm>
#include <utility>

namespace windrow::detail {
namespace {

HANDLE handle(std::intptr_t file) {
    return reinterpret_cast<HANDLE>(file);
}
int reason(BOOL succeeded) {
    return succeeded != 0 ? 0 : last_reason();
}

} // namespace

PartFile::~PartFile() {
    if (file_ != -1)
        CloseHandle(handle(file_));
    if (!part_.empty())
        DeleteFileW(part_.c_str());
}

int PartFile::open(std::filesystem::path part) {
    const HANDLE file = CreateFileW(part.c_str(), GENERIC_WRITE, 0, nullptr, CREATE_NEW, FILE_ATTRIBUTE_NORMAL, nullptr);
    if (file == INVALID_HANDLE_VALUE)
        return last_reason();
    file_ = reinterpret_cast<std::intptr_t>(file);
    part_ = std::move(part);
    return 0;
}

int PartFile::write(const char* bytes, std::size_t count) {
    while (count > 0) {
        DWORD written = 0;
        if (WriteFile(handle(file_), bytes, static_cast<DWORD>(std::min(count, std::size_t{1} << 30)), &written, nullptr) == 0)
            return last_reason();
        if (written == 0)
            return ENOSPC;
        bytes += written;
        count -= written;
    }
    return 0;
}

int PartFile::seek(std::streamoff offset, std::ios_base::seekdir from, std::streamoff& position) {
    LARGE_INTEGER to{}, at{};
    to.QuadPart = offset;
    const DWORD whence = from == std::ios_base::beg ? FILE_BEGIN : from == std::ios_base::cur ? FILE_CURRENT : FILE_END;
    const int error = reason(SetFilePointerEx(handle(file_), to, &at, whence));
    position = at.QuadPart;
    return error;
}

int PartFile::publish(const std::filesystem::path& name) {
    if (const int error = reason(FlushFileBuffers(handle(file_))); error != 0)
        return error;
    if (const int error = reason(CloseHandle(handle(std::exchange(file_, -1)))); error != 0)
        return error;
    // What looks at each new file, or reads the old one, has it open for some milliseconds.
    constexpr int k_attempts = 50;
    constexpr DWORD k_wait = 10; // ms
    for (int attempt = 1;; ++attempt) {
        const int error = reason(MoveFileExW(part_.c_str(), name.c_str(), MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH));
        if (error == 0)
            part_.clear();
        if ((error != EACCES && error != EBUSY) || attempt == k_attempts)
            return error;
        Sleep(k_wait);
    }
}

int PartFile::check_name(const std::filesystem::path& name) {
    // NUL, CON and their like are devices in every folder.
    wchar_t full[MAX_PATH] = {};
    if (GetFullPathNameW(name.c_str(), MAX_PATH, full, nullptr) != 0 && std::wstring_view(full).starts_with(L"\\\\.\\"))
        return ENXIO;
    const DWORD attributes = GetFileAttributesW(name.c_str());
    if (attributes == INVALID_FILE_ATTRIBUTES) {
        const int error = last_reason();
        return error == ENAMETOOLONG || error == EINVAL ? error : 0;
    }
    return (attributes & FILE_ATTRIBUTE_DIRECTORY) != 0 ? EISDIR : 0;
}

unsigned long PartFile::process() {
    return GetCurrentProcessId();
}

// Windows deletes no file that is open without its leave.
void PartFile::remove_dead(const std::filesystem::path& part) {
    DeleteFileW(part.c_str());
}

} // namespace windrow::detail

#endif
