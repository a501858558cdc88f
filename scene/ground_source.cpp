#include "scene/ground_source.h"

#include "fluid/files/input_file.h"
#include "scene/height_files.h"
#include "scene/json_document.h"
#include "scene/number_text.h"
#include "scene/scene_parts.h"
#include "scene/setting_reader.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#define WINDROW_FN inline
namespace windrow::numerics {
using namespace glm;
#include "shaders/numerics/place_noise.glsl"
} // namespace windrow::numerics
#undef WINDROW_FN

namespace windrow::scene {
namespace {

using detail::message;

constexpr int k_max_samples = 4097; // a side: what a renderer draws as one piece
constexpr std::size_t k_max_bytes = (std::size_t{512} << 20) + 4096;

using Heights = std::shared_ptr<const HeightMap>;

std::string metres(glm::dvec2 extent) {
    return message("[", detail::Figure{extent.x}, ", ", detail::Figure{extent.y}, "] m");
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

Heights rolling(const GroundSource& ground) {
    const auto texels = level_texels(ground.extent);
    if (!texels)
        return nullptr;
    const float height = static_cast<float>(ground.low);
    auto made = HeightMap::create(*texels + 1, static_cast<float>(ground.extent.x / texels->x),
                                  [&](glm::vec2 place) { return height + ground.hills.at(place); });
    return made ? std::make_shared<const HeightMap>(*std::move(made)) : nullptr;
}

Heights from_file(JsonObject& object, const GroundSource& ground, const std::filesystem::path& file,
                  const std::filesystem::path& folder, const HeightKeys& keys) {
    const std::string named = "is " + quote_json(object.value()["heights"]), name = file.string();
    detail::InputBudget& budget = object.log().budget();
    const auto bytes = detail::read_input(file, {.folder = folder, .max_bytes = k_max_bytes}, budget);
    const auto picture =
        bytes ? read_height_file(*bytes, name, keys, true, object.log()) : Result<HeightPicture>(bytes.failure());
    if (!picture) {
        object.reject("heights", named + ": " + picture.error());
        return nullptr;
    }
    const std::vector<float>& own = picture->data.heights;
    if (auto taken = budget.take_memory(name, own.size() * sizeof(float)); !taken) {
        object.reject("heights", named + ": " + taken.error());
        return nullptr;
    }
    const glm::ivec2 corners = picture->data.corners;
    if (std::max(corners.x, corners.y) > k_max_samples || std::min(corners.x, corners.y) < 2) {
        object.reject("heights", message(named, ", which has ", corners.x, " x ", corners.y, " pixels: give 2 to ", k_max_samples,
                                         " a side."));
        return nullptr;
    }
    const double spacing = ground.extent.x / (corners.x - 1), wanted = spacing * (corners.y - 1);
    if (std::abs(ground.extent.y - wanted) > 1e-3 * spacing) {
        object.reject("extent", message("is ", metres(ground.extent), ", which makes the ", corners.x, " x ", corners.y,
                                        " pixels of \"heights\" not square: give ", metres({ground.extent.x, wanted}),
                                        ", whose pixels are square."));
        return nullptr;
    }
    std::vector<float> heights;
    heights.reserve(own.size());
    for (std::size_t pixel = 0; pixel < own.size(); ++pixel) {
        const auto n = static_cast<int>(pixel);
        const glm::vec2 place = static_cast<float>(spacing) * glm::vec2(n % corners.x, n / corners.x);
        const double height = static_cast<double>(own[pixel]);
        heights.push_back(static_cast<float>(picture->metres ? height : ground.low + (ground.high - ground.low) * height) +
                          ground.hills.at(place));
    }
    auto made = HeightMap::create(corners, static_cast<float>(spacing), std::move(heights));
    if (!made) {
        object.reject(made.error());
        return nullptr;
    }
    return std::make_shared<const HeightMap>(*std::move(made));
}

} // namespace

float Hills::at(glm::vec2 place) const {
    const glm::vec2 cell = place / static_cast<float>(length) + 17.3f * static_cast<float>(seed % 64u);
    // Incommensurable steps, so that the octaves' lattices do not meet; each weighs less than it is finer: no slope stands out.
    const float noise = 0.72f * numerics::windrow_place_noise(cell) + 0.22f * numerics::windrow_place_noise(2.7f * cell + 31.0f) +
                        0.06f * numerics::windrow_place_noise(7.3f * cell + 77.0f);
    return static_cast<float>(height) * noise;
}

double GroundSource::height(double x, double z) const {
    const double above = heights ? static_cast<double>(heights->drawn_height(glm::vec2(x - corner.x, z - corner.z))) : low;
    return corner.y + above;
}

void read_ground(JsonObject object, GroundSource& ground, const std::filesystem::path& folder) {
    const std::size_t faults_before = object.log().faults();
    std::optional<std::filesystem::path> file;
    const HeightKeys keys = height_keys(object);
    read_settings(object, ground, [&](const auto& row, auto& member) {
        if constexpr (std::same_as<decltype(member), std::string&>) {
            file = file_beside(object, {row.name, row.meaning}, folder);
            if (file)
                member = object.value()[row.name].template get<std::string>();
        }
        return std::same_as<decltype(member), std::string&>;
    });
    if (file && !(ground.low < ground.high) && object.log().faults() == faults_before)
        object.reject("high", "is " + figure(ground.high) + " m, not above \"low\", " + figure(ground.low) + " m: give more.");
    if (object.log().faults() == faults_before) {
        ground.heights = file ? from_file(object, ground, *file, folder, keys) : rolling(ground);
        if (!ground.heights && !file)
            object.reject("extent", "is " + metres(ground.extent) +
                                        ", which no grid of square texels fits: give two lengths in a ratio of whole numbers.");
    }
    object.finish();
    if (!ground.heights)
        ground.heights = rolling({});
}

} // namespace windrow::scene
