#include "vegetation/program/grass_reader.h"

#include "coupling/plant_classes.h"
#include "vegetation/program/field_reader.h"
#include "vegetation/program/mask_reader.h"
#include "vegetation/program/picture_fields.h"

namespace windrow::vegetation::program {
namespace {

constexpr std::size_t k_most_layers = 16;

constexpr PlantClass k_classes[] = {{"grass", &windrow::grass},
                                    {"wheat", &windrow::wheat},
                                    {"reed", &windrow::reed},
                                    {"leaf", &windrow::leaf},
                                    {"twig", &windrow::twig},
                                    {"branch", &windrow::branch},
                                    {"small_trunk", &windrow::small_trunk},
                                    {"large_trunk", &windrow::large_trunk}};

GrassLayer read_layer(JsonObject object, glm::vec2 extent, const std::filesystem::path& folder) {
    GrassLayer layer;
    const std::size_t faults_before = object.log().faults();
    std::vector<std::string> names;
    for (const PlantClass& known : k_classes)
        names.emplace_back(known.name);
    layer.name = object.text({"name", "For people."}, layer.name);
    if (const std::size_t chosen =
            object.word_index({"class", "The class of plant that length and stalk begin with."}, layer.plant, names);
        chosen < names.size()) {
        layer.plant = names[chosen];
        layer.settings.blade.stalk = k_classes[chosen].stalk();
    }
    FieldReader fields(object);
    list_fields(fields, layer.settings.blade);
    list_fields(fields, layer.settings);
    list_fields(fields, layer);
    read_part(
        object.object({"stalk", "What the wind bends, as far as it is not the class's. The defaults stated are those of grass."}),
        layer.settings.blade.stalk);
    JsonObject look =
        object.object({"look", "Colours are linear albedo. What comes back and what shines through, together, are at most 0.6."});
    FieldReader look_fields(look);
    list_fields(look_fields, layer.look);
    look.finish();
    layer.mask = read_mask(
        object.object({"mask", "Where the layer grows: alpha 0 is no blade, between 0 and 1 blades are as much smaller."}),
        extent, layer.settings.seed, folder);
    object.finish();
    if (object.log().faults() == faults_before) {
        note_refusals(grass::validate(layer.settings), "grass.", object);
        note_refusals(render::validate(layer.look), "look.", look);
    }
    return layer;
}

} // namespace

std::span<const PlantClass> plant_classes() {
    return k_classes;
}

std::vector<GrassLayer> read_grass(JsonObject& picture, glm::vec2 extent, const std::filesystem::path& folder) {
    std::vector<GrassLayer> layers;
    const auto items = picture.array({"grass", "Layers of blades."}, k_most_layers);
    for (std::size_t i = 0; i < items.size(); ++i)
        layers.push_back(read_layer(JsonObject(items[i], picture.path() + ".grass[" + std::to_string(i) + "]",
                                               picture.pattern() + ".grass[]", picture.log()),
                                    extent, folder));
    return layers;
}

} // namespace windrow::vegetation::program
