#include "fluid/files/opened_file.h"

#if defined(_WIN32)

#include "fluid/files/windows_error.h"

#include <algorithm>
#include <string>

namespace windrow::detail {
namespace {

// Folders too. A writer may replace the file meanwhile: what was opened is read.
HANDLE opened(const std::filesystem::path& file, DWORD access) {
    return CreateFileW(file.c_str(), access, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, nullptr, OPEN_EXISTING,
                       FILE_FLAG_BACKUP_SEMANTICS, nullptr);
}

// Its only absolute name, links followed, which begins with \\?\; empty where Windows does not name it. Not a path: a name on a
// drive within a path has no relative path in the standard library.
std::wstring real_name(HANDLE file) {
    std::wstring name(32768, L'\0');
    const DWORD length = GetFinalPathNameByHandleW(file, name.data(), static_cast<DWORD>(name.size()), FILE_NAME_NORMALIZED);
    name.resize(length < name.size() ? length : 0);
    return name;
}

} // namespace

OpenedFile::OpenedFile(const std::filesystem::path& file) : name_(file) {
    const HANDLE handle = opened(file, GENERIC_READ);
    BY_HANDLE_FILE_INFORMATION facts{};
    if (handle == INVALID_HANDLE_VALUE) {
        error_ = last_reason();
        return;
    }
    file_ = reinterpret_cast<std::intptr_t>(handle);
    if (GetFileType(handle) != FILE_TYPE_DISK || GetFileInformationByHandle(handle, &facts) == 0)
        return;
    kind_ = (facts.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0 ? Kind::folder : Kind::regular;
    size_ = (std::uintmax_t{facts.nFileSizeHigh} << 32) | facts.nFileSizeLow;
}

OpenedFile::~OpenedFile() {
    if (file_ != -1)
        CloseHandle(reinterpret_cast<HANDLE>(file_));
}

bool OpenedFile::is_inside(const std::filesystem::path& folder) const {
    const HANDLE handle = opened(folder.empty() ? L"." : folder, 0);
    if (handle == INVALID_HANDLE_VALUE)
        return false;
    std::wstring home = real_name(handle);
    const std::wstring real = real_name(reinterpret_cast<HANDLE>(file_));
    CloseHandle(handle);
    if (home.empty() || real == home)
        return !home.empty();
    if (!home.ends_with(L'\\'))
        home += L'\\'; // the root of a drive has one
    return real.starts_with(home);
}

std::ptrdiff_t OpenedFile::read(char* bytes, std::size_t most) {
    DWORD got = 0;
    if (ReadFile(reinterpret_cast<HANDLE>(file_), bytes, static_cast<DWORD>(std::min(most, std::size_t{1} << 30)), &got,
                 nullptr) == 0) {
        error_ = last_reason();
        return -1;
    }
    return static_cast<std::ptrdiff_t>(got);
}

} // namespace windrow::detail

#endif
