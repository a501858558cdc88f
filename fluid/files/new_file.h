// A file that appears under its name only when it is complete.
//
//     detail::NewFile file("wind.vdb");
//     if (!file.write(bytes) || !file.publish())
//         return reason(file.error());
//
// The bytes go to a part file beside the name, which no other writer shares: `<name>.<process>.<count>.windrow-part`, made
// exclusively and locked while it is written. publish() has the disk confirm, closes and renames. Until then, and for
// good if anything failed, whatever had the name keeps it, and the part is removed. The part of a killed process has no lock:
// clear_dead_parts() removes it.
//
// On Windows the part is locked until it is closed, a moment before it is renamed, and a name that another process has open keeps
// its old file.
//
// It is no stream, since one brings the locales of the standard library, a quarter of a library that holds that:
// streamed_file.h is one.
#pragma once

#include "fluid/api.h"
#include "fluid/files/part_file.h"
#include "fluid/result.h"

#include <cstddef>
#include <filesystem>
#include <string_view>

namespace windrow::detail {

/// Keeps the reason of what fails: std::filebuf may lose errno and never asks the disk.
class WINDROW_INTERNAL NewFile {
  public:
    /// Opens the part; error() is 0 if that worked. A symbolic link stays, and its target is written.
    explicit NewFile(const std::filesystem::path& name);
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;

    /// Appends, without a buffer; false if this or anything before it failed.
    [[nodiscard]] bool write(std::string_view bytes);
    /// Moves to a place, which is returned; -1 after a failure.
    [[nodiscard]] std::streamoff seek(std::streamoff offset, std::ios_base::seekdir from);
    /// Gives the file its name; false if this or anything before it failed.
    [[nodiscard]] bool publish();
    /// errno of the first failure, 0 without one. EISDIR, ENXIO: the name is that of a folder, of no regular file. Nothing is
    /// written after a failure.
    [[nodiscard]] int error() const { return error_; }

  private:
    void open_part();
    [[nodiscard]] bool check(int error); ///< Keeps the first failure; true without one.

    std::filesystem::path name_;
    PartFile part_;
    int error_ = 0;
};

/// The whole file at once. The error names `what` ("picture", "table"), the file and the reason.
[[nodiscard]] WINDROW_INTERNAL Result<void> write_file(std::string_view what, const std::filesystem::path& file,
                                                       std::string_view bytes);

/// "no space left on device", or what else an errno means.
[[nodiscard]] WINDROW_INTERNAL std::string reason_of(int error);

/// Whether an errno is the machine's fault (disk full or broken, no memory), not the name's.
[[nodiscard]] WINDROW_INTERNAL bool machine_lacks(int error);

/// Removes the parts in a folder whose writers ended without removing them.
WINDROW_INTERNAL void clear_dead_parts(const std::filesystem::path& folder);

} // namespace windrow::detail
