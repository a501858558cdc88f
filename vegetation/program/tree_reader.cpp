#include "vegetation/program/tree_reader.h"

#include "vegetation/program/field_reader.h"
#include "vegetation/program/picture_fields.h"
#include "vegetation/trees/tree_presets.h"

namespace windrow::vegetation::program {
namespace {

constexpr std::size_t k_most_stands = 256;
constexpr std::size_t k_most_places = 4096;

trees::TreeScatter read_scatter(JsonObject object) {
    trees::TreeScatter scatter;
    const std::size_t faults_before = object.log().faults();
    FieldReader fields(object);
    list_fields(fields, scatter);
    each(object, {"clear", "Circles where none stand."}, k_most_places, [&](JsonObject item) {
        trees::ClearCircle circle;
        read_part(std::move(item), circle);
        scatter.clear.push_back(circle);
    });
    object.finish();
    if (object.log().faults() == faults_before)
        note_refusals(trees::validate(scatter), "scatter.", object);
    return scatter;
}

TreeStand read_stand(JsonObject object) {
    TreeStand stand;
    std::vector<std::string> kinds;
    for (const std::string_view kind : trees::preset_names())
        kinds.emplace_back(kind);
    const std::size_t chosen = object.word_index({"kind", "Which trees."}, stand.kind, kinds);
    if (chosen < kinds.size())
        stand.kind = kinds[chosen];
    FieldReader fields(object);
    list_fields(fields, stand);
    stand.springs = object.boolean(
        {"springs", "Whether trunks, limbs and twigs swing; else they take the bend that the wind holds."}, stand.springs);
    each(object, {"places", "Trees at places of their own."}, k_most_places, [&](JsonObject item) {
        StandPlace place;
        read_part(std::move(item), place);
        stand.places.push_back(place);
    });
    stand.scatter = read_scatter(object.object({"scatter", "And more by chance."}));
    object.finish();
    return stand;
}

} // namespace

std::vector<TreeStand> read_trees(JsonObject& picture) {
    std::vector<TreeStand> stands;
    each(picture, {"trees", "Stands of trees."}, k_most_stands,
         [&](JsonObject item) { stands.push_back(read_stand(std::move(item))); });
    return stands;
}

} // namespace windrow::vegetation::program
