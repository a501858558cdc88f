// The part file of a NewFile, by the calls of the system: part_file_posix.cpp, part_file_windows.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <ios>

namespace windrow::detail {

/// A file that its process alone writes, under a name of its own until it is published. Calls return errno, 0 if they worked.
class PartFile {
  public:
    PartFile() = default;
    ~PartFile(); ///< Removes it, unless it was published.
    PartFile(const PartFile&) = delete;
    PartFile& operator=(const PartFile&) = delete;

    /// Makes the file, exclusively, and locks it. EEXIST: another part has the name, or its folder was cleared just now.
    [[nodiscard]] int open(std::filesystem::path part);
    [[nodiscard]] int write(const char* bytes, std::size_t count);
    [[nodiscard]] int seek(std::streamoff offset, std::ios_base::seekdir from, std::streamoff& position);
    /// The disk confirms all bytes, and the file gets its name; a file that has it is replaced. On Windows another process must not
    /// have that file open: this waits for half a second, then fails.
    [[nodiscard]] int publish(const std::filesystem::path& name);

    /// Why a name cannot be that of a new file: EISDIR a folder, ENXIO no regular file, ENAMETOOLONG. 0: it can.
    [[nodiscard]] static int check_name(const std::filesystem::path& name);
    /// A number of this process, for names.
    [[nodiscard]] static unsigned long process();
    /// Removes a part whose writer has ended.
    static void remove_dead(const std::filesystem::path& part);

  private:
    std::filesystem::path part_; ///< empty: there is none
    std::intptr_t file_ = -1;    ///< a descriptor, or a HANDLE
};

} // namespace windrow::detail
