// A file that is open for reading, by the calls of the system: opened_file_posix.cpp, opened_file_windows.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace windrow::detail {

class OpenedFile {
  public:
    enum class Kind : std::uint8_t { regular, folder, other };

    /// Does not wait for the other end of a pipe. error() is errno, 0 if it is open.
    explicit OpenedFile(const std::filesystem::path& file);
    ~OpenedFile();
    OpenedFile(const OpenedFile&) = delete;
    OpenedFile& operator=(const OpenedFile&) = delete;

    [[nodiscard]] int error() const { return error_; }
    [[nodiscard]] Kind kind() const { return kind_; }
    [[nodiscard]] std::uintmax_t size() const { return size_; }
    /// Whether it, links followed, is in the folder.
    [[nodiscard]] bool is_inside(const std::filesystem::path& folder) const;
    /// Number of bytes, 0 at the end, -1 if it failed: error() is why.
    [[nodiscard]] std::ptrdiff_t read(char* bytes, std::size_t most);

  private:
    std::filesystem::path name_;
    std::intptr_t file_ = -1;               ///< a descriptor, or a HANDLE
    std::uint64_t volume_ = 0, number_ = 0; ///< of the file, however it is named
    std::uintmax_t size_ = 0;
    Kind kind_ = Kind::other;
    int error_ = 0;
};

} // namespace windrow::detail
