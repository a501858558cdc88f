#include "scene/scene_air.h"

#include "fluid/core/archive.h"
#include "fluid/core/message.h"
#include "fluid/timed_path.h"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

namespace windrow::scene {
namespace {

using detail::message;

constexpr detail::Format k_format{.letters = "WINDSCEN",
                                  .version = detail::Layout("clock, floor, motors, obstacles, wakes 1").version(),
                                  .name = "state of a scene",
                                  .writer = "SceneAir::save"};

Motor moved(const Motor& motor, glm::dvec3 position) {
    Motor result = motor;
    std::visit([&](auto& kind) { kind.position = position; }, result);
    return result;
}

/// Mean strength between two ages [s].
double strength_of(const Motor& motor, double from, double to) {
    return std::visit(
        [&](const auto& kind) {
            if constexpr (requires { kind.envelope; })
                return kind.envelope.mean(from, to);
            else
                return kind.mean(from, to);
        },
        motor);
}

// [m] Height of the equal rows above the floor: those of the law, or of a list the first.
double equal_rows(const Rows& rows) {
    const std::vector<float>& heights = rows.heights;
    if (heights.empty())
        return rows.uniform * static_cast<double>(rows.first);
    std::size_t equal = 1;
    while (equal < heights.size() && heights[equal] - heights[equal - 1] <= 2.02f * heights[0])
        ++equal;
    return 2.0 * static_cast<double>(equal) * static_cast<double>(heights[0]);
}

// [m] Of the region in which it acts.
float width_of(const Motor& motor) {
    const auto of_round = []<class Round>(const Round& round) {
        if constexpr (requires { round.end_radius; })
            return 2.0f * std::max(round.start_radius, round.end_radius);
        else
            return 2.0f * round.radius;
    };
    const auto of_region = [&]<class Kind>(const Kind& region) {
        if constexpr (std::same_as<Kind, AlignedBox>)
            return 2.0f * std::min({region.half_size.x, region.half_size.y, region.half_size.z});
        else
            return of_round(region);
    };
    return std::visit(
        [&](const auto& kind) {
            if constexpr (requires { kind.region; })
                return std::visit(of_region, kind.region);
            else
                return of_round(kind);
        },
        motor);
}

// [m] The second of its three: how wide a tall tower is, how high a long wall.
float width_of(const Shape& shape) {
    const glm::vec3 half = detail::half_extent(shape);
    return 2.0f * std::max(std::min(half.x, half.y), std::min(std::max(half.x, half.y), half.z));
}

} // namespace

SceneAir::SceneAir(const Scene& scene)
    : scene_(&scene), state_(state_of_begin()), cell_size_(scene.air.cell_size),
      rows_(scene.air.rows ? &*scene.air.rows : nullptr) {}

SceneAir::SceneAir(const Scene& scene, std::size_t level) : SceneAir(scene) {
    const SceneLevel& own = scene.outer.at(level);
    cell_size_ = least_ = own.cell_size;
    rows_ = own.rows ? &*own.rows : nullptr;
    levels_played_ = true;
}

SceneAir SceneAir::within(const Scene& scene) {
    SceneAir air(scene);
    air.levels_played_ = true;
    return air;
}

SceneAir::State SceneAir::state_of_begin() const {
    State state;
    state.motors.resize(scene_->motors.size());
    state.obstacles.resize(scene_->obstacles.size());
    state.wakes.resize(scene_->carried.size());
    return state;
}

SceneAir::State SceneAir::State::unowned() const {
    State state = *this;
    for (MovedMotor& motor : state.motors)
        motor.id = motor.id.unowned();
    for (ObstacleId& id : state.obstacles)
        id = id.unowned();
    for (MotorId& id : state.wakes)
        id = id.unowned();
    return state;
}

void SceneAir::take_appended() {
    state_.motors.resize(scene_->motors.size());
    state_.obstacles.resize(scene_->obstacles.size());
}

void SceneAir::restore(const State& state) {
    state_ = state;
    take_appended();
}

Result<void> SceneAir::begin(WindControl& wind) {
    if (!scene_->outer.empty() && !levels_played_)
        return Error{message(scene_->file.string(),
                             ": $.air.outer is a wind around the box, which is not played here: use windrow "
                             "run, windrow view or windrow-draw, or remove it.")};
    state_ = state_of_begin();
    if (auto placed = place_box(wind, 0.0); !placed)
        return placed;
    if (auto placed = place_obstacles(wind.obstacles(), 0.0); !placed)
        return placed;
    if (const auto added = wind.drag().add(scene_->drag); !added)
        return rejection("drag", 0.0, added.error());
    for (const PlantedStand& planted : scene_->planted)
        if (const auto added = wind.drag().add(drag_of(planted.stand, planted.ground)); !added)
            return rejection(planted.key.c_str(), 0.0, added.error());
    // Air that was filled in before the floor stood where it belongs has the wind of other heights.
    wind.reset();
    return {};
}

Result<void> SceneAir::advance_to(WindControl& wind, double end) {
    if (auto placed = place(wind, end); !placed)
        return placed;
    state_.steps += end > state_.time ? 1 : 0;
    state_.time = end;
    return {};
}

Result<void> SceneAir::warm_up(WindControl& wind, double seconds, double hz, const Step& step) {
    for (auto left = static_cast<std::int64_t>(std::ceil(seconds * hz)); left > 0; --left) {
        if (auto placed = place(wind, state_.time); !placed)
            return placed;
        if (auto stepped = step(1.0 / hz, left - 1); !stepped)
            return stepped;
    }
    return {};
}

Result<void> SceneAir::place(WindControl& wind, double end) {
    if (auto placed = place_box(wind, end); !placed)
        return placed;
    if (auto placed = place_motors(wind.motors(), end); !placed)
        return placed;
    if (auto placed = place_obstacles(wind.obstacles(), end); !placed)
        return placed;
    return place_wakes(wind.motors(), end);
}

Result<void> SceneAir::place_box(WindControl& wind, double time) {
    if (!std::holds_alternative<std::monostate>(scene_->follow))
        if (const auto followed = wind.follow(scene_->followed_point(time)); !followed)
            return rejection("follow", time, followed.error());
    if (!scene_->has_floor())
        return {};
    // Rows of their own interpolate the air where they move: they stay while the ground is among the lower half of the equal ones.
    const double wanted = scene_->floor_height(time);
    const double stays = rows_ != nullptr ? 0.5 * equal_rows(*rows_) : 0.0;
    if (state_.floor && wanted >= *state_.floor && wanted < *state_.floor + stays)
        return {};
    if (const auto placed = wind.set_floor(wanted); !placed)
        return rejection("floor", time, placed.error());
    state_.floor = wanted;
    return {};
}

std::vector<SceneAir::ActingMotor> SceneAir::acting(const Motors& motors) const {
    const double time = state_.time;
    std::vector<ActingMotor> result;
    for (std::size_t i = 0; i < scene_->motors.size(); ++i) {
        const SceneMotor& motor = scene_->motors[i];
        const MovedMotor& part = state_.motors[i];
        if (time < motor.from || time >= motor.until || (part.begun && motors.find(part.id) == nullptr))
            continue;
        const double age = part.begun ? time - part.since : 0.0;
        result.push_back({&motor, motor.path ? moved(motor.motor, scene_->paths[*motor.path].path.at(time)) : motor.motor,
                          strength_of(motor.motor, age, age + 1.0 / scene_->tick_hz)});
    }
    return result;
}

std::vector<SceneAir::StandingObstacle> SceneAir::standing(double time) const {
    std::vector<StandingObstacle> result;
    for (const SceneObstacle& body : scene_->obstacles)
        if (body.from <= time && time < body.until)
            result.push_back({&body, obstacle_at(body, time)});
    return result;
}

bool SceneAir::StandingObstacle::blocks(glm::dvec3 from, glm::dvec3 to) const {
    const auto reach = static_cast<double>(glm::length(detail::half_extent(now.shape)));
    if (glm::distance(from, now.position) > reach + glm::distance(from, to))
        return false;
    const glm::quat to_own = glm::conjugate(glm::normalize(now.orientation));
    const glm::vec3 begin = to_own * glm::vec3(from - now.position), end = to_own * glm::vec3(to - now.position);
    return detail::distance_to(now.shape, end) < 0.0f || detail::blocks(now.shape, begin, end);
}

MotorId SceneAir::motor(std::string_view name, const Motors& motors) const {
    for (std::size_t i = 0; i < scene_->motors.size(); ++i)
        if (scene_->motors[i].name == name && motors.find(state_.motors[i].id) != nullptr)
            return state_.motors[i].id;
    return {};
}

ObstacleId SceneAir::obstacle(std::string_view name, const Obstacles& obstacles) const {
    for (std::size_t i = 0; i < scene_->obstacles.size(); ++i)
        if (scene_->obstacles[i].name == name && obstacles.find(state_.obstacles[i]) != nullptr)
            return state_.obstacles[i];
    return {};
}

template <class Archive>
void SceneAir::pass(Archive& archive, auto& state) {
    const auto pass_id = [&](auto& id) { archive(id.slot, id.generation); }; // its owner is each process's own
    archive(state.time, state.steps, state.floor);
    for (auto& motor : state.motors) {
        pass_id(motor.id);
        archive(motor.begun, motor.since);
    }
    for (auto& id : state.obstacles)
        pass_id(id);
    for (auto& id : state.wakes)
        pass_id(id);
}

std::vector<std::byte> SceneAir::save() const {
    detail::Writer writer(64 + 32 * (state_.motors.size() + state_.obstacles.size() + state_.wakes.size()));
    writer(static_cast<std::uint32_t>(state_.motors.size()), static_cast<std::uint32_t>(state_.obstacles.size()),
           static_cast<std::uint32_t>(state_.wakes.size()));
    pass(writer, state_);
    return std::move(writer).finish(k_format);
}

Result<void> SceneAir::load(std::span<const std::byte> bytes) {
    const auto content = detail::unseal(bytes, k_format);
    if (!content)
        return content.failure();
    detail::Reader reader(*content);
    std::uint32_t motors = 0, obstacles = 0, wakes = 0;
    reader(motors, obstacles, wakes);
    State state = state_of_begin();
    if (motors != state.motors.size() || obstacles != state.obstacles.size() || wakes != state.wakes.size())
        return Error{message("the state of a scene is of ", motors, " motors, ", obstacles, " obstacles and ", wakes,
                             " wakes, but ", scene_->file.string(), " has ", state.motors.size(), ", ", state.obstacles.size(),
                             " and ", state.wakes.size(), ": load it with the scene that it was saved with.")};
    pass(reader, state);
    reader.end();
    if (reader.rejected())
        return Error{message("the state of a scene cannot be used: ", reader.reason())};
    state_ = std::move(state);
    return {};
}

Error SceneAir::rejection(const char* key, double time, const std::string& why) const {
    return Error{message(scene_->file.string(), ": $.", key, " at ", time, " s: ", why)};
}

Result<void> SceneAir::place_motors(Motors& motors, double end) {
    for (std::size_t i = 0; i < scene_->motors.size(); ++i) {
        MovedMotor& part = state_.motors[i];
        Result<void> placed;
        if (width_of(scene_->motors[i].motor) > least_)
            placed = place_motor(motors, scene_->motors[i], part, end);
        else if (motors.find(part.id) != nullptr) // a host has made it smaller
            placed = motors.remove(std::exchange(part, {}).id);
        if (!placed)
            return placed.failure().after(message(scene_->file.string(), ": $.motors[", i, "]: "));
    }
    return {};
}

Result<void> SceneAir::place_motor(Motors& motors, const SceneMotor& motor, MovedMotor& part, double end) {
    const double start = state_.time, middle = 0.5 * (start + end);
    const bool acts = motor.from <= middle && middle < motor.until;
    if (acts && !part.begun) {
        // A wake begins its path at the body's place at the tick's start, then moves like any other motor.
        const auto added = motors.add(motor.path ? moved(motor.motor, scene_->paths[*motor.path].path.at(start)) : motor.motor);
        if (!added)
            return added.failure();
        part = {.id = *added, .begun = true, .since = start};
    }
    if (motors.find(part.id) == nullptr)
        return {};
    if (!acts)
        return motors.remove(part.id);
    return motor.path ? motors.move(part.id, scene_->paths[*motor.path].path.at(end)) : Result<void>{};
}

Result<void> SceneAir::place_obstacles(Obstacles& obstacles, double end) {
    for (std::size_t i = 0; i < scene_->obstacles.size(); ++i) {
        ObstacleId& id = state_.obstacles[i];
        Result<void> placed;
        if (width_of(scene_->obstacles[i].obstacle.shape) > least_)
            placed = place_obstacle(obstacles, scene_->obstacles[i], id, end);
        else if (id != ObstacleId{}) // as above
            placed = obstacles.remove(std::exchange(id, {}));
        if (!placed)
            return placed.failure().after(message(scene_->file.string(), ": $.obstacles[", i, "]: "));
    }
    return {};
}

Result<void> SceneAir::place_obstacle(Obstacles& obstacles, const SceneObstacle& body, ObstacleId& id, double end) {
    const double start = state_.time, middle = 0.5 * (start + end);
    const bool is_there = body.from <= middle && middle < body.until;
    const bool removed = id != ObstacleId{} && obstacles.find(id) == nullptr; // by the host
    if (!is_there) {
        const ObstacleId had = std::exchange(id, {});
        return removed || had == ObstacleId{} ? Result<void>{} : obstacles.remove(had);
    }
    if (id == ObstacleId{}) {
        const auto added = obstacles.add(obstacle_at(body, start));
        if (!added)
            return added.failure();
        id = *added;
    }
    if (!body.moves() || removed)
        return {};
    const Obstacle then = obstacle_at(body, end);
    if (!body.turn_path && body.rpm == glm::dvec3(0.0))
        return obstacles.move(id, then.position);
    const glm::dvec3 spin = end > start ? turned(body, start, end) / (end - start) : glm::dvec3(0.0);
    return obstacles.move(id, then.position, then.orientation, glm::vec3(spin));
}

Result<void> SceneAir::place_wakes(Motors& motors, double end) {
    for (std::size_t i = 0; i < scene_->carried.size(); ++i) {
        const Carried& body = scene_->carried[i];
        const MotionPath& path = scene_->paths[body.path].path;
        MotorId& id = state_.wakes[i];
        if (std::min(body.front.x, body.front.y) <= least_)
            continue;
        if (id == MotorId{}) {
            WakeMotor wake = wake_of(body.front, cell_size_);
            wake.position = body.middle_at(path, state_.time);
            const auto added = motors.add(wake);
            if (!added)
                return added.failure().after(message(scene_->file.string(), ": ", body.key, ", its wake: "));
            id = *added;
        }
        if (motors.find(id) == nullptr) // removed by the host
            continue;
        if (auto moved = motors.move(id, body.middle_at(path, end)); !moved)
            return moved.failure().after(message(scene_->file.string(), ": ", body.key, ", its wake: "));
    }
    return {};
}

Obstacle SceneAir::obstacle_at(const SceneObstacle& body, double time) const {
    Obstacle obstacle = body.obstacle;
    if (body.path)
        obstacle.position = scene_->paths[*body.path].path.at(time);
    obstacle.orientation = glm::quat(orientation_at(body, time));
    if (body.pivot != glm::dvec3(0.0))
        obstacle.position -= glm::dquat(obstacle.orientation) * body.pivot;
    return obstacle;
}

glm::dquat SceneAir::orientation_at(const SceneObstacle& body, double time) const {
    const glm::dquat still(body.turn_path ? orientation_of(scene_->paths[*body.turn_path].path.at(time))
                                          : body.obstacle.orientation);
    const double rate = glm::length(body.rpm);
    if (!(rate > 0.0))
        return still;
    const double turns = rate * time / 60.0;
    return still * glm::angleAxis(2.0 * std::numbers::pi * (turns - std::floor(turns)), body.rpm / rate);
}

// By pieces that two orientations tell.
glm::dvec3 SceneAir::turned(const SceneObstacle& body, double start, double end) const {
    constexpr double k_piece = 60.0; // [degrees]
    double most = 6.0 * glm::length(body.rpm) * (end - start);
    if (body.turn_path) {
        const MotionPath& path = scene_->paths[*body.turn_path].path;
        const glm::dvec3 way = glm::abs(path.at(end) - path.at(start));
        most = std::max({way.x, way.y, way.z});
    }
    const int pieces = static_cast<int>(std::clamp(std::ceil(most / k_piece), 1.0, 1e4));
    glm::dvec3 sum(0.0);
    glm::dquat here = orientation_at(body, start);
    for (int n = 1; n <= pieces; ++n) {
        const glm::dquat next = orientation_at(body, start + (end - start) * n / pieces);
        sum += detail::turn_between(here, next);
        here = next;
    }
    return sum;
}

} // namespace windrow::scene
