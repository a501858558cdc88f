// What a hand does to a meadow, in the scene's own words: a stroke is a path, a wake on it and walkers; a blast is a motor; paint is
// strokes of a brush on the mask of a layer. So a saved scene has it, at its own time.
#include "coupling/ground_config.h"
#include "fluid/core/message.h"
#include "fluid/motors.h"
#include "scene/carried.h"
#include "scene/setting_writer.h"
#include "vegetation/view/session.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

namespace windrow::vegetation::view {
namespace {

using detail::message;

constexpr double k_elsewhere = 1e6;          // [m] where a walker is who does not press: beyond any ground's memory
constexpr int k_teeth = 7;                   // of a comb
constexpr std::size_t k_most_walkers = 256;  // of a scene file
constexpr std::size_t k_most_brushes = 1024; // the same, of a layer

scene::PathPoint far_from(glm::dvec3 place, double time) {
    return {.time = time, .position = place + glm::dvec3(k_elsewhere, 0.0, 0.0)};
}

nlohmann::json json_of(const scene::MotionPath& path) {
    nlohmann::json points = nlohmann::json::array();
    for (const scene::PathPoint& point : path.points())
        points.push_back({point.time, point.position.x, point.position.y, point.position.z});
    return {{"points", std::move(points)}};
}

} // namespace

Result<std::size_t> Session::add_moment(scene::SceneMotor motor) {
    if (scene_->air.motors.size() >= Motors::k_capacity)
        return Error{message("the scene has ", Motors::k_capacity, " motors, the most that it takes: remove one.")};
    scene_->air.motors.push_back(std::move(motor));
    motor_changed_.push_back(true);
    motor_removed_.push_back(false);
    motor_of_moment_.push_back(true);
    take_appended();
    return scene_->air.motors.size() - 1;
}

Result<std::size_t> Session::blast(glm::dvec3 place, float radius, float speed) {
    if (auto can = can_change(); !can)
        return can.failure();
    const PressureMotor burst{.position = place + glm::dvec3(0.0, 0.4 * static_cast<double>(radius), 0.0),
                              .radius = radius,
                              .speed = speed,
                              .duration = 0.3f};
    if (auto valid = validate(Motor(burst)); !valid)
        return valid.failure();
    return add_moment({.name = message("blast ", motors().size() + 1), .motor = burst, .path = {}, .from = time()});
}

Result<std::size_t> Session::gust(const DirectionalMotor& motor) {
    if (auto can = can_change(); !can)
        return can.failure();
    if (auto valid = validate(Motor(motor)); !valid)
        return valid.failure();
    return add_moment({.name = message("gust ", motors().size() + 1), .motor = motor, .path = {}, .from = time()});
}

Result<void> Session::begin_stroke(Hand hand, glm::dvec3 place, float radius) {
    if (auto can = can_change(); !can)
        return can;
    const std::size_t teeth = hand == Hand::comb ? k_teeth : 1;
    if (scene_->picture.walkers.size() + teeth > k_most_walkers)
        return Error{message("the scene has ", scene_->picture.walkers.size(), " walkers and takes ", k_most_walkers,
                             ": save it, and open what was saved without some of them.")};
    if (!scene_->picture.ground_memory) {
        scene_->picture.ground_memory.emplace();
        if (auto remembers = player_->change({.ground_memory = true}); !remembers)
            return remembers;
        document_["picture"]["ground_memory"] = nlohmann::json::object();
    }
    stroke_ = StrokeNow{.hand = hand, .radius = radius, .place = place};
    return {};
}

void Session::stroke_to(glm::dvec3 place) {
    if (stroke_)
        stroke_->place = place;
}

Result<void> Session::begin_teeth() {
    StrokeNow& stroke = *stroke_;
    const auto taken = [&](const std::string& name) {
        return std::any_of(scene_->air.paths.begin(), scene_->air.paths.end(),
                           [&](const auto& path) { return path.name == name || path.name.rfind(name + " tooth", 0) == 0; });
    };
    do
        stroke.name = message("stroke ", ++strokes_made_);
    while (taken(stroke.name));
    const bool combs = stroke.hand == Hand::comb;
    const double before = time() - 0.25 / scene_->air.frame_times().step_hz();
    const float texel = scene_->picture.ground_memory->texel_size;
    for (int tooth = 0; tooth < (combs ? k_teeth : 1); ++tooth) {
        std::vector<scene::PathPoint> points;
        if (before > 0.0)
            points.push_back(far_from(stroke.place, before));
        points.push_back({.time = time(), .position = stroke.place});
        stroke.paths.push_back(scene_->air.paths.size());
        scene_->air.paths.push_back({.name = combs ? message(stroke.name, " tooth ", tooth + 1) : stroke.name,
                                     .path = scene::MotionPath(std::move(points))});
        scene_->picture.walkers.push_back({.path = stroke.paths.back(),
                                           .radius = combs ? texel : stroke.radius,
                                           .weight = 1.0f,
                                           .airborne = {},
                                           .figure = false,
                                           .wake = false});
    }
    WakeMotor wake = scene::wake_of(glm::vec2(2.0f * stroke.radius), scene_->air.air.cell_size);
    const std::size_t middle = stroke.paths[stroke.paths.size() / 2];
    const auto added = add_moment({.name = stroke.name, .motor = wake, .path = middle, .from = time()});
    if (!added)
        return added.failure();
    stroke.motor = *added;
    return {};
}

Result<void> Session::move_hand(double end) {
    if (!stroke_)
        return {};
    if (stroke_->paths.empty())
        if (auto begun = begin_teeth(); !begun) {
            stroke_.reset();
            return begun;
        }
    StrokeNow& stroke = *stroke_;
    const auto& middle = scene_->air.paths[stroke.paths[stroke.paths.size() / 2]].path.points();
    if (end <= middle.back().time + 1e-12)
        return {};
    glm::dvec3 way = stroke.place - middle.back().position;
    way.y = 0.0;
    if (glm::length(way) > 1e-3)
        stroke.way = glm::normalize(way);
    const glm::dvec3 across(-stroke.way.z, 0.0, stroke.way.x);
    const double apart = 0.5 * static_cast<double>(scene_->picture.ground_memory->texel_size);
    const double first = 0.5 * static_cast<double>(stroke.paths.size() - 1);
    for (std::size_t tooth = 0; tooth < stroke.paths.size(); ++tooth) {
        scene::MotionPath& path = scene_->air.paths[stroke.paths[tooth]].path;
        std::vector<scene::PathPoint> points = path.points();
        points.push_back({.time = end, .position = stroke.place + apart * (static_cast<double>(tooth) - first) * across});
        path = scene::MotionPath(std::move(points));
    }
    return {};
}

Result<void> Session::end_stroke() {
    if (!stroke_)
        return {};
    const StrokeNow stroke = *std::exchange(stroke_, std::nullopt);
    if (stroke.paths.empty())
        return Error{"the hand moves air and grass while the scene plays: press Space."};
    scene_->air.motors[stroke.motor].until = time();
    for (const std::size_t tooth : stroke.paths) {
        scene::ScenePath& path = scene_->air.paths[tooth];
        std::vector<scene::PathPoint> points = path.path.points();
        points.push_back(far_from(stroke.place, points.back().time + 0.25 / scene_->air.frame_times().step_hz()));
        path.path = scene::MotionPath(std::move(points));
        document_["paths"][path.name] = json_of(path.path);
    }
    for (std::size_t n = scene_->picture.walkers.size() - stroke.paths.size(); n < scene_->picture.walkers.size(); ++n) {
        const scene::Walker& walker = scene_->picture.walkers[n];
        document_["picture"]["walkers"].push_back({{"path", scene_->air.paths[walker.path].name},
                                                   {"radius", scene::written(walker.radius)},
                                                   {"figure", false},
                                                   {"wake", false}});
    }
    return {};
}

float Session::finest_brush(std::size_t layer) const {
    const glm::vec2 spacing = scene_->picture.grass.at(layer).mask.mask->grid().spacing;
    return 1.5f * std::max(spacing.x, spacing.y);
}

Result<void> Session::paint(std::size_t layer, glm::dvec3 place, float radius, bool erases) {
    if (auto can = can_change(); !can)
        return can;
    auto& layers = scene_->picture.grass;
    if (layer >= layers.size())
        return Error{"the scene has no grass to paint: give it a layer in $.picture.grass."};
    const glm::dvec3 from_corner = place - scene_->picture.ground.corner;
    grass::Brush brush{.centre = {from_corner.x, from_corner.z}, .radius = radius, .strength = 0.5f};
    auto& drawn = document_["picture"]["grass"]; // a draft draws some of them
    for (std::size_t n = erases ? 0 : layer; n < (erases ? drawn.size() : layer + 1); ++n) {
        if (n < layers.size()) {
            auto& mask = layers[n].mask;
            if (mask.strokes.size() >= k_most_brushes)
                return Error{message("$.picture.grass[", n, "].mask has ", k_most_brushes,
                                     " strokes, the most that a scene takes: paint a map instead (mask.file).")};
            brush.radius = std::max(radius, finest_brush(n));
            const auto touched = erases ? mask.mask->erase(brush) : mask.mask->paint(brush);
            if (!touched)
                return touched.failure();
            mask.strokes.push_back({.erases = erases, .brush = brush});
            if (auto painted = player_->repaint(n, *touched); !painted)
                return painted;
        }
        drawn[n]["mask"]["strokes"].push_back({{erases ? "erase" : "paint", scene::write_object(brush)}});
    }
    return {};
}

Result<void> Session::end_painting() {
    return player_->change({.look = true});
}

} // namespace windrow::vegetation::view
