#include "vegetation/files/mesh_file.h"

#include "fluid/core/validation.h"
#include "fluid/files/input_file.h"
#include "scene/obj_file.h"
#include "vegetation/files/gltf_file.h"
#include "vegetation/files/mesh_folder.h"
#include "vegetation/fur/mesh_weld.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace windrow::vegetation::fur {
namespace {

using windrow::detail::message;

static_assert(k_max_vertices == windrow::scene::k_max_mesh_vertices && k_max_triangles == windrow::scene::k_max_mesh_triangles &&
              k_max_parts >= windrow::scene::k_max_materials);

namespace fs = std::filesystem;
using Coats = std::map<std::string, FurLine>;
using windrow::detail::InputBudget;

// The file's ending in small letters.
std::string ending_of(const fs::path& path) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

Result<Soup> read_obj(const fs::path& path, const std::string& bytes, Coats& coats, InputBudget& budget) {
    const auto obj = windrow::scene::read_obj(bytes, path.string(), {k_max_vertices, k_max_triangles});
    if (!obj)
        return obj.failure();
    for (const std::string& library : obj->libraries) {
        const auto text = read_beside(path, library, budget);
        if (!text)
            return text.failure();
        auto more = read_fur_lines(*text, (path.parent_path() / library).string());
        if (!more)
            return more.failure();
        coats.merge(*more);
    }
    using windrow::scene::ObjCorner;
    Soup soup;
    for (const windrow::scene::ObjPart& from : obj->parts) {
        SoupPart& part = soup.emplace_back(SoupPart{from.material, {}, true});
        part.corners.reserve(from.corners.size());
        for (const ObjCorner& corner : from.corners) {
            Corner& made = part.corners.emplace_back(Corner{obj->positions[corner.position]});
            if (corner.normal != ObjCorner::k_none)
                made.normal = obj->normals[corner.normal];
            if (corner.uv != ObjCorner::k_none)
                made.uv = obj->uvs[corner.uv];
            part.has_uv = part.has_uv && corner.uv != ObjCorner::k_none;
        }
    }
    return soup;
}

Result<Soup> read_soup(const fs::path& path, const std::optional<fs::path>& folder, InputBudget& budget, Coats& coats) {
    const std::string ending = ending_of(path);
    if (ending != ".obj" && ending != ".gltf" && ending != ".glb")
        return windrow::Error{message(path.string(), " ends in '", ending, "': give a mesh as .obj, .gltf or .glb.")};
    auto bytes = windrow::detail::read_input(path, {.folder = folder, .max_bytes = k_max_bytes}, budget);
    if (!bytes)
        return bytes.failure();
    if (ending == ".obj")
        return read_obj(path, *bytes, coats, budget);
    return read_gltf(*bytes, path, budget);
}

void turn(Soup& soup, const MeshLoad& load) {
    const windrow::scene::MeshTurn turn(load);
    for (SoupPart& part : soup)
        for (Corner& corner : part.corners) {
            corner.position = turn(corner.position);
            corner.normal = turn(corner.normal);
        }
}

// Scaled and stood up; how many metres one of the file's units became.
float stand(Mesh& mesh, const MeshLoad& load) {
    const windrow::scene::MeshStand stand(load, mesh.low, mesh.high);
    for (MeshVertex& vertex : mesh.vertices)
        vertex.position = stand(vertex.position);
    measure(mesh);
    return stand.scale;
}

Result<Mesh> read(const fs::path& path, const MeshLoad& load, const std::optional<fs::path>& folder, InputBudget& budget) {
    if (const auto valid = validate(load); !valid)
        return valid.failure();
    Coats coats;
    auto soup = read_soup(path, folder, budget, coats);
    if (!soup)
        return soup.failure();
    turn(*soup, load);
    auto mesh = weld(*soup, path.string() + " ");
    if (!mesh)
        return mesh;
    soup->clear();

    if (mesh->triangles() > load.max_triangles) {
        simplify(*mesh, load.max_triangles);
        if (mesh->triangles() > load.max_triangles)
            return windrow::Error{message(path.string(), " cannot be simplified below ", mesh->triangles(),
                                          " triangles: give load.max_triangles of as many.")};
        for (MeshVertex& vertex : mesh->vertices)
            vertex.normal = glm::vec3(0.0f);
    }
    const glm::vec3 edges = mesh->high - mesh->low;
    if (!((load.size_of == SizeOf::height ? edges.y : 1.0f) > 1e-6f * glm::length(edges)))
        return windrow::Error{message(path.string(), " is flat: set load.size_of to the longest edge.")};
    const float scale = stand(*mesh, load);
    smooth_normals(*mesh);
    if (!mesh->has_uv)
        project_uv(*mesh);
    for (MeshPart& part : mesh->parts)
        if (const auto coat = coats.find(part.material); coat != coats.end()) {
            part.fur = coat->second;
            part.fur->height *= scale;
        }
    if (const auto valid = validate(*mesh, path.string().c_str()); !valid)
        return valid.failure();
    const std::size_t memory = mesh->vertices.size() * sizeof(MeshVertex) + mesh->indices.size() * sizeof mesh->indices.front();
    if (auto taken = budget.take_memory(path.string(), memory); !taken)
        return taken.failure();
    return mesh;
}

} // namespace

Result<void> validate(const MeshLoad& load) {
    return windrow::detail::validate_settings(load, "load");
}

Result<Mesh> read_mesh(const fs::path& path, const MeshLoad& load) {
    InputBudget budget;
    return windrow::detail::where_memory_lasts([&] { return read(path, load, std::nullopt, budget); });
}

Result<Mesh> read_mesh(const fs::path& path, const MeshLoad& load, const fs::path& folder, InputBudget& budget) {
    return windrow::detail::where_memory_lasts([&] { return read(path, load, folder, budget); });
}

} // namespace windrow::vegetation::fur
