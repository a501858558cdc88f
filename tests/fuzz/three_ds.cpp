// Meshes: 3DS.
#include "tests/fuzz/mesh_bytes.h"

namespace windrow::fuzz {

ReadOutcome read_input(std::string_view bytes) {
    return read_mesh_bytes(bytes, "mesh.3ds");
}

} // namespace windrow::fuzz
