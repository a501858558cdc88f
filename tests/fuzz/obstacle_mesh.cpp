// Meshes of obstacles: OBJ, its faces cut into triangles, closed and searched.
#include "scene/obj_file.h"
#include "tests/fuzz/fuzz_target.h"

#include <cmath>

namespace windrow::fuzz {

ReadOutcome read_input(std::string_view bytes) {
    const auto obj = scene::read_obj(bytes, "mesh.obj", {.vertices = 2'000, .triangles = 1'000});
    if (!obj)
        return ReadOutcome::rejected;
    const auto mesh = TriangleMesh::create(scene::mesh_of_obj(*obj));
    if (!mesh)
        return ReadOutcome::rejected;
    const TriangleMesh& made = **mesh;
    const auto again = TriangleMesh::create(made.data());
    require(again && (*again)->data() == made.data(), "a mesh is made again of its own data");
    const glm::vec3 middle = 0.5f * (made.low() + made.high());
    require(std::isfinite(made.distance_to(middle)) && made.thickness() >= 0.0f, "a mesh has distances and a thickness");
    (void)made.crosses(middle, made.high());
    return ReadOutcome::accepted;
}

} // namespace windrow::fuzz
