// A file that appears under its name only when it is complete.
//
//     detail::NewFile file("wind.vdb");
//     std::ostream(&file) << bytes;
//     if (!file.publish())
//         return reason(file.error());
//
// The bytes go to a part file beside the name, which no other writer shares: `<name>.<process>.<count>.windrow-part`, made
// exclusively and locked while it is written. publish() flushes, has the disk confirm, closes and renames. Until then, and for
// good if anything failed, whatever had the name keeps it, and the part is removed. The part of a killed process has no lock:
// clear_dead_parts() removes it.
//
// On Windows the part is locked until it is closed, a moment before it is renamed, and a name that another process has open keeps
// its old file.
#pragma once

#include "fluid/api.h"
#include "fluid/files/part_file.h"
#include "fluid/result.h"

#include <cstddef>
#include <filesystem>
#include <streambuf>
#include <string_view>
#include <vector>

namespace windrow::detail {

/// A stream buffer for a std::ostream, with the reason kept: std::filebuf may lose errno and never asks the disk.
class WINDROW_INTERNAL NewFile : public std::streambuf {
  public:
    /// Opens the part; error() is 0 if that worked. A symbolic link stays, and its target is written.
    explicit NewFile(const std::filesystem::path& name);
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;

    /// Gives the file its name; false if this or anything before it failed.
    [[nodiscard]] bool publish();
    /// errno of the first failure, 0 without one. EISDIR, ENXIO: the name is that of a folder, of no regular file. Nothing is
    /// written after a failure.
    [[nodiscard]] int error() const { return error_; }

  protected:
    int_type overflow(int_type character) override;
    int sync() override;
    pos_type seekoff(off_type offset, std::ios_base::seekdir from, std::ios_base::openmode which) override;
    pos_type seekpos(pos_type position, std::ios_base::openmode which) override;

  private:
    void open_part();
    [[nodiscard]] bool flush();
    [[nodiscard]] bool check(int error); ///< Keeps the first failure; true without one.

    std::filesystem::path name_;
    PartFile part_;
    std::vector<char> buffer_;
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
