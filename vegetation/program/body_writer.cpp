#include "vegetation/program/body_writer.h"

#include "vegetation/program/body_fields.h"
#include "vegetation/program/field_writer.h"
#include "vegetation/program/skeleton_reader.h"

namespace windrow::vegetation::program {
namespace {

/// Names as one_of of the reader has them.
const char* name_of(const BodyMesh& mesh) {
    constexpr const char* k_names[] = {"file", "sheet", "globe_sphere", "cube_sphere", "wing", "beast"};
    static_assert(std::size(k_names) == std::variant_size_v<BodyMesh>);
    return k_names[mesh.index()];
}

json write_mesh(const BodyMesh& mesh) {
    json shape = std::visit([](const auto& one) { return write_part(one); }, mesh);
    if (const auto* file = std::get_if<MeshSource>(&mesh))
        shape["name"] = file->name;
    return {{name_of(mesh), std::move(shape)}};
}

json write_coat(const BodyCoat& coat, bool of_a_file) {
    const fur::CoatSettings& settings = coat.settings;
    json object = write_part(settings);
    object["material"] = coat.material;
    FieldWriter layers;
    windrow::ShellSettings shells = settings.layers;
    list_furs_fields(layers, shells);
    list_fields(layers, shells);
    object["layers"] = std::move(layers.object);
    object["layers"]["strand"] = write_part(settings.layers.strand);
    FieldWriter strands;
    fur::StrandFieldSettings field = settings.strands;
    list_furs_fields(strands, field);
    list_fields(strands, field);
    object["strands"] = std::move(strands.object);
    object["comb"] = write_part(settings.comb);
    object["spots"] = json::array();
    for (const fur::Spot& spot : settings.spots)
        object["spots"].push_back(write_part(spot));
    object["maps"] = write_part(settings.maps);
    const auto name = [&](const char* key, const std::string& file) {
        if (!file.empty())
            object["maps"][key] = file;
    };
    name("length", settings.maps.length);
    name("colour", settings.maps.colour);
    name("noise_a", settings.maps.noise_a);
    name("noise_b", settings.maps.noise_b);
    object["look"] = write_part(settings.look);
    object["levels"] = write_part(settings.levels);
    if (settings.inertia)
        object["inertia"] = write_part(*settings.inertia);
    if (settings.cloud)
        object["cloud"] = write_part(*settings.cloud);
    // What the mesh's own fur line says, the scene must not say.
    const auto drop = [&](const char* part, const char* key, bool said) {
        if (of_a_file && !said)
            object[part].erase(key);
    };
    drop("layers", "shells", coat.said.shells);
    drop("layers", "length", coat.said.length);
    drop("strands", "thickness", coat.said.thickness);
    drop("strands", "density", coat.said.density);
    return object;
}

json write_motion(const BodyMotion& motion, const windrow::scene::Scene& air) {
    json object = write_part(motion);
    if (motion.path)
        object["path"] = air.paths[*motion.path].name;
    object["sway"] = write_part(motion.sway);
    object["hop"] = write_part(motion.hop);
    return object;
}

} // namespace

json write_body(const Body& body, const windrow::scene::Scene& air) {
    json object = {{"name", body.name},
                   {"mesh", write_mesh(body.mesh)},
                   {"place", write_part(body.place)},
                   {"motion", write_motion(body.motion, air)},
                   {"skeleton", write_skeleton(body.skeleton)}};
    object["coats"] = json::array();
    for (const BodyCoat& coat : body.coats)
        object["coats"].push_back(write_coat(coat, std::holds_alternative<MeshSource>(body.mesh)));
    return object;
}

} // namespace windrow::vegetation::program
