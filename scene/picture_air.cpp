#include "scene/picture_air.h"

#include "fluid/core/message.h"
#include "scene/setting_reader.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace windrow::scene {
namespace {

using detail::message;

/// Whether the path leads anywhere.
bool leads(const MotionPath& path) {
    const auto& points = path.points();
    return std::any_of(points.begin(), points.end(),
                       [&](const auto& point) { return glm::distance(point.position, points.front().position) > 1e-6; });
}

/// Whether something moves the air on that path already.
bool taken(const Scene& scene, std::size_t path) {
    const auto on_it = [&](const auto& one) { return one.path == path; };
    return !leads(scene.paths[path].path) || std::ranges::any_of(scene.carried, on_it) ||
           std::ranges::any_of(scene.obstacles, on_it) || std::ranges::any_of(scene.motors, [&](const SceneMotor& motor) {
               return on_it(motor) && std::holds_alternative<WakeMotor>(motor.motor);
           });
}

void add_body(Scene& scene, const PictureAir& picture, std::size_t n, ReadLog& log, MeshBoxReader meshes) {
    static const nlohmann::json k_default = nlohmann::json::object();
    const MovedBody& body = picture.bodies[n];
    if (!body.motion.path || !body.motion.wake || !body.furred || taken(scene, *body.motion.path))
        return;
    const std::string key = message("$.picture.bodies[", n, "]");
    const auto box =
        read_body_box(JsonObject(body.mesh != nullptr ? *body.mesh : k_default, key + ".mesh", "$.picture.bodies[].mesh", log),
                      scene.file.parent_path(), meshes);
    if (!box) {
        scene.warnings.push_back(message(scene.file.string(), ": ", key, ", ", body.name,
                                         ", has no wake, since its size is not known: ", box.error()));
        return;
    }
    const glm::vec3 size = body.place.scale * (box->high - box->low);
    const float width = body.motion.faces ? size.x : std::sqrt(size.x * size.z); // from any side, where it does not face its way
    scene.carried.push_back({.key = key,
                             .path = *body.motion.path,
                             .front = {width, size.y},
                             .middle_at = [place = body.place, motion = body.motion, ground = picture.ground,
                                           middle = glm::dvec3(0.5f * body.place.scale * (box->low + box->high))](
                                              const MotionPath& path, double time) {
                                 const BodyPose pose = pose_at(place, motion, &path, ground, time);
                                 return pose.position + pose.orientation * middle;
                             }});
}

void add_walker(Scene& scene, const PictureAir& picture, std::size_t n) {
    const Walker& walker = picture.walkers[n];
    if (!walker.wake || taken(scene, walker.path))
        return;
    const glm::vec2 front = walker.figure ? k_walker_front : glm::vec2(2.0f * walker.radius);
    scene.carried.push_back(
        {.key = message("$.picture.walkers[", n, "]"),
         .path = walker.path,
         .front = front,
         .middle_at = [walker, ground = picture.ground,
                       middle = glm::dvec3(0.0, 0.5 * static_cast<double>(front.y), 0.0)](const MotionPath& path, double time) {
             glm::dvec3 place = path.at(time);
             place.y = ground.height(place.x, place.z) + static_cast<double>(walker.foot_height(time));
             return place + middle;
         }});
}

void add_trees(Scene& scene, const PictureAir& picture, ReadLog& log) {
    std::size_t count = scene.drag.size();
    for (std::size_t n = 0; n < picture.trees.size(); ++n) {
        const StandSource& stand = picture.trees[n];
        if (!stand.slows_air)
            continue;
        const std::string key = message("picture.trees[", n, "]");
        count += stand.places.size() + static_cast<std::size_t>(stand.scatter.count);
        if (count > DragField::k_capacity) {
            log.reject("$." + key, message("makes ", count, " deposits of drag with what is before it, and the air takes ",
                                           DragField::k_capacity, ": give fewer trees, or \"slows_air\": false."));
            return;
        }
        scene.planted.push_back({.key = key, .stand = stand, .ground = picture.ground});
    }
}

} // namespace

PictureAir read_picture_air(JsonObject picture, std::span<const std::string> path_names, const std::filesystem::path& folder) {
    PictureAir read;
    read_ground(picture.object("ground"), read.ground, folder);
    read_items(picture, "walkers", {0.0, 256.0},
               [&](JsonObject item) { read_walker(std::move(item), read.walkers.emplace_back(), path_names); });
    read_items(picture, "bodies", {0.0, 64.0}, [&](JsonObject item) {
        MovedBody& body = read.bodies.emplace_back();
        body.name = item.text("name", body.name);
        read_object(item.object("place"), body.place);
        JsonObject motion = item.object("motion");
        read_settings(motion, body.motion, [&](const auto& row, auto& member) {
            if constexpr (std::same_as<decltype(member), std::optional<std::size_t>&>)
                member = motion.name({row.name, row.meaning}, path_names, "paths");
            return std::same_as<decltype(member), std::optional<std::size_t>&>;
        });
        motion.finish();
        const auto coats = item.value().find("coats");
        body.furred = coats != item.value().end() && coats->is_array() && !coats->empty();
        if (const auto mesh = item.value().find("mesh"); mesh != item.value().end())
            body.mesh = &*mesh;
    });
    read_items(picture, "trees", {0.0, 256.0}, [&](JsonObject item) { read_stand(std::move(item), read.trees.emplace_back()); });
    return read;
}

void add_picture_air(Scene& scene, const PictureAir& picture, ReadLog& log, MeshBoxReader meshes) {
    if (picture.ground.in_air && picture.ground.heights) {
        SceneObstacle& hills = scene.obstacles.emplace_back();
        hills.name = "ground";
        hills.obstacle.position = picture.ground.corner;
        hills.obstacle.shape = Ground{picture.ground.heights};
    }
    add_trees(scene, picture, log);
    for (std::size_t n = 0; n < picture.bodies.size(); ++n)
        add_body(scene, picture, n, log, meshes);
    for (std::size_t n = 0; n < picture.walkers.size(); ++n)
        add_walker(scene, picture, n);
}

} // namespace windrow::scene
