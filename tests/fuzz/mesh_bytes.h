// A mesh's bytes through the whole reader: our checks, tinygltf, weld, simplification, normals, uv.
#pragma once

#include "tests/fuzz/fuzz_target.h"
#include "tests/fuzz/scratch_folder.h"
#include "vegetation/files/mesh_file.h"

namespace windrow::fuzz {

inline ReadOutcome read_mesh_bytes(std::string_view bytes, const char* name) {
    static const ScratchFolder folder;
    // So few triangles that inputs of some kilobytes are simplified too.
    return outcome_of(static_cast<bool>(vegetation::fur::read_mesh(folder.write(name, bytes), {.max_triangles = 40})));
}

} // namespace windrow::fuzz
