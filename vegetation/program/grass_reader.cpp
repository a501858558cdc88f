// Layers of grass, each with its class of plant, its field, its look and its mask: a picture or an even alpha, bare patches, a path,
// and strokes upon it.
#include "coupling/plant_classes.h"
#include "fluid/files/input_file.h"
#include "scene/json_document.h"
#include "vegetation/program/part_reader.h"

namespace windrow::vegetation::program {
namespace {

/// Those of coupling/plant_classes.h, by its functions' names, and how they swing. A wind twists blades and leaves, not round stems.
constexpr struct {
    const char* name;
    windrow::Drag (*stalk)();
    windrow::SpringClass spring;
    float twist = 0.0f;
} k_classes[] = {{"grass", &windrow::grass, render::GrassLayerSettings{}.spring, windrow::BladeSettings{}.twist},
                 {"wheat", &windrow::wheat, windrow::springs::wheat},
                 {"reed", &windrow::reed, windrow::springs::reed},
                 {"leaf", &windrow::leaf, windrow::springs::leaf, windrow::BladeSettings{}.twist},
                 {"twig", &windrow::twig, windrow::springs::twig},
                 {"branch", &windrow::branch, windrow::springs::branch},
                 {"small_trunk", &windrow::small_trunk, windrow::springs::branch},
                 {"large_trunk", &windrow::large_trunk, windrow::springs::trunk}};

void read_stroke(JsonObject object, Stroke& stroke) {
    const std::size_t kind = object.one_of({"paint", "erase"});
    stroke.erases = kind == 1;
    if (kind < 2)
        read_object(object.object(stroke.erases ? Key{"erase", "Takes it, down to 0."} : Key{"paint", "Adds alpha, up to 1."}),
                    stroke.brush);
    object.finish();
}

windrow::Result<grass::PlacementMask> make_mask(const MaskSource& source, const std::filesystem::path* file,
                                                const Surroundings& around, windrow::detail::InputBudget& budget) {
    auto mask = file != nullptr ? read_pgm(*file, around, around.extent, budget)
                                : grass::PlacementMask::create(source.corners, around.extent, source.even);
    if (!mask)
        return mask;
    if (const auto thinned = grass::thin_out(*mask, source.bare); !thinned)
        return thinned.failure();
    if (const auto trodden = grass::tread(*mask, source.path); !trodden)
        return trodden.failure();
    for (const Stroke& stroke : source.strokes)
        if (const auto touched = stroke.erases ? mask->erase(stroke.brush) : mask->paint(stroke.brush); !touched)
            return touched.failure();
    return mask;
}

} // namespace

windrow::Result<grass::PlacementMask> read_pgm(const std::filesystem::path& file, const Surroundings& around, glm::vec2 extent,
                                               windrow::detail::InputBudget& budget) {
    const auto bytes =
        windrow::detail::read_input(file, {.folder = around.folder, .max_bytes = grass::PlacementMask::k_max_pgm_bytes}, budget);
    if (!bytes)
        return bytes.failure();
    auto mask = grass::PlacementMask::from_pgm(*bytes, extent, file.string(), budget.memory_left() / sizeof(float));
    if (mask)
        if (auto taken = budget.take_memory(file.string(), mask->values().size_bytes()); !taken)
            return taken.failure();
    return mask;
}

void read_part(JsonObject object, MaskSource& source, Surroundings& around) {
    const std::size_t faults_before = object.log().faults();
    std::optional<std::filesystem::path> file;
    read_parts(object, source, around, [&](const auto& row, auto& member) {
        if constexpr (std::same_as<decltype(member), std::string&>)
            file = read_file(object, {row.name, row.meaning}, member, around);
        return std::same_as<decltype(member), std::string&>;
    });
    object.not_both("file", "corners");
    object.not_both("file", "even");
    read_items(object, {"strokes", "Brushes upon it, in their order."}, {0.0, 1024.0},
               [&](JsonObject item) { read_stroke(std::move(item), source.strokes.emplace_back()); });
    object.finish();
    if (object.log().faults() != faults_before)
        return;
    if (auto mask = make_mask(source, file ? &*file : nullptr, around, object.log().budget()))
        source.mask = *std::move(mask);
    else if (file)
        object.reject("file", "is " + windrow::scene::quote_json(object.value()["file"]) + ": " + mask.error());
    else
        object.reject("cannot be made: " + mask.error());
}

void read_part(JsonObject object, GrassSource& layer, Surroundings& around) {
    const std::size_t faults_before = object.log().faults();
    read_parts(object, layer, around, [&](const auto& row, auto& member) {
        using Member = std::remove_cvref_t<decltype(member)>;
        const Key key{row.name, row.meaning};
        if constexpr (std::same_as<Member, std::string>) {
            if (key.name != std::string_view("class"))
                return false;
            std::vector<std::string> names;
            for (const auto& known : k_classes)
                names.emplace_back(known.name);
            if (const std::size_t chosen = object.word_index(key, member, names); chosen < names.size()) {
                member = names[chosen];
                layer.drawn.field.blade.stalk = k_classes[chosen].stalk();
                layer.drawn.spring = k_classes[chosen].spring;
                layer.drawn.field.blade.twist = k_classes[chosen].twist;
            }
            return true;
        } else if constexpr (std::same_as<Member, windrow::Drag>) { // the layer has its length
            read_settings(object, member, [](const auto& of, const auto&) { return of.name != std::string_view("length"); });
            read_stalk(object.object(key), member);
            return true;
        } else if constexpr (std::same_as<Member, MaskSource>) {
            member.bare.seed = layer.drawn.field.seed;
        }
        return false;
    });
    object.finish();
    if (object.log().faults() == faults_before)
        check_read(object, layer.drawn);
}

void read_stalk(JsonObject object, windrow::Drag& stalk) {
    read_settings(object, stalk, [](const auto& of, const auto&) { return of.name == std::string_view("length"); });
    object.finish();
}

} // namespace windrow::vegetation::program
