#include "scene/shape_files.h"

#include "fluid/core/message.h"
#include "fluid/files/input_file.h"
#include "scene/height_files.h"
#include "scene/obj_file.h"
#include "scene/scene_parts.h"
#include "scene/vox_file.h"

#include <filesystem>

namespace windrow::scene {
namespace {

using detail::message;

constexpr std::size_t k_max_bytes = std::size_t{128} << 20; // a mesh of a million triangles as text has about as many

Result<MeshData> parse_obj(std::string_view bytes, const std::string& name) {
    return detail::where_memory_lasts([&]() -> Result<MeshData> {
        const auto obj =
            read_obj(bytes, name, {.vertices = 3 * TriangleMesh::k_max_triangles, .triangles = TriangleMesh::k_max_triangles});
        if (!obj)
            return obj.failure();
        return mesh_of_obj(*obj);
    });
}

// Parsers that need nothing of the log.
template <class Parse>
auto alone(const Parse& parse) {
    return [&parse](std::string_view bytes, const std::string& name, ReadLog&) { return parse(bytes, name); };
}

} // namespace

template <class Kind, class Parse>
void ShapeFiles::read(JsonObject& object, const Key& key, const char* what, Files<Kind>& files,
                      std::shared_ptr<const Kind>& shared, const Parse& parse, const std::string& how) {
    const auto file = file_beside(object, key, folder_);
    if (!file) {
        if (!object.value().contains(key.name))
            object.reject(key, message("is missing: name ", what, " in the scene's folder."));
        return;
    }
    const auto [known, added] = files.try_emplace(message(file->string(), how));
    if (!added) {
        shared = known->second;
        if (shared == nullptr)
            object.reject(key, "names a file that cannot be used: see above.");
        return;
    }
    if (object.log().is_full()) { // a file may cost seconds before its fault is found
        object.log().count_fault();
        return;
    }
    const auto made = [&]() -> Result<std::shared_ptr<const Kind>> {
        const std::string name = file->string();
        const auto bytes = detail::read_input(*file, {.folder = folder_, .max_bytes = k_max_bytes}, object.log().budget());
        if (!bytes)
            return bytes.failure();
        auto data = parse(*bytes, name, object.log());
        if (!data)
            return data.failure();
        auto kind = Kind::create(*std::move(data));
        if (!kind)
            return kind.failure().after(message(name, ": "));
        if (auto taken = object.log().budget().take_memory(name, (*kind)->memory_bytes()); !taken)
            return taken.failure();
        return kind;
    }();
    if (made)
        shared = known->second = *made;
    else
        object.log().reject_as_is(made.error());
}

void ShapeFiles::read(JsonObject& object, const Key& key, std::shared_ptr<const TriangleMesh>& mesh) {
    read(object, key, "a mesh, OBJ,", meshes_, mesh, alone(parse_obj));
}

void ShapeFiles::read(JsonObject& object, const Key& key, std::shared_ptr<const VoxelGrid>& grid) {
    read(object, key, "a MagicaVoxel file", grids_, grid, alone(read_vox));
}

void ShapeFiles::read(JsonObject& object, const Key& key, std::shared_ptr<const HeightMap>& heights) {
    read_heights(object, key, heights, std::nullopt);
}

void ShapeFiles::read_ground(JsonObject& object, const Key& key, std::shared_ptr<const HeightMap>& heights) {
    read_heights(object, key, heights, holes_of(object));
}

std::optional<std::filesystem::path> ShapeFiles::holes_of(JsonObject& object) const {
    return file_beside(object,
                       {"holes",
                        "Picture beside the scene, PGM, PNG or TIFF, which covers the heights whole, however many pixels it has: "
                        "where it is white there is no ground, to any depth. Default: no hole."},
                       folder_);
}

void ShapeFiles::read_heights(JsonObject& object, const Key& key, std::shared_ptr<const HeightMap>& heights,
                              const std::optional<std::filesystem::path>& holes) {
    const HeightKeys keys = height_keys(object);
    const bool scaled = object.value().contains("scale");
    const std::string how = message(", byte order ", static_cast<int>(keys.byte_order), keys.nodata ? ", nodata " : "",
                                    keys.nodata.value_or(0.0), ", holes ", holes ? holes->string() : "");
    read(
        object, key, "a picture of heights, PGM, PNG, TIFF, .asc or raw,", heights_, heights,
        [&](std::string_view bytes, const std::string& name, ReadLog& log) -> Result<HeightData> {
            auto picture = read_height_file(bytes, name, keys, scaled, log);
            if (!picture)
                return picture.failure();
            if (holes) {
                const auto mask = detail::read_input(*holes, {.folder = folder_, .max_bytes = k_max_bytes}, log.budget());
                if (!mask)
                    return mask.failure();
                auto read = read_holes(*mask, holes->string(), log);
                if (!read)
                    return read.failure();
                picture->data.holes = *std::move(read);
            }
            return std::move(picture->data);
        },
        how);
}

} // namespace windrow::scene
