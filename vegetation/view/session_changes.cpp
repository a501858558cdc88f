// What is changed in a session acts at once in its air and in the winds around that, and is in the scene that is saved.
#include "vegetation/view/session.h"

#include <utility>

namespace windrow::vegetation::view {

Result<void> Session::in_each(const std::function<Result<void>(WindControl&, scene::SceneAir&)>& change) {
    for (std::size_t place = 0; place < levels(); ++place)
        if (auto changed = change(player_->levels()->wind(place), player_->levels()->air(place)); !changed)
            return changed;
    return change(wind(), player_->scene_air());
}

bool Session::acts(std::size_t place) const {
    return player_->air().control().motors().find(player_->scene_air().motor(place)) != nullptr;
}

bool Session::can_change_obstacle(std::size_t place) const {
    return place < obstacles_read_ || place >= obstacles_read_ + hills_;
}

Result<void> Session::can_change() const {
    return recording_ ? Result<void>(Error{"a recording is played as it was: open a scene to change one."}) : Result<void>{};
}

Result<void> Session::set_motor(std::size_t place, const Motor& motor) {
    if (auto can = can_change(); !can)
        return can;
    if (auto valid = validate(motor); !valid)
        return valid;
    const auto set_one = [&](WindControl& one, scene::SceneAir& air) -> Result<void> {
        const MotorId id = air.motor(place);
        return one.motors().find(id) != nullptr ? one.motors().set(id, motor) : Result<void>{};
    };
    if (auto set = in_each(set_one); !set)
        return set;
    scene_->air.motors[place].motor = motor;
    motor_changed_[place] = true;
    return {};
}

Result<void> Session::move_motor(std::size_t place, glm::dvec3 position) {
    if (auto can = can_change(); !can)
        return can;
    const auto move_one = [&](WindControl& one, scene::SceneAir& air) -> Result<void> {
        const MotorId id = air.motor(place);
        return one.motors().find(id) != nullptr ? one.motors().move(id, position) : Result<void>{};
    };
    if (auto moved = in_each(move_one); !moved)
        return moved;
    std::visit([&](auto& kind) { kind.position = position; }, scene_->air.motors[place].motor);
    motor_changed_[place] = true;
    return {};
}

Result<std::size_t> Session::add_motor(const Motor& motor, std::string name) {
    if (auto can = can_change(); !can)
        return can.failure();
    if (auto valid = validate(motor); !valid)
        return valid.failure();
    const auto added = add_moment({.name = std::move(name), .motor = motor, .path = {}, .from = time()});
    motor_of_moment_.back() = false;
    return added;
}

Result<void> Session::remove_motor(std::size_t place) {
    if (auto can = can_change(); !can)
        return can;
    const auto remove_one = [&](WindControl& one, scene::SceneAir& air) -> Result<void> {
        const MotorId id = air.motor(place);
        return one.motors().find(id) != nullptr ? one.motors().remove(id) : Result<void>{};
    };
    if (auto removed = in_each(remove_one); !removed)
        return removed;
    scene_->air.motors[place].until = time();
    motor_removed_[place] = true;
    return {};
}

Result<void> Session::set_obstacle(std::size_t place, const Obstacle& obstacle) {
    if (auto can = can_change(); !can)
        return can;
    if (auto valid = validate(obstacle); !valid)
        return valid;
    const auto set_one = [&](WindControl& one, scene::SceneAir& air) -> Result<void> {
        const ObstacleId id = air.obstacle(place);
        return one.obstacles().find(id) != nullptr ? one.obstacles().set(id, obstacle) : Result<void>{};
    };
    if (auto set = in_each(set_one); !set)
        return set;
    scene_->air.obstacles[place].obstacle = obstacle;
    obstacle_changed_[place] = true;
    return player_->change({.obstacles = true});
}

Result<void> Session::move_obstacle(std::size_t place, glm::dvec3 position, glm::quat orientation) {
    if (auto can = can_change(); !can)
        return can;
    const auto move_one = [&](WindControl& one, scene::SceneAir& air) -> Result<void> {
        const ObstacleId id = air.obstacle(place);
        return one.obstacles().find(id) != nullptr ? one.obstacles().move(id, position, orientation) : Result<void>{};
    };
    if (auto moved = in_each(move_one); !moved)
        return moved;
    scene_->air.obstacles[place].obstacle.position = position;
    scene_->air.obstacles[place].obstacle.orientation = orientation;
    obstacle_changed_[place] = true;
    return {};
}

void Session::take_appended() {
    for (std::size_t place = 0; place < levels(); ++place)
        player_->levels()->air(place).take_appended();
    player_->scene_air().take_appended();
}

Result<std::size_t> Session::add_obstacle(const Obstacle& obstacle, std::string name) {
    if (auto can = can_change(); !can)
        return can.failure();
    if (auto valid = validate(obstacle); !valid)
        return valid.failure();
    scene_->air.obstacles.push_back({.name = std::move(name), .obstacle = obstacle, .path = {}, .turn_path = {}, .from = time()});
    obstacle_changed_.push_back(true);
    obstacle_removed_.push_back(false);
    take_appended();
    if (auto changed = player_->change({.obstacles = true}); !changed)
        return changed.failure();
    return scene_->air.obstacles.size() - 1;
}

Result<void> Session::remove_obstacle(std::size_t place) {
    if (auto can = can_change(); !can)
        return can;
    scene_->air.obstacles[place].until = time(); // it leaves with the next step
    obstacle_removed_[place] = true;
    return {};
}

Result<void> Session::set_air(const Config& air) {
    if (auto can = can_change(); !can)
        return can;
    if (auto valid = validate(air); !valid)
        return valid;
    WindControl& outermost = levels() > 0 ? player_->levels()->wind(0) : wind(); // whose mean wind and gusts all take
    const Config& now = outermost.config();
    if (air.ambient != now.ambient)
        if (auto set = outermost.set_ambient(air.ambient); !set)
            return set;
    if (air.gusts.intensity != now.gusts.intensity || air.gusts.length != now.gusts.length || air.gusts.seed != now.gusts.seed) {
        Gusts gusts = air.gusts;
        gusts.tile = now.gusts.tile;
        if (auto set = outermost.set_gusts(gusts); !set)
            return set;
    }
    waits_ = true;
    scene_->air.air = air;
    return {};
}

} // namespace windrow::vegetation::view
