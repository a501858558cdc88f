// Height maps and masks: binary PGM, as a scene names them.
#include "tests/fuzz/fuzz_target.h"
#include "tests/fuzz/scratch_folder.h"
#include "vegetation/program/picture_reader.h"

namespace windrow::fuzz {

ReadOutcome read_input(std::string_view bytes) {
    static const ScratchFolder folder;
    const auto mask = vegetation::grass::PlacementMask::load(folder.write("map.pgm", bytes).string(), glm::vec2(10.0f));
    if (!mask)
        return ReadOutcome::rejected;
    // Once more as the heights of a ground whose pixels come out square, and as a mask on it.
    const glm::ivec2 corners = mask->grid().corners;
    const nlohmann::json scene{{"picture",
                                {{"ground", {{"heights", "map.pgm"}, {"extent", {corners.x - 1, corners.y - 1}}}},
                                 {"grass", nlohmann::json::array({{{"mask", {{"file", "map.pgm"}}}}})}}}};
    return outcome_of(
        static_cast<bool>(vegetation::program::read_picture_scene_text(scene.dump(), folder.path() / "scene.json")));
}

} // namespace windrow::fuzz
