#include "vegetation/program/coat_reader.h"

#include "scene/scene_parts.h"
#include "vegetation/program/coat_fields.h"
#include "vegetation/program/field_reader.h"

namespace windrow::vegetation::program {
namespace {

void read_layers(JsonObject object, fur::CoatSettings& coat, FurSaid& said) {
    said.shells = object.value().contains("shells");
    said.length = object.value().contains("length");
    FieldReader fields(object);
    list_furs_fields(fields, coat.layers);
    list_fields(fields, coat.layers);
    read_part(object.object({"strand", "What the wind meets; its length is the layers'."}), coat.layers.strand);
    object.finish();
}

void read_strands(JsonObject object, fur::CoatSettings& coat, FurSaid& said) {
    said.thickness = object.value().contains("thickness");
    said.density = object.value().contains("density");
    FieldReader fields(object);
    list_furs_fields(fields, coat.strands);
    list_fields(fields, coat.strands);
    object.finish();
}

void read_maps(JsonObject object, fur::CoatMaps& maps, const std::filesystem::path& folder) {
    const auto name = [&](const Key& key, std::string& file) {
        if (windrow::scene::file_beside(object, key, folder))
            file = object.value()[key.name].get<std::string>();
    };
    name({"length", "Grey picture beside the scene: 0 bald to 1 whole."}, maps.length);
    name({"colour", "Picture beside the scene that multiplies root and tip."}, maps.colour);
    name({"noise_a", "One of two grey pictures that say in place of chance where strands are."}, maps.noise_a);
    name({"noise_b", "The other."}, maps.noise_b);
    FieldReader fields(object);
    list_fields(fields, maps);
    object.finish();
}

} // namespace

BodyCoat read_coat(JsonObject object, const std::filesystem::path& folder) {
    BodyCoat coat;
    fur::CoatSettings& settings = coat.settings;
    const std::size_t faults_before = object.log().faults();
    coat.material = object.text({"material", "Part of the mesh that wears it. Default: all of it."}, coat.material);
    FieldReader fields(object);
    list_fields(fields, settings);
    read_layers(object.object({"layers", "Where the layers lie and how the wind bends them."}), settings, coat.said);
    read_strands(object.object({"strands", "What each layer leaves open."}), settings, coat.said);
    read_part(object.object({"comb", "How strands lie at rest."}), settings.comb);
    each(object, {"spots", "Round brushes in the mesh's own space: inside, strands are shorter and coloured."}, fur::k_most_spots,
         [&](JsonObject item) {
             fur::Spot spot;
             read_part(std::move(item), spot);
             settings.spots.push_back(spot);
         });
    read_maps(object.object({"maps", "Pictures of length and colour."}), settings.maps, folder);
    read_part(object.object({"look", "Colours and light. Colours are linear."}), settings.look);
    read_part(object.object({"levels", "How many layers are drawn, and how."}), settings.levels);
    windrow::CascadeConfig inertia;
    read_part(object.object({"inertia", "How tips lag behind the body. Without it they move with it at once."}), inertia);
    if (object.value().contains("inertia"))
        settings.inertia = inertia;
    fur::CloudShellSettings cloud;
    read_part(
        object.object({"cloud", "Heaps of cloud in place of strands, the layers' length high; it is as large as the mesh."}),
        cloud);
    if (object.value().contains("cloud"))
        settings.cloud = cloud;
    object.finish();
    if (object.log().faults() == faults_before)
        note_refusals(fur::validate(settings), "coat.", object);
    return coat;
}

} // namespace windrow::vegetation::program
