#include "fluid/files/pgm.h"

#include "fluid/core/message.h"

#include <algorithm>
#include <sstream>
#include <vector>

namespace windrow::detail {

float Pgm::value(std::size_t pixel) const {
    const auto byte = [&](std::size_t at) { return static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at])); };
    const std::uint32_t level = !levels.empty() ? levels[pixel]
                                : white > 255   ? byte(2 * pixel) << 8 | byte(2 * pixel + 1)
                                                : byte(pixel); // the high byte is first
    return std::min(static_cast<float>(level) / static_cast<float>(white), 1.0f);
}

Result<Pgm> read_pgm(std::string_view bytes, const std::string& name, std::size_t max_pixels) {
    const Error no_picture{name + " is not a PGM of up to 65535 levels: save the image as PGM (P5)."};
    std::istringstream header(std::string(bytes.substr(0, 256)));
    std::string kind;
    std::vector<int> numbers;
    header >> kind;
    for (std::string word; (kind == "P5" || kind == "P2") && numbers.size() < 3 && header >> word;) {
        if (word[0] == '#') {
            std::getline(header, word);
            continue;
        }
        std::istringstream digits(word);
        int number = 0;
        if (!(digits >> number) || !digits.eof())
            return no_picture;
        numbers.push_back(number);
    }
    if (numbers.size() != 3 || numbers[2] < 1 || numbers[2] > 65535 || header.tellg() < 0)
        return no_picture;
    Pgm picture{.size = {std::max(numbers[0], 0), std::max(numbers[1], 0)},
                .white = static_cast<std::uint32_t>(numbers[2]),
                .bytes = bytes.substr(std::min(static_cast<std::size_t>(header.tellg()) + 1, bytes.size()))};
    // Before room is made for what the header says and the file may not hold. In words, a level has a digit and a blank.
    const std::size_t begin = static_cast<std::size_t>(header.tellg()) + 1,
                      wanted = begin + (kind == "P2" ? 2 * picture.pixels() - std::min<std::size_t>(picture.pixels(), 1)
                                                     : (picture.white > 255 ? 2 : 1) * picture.pixels());
    if (bytes.size() < wanted)
        return Error{message(name, " ends early: it has ", bytes.size(), " bytes of ", wanted, "; save it again.")};
    if (picture.pixels() > max_pixels)
        return Error{message(name, " has ", numbers[0], " x ", numbers[1], " pixels: give at most ", max_pixels, " in all.")};
    if (kind == "P2") {
        std::istringstream words{std::string(picture.bytes)};
        picture.levels.reserve(picture.pixels());
        for (std::uint32_t level = 0; picture.levels.size() < picture.pixels() && words >> level;)
            picture.levels.push_back(static_cast<std::uint16_t>(std::min<std::uint32_t>(level, 65535)));
        if (picture.levels.size() < picture.pixels())
            return Error{message(name, " has ", picture.levels.size(), " levels of ", picture.pixels(), "; save it again.")};
    }
    return picture;
}

} // namespace windrow::detail
