// The files of a command and the folder that holds them.
#pragma once

#include "cli/console.h"
#include "fluid/files/streamed_file.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace windrow::cli {

/// The fault behind an errno. `flag` names the place: a folder with --out, a file with any other.
[[nodiscard]] Fault write_fault(const std::filesystem::path& file, int reason, std::string_view flag = "--out");

/// A folder that one command writes into, until this object ends.
class OutputFolder {
  public:
    OutputFolder() = default;
    ~OutputFolder();
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

    /// Makes the folder where it is missing, removes parts that killed runs left in it, and tries it with a small file, before a
    /// long run ends in a folder that cannot be written. Rejects a folder that another command has open.
    [[nodiscard]] Fault open(const std::filesystem::path& folder);

  private:
    int lock_ = -1;
};

/// Whether a file's text stays in memory too, for the snapshot of a run.
enum class KeepText : std::uint8_t { no, yes };

/// A text file that appears under its name when it is whole (fluid/files/new_file.h). Dropped, it leaves nothing.
class OutputFile {
  public:
    explicit OutputFile(std::filesystem::path file, const char* flag = "--out");
    /// The same with `begun` in it. A text that is kept costs its size in memory.
    OutputFile(std::filesystem::path file, KeepText keep, std::string_view begun);

    /// The first fault so far, before long work ends in a file that takes nothing.
    [[nodiscard]] Fault fault() const;
    /// Appends; after a failure it does nothing more.
    void write(std::string_view text);
    /// Has the disk confirm and gives the file its name; the first fault of all that was written.
    [[nodiscard]] Fault publish();
    /// All that was written, of a file that keeps its text.
    [[nodiscard]] const std::string& text() const { return *text_; }

  private:
    std::filesystem::path file_;
    const char* flag_;
    detail::StreamedFile out_;
    std::optional<std::string> text_{}; ///< set: it is kept
};

} // namespace windrow::cli
