#include "scene/scene_writer.h"

#include "fluid/core/message.h"
#include "fluid/wind.h"
#include "scene/scene.h"
#include "scene/scene_reader.h"
#include "scene/setting_writer.h"

#include <algorithm>
#include <array>
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

// What all levels take from the outermost wind, each when it is stepped.
constexpr std::array k_of_the_outermost{"ambient", "gusts"};

const WindControl& outermost_of(const WindControl& wind) {
    return wind.outer() ? outermost_of(*wind.outer()) : wind;
}

json written_air(const WindControl& wind) {
    const Config& config = wind.config();
    const glm::dvec3 centre = wind.origin() + 0.5 * glm::dvec3(wind.box().size());
    json air = write_object(config);
    const json outermost = write_object(outermost_of(wind).config());
    for (const char* const key : k_of_the_outermost) {
        air.erase(key);
        if (outermost.contains(key))
            air[key] = outermost[key];
    }
    air["centre"] = written(centre);
    air.erase("floor"); // a key of the scene
    return air;
}

// What stands and acts in a wind, under the keys of a scene.
Result<json> written_content(const WindControl& wind) {
    json content = json::object();
    for (const Motors::Slot& slot : wind.motors().slots()) {
        if (!slot.used)
            continue;
        if (std::holds_alternative<WakeMotor>(slot.motor))
            return Error{"a wake has a path in a scene, and the wind holds where it is now alone: remove the wake first."};
        content["motors"].push_back(written_motor(slot.motor));
    }
    for (const Obstacles::Slot& slot : wind.obstacles().slots()) {
        if (!slot.used)
            continue;
        if (std::visit([](const auto& shape) { return in_a_file(shape); }, slot.obstacle.shape))
            return Error{message("an obstacle is a ",
                                 std::visit([](const auto& shape) { return shape.k_name; }, slot.obstacle.shape),
                                 ": a scene names its file, which the wind has not: remove the obstacle first.")};
        content["obstacles"].push_back(write_object(slot.obstacle));
    }
    for (const DragField::Slot& slot : wind.drag().slots())
        if (slot.used)
            content["drag"].push_back(write_value(slot.deposit));
    return content;
}

// --- Winds around it: a scene gives each a box and ticks, and all else is that of the innermost -----------------------------------

constexpr int k_most_levels = 2;

Result<void> check_level(const Wind& level, const SceneLevel& own, const WindControl& inner) {
    Config expected = inner.config();
    expected.cells = own.cells;
    expected.cell_size = own.cell_size;
    expected.rows = own.rows;
    expected.blend_width = own.blend_width;
    expected.ticks = own.ticks;
    const json of_inner = write_object(expected), of_level = write_object(level.config());
    for (const auto& keys : {of_inner, of_level})
        for (const auto& [key, value] : keys.items())
            if (key != "centre" && key != "floor" &&
                std::find(k_of_the_outermost.begin(), k_of_the_outermost.end(), key) == k_of_the_outermost.end() &&
                (!of_inner.contains(key) || !of_level.contains(key) || of_inner[key] != of_level[key]))
                return Error{message("an outer wind has another ", key,
                                     " than the wind inside it, and a scene has one for all: "
                                     "give both the same.")};
    const glm::dvec3 middle = inner.origin() + 0.5 * glm::dvec3(inner.box().size()),
                     around = level.origin() + 0.5 * glm::dvec3(level.box().size());
    const double near = 0.501 * static_cast<double>(level.box().cell_size + inner.box().cell_size);
    const bool floor = expected.boundaries.y_low.solid();
    const double height = floor ? level.origin().y - inner.origin().y : around.y - middle.y;
    if (std::abs(around.x - middle.x) > near || std::abs(around.z - middle.z) > near || std::abs(height) > near)
        return Error{message("an outer wind is around ", around, " m and the wind inside it around ", middle,
                             " m, and a scene has one point for all: let both follow it.")};
    return {};
}

Result<void> check_content(const json& level, const json& inner) {
    for (const auto& [key, parts] : level.items())
        for (const json& part : parts)
            if (!inner.contains(key) || std::find(inner[key].begin(), inner[key].end(), part) == inner[key].end())
                return Error{message("an outer wind has ", key,
                                     " that the wind inside it has not, and a scene puts each into all "
                                     "levels: add them to both, or remove them.")};
    return {};
}

// The key `outer` of a wind's air; null without.
Result<json> written_outer(const WindControl& wind, const WindControl& inner, const json& content, int most) {
    if (!wind.outer())
        return json();
    if (most == 0)
        return Error{message("the box is inside more than ", k_most_levels, " winds: a scene has no more.")};
    const Wind& level = *wind.outer();
    const Config& config = level.config();
    const SceneLevel own{.cells = config.cells,
                         .cell_size = config.cell_size,
                         .rows = config.rows,
                         .blend_width = config.blend_width,
                         .ticks = config.ticks};
    if (auto same = check_level(level, own, inner); !same)
        return same.failure();
    const auto its = written_content(level);
    if (!its)
        return its;
    if (auto held = check_content(*its, content); !held)
        return held.failure();
    json object = write_object(own);
    auto beyond = written_outer(level, inner, content, most - 1);
    if (!beyond)
        return beyond;
    if (!beyond->is_null())
        object["outer"] = *std::move(beyond);
    return object;
}

} // namespace

Result<std::string> write_scene(const WindControl& wind, const WrittenScene& times, const std::filesystem::path& file) {
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
        auto content = written_content(wind);
        if (!content)
            return content.failure();
        auto outer = written_outer(wind, wind, *content, k_most_levels);
        if (!outer)
            return outer.failure();
        if (!outer->is_null())
            scene["air"]["outer"] = *std::move(outer);
        scene.update(*content);
        std::string text = scene.dump(2) + "\n";
        if (const auto read = read_scene_text(text, file); !read) // what a wind may have and a scene may not
            return read.failure();
        return text;
    });
}

} // namespace windrow::scene
