#include "vegetation/program/mask_reader.h"

#include "fluid/input_file.h"
#include "scene/json_document.h"
#include "scene/scene_parts.h"
#include "vegetation/program/field_reader.h"
#include "vegetation/program/picture_fields.h"

namespace windrow::vegetation::program {
namespace {

constexpr std::size_t k_most_strokes = 1024;

Stroke read_stroke(const nlohmann::json& value, const std::string& path, const std::string& pattern,
                   windrow::scene::ReadLog& log) {
    JsonObject object(value, path, pattern, log);
    Stroke stroke;
    const std::size_t kind = object.one_of({"paint", "erase"});
    stroke.erases = kind == 1;
    if (kind < 2)
        read_part(object.object(stroke.erases ? Key{"erase", "Takes it, down to 0."} : Key{"paint", "Adds alpha, up to 1."}),
                  stroke.brush);
    object.finish();
    return stroke;
}

windrow::Result<grass::PlacementMask> make_mask(const MaskSource& source, glm::vec2 extent, const std::filesystem::path* file,
                                                const std::filesystem::path& folder, windrow::detail::InputBudget& budget) {
    auto mask = file != nullptr ? read_pgm(*file, folder, extent, budget)
                                : grass::PlacementMask::create(source.corners, extent, source.even);
    if (!mask)
        return mask;
    if (const auto thinned = grass::thin_out(*mask, source.bare); !thinned)
        return windrow::Error{thinned.error()};
    if (const auto trodden = grass::tread(*mask, source.path); !trodden)
        return windrow::Error{trodden.error()};
    for (const Stroke& stroke : source.strokes)
        if (const auto touched = stroke.erases ? mask->erase(stroke.brush) : mask->paint(stroke.brush); !touched)
            return windrow::Error{touched.error()};
    return mask;
}

} // namespace

windrow::Result<grass::PlacementMask> read_pgm(const std::filesystem::path& file, const std::filesystem::path& folder,
                                               glm::vec2 extent, windrow::detail::InputBudget& budget) {
    const auto bytes =
        windrow::detail::read_input(file, {.folder = folder, .most_bytes = grass::PlacementMask::k_most_pgm_bytes}, budget);
    if (!bytes)
        return windrow::Error{bytes.error()};
    auto mask = grass::PlacementMask::from_pgm(*bytes, extent, file.string(), budget.memory_left() / sizeof(float));
    if (mask)
        if (auto taken = budget.take_memory(file.string(), mask->values().size_bytes()); !taken)
            return windrow::Error{taken.error()};
    return mask;
}

MaskSource read_mask(JsonObject object, glm::vec2 extent, std::uint32_t seed, const std::filesystem::path& folder) {
    MaskSource source;
    const std::size_t faults_before = object.log().faults();
    const auto file = windrow::scene::file_beside(object,
                                                  {"file", "Binary PGM of 8 or 16 bits in the scene's folder, named relative to "
                                                           "it, stretched over the ground. Default: an even alpha."},
                                                  folder);
    if (file)
        source.file = object.value()["file"].get<std::string>();
    source.corners = object.whole_pair({"corners", "Samples along x and z, without a file."}, source.corners,
                                       {.least = 2.0, .most = 4097.0}, "x, z");
    source.even = object.real({"even", "Alpha before the rest, without a file."}, source.even, k_share_rule);
    object.not_both("file", "corners");
    object.not_both("file", "even");
    FieldReader fields(object);
    list_fields(fields, source.bare);
    source.bare.seed = seed;
    read_part(object.object({"path", "A path on which it does not grow, winding along z."}), source.path);
    const auto items = object.array({"strokes", "Brushes upon it, in their order."}, k_most_strokes);
    for (std::size_t i = 0; i < items.size(); ++i)
        source.strokes.push_back(read_stroke(items[i], object.path() + ".strokes[" + std::to_string(i) + "]",
                                             object.pattern() + ".strokes[]", object.log()));
    object.finish();
    if (object.log().faults() != faults_before)
        return source;
    if (auto mask = make_mask(source, extent, file ? &*file : nullptr, folder, object.log().budget()))
        source.mask = *std::move(mask);
    else if (file)
        object.refuse("file", "is " + windrow::scene::quote_json(object.value()["file"]) + ": " + mask.error());
    else
        object.refuse("cannot be made: " + mask.error());
    return source;
}

} // namespace windrow::vegetation::program
