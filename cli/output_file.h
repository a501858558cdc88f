// Files that appear under their name only when they are whole, and the folder that they lie in.
#pragma once

#include "cli/fault.h"

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

namespace windrow::cli {

/// The fault behind an errno. `flag` names the place: a folder with --out, a file with any other.
[[nodiscard]] Fault write_fault(const std::filesystem::path& file, int reason, std::string_view flag = "--out");

/// Makes the folder where it is missing and tries it with a small file, before a long run ends in a folder that takes nothing.
[[nodiscard]] Fault prepare_folder(const std::filesystem::path& folder);

/// A text file that is written to `<name>.<process>.tmp` beside its name and renamed when it is whole. Dropped, it leaves
/// nothing.
class OutputFile {
  public:
    explicit OutputFile(std::filesystem::path file, const char* flag = "--out");
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// The first fault so far, before long work ends in a file that takes nothing.
    [[nodiscard]] Fault fault() const;
    /// Appends; after a failure it does nothing more.
    void write(std::string_view text);
    /// Flushes, has the disk confirm, closes and renames; tells the first fault of all that was written.
    [[nodiscard]] Fault publish();

  private:
    std::filesystem::path file_;
    std::filesystem::path part_;
    const char* flag_;
    std::FILE* stream_ = nullptr;
    int reason_ = 0;
};

} // namespace windrow::cli
