#include "vegetation/program/picture_writer.h"

#include "vegetation/program/body_writer.h"
#include "vegetation/program/coat_fields.h"
#include "vegetation/program/field_writer.h"
#include "vegetation/program/picture_fields.h"

namespace windrow::vegetation::program {
namespace {

using nlohmann::json;

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
    object["bodies"] = json::array();
    for (const Body& body : picture.bodies)
        object["bodies"].push_back(write_body(body, scene.air));
    object["lamps"] = json::array();
    for (const fur::Lamp& lamp : picture.lamps)
        object["lamps"].push_back(write_part(lamp));
    object["sampling"] = write_part(picture.sampling);
    return object;
}

} // namespace windrow::vegetation::program
