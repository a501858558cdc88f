// A file that appears under its name only when it is whole.
//
// Everything goes to `<name>.tmp` in the same folder; publish() flushes, has the disk confirm it, closes and renames. Until then,
// and for good if anything failed, whatever had the name keeps it, and the temporary is removed.
#pragma once

#include <cstddef>
#include <filesystem>
#include <streambuf>
#include <vector>

namespace windrow::vdb {

/// A stream buffer for a std::ostream, with the reason kept: std::filebuf may lose errno and never asks the disk.
class NewFile : public std::streambuf {
  public:
    /// Opens the temporary; error() tells whether that worked. A temporary that a crash left there is overwritten.
    explicit NewFile(const std::filesystem::path& name);
    ~NewFile() override;
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;

    /// Gives the file its name; false if this or anything before it failed.
    [[nodiscard]] bool publish();
    /// errno of the first failure, 0 without one. Nothing is written after a failure.
    [[nodiscard]] int error() const { return error_; }

  protected:
    int_type overflow(int_type character) override;
    int sync() override;
    pos_type seekoff(off_type offset, std::ios_base::seekdir from, std::ios_base::openmode which) override;
    pos_type seekpos(pos_type position, std::ios_base::openmode which) override;

  private:
    [[nodiscard]] bool flush();
    [[nodiscard]] bool check(bool succeeded); ///< Keeps errno of the first failure.

    std::filesystem::path name_;
    std::filesystem::path temporary_;
    std::vector<char> buffer_;
    int descriptor_ = -1;
    bool temporary_exists_ = false;
    int error_ = 0;
};

} // namespace windrow::vdb
