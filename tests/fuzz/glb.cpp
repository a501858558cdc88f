// Meshes: glTF as binary (GLB).
#include "tests/fuzz/json_mutator.h"
#include "tests/fuzz/mesh_bytes.h"

namespace windrow::fuzz {

ReadOutcome read_input(std::string_view bytes) {
    return read_mesh_bytes(bytes, "mesh.glb");
}

// Learned from the seeds alone: the check of glTF keeps no list of its keys.
std::vector<scene::KnownKey> known_keys(std::string_view) {
    return {};
}

} // namespace windrow::fuzz
