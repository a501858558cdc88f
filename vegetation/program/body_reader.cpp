#include "vegetation/program/body_reader.h"

#include "scene/file_beside.h"
#include "vegetation/program/body_fields.h"
#include "vegetation/program/coat_reader.h"
#include "vegetation/program/field_reader.h"
#include "vegetation/program/skeleton_reader.h"

namespace windrow::vegetation::program {
namespace {

constexpr std::size_t k_most_bodies = 64;
constexpr std::size_t k_most_coats = 16;

BodyMesh read_file(JsonObject object, const std::filesystem::path& folder) {
    MeshSource mesh;
    if (windrow::scene::file_beside(object, "name", folder))
        mesh.name = object.value()["name"].get<std::string>();
    else if (!object.value().contains("name"))
        object.refuse("name", "is missing: name a mesh in the scene's folder, OBJ, glTF, GLB or 3DS.");
    FieldReader fields(object);
    list_fields(fields, mesh);
    object.finish();
    return mesh;
}

/// A mesh of a formula.
template <class Shape>
BodyMesh read_shape(JsonObject object) {
    Shape shape;
    read_part(std::move(object), shape);
    return shape;
}

BodyMesh read_mesh(JsonObject object, const std::filesystem::path& folder) {
    BodyMesh mesh = Body{}.mesh;
    switch (object.one_of({"file", "sheet", "globe_sphere", "cube_sphere", "wing", "beast"}, "cube_sphere")) {
    case 0:
        mesh = read_file(object.object("file"), folder);
        break;
    case 1:
        mesh = read_shape<fur::Sheet>(object.object("sheet"));
        break;
    case 2:
        mesh = read_shape<fur::GlobeSphere>(object.object("globe_sphere"));
        break;
    case 3:
        mesh = read_shape<fur::CubeSphere>(object.object("cube_sphere"));
        break;
    case 4:
        mesh = read_shape<fur::Wing>(object.object("wing"));
        break;
    case 5:
        mesh = read_shape<fur::Beast>(object.object("beast"));
        break;
    default:
        break;
    }
    object.finish();
    return mesh;
}

BodyMotion read_motion(JsonObject object, std::span<const std::string> path_names) {
    BodyMotion motion;
    motion.path = object.name("path", path_names, "paths");
    FieldReader fields(object);
    list_fields(fields, motion);
    read_part(object.object("sway"), motion.sway);
    read_part(object.object("hop"), motion.hop);
    object.finish();
    return motion;
}

Body read_body(JsonObject object, std::span<const std::string> path_names, const std::filesystem::path& folder) {
    Body body;
    body.name = object.text("name", body.name);
    body.mesh = read_mesh(object.object("mesh"), folder);
    read_part(object.object("place"), body.place);
    body.motion = read_motion(object.object("motion"), path_names);
    body.skeleton = read_skeleton(object.object("skeleton"));
    each(object, "coats", k_most_coats, [&](JsonObject item) { body.coats.push_back(read_coat(std::move(item), folder)); });
    object.finish();
    return body;
}

} // namespace

std::vector<Body> read_bodies(JsonObject& picture, std::span<const std::string> path_names, const std::filesystem::path& folder) {
    std::vector<Body> bodies;
    each(picture, "bodies", k_most_bodies,
         [&](JsonObject item) { bodies.push_back(read_body(std::move(item), path_names, folder)); });
    return bodies;
}

std::vector<fur::Lamp> read_lamps(JsonObject& picture) {
    std::vector<fur::Lamp> lamps;
    each(picture, "lamps", fur::k_most_lamps, [&](JsonObject item) {
        fur::Lamp lamp;
        read_part(std::move(item), lamp);
        lamps.push_back(lamp);
    });
    return lamps;
}

} // namespace windrow::vegetation::program
