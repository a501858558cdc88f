// A new file as a stream: for what is written in small parts, or by a library that takes a std::ostream.
//
//     detail::StreamedFile file("wind.vdb");
//     std::ostream(&file) << bytes;
//     if (!file.publish())
//         return reason(file.error());
#pragma once

#include "fluid/files/new_file.h"

#include <streambuf>
#include <vector>

namespace windrow::detail {

/// A stream buffer for a std::ostream; publish() and error() are those of NewFile.
class WINDROW_INTERNAL StreamedFile : public std::streambuf {
  public:
    explicit StreamedFile(const std::filesystem::path& name);
    StreamedFile(const StreamedFile&) = delete;
    StreamedFile& operator=(const StreamedFile&) = delete;

    [[nodiscard]] bool publish();
    [[nodiscard]] int error() const { return file_.error(); }

  protected:
    int_type overflow(int_type character) override;
    int sync() override;
    pos_type seekoff(off_type offset, std::ios_base::seekdir from, std::ios_base::openmode which) override;
    pos_type seekpos(pos_type position, std::ios_base::openmode which) override;

  private:
    [[nodiscard]] bool flush();

    NewFile file_;
    std::vector<char> buffer_;
};

} // namespace windrow::detail
