// Files that appear under their name only when they are whole, and the folder that they lie in.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

namespace windrow::cli {

/// Why a file or folder cannot be written, and whose fault it is: the shell is told by the exit code.
struct WriteFault {
    std::string sentence; ///< empty: no fault
    bool machine = false; ///< the disk is full, a quota or a size limit is reached; else the name or the rights are wrong

    [[nodiscard]] explicit operator bool() const { return !sentence.empty(); }
};

/// The fault behind an errno. `flag` names the place: a folder with --out, a file with any other.
[[nodiscard]] WriteFault write_fault(const std::filesystem::path& file, int reason, std::string_view flag = "--out");

/// Makes the folder where it is missing and tries it with a small file, before a long run ends in a folder that takes nothing.
[[nodiscard]] WriteFault prepare_folder(const std::filesystem::path& folder);

/// A text file that is written to `<name>.<process>.tmp` beside its name and renamed when it is whole. Dropped, it leaves
/// nothing.
class OutputFile {
  public:
    explicit OutputFile(std::filesystem::path file, const char* flag = "--out");
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// The first fault so far, before long work ends in a file that takes nothing.
    [[nodiscard]] WriteFault fault() const;
    /// Appends; after a failure it does nothing more.
    void write(std::string_view text);
    /// Flushes, has the disk confirm, closes and renames; tells the first fault of all that was written.
    [[nodiscard]] WriteFault publish();

  private:
    std::filesystem::path file_;
    std::filesystem::path part_;
    const char* flag_;
    std::FILE* stream_ = nullptr;
    int reason_ = 0;
};

} // namespace windrow::cli
