// Scene files: `windrow run`'s JSON.
#include "scene/scene_reader.h"
#include "tests/fuzz/fuzz_target.h"
#include "tests/fuzz/json_mutator.h"
#include "tests/fuzz/scratch_folder.h"

namespace windrow::fuzz {
namespace {

// One closed cell.
constexpr std::string_view k_voxels("VOX \x96\0\0\0"
                                    "MAIN\0\0\0\0\x2c\0\0\0"
                                    "SIZE\x0c\0\0\0\0\0\0\0\1\0\0\0\1\0\0\0\1\0\0\0"
                                    "XYZI\x08\0\0\0\0\0\0\0\1\0\0\0\0\0\0\1",
                                    64);

const std::filesystem::path& scene_file() {
    static const ScratchFolder folder;
    static const std::filesystem::path file = [] {
        folder.write("path.csv", "t,x,y,z\n0,0,0,0\n1,2,0,1\n3,4,1,0\n");
        folder.write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
        folder.write("tower.vox", k_voxels);
        return folder.path() / "scene.json";
    }();
    return file;
}

} // namespace

ReadOutcome read_input(std::string_view bytes) {
    return outcome_of(static_cast<bool>(scene::read_scene_text(bytes, scene_file())));
}

std::vector<scene::KnownKey> known_keys(std::string_view text) {
    std::vector<scene::KnownKey> keys;
    (void)scene::read_scene_text(text, scene_file(), &keys);
    return keys;
}

} // namespace windrow::fuzz
