#include "examples/meadow/picture_writer.h"

#include "examples/meadow/picture_fields.h"
#include "scene/number_text.h"

#include <charconv>
#include <cmath>

namespace meadow {
namespace {

using nlohmann::json;

json written(double value) {
    // Whole numbers as a person writes them: 30, not 30.0.
    if (value == std::trunc(value) && std::abs(value) < 1e15)
        return json(static_cast<std::int64_t>(value));
    return json(value);
}
json written(float value) {
    char digits[64];
    const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
    return written(windrow::scene::parse_number({digits, end}).value_or(static_cast<double>(value)));
}
template <int Count, class Number>
json written(const glm::vec<Count, Number, glm::defaultp>& values) {
    json list = json::array();
    for (int n = 0; n < Count; ++n)
        list.push_back(written(values[n]));
    return list;
}

class FieldWriter {
  public:
    void real(const char* key, float value, const NumberRule&) { object[key] = written(value); }
    void number(const char* key, double value, const NumberRule&) { object[key] = written(value); }
    void integer(const char* key, int value, const NumberRule&) { object[key] = value; }
    void whole(const char* key, std::uint32_t value, const NumberRule&) { object[key] = value; }
    void place(const char* key, glm::dvec3 value, const NumberRule&) { object[key] = written(value); }
    void colour(const char* key, glm::vec3 value) { object[key] = written(value); }
    void pair(const char* key, glm::dvec2 value, const NumberRule&, const char*) { object[key] = written(value); }
    void pair(const char* key, glm::vec2 value, const NumberRule&, const char*) { object[key] = written(value); }

    json object = json::object();
};

/// By value: the lists take what a reader may change.
template <class Part>
json write_part(Part part) {
    FieldWriter fields;
    list_fields(fields, part);
    return std::move(fields.object);
}

json write_camera(const CameraSource& camera, const windrow::scene::Scene& air) {
    json object = write_part(camera.lens);
    object["above_ground"] = camera.above_ground;
    if (camera.path)
        object["path"] = air.paths[*camera.path].name;
    else
        object["position"] = written(camera.lens.position);
    if (camera.target_path)
        object["target_path"] = air.paths[*camera.target_path].name;
    else
        object["target"] = written(camera.lens.target);
    return object;
}

json write_mask(const MaskSource& mask) {
    json object = json::object();
    if (mask.file.empty()) {
        object["corners"] = {mask.corners.x, mask.corners.y};
        object["even"] = written(mask.even);
    } else {
        object["file"] = mask.file;
    }
    object.update(write_part(mask.bare));
    object["path"] = write_part(mask.path);
    object["strokes"] = json::array();
    for (const Stroke& stroke : mask.strokes)
        object["strokes"].push_back({{stroke.erases ? "erase" : "paint", write_part(stroke.brush)}});
    return object;
}

json write_layer(const GrassLayer& layer) {
    json object = write_part(layer.settings.blade);
    object.update(write_part(layer.settings));
    object.update(write_part(layer));
    object["name"] = layer.name;
    object["class"] = layer.plant;
    object["stalk"] = write_part(layer.settings.blade.stalk);
    object["look"] = write_part(layer.look);
    object["mask"] = write_mask(layer.mask);
    return object;
}

json write_walker(const Walker& walker, const windrow::scene::Scene& air) {
    json object = write_part(walker);
    object["path"] = air.paths[walker.path].name;
    object["figure"] = walker.figure;
    object["airborne"] = json::array();
    for (const Jump& jump : walker.airborne)
        object["airborne"].push_back(
            {{"from", written(jump.from)}, {"until", written(jump.until)}, {"height", written(jump.height)}});
    return object;
}

json write_stand(const TreeStand& stand) {
    json object = write_part(stand);
    object["kind"] = stand.kind;
    object["springs"] = stand.springs;
    object["places"] = json::array();
    for (const StandPlace& place : stand.places)
        object["places"].push_back(write_part(place));
    object["scatter"] = write_part(stand.scatter);
    object["scatter"]["clear"] = json::array();
    for (const trees::ClearCircle& circle : stand.scatter.clear)
        object["scatter"]["clear"].push_back(write_part(circle));
    return object;
}

} // namespace

json write_picture(const PictureScene& scene) {
    const Picture& picture = scene.picture;
    json object = {{"size", {picture.size.x, picture.size.y}}, {"settle", written(picture.settle)}};
    if (picture.frames_per_second)
        object["frames_per_second"] = written(*picture.frames_per_second);
    object["camera"] = write_camera(picture.camera, scene.air);
    object["sun"] = write_part(picture.sun);
    object["fog"] = write_part(picture.fog);
    object["clouds"] = write_part(picture.clouds);
    object["ground"] = write_part(picture.ground);
    object["ground"]["hills"] = write_part(picture.ground.hills);
    if (!picture.ground.file.empty())
        object["ground"]["heights"] = picture.ground.file;
    object["grass"] = json::array();
    for (const GrassLayer& layer : picture.grass)
        object["grass"].push_back(write_layer(layer));
    object["trees"] = json::array();
    for (const TreeStand& stand : picture.trees)
        object["trees"].push_back(write_stand(stand));
    object["walkers"] = json::array();
    for (const Walker& walker : picture.walkers)
        object["walkers"].push_back(write_walker(walker, scene.air));
    object["fans"] = json::array();
    for (const Fan& fan : picture.fans)
        object["fans"].push_back(write_part(fan));
    if (picture.ground_memory) {
        object["ground_memory"] = write_part(*picture.ground_memory);
        object["ground_memory"]["spring"] = write_part(picture.ground_memory->spring);
    }
    object["sampling"] = write_part(picture.sampling);
    return object;
}

} // namespace meadow
