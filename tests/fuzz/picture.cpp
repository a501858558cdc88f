// Scene files with a picture: windrow-draw's JSON.
#include "tests/fuzz/fuzz_target.h"
#include "tests/fuzz/json_mutator.h"
#include "tests/fuzz/scratch_folder.h"
#include "vegetation/program/picture_reader.h"

#include <algorithm>
#include <cmath>

namespace windrow::fuzz {
namespace {

using nlohmann::json;

/// A PGM of 8 bits whose levels rise along its pixels.
std::string pgm(int width, int height) {
    std::string bytes = "P5\n" + std::to_string(width) + " " + std::to_string(height) + "\n255\n";
    for (int n = 0; n < width * height; ++n)
        bytes.push_back(static_cast<char>(255 * n / (width * height)));
    return bytes;
}

const std::filesystem::path& scene_file() {
    static const ScratchFolder folder;
    static const std::filesystem::path file = [] {
        folder.write("ground.pgm", pgm(5, 5));
        folder.write("hills.pgm", pgm(9, 5));
        folder.write("paths.pgm", pgm(4, 4));
        folder.write("path.csv", "0,0,0,0\n1,2,0,1\n3,4,1,0\n");
        return folder.path() / "scene.json";
    }();
    return file;
}

/// The reader makes the ground and the masks, up to 4097 corners a side. The values there follow the same code whatever their
/// number, so only the number is bounded: at seconds an execution nothing else would be read.
constexpr double k_max_corners = 65.0;

bool pair_of_numbers(const json& value) {
    return value.is_array() && value.size() == 2 && value[0].is_number() && value[1].is_number();
}

/// As the reader chooses the texels of a ground without a file.
bool large_ground(const json& extent) {
    if (!pair_of_numbers(extent))
        return false;
    const double x = extent[0].get<double>(), z = extent[1].get<double>();
    if (std::max(x, z) > 300.0)
        return true;
    for (double texels = 1.0; texels <= 4096.0; ++texels)
        if (const double other = texels * z / x; std::abs(other - std::round(other)) <= 1e-4 && other > 0.5)
            return std::max(texels, other) > 300.0;
    return false; // rejected
}

bool large(const json& value) {
    if (value.is_object() && value.contains("corners") && pair_of_numbers(value["corners"]) &&
        (value["corners"][0] > k_max_corners || value["corners"][1] > k_max_corners))
        return true;
    if (value.is_object() && value.contains("extent") && large_ground(value["extent"]))
        return true;
    return value.is_structured() && std::any_of(value.begin(), value.end(), large);
}

/// A document that nests deeper than a scene is rejected before anything is made.
bool large_text(std::string_view text) {
    constexpr int k_deepest = 40;
    bool deep = false;
    const auto shallow = [&](int depth, json::parse_event_t, json&) {
        deep = deep || depth >= k_deepest;
        return !deep;
    };
    const json document = json::parse(text, shallow, false);
    return !deep && large(document);
}

} // namespace

ReadOutcome read_input(std::string_view bytes) {
    if (large_text(bytes))
        return ReadOutcome::skipped;
    return outcome_of(static_cast<bool>(vegetation::program::read_picture_scene_text(bytes, scene_file())));
}

std::vector<scene::KnownKey> known_keys(std::string_view text) {
    std::vector<scene::KnownKey> keys;
    if (!large_text(text))
        (void)vegetation::program::read_picture_scene_text(text, scene_file(), &keys);
    return keys;
}

} // namespace windrow::fuzz
