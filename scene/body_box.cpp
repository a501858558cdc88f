#include "scene/body_box.h"

#include "fluid/core/message.h"
#include "fluid/files/input_file.h"
#include "scene/obj_file.h"
#include "scene/scene_parts.h"
#include "scene/setting_reader.h"

#include <algorithm>
#include <cctype>
#include <glm/common.hpp>
#include <limits>
#include <string>

namespace windrow::scene {
namespace {

using detail::message;

Result<BodyBox> box_of_obj(const std::filesystem::path& file, const MeshLoad& load, const std::filesystem::path& folder,
                           detail::InputBudget& budget) {
    const auto bytes = detail::read_input(file, {.folder = folder, .max_bytes = k_max_mesh_bytes}, budget);
    if (!bytes)
        return bytes.failure();
    return detail::where_memory_lasts([&]() -> Result<BodyBox> {
        const auto obj = read_obj(*bytes, file.string(), {k_max_mesh_vertices, k_max_mesh_triangles});
        if (!obj)
            return obj.failure();
        const MeshTurn turn(load);
        BodyBox turned{glm::vec3(std::numeric_limits<float>::max()), glm::vec3(std::numeric_limits<float>::lowest())};
        for (const ObjPart& part : obj->parts)
            for (const ObjCorner& corner : part.corners) {
                const glm::vec3 place = turn(obj->positions[corner.position]);
                turned = {glm::min(turned.low, place), glm::max(turned.high, place)};
            }
        const MeshStand stand(load, turned.low, turned.high);
        return BodyBox{stand(turned.low), stand(turned.high)};
    });
}

Result<BodyBox> box_of_file(JsonObject object, const std::filesystem::path& folder, MeshBoxReader meshes) {
    const auto file = file_beside(object, {"name", "Relative to the scene's folder, and in it."}, folder);
    MeshLoad load;
    read_settings(object, load, [](const auto&, const auto&) { return false; });
    if (!file)
        return Error{message(object.path(), " names no mesh in the scene's folder.")};
    std::string ending = file->extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (ending == ".obj")
        return box_of_obj(*file, load, folder, object.log().budget());
    if (meshes != nullptr)
        return meshes(*file, load, folder, object.log().budget());
    return Error{message(file->string(), " is no OBJ, which is all that this program reads: save it as OBJ.")};
}

} // namespace

Result<BodyBox> read_body_box(JsonObject mesh, const std::filesystem::path& folder, MeshBoxReader meshes) {
    static constexpr auto k_kinds = {"file", "sheet", "globe_sphere", "cube_sphere", "wing", "beast"};
    const std::size_t chosen = mesh.one_of(k_kinds, "cube_sphere");
    if (chosen == k_kinds.size())
        return Error{message(mesh.path(), " is of no known kind.")};
    JsonObject kind = mesh.object(k_kinds.begin()[chosen]);
    switch (chosen) {
    case 0:
        return box_of_file(std::move(kind), folder, meshes);
    case 1: {
        const glm::dvec2 size = 0.5 * kind.pair("size", glm::dvec2(1.0), {1e-3, 1e4, "m"}, "x, z");
        const double wave = kind.number("wave", 0.0, {0.0, 1e3, "m"});
        return BodyBox{glm::vec3(-size.x, -wave, -size.y), glm::vec3(size.x, wave, size.y)};
    }
    case 2:
    case 3: {
        const float radius = kind.real("radius", 0.5f, {1e-3, 1e3, "m"});
        return BodyBox{glm::vec3(-radius), glm::vec3(radius)};
    }
    case 4: { // vegetation/fur/shapes_wing.cpp has its form
        const float span = kind.real("span", 1.0f, {1e-2, 100.0, "m"}), chord = kind.real("chord", 0.35f, {1e-3, 100.0, "m"});
        const float sweep = kind.real("sweep", 0.25f, k_fraction_range), droop = kind.real("droop", 0.12f, {0.0, 0.5});
        const bool left = kind.boolean("left", false);
        return BodyBox{{left ? -span : 0.0f, -droop * span, -std::max(chord, sweep * span + 0.2f * chord)},
                       {left ? 0.0f : span, 0.05f * span + 0.12f * chord, 0.04f * span}};
    }
    default: { // the mesh of vegetation/fur/beast.cpp at 34 cells
        const float height = kind.real("height", 2.0f, {0.1, 20.0, "m"});
        return BodyBox{height * glm::vec3(-0.22776f, 0.0f, -0.82588f), height * glm::vec3(0.22776f, 1.29672f, 0.98535f)};
    }
    }
}

} // namespace windrow::scene
