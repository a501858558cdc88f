#include "fluid/files/streamed_file.h"

namespace windrow::detail {
namespace {

constexpr std::size_t k_buffer_bytes = std::size_t{1} << 16;

} // namespace

StreamedFile::StreamedFile(const std::filesystem::path& name) : file_(name), buffer_(k_buffer_bytes) {
    setp(buffer_.data(), buffer_.data() + buffer_.size());
}

bool StreamedFile::publish() {
    return flush() && file_.publish();
}

StreamedFile::int_type StreamedFile::overflow(int_type character) {
    if (!flush())
        return traits_type::eof();
    if (!traits_type::eq_int_type(character, traits_type::eof()))
        sputc(traits_type::to_char_type(character));
    return traits_type::not_eof(character);
}

int StreamedFile::sync() {
    return flush() ? 0 : -1;
}

StreamedFile::pos_type StreamedFile::seekoff(off_type offset, std::ios_base::seekdir from, std::ios_base::openmode) {
    return pos_type(flush() ? file_.seek(offset, from) : off_type(-1));
}

StreamedFile::pos_type StreamedFile::seekpos(pos_type position, std::ios_base::openmode which) {
    return seekoff(off_type(position), std::ios_base::beg, which);
}

bool StreamedFile::flush() {
    const bool written = file_.write({pbase(), static_cast<std::size_t>(pptr() - pbase())});
    setp(buffer_.data(), buffer_.data() + buffer_.size());
    return written;
}

} // namespace windrow::detail
