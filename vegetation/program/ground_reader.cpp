// The ground: heights out of a picture, random hills, or level.
#include "scene/json_document.h"
#include "scene/number_text.h"
#include "vegetation/program/part_reader.h"

#include <algorithm>
#include <cmath>

namespace windrow::vegetation::program {
namespace {

using windrow::scene::figure;

constexpr int k_max_samples = 4097; // a side: what a renderer draws as one piece

std::string metres(glm::dvec2 extent) {
    return std::string("[") + figure(extent.x) + ", " + figure(extent.y) + "] m";
}

/// Texels of a spacing that fits both sides, about a metre or a 500th of the ground. Nothing where no grid of square texels does.
std::optional<glm::ivec2> level_texels(glm::dvec2 extent) {
    const double most = k_max_samples - 1.0;
    for (double x = 1.0; x <= most; ++x) {
        const double z = x * extent.y / extent.x;
        if (z > most)
            break;
        // A thousandth of a texel is what masks are held to.
        if (std::round(z) < 1.0 || std::abs(z - std::round(z)) > 1e-4)
            continue;
        const double wanted = std::max(1.0, std::max(extent.x, extent.y) / 500.0);
        const double finer = std::clamp(std::ceil(extent.x / x / wanted), 1.0, std::floor(most / std::max(x, std::round(z))));
        return glm::ivec2(x * finer, std::round(z) * finer);
    }
    return std::nullopt;
}

std::optional<HeightMap> rolling(const GroundSource& ground) {
    const auto texels = level_texels(ground.extent);
    if (!texels)
        return std::nullopt;
    const float height = static_cast<float>(ground.low);
    auto made = HeightMap::create(*texels + 1, static_cast<float>(ground.extent.x / texels->x),
                                  [&](glm::vec2 place) { return height + ground.hills.at(place); });
    return made ? std::optional(*std::move(made)) : std::nullopt;
}

std::optional<HeightMap> from_file(JsonObject& object, const GroundSource& ground, const std::filesystem::path& file,
                                   const Surroundings& around) {
    const std::string named = "is " + windrow::scene::quote_json(object.value()["heights"]);
    // A mask's file is the same picture of 0 to 1.
    const auto picture = read_pgm(file, around, glm::vec2(ground.extent), object.log().budget());
    if (!picture) {
        object.reject("heights", named + ": " + picture.error());
        return std::nullopt;
    }
    const glm::ivec2 corners = picture->grid().corners;
    if (std::max(corners.x, corners.y) > k_max_samples) {
        object.reject("heights", named + ", which has " + std::to_string(corners.x) + " x " + std::to_string(corners.y) +
                                     " pixels: give at most " + std::to_string(k_max_samples) + " a side.");
        return std::nullopt;
    }
    const double spacing = ground.extent.x / (corners.x - 1), wanted = spacing * (corners.y - 1);
    if (std::abs(ground.extent.y - wanted) > 1e-3 * spacing) {
        object.reject("extent", "is " + metres(ground.extent) + ", which makes the " + std::to_string(corners.x) + " x " +
                                    std::to_string(corners.y) + " pixels of \"heights\" not square: give " +
                                    metres({ground.extent.x, wanted}) + ", whose pixels are square.");
        return std::nullopt;
    }
    std::vector<float> heights;
    heights.reserve(picture->values().size());
    for (const float share : picture->values()) {
        const auto n = static_cast<int>(heights.size());
        const glm::vec2 place = static_cast<float>(spacing) * glm::vec2(n % corners.x, n / corners.x);
        heights.push_back(static_cast<float>(ground.low + (ground.high - ground.low) * static_cast<double>(share)) +
                          ground.hills.at(place));
    }
    auto made = HeightMap::create(corners, static_cast<float>(spacing), std::move(heights));
    if (!made) {
        object.reject(made.error());
        return std::nullopt;
    }
    return *std::move(made);
}

} // namespace

void read_part(JsonObject object, GroundSource& ground, Surroundings& around) {
    const std::size_t faults_before = object.log().faults();
    std::optional<std::filesystem::path> file;
    read_parts(object, ground, around, [&](const auto& row, auto& member) {
        if constexpr (std::same_as<decltype(member), std::string&>)
            file = read_file(object, {row.name, row.meaning}, member, around);
        return std::same_as<decltype(member), std::string&>;
    });
    if (file && !(ground.low < ground.high) && object.log().faults() == faults_before)
        object.reject("high", "is " + figure(ground.high) + " m, not above \"low\", " + figure(ground.low) + " m: give more.");
    if (object.log().faults() == faults_before) {
        ground.heights = file ? from_file(object, ground, *file, around) : rolling(ground);
        if (!ground.heights && !file)
            object.reject("extent", "is " + metres(ground.extent) +
                                        ", which no grid of square texels fits: give two lengths in a ratio of whole numbers.");
    }
    object.finish();
    // Level where the file's are rejected, so that what stands on them can be read and judged.
    if (!ground.heights)
        ground.heights = rolling({});
    around.extent = ground.heights->extent();
}

} // namespace windrow::vegetation::program
