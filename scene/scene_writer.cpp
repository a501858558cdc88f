#include "scene/scene_writer.h"

#include "fluid/core/message.h"
#include "scene/scene.h"
#include "scene/setting_writer.h"

#include <cmath>
#include <glm/vector_relational.hpp>

namespace windrow::scene {
namespace {

using detail::message;
using nlohmann::json;

constexpr bool in_a_file(const auto&) {
    return false;
}
constexpr bool in_a_file(const MeshShape&) {
    return true;
}
constexpr bool in_a_file(const VoxelShape&) {
    return true;
}
constexpr bool in_a_file(const Ground&) {
    return true;
}

json written_motor(const Motor& motor) {
    return std::visit(
        [](const auto& kind) {
            json object = write_object(kind);
            object["kind"] = kind.k_name;
            if (object.contains("envelope") && !object["envelope"].contains("hold"))
                object["envelope"].erase("decay"); // it never begins
            return object;
        },
        motor);
}

json written_air(const WindControl& wind) {
    const Config& config = wind.config();
    const glm::dvec3 centre = wind.origin() + 0.5 * glm::dvec3(wind.box().size());
    json air = write_object(config);
    air["centre"] = written(centre);
    air.erase("floor"); // a key of the scene
    return air;
}

} // namespace

Result<std::string> write_scene(const WindControl& wind, const WrittenScene& times) {
    return detail::where_memory_lasts([&]() -> Result<std::string> {
        const Config& config = wind.config();
        if (config.roughness && config.roughness->map)
            return Error{"roughness.map: a scene names a picture of it, and the wind has none: leave it out."};
        json scene{{"duration", written(times.duration)},
                   {"tick_hz", written(times.tick_hz)},
                   {"frames_per_second", written(times.frames_per_second)},
                   {"air", written_air(wind)}};
        if (config.boundaries.y_low.solid())
            scene["floor"] = written(wind.origin().y);
        const Boundaries& sides = config.boundaries;
        const auto open = [](const Boundary& low, const Boundary& high) {
            return low.kind == BoundaryKind::open && high.kind == BoundaryKind::open;
        };
        const glm::bvec3 follows = config.follow_axes.value_or(
            glm::bvec3(open(sides.x_low, sides.x_high), open(sides.y_low, sides.y_high), open(sides.z_low, sides.z_high)));
        if (glm::any(follows))
            scene["follow"] = scene["air"]["centre"];
        for (const Motors::Slot& slot : wind.motors().slots()) {
            if (!slot.used)
                continue;
            if (std::holds_alternative<WakeMotor>(slot.motor))
                return Error{"a wake has a path in a scene, and the wind holds where it is now alone: remove the wake first."};
            scene["motors"].push_back(written_motor(slot.motor));
        }
        for (const Obstacles::Slot& slot : wind.obstacles().slots()) {
            if (!slot.used)
                continue;
            if (std::visit([](const auto& shape) { return in_a_file(shape); }, slot.obstacle.shape))
                return Error{message("an obstacle is a ",
                                     std::visit([](const auto& shape) { return shape.k_name; }, slot.obstacle.shape),
                                     ": a scene names its file, which the wind has not: remove the obstacle first.")};
            scene["obstacles"].push_back(write_object(slot.obstacle));
        }
        for (const DragField::Slot& slot : wind.drag().slots())
            if (slot.used)
                scene["drag"].push_back(write_value(slot.deposit));
        return scene.dump(2) + "\n";
    });
}

} // namespace windrow::scene
