#include "vegetation/program/body_reader.h"

#include "scene/scene_parts.h"
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
    if (windrow::scene::file_beside(object, {"name", "Relative to the scene's folder, and in it."}, folder))
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
        mesh = read_file(
            object.object(
                {"file",
                 "A mesh beside the scene: OBJ with its mtl, glTF, GLB or 3DS. It is read when the scene is drawn. A coat whose "
                 "material has a fur line in the mtl has its shells, length, thickness and density where the scene names none."}),
            folder);
        break;
    case 1:
        mesh = read_shape<fur::Sheet>(object.object({"sheet", "A sheet facing up."}));
        break;
    case 2:
        mesh = read_shape<fur::GlobeSphere>(object.object({"globe_sphere", "A sphere by longitude and latitude."}));
        break;
    case 3:
        mesh = read_shape<fur::CubeSphere>(object.object({"cube_sphere", "A sphere of even cells."}));
        break;
    case 4:
        mesh = read_shape<fur::Wing>(
            object.object({"wing", "A bird's wing, spread along x from its root at 0, its leading edge towards +z."}));
        break;
    case 5:
        mesh = read_shape<fur::Beast>(object.object({"beast", "A wolf-like beast on y = 0 that looks along +z."}));
        break;
    default:
        break;
    }
    object.finish();
    return mesh;
}

BodyMotion read_motion(JsonObject object, std::span<const std::string> path_names) {
    BodyMotion motion;
    motion.path = object.name({"path", "Name of a path of the scene's, to which the place is added."}, path_names, "paths");
    FieldReader fields(object);
    list_fields(fields, motion);
    read_part(object.object({"sway", "To and fro, by a sine."}), motion.sway);
    read_part(object.object({"hop", "Jumps on a parabola, one after another."}), motion.hop);
    object.finish();
    return motion;
}

Body read_body(JsonObject object, std::span<const std::string> path_names, const std::filesystem::path& folder) {
    Body body;
    body.name = object.text({"name", "For sentences."}, body.name);
    body.mesh = read_mesh(object.object({"mesh", "What it is made of. Default: a cube_sphere."}), folder);
    read_part(object.object({"place", "Where it is, or from where its path counts."}), body.place);
    body.motion = read_motion(object.object({"motion", "How it moves."}), path_names);
    body.skeleton = read_skeleton(object.object({"skeleton", "Bones that move the mesh."}));
    each(object, {"coats", "What it wears. A body without a coat is not seen."}, k_most_coats,
         [&](JsonObject item) { body.coats.push_back(read_coat(std::move(item), folder)); });
    object.finish();
    return body;
}

} // namespace

std::vector<Body> read_bodies(JsonObject& picture, std::span<const std::string> path_names, const std::filesystem::path& folder) {
    std::vector<Body> bodies;
    each(picture, {"bodies", "Things that stand or move and wear coats of shells: fur, feathers, grass, spikes, clouds."},
         k_most_bodies, [&](JsonObject item) { bodies.push_back(read_body(std::move(item), path_names, folder)); });
    return bodies;
}

std::vector<fur::Lamp> read_lamps(JsonObject& picture) {
    std::vector<fur::Lamp> lamps;
    each(picture, {"lamps", "Points of light beside the sun, which shine on coats and cast no shadow."}, fur::k_most_lamps,
         [&](JsonObject item) {
             fur::Lamp lamp;
             read_part(std::move(item), lamp);
             lamps.push_back(lamp);
         });
    return lamps;
}

} // namespace windrow::vegetation::program
