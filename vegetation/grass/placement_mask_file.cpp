// The mask as a binary PGM: what every image program opens, without a library.
#include "fluid/input_file.h"
#include "fluid/new_file.h"
#include "vegetation/grass/placement_mask.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <sstream>
#include <string>

namespace windrow::vegetation::grass {

windrow::Result<void> PlacementMask::save(const std::string& path) const {
    std::string bytes = "P5\n" + std::to_string(grid_.corners.x) + " " + std::to_string(grid_.corners.y) + "\n65535\n";
    bytes.reserve(bytes.size() + 2 * values_.size());
    for (const float value : values_) {
        const auto level = static_cast<std::uint32_t>(value * 65535.0f + 0.5f);
        bytes.push_back(static_cast<char>(level >> 8)); // PGM has the high byte first
        bytes.push_back(static_cast<char>(level & 255u));
    }
    return windrow::detail::write_file("mask", path, bytes);
}

windrow::Result<PlacementMask> PlacementMask::load(const std::string& path, glm::vec2 extent) {
    windrow::detail::InputBudget budget;
    const auto bytes = windrow::detail::read_input(path, {.max_bytes = k_max_pgm_bytes}, budget);
    if (!bytes)
        return windrow::Error{bytes.error()};
    return from_pgm(*bytes, extent, path, std::numeric_limits<std::size_t>::max());
}

windrow::Result<PlacementMask> PlacementMask::from_pgm(std::string_view bytes, glm::vec2 extent, const std::string& name,
                                                       std::size_t max_values) {
    const windrow::Error no_image{name + " is not a binary PGM of up to 65535 levels: save the image as PGM (P5)."};
    std::istringstream header(std::string(bytes.substr(0, 256)));
    std::string kind;
    std::vector<int> numbers;
    header >> kind;
    for (std::string word; kind == "P5" && numbers.size() < 3 && header >> word;) {
        if (word[0] == '#') {
            std::getline(header, word);
            continue;
        }
        std::istringstream digits(word);
        int number = 0;
        if (!(digits >> number) || !digits.eof())
            return no_image;
        numbers.push_back(number);
    }
    if (numbers.size() != 3 || numbers[2] < 1 || numbers[2] > 65535 || header.tellg() < 0)
        return no_image;
    const std::size_t begin = static_cast<std::size_t>(header.tellg()) + 1, width = numbers[2] > 255 ? 2 : 1;
    const auto pixels = [&](int n) { return static_cast<std::size_t>(std::max(numbers[static_cast<std::size_t>(n)], 0)); };
    // Before room is made for what the header says and the file may not hold.
    if (bytes.size() < begin + width * pixels(0) * pixels(1))
        return windrow::Error{name + " ends early: it has " + std::to_string(bytes.size()) + " bytes of " +
                              std::to_string(begin + width * pixels(0) * pixels(1)) + "; save it again."};
    if (pixels(0) * pixels(1) > max_values)
        return windrow::Error{name + " has " + std::to_string(numbers[0]) + " x " + std::to_string(numbers[1]) +
                              " pixels: give at most " + std::to_string(max_values) + " in all."};
    auto mask = create({numbers[0], numbers[1]}, extent);
    if (!mask)
        return windrow::Error{name + ": " + mask.error()};
    const auto byte = [&](std::size_t at) { return static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at])); };
    for (std::size_t n = 0; n < mask->values_.size(); ++n) {
        const std::size_t at = begin + width * n;
        const std::uint32_t level = width == 2 ? byte(at) << 8 | byte(at + 1) : byte(at);
        // A level of a 16-bit mask is a level; others to the nearest.
        const float alpha = static_cast<float>(level) / static_cast<float>(numbers[2]);
        mask->values_[n] = std::min(static_cast<float>(static_cast<std::uint32_t>(alpha * 65535.0f + 0.5f)) / 65535.0f, 1.0f);
    }
    return mask;
}

} // namespace windrow::vegetation::grass
