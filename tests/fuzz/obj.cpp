// Meshes: OBJ and its MTL. The input is the OBJ; behind a line "#mtl" follows the file that `mtllib mesh.mtl` names.
#include "tests/fuzz/mesh_bytes.h"

namespace windrow::fuzz {

ReadOutcome read_input(std::string_view bytes) {
    static const ScratchFolder folder;
    constexpr std::string_view k_mark = "\n#mtl\n";
    const std::size_t mark = bytes.find(k_mark);
    const bool two = mark != std::string_view::npos;
    folder.write("mesh.mtl", two ? bytes.substr(mark + k_mark.size()) : std::string_view());
    return read_mesh_bytes(two ? bytes.substr(0, mark + 1) : bytes, "mesh.obj");
}

} // namespace windrow::fuzz
