#include "vegetation/program/coat_reader.h"

#include "scene/file_beside.h"
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
    read_part(object.object("strand"), coat.layers.strand);
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
    const auto name = [&](const char* key, std::string& file) {
        if (windrow::scene::file_beside(object, key, folder))
            file = object.value()[key].get<std::string>();
    };
    name("length", maps.length);
    name("colour", maps.colour);
    name("noise_a", maps.noise_a);
    name("noise_b", maps.noise_b);
    FieldReader fields(object);
    list_fields(fields, maps);
    object.finish();
}

} // namespace

BodyCoat read_coat(JsonObject object, const std::filesystem::path& folder) {
    BodyCoat coat;
    fur::CoatSettings& settings = coat.settings;
    const std::size_t faults_before = object.log().faults();
    coat.material = object.text("material", coat.material);
    FieldReader fields(object);
    list_fields(fields, settings);
    read_layers(object.object("layers"), settings, coat.said);
    read_strands(object.object("strands"), settings, coat.said);
    read_part(object.object("comb"), settings.comb);
    each(object, "spots", fur::k_most_spots, [&](JsonObject item) {
        fur::Spot spot;
        read_part(std::move(item), spot);
        settings.spots.push_back(spot);
    });
    read_maps(object.object("maps"), settings.maps, folder);
    read_part(object.object("look"), settings.look);
    read_part(object.object("levels"), settings.levels);
    windrow::CascadeConfig inertia;
    read_part(object.object("inertia"), inertia);
    if (object.value().contains("inertia"))
        settings.inertia = inertia;
    fur::CloudShellSettings cloud;
    read_part(object.object("cloud"), cloud);
    if (object.value().contains("cloud"))
        settings.cloud = cloud;
    object.finish();
    if (object.log().faults() == faults_before)
        note_refusals(fur::validate(settings), "coat.", object);
    return coat;
}

} // namespace windrow::vegetation::program
