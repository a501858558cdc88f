#include "vegetation/program/picture_writer.h"

#include "scene/setting_writer.h"

namespace windrow::vegetation::program {
namespace {

using nlohmann::json;
using windrow::scene::write_object;

void finish_mask(json& object, const MaskSource& mask) {
    if (!mask.file.empty()) {
        object.erase("corners");
        object.erase("even");
    }
    object["strokes"] = json::array();
    for (const Stroke& stroke : mask.strokes)
        object["strokes"].push_back({{stroke.erases ? "erase" : "paint", write_object(stroke.brush)}});
}

void finish_coat(json& object, const BodyCoat& coat, bool of_a_file) {
    object["layers"]["strand"].erase("length");
    // What the mesh's own fur line says, the scene must not say.
    const auto drop = [&](const char* part, const char* key, bool said) {
        if (of_a_file && !said)
            object[part].erase(key);
    };
    drop("layers", "shells", coat.said.shells);
    drop("layers", "length", coat.said.length);
    drop("strands", "thickness", coat.said.thickness);
    drop("strands", "density", coat.said.density);
}

} // namespace

json write_picture(const PictureScene& scene) {
    const Picture& picture = scene.picture;
    json object = write_object(picture);
    const auto name_path = [&](json& part, const char* key, std::optional<std::size_t> path) {
        if (path)
            part[key] = scene.air.paths[*path].name;
    };
    json& camera = object["camera"];
    name_path(camera, "path", picture.camera.path);
    name_path(camera, "target_path", picture.camera.target_path);
    if (picture.camera.path)
        camera.erase("position");
    if (picture.camera.target_path)
        camera.erase("target");
    for (std::size_t n = 0; n < picture.grass.size(); ++n) {
        json& layer = object["grass"][n];
        layer["length"] = layer["stalk"]["length"];
        layer["stalk"].erase("length");
        finish_mask(layer["mask"], picture.grass[n].mask);
    }
    for (std::size_t n = 0; n < picture.walkers.size(); ++n)
        name_path(object["walkers"][n], "path", picture.walkers[n].path);
    for (std::size_t n = 0; n < picture.bodies.size(); ++n) {
        const Body& body = picture.bodies[n];
        json& written = object["bodies"][n];
        name_path(written["motion"], "path", body.motion.path);
        for (std::size_t b = 0; b < body.skeleton.bones.size(); ++b)
            if (const int parent = body.skeleton.bones[b].parent; parent >= 0)
                written["skeleton"]["bones"][b]["parent"] = body.skeleton.bones[static_cast<std::size_t>(parent)].name;
        for (std::size_t c = 0; c < body.coats.size(); ++c)
            finish_coat(written["coats"][c], body.coats[c], std::holds_alternative<MeshSource>(body.mesh));
    }
    return object;
}

} // namespace windrow::vegetation::program
