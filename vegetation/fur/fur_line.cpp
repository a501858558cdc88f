#include "vegetation/fur/fur_line.h"

#include "fluid/core/validation.h"
#include "fluid/files/text_lines.h"

#include <array>

namespace windrow::vegetation::fur {
namespace {

using windrow::detail::message, windrow::detail::take_word, windrow::detail::TextLines, windrow::detail::trimmed;

using windrow::Error;
using windrow::Result;

template <class Number>
bool read(std::string_view word, Number& number) {
    const auto read = windrow::detail::number_of<Number>(word);
    number = read.value_or(number);
    return read.has_value();
}

Result<FurLine> fur_of(std::string_view words, const std::string& place) {
    std::array<std::string_view, 4> word;
    for (std::string_view& each : word)
        each = take_word(words);
    if (word.back().empty() || !trimmed(words).empty())
        return windrow::Error{message(place,
                                      ": fur needs four numbers: give shell count, height, thickness and resolution, as in "
                                      "`fur 48 0.419 2.753 11`.")};
    FurLine fur;
    if (!read(word[0], fur.shells))
        return windrow::Error{message(place, ": fur's shell count is '", word[0], "': give a whole number, 2 to 4096.")};
    const std::array<float*, 3> numbers{&fur.height, &fur.thickness, &fur.resolution};
    constexpr std::array<std::string_view, 3> names{"height", "thickness", "resolution"};
    for (std::size_t i = 0; i < numbers.size(); ++i)
        if (!read(word[i + 1], *numbers[i]))
            return windrow::Error{message(place, ": fur's ", names[i], " is '", word[i + 1], "': give a number.")};
    if (const auto valid = windrow::detail::validate_settings(fur, place + ": fur"); !valid)
        return valid.failure();
    return fur;
}

} // namespace

Result<std::map<std::string, FurLine>> read_fur_lines(std::string_view mtl, const std::string& name) {
    std::map<std::string, FurLine> coats;
    std::string material;
    TextLines lines(mtl);
    for (std::string_view line; lines.next(line);) {
        const std::string_view key = take_word(line);
        if (key == "newmtl")
            material = trimmed(line);
        if (key != "fur")
            continue;
        const std::string place = message(name, ":", lines.number());
        if (material.empty())
            return windrow::Error{message(place, ": fur line before any newmtl line: move it below the line of its material.")};
        const auto fur = fur_of(line, place);
        if (!fur)
            return fur.failure();
        if (!coats.emplace(material, *fur).second)
            return windrow::Error{message(place, ": duplicate fur line of material '", material, "': remove one.")};
    }
    return coats;
}

} // namespace windrow::vegetation::fur
