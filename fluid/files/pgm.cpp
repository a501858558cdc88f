#include "fluid/files/pgm.h"

#include "fluid/core/message.h"
#include "fluid/files/text_lines.h"

#include <algorithm>
#include <vector>

namespace windrow::detail {

namespace {

/// Words between blanks. No stream: those of the standard library bring all locales into a page's module.
class Words {
  public:
    explicit Words(std::string_view text) : text_(text) {}

    /// Empty at the end.
    std::string_view next() {
        const std::size_t begin = std::min(text_.find_first_not_of(k_blanks, place_), text_.size());
        place_ = std::min(text_.find_first_of(k_blanks, begin), text_.size());
        return text_.substr(begin, place_ - begin);
    }
    void skip_line() { place_ = std::min(text_.find('\n', place_), text_.size()); }
    /// Behind the last word.
    [[nodiscard]] std::size_t place() const { return place_; }

  private:
    static constexpr std::string_view k_blanks = " \t\n\v\f\r";
    std::string_view text_;
    std::size_t place_ = 0;
};

template <class Number>
bool read_whole(std::string_view word, Number& number) {
    const auto read = detail::number_of<Number>(word);
    number = read.value_or(number);
    return read.has_value();
}

} // namespace

float Pgm::value(std::size_t pixel) const {
    const auto byte = [&](std::size_t at) { return static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at])); };
    const std::uint32_t level = !levels.empty() ? levels[pixel]
                                : white > 255   ? byte(2 * pixel) << 8 | byte(2 * pixel + 1)
                                                : byte(pixel); // the high byte is first
    return std::min(static_cast<float>(level) / static_cast<float>(white), 1.0f);
}

Result<Pgm> read_pgm(std::string_view bytes, const std::string& name, std::size_t max_pixels) {
    const Error no_picture{name + " is not a PGM of up to 65535 levels: save the image as PGM (P5)."};
    const std::string_view head = bytes.substr(0, 256);
    Words header(head);
    const std::string_view kind = header.next();
    std::vector<int> numbers;
    while ((kind == "P5" || kind == "P2") && numbers.size() < 3) {
        const std::string_view word = header.next();
        if (word.starts_with('#'))
            header.skip_line();
        else if (int number = 0; read_whole(word, number))
            numbers.push_back(number);
        else
            return no_picture;
    }
    if (numbers.size() != 3 || numbers[2] < 1 || numbers[2] > 65535 || header.place() == head.size())
        return no_picture;
    Pgm picture{.size = {std::max(numbers[0], 0), std::max(numbers[1], 0)},
                .white = static_cast<std::uint32_t>(numbers[2]),
                .bytes = bytes.substr(header.place() + 1)};
    // Before room is made for what the header says and the file may not hold. In words, a level has a digit and a blank.
    const std::size_t begin = header.place() + 1,
                      wanted = begin + (kind == "P2" ? 2 * picture.pixels() - std::min<std::size_t>(picture.pixels(), 1)
                                                     : (picture.white > 255 ? 2 : 1) * picture.pixels());
    if (bytes.size() < wanted)
        return Error{message(name, " ends early: it has ", bytes.size(), " bytes of ", wanted, "; save it again.")};
    if (picture.pixels() > max_pixels)
        return Error{message(name, " has ", numbers[0], " x ", numbers[1], " pixels: give at most ", max_pixels, " in all.")};
    if (kind == "P2") {
        Words words(picture.bytes);
        picture.levels.reserve(picture.pixels());
        for (std::uint32_t level = 0; picture.levels.size() < picture.pixels() && read_whole(words.next(), level);)
            picture.levels.push_back(static_cast<std::uint16_t>(std::min<std::uint32_t>(level, 65535)));
        if (picture.levels.size() < picture.pixels())
            return Error{message(name, " has ", picture.levels.size(), " levels of ", picture.pixels(), "; save it again.")};
    }
    return picture;
}

} // namespace windrow::detail
