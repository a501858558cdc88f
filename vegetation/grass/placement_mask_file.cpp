// The mask as a binary PGM: what every image program opens, without a library.
#include "fluid/files/input_file.h"
#include "fluid/files/new_file.h"
#include "fluid/files/pgm.h"
#include "vegetation/grass/placement_mask.h"

#include <cstdint>
#include <limits>
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
        return bytes.failure();
    return from_pgm(*bytes, extent, path, std::numeric_limits<std::size_t>::max());
}

windrow::Result<PlacementMask> PlacementMask::from_pgm(std::string_view bytes, glm::vec2 extent, const std::string& name,
                                                       std::size_t max_values) {
    const auto picture = windrow::detail::read_pgm(bytes, name, max_values);
    if (!picture)
        return picture.failure();
    auto mask = create(picture->size, extent);
    if (!mask)
        return mask.failure().after(name + ": ");
    // A level of a 16-bit mask is a level; others to the nearest.
    for (std::size_t n = 0; n < mask->values_.size(); ++n)
        mask->values_[n] = static_cast<float>(static_cast<std::uint32_t>(picture->value(n) * 65535.0f + 0.5f)) / 65535.0f;
    return mask;
}

} // namespace windrow::vegetation::grass
