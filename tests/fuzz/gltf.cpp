// Meshes: glTF as text; its buffers are data in the text.
#include "tests/fuzz/json_mutator.h"
#include "tests/fuzz/mesh_bytes.h"

namespace windrow::fuzz {

ReadOutcome read_input(std::string_view bytes) {
    return read_mesh_bytes(bytes, "mesh.gltf");
}

// Learned from the seeds alone: the check of glTF keeps no list of its keys.
std::vector<scene::KnownKey> known_keys(std::string_view) {
    return {};
}

} // namespace windrow::fuzz
