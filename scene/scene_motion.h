// What moves in a scene, put where it belongs tick by tick: the box that follows, its floor, the motors and obstacles that come,
// move and go.
//
//     auto motion = windrow::scene::SceneMotion(scene);
//     auto placed = motion.begin(*wind);                                     // the box lies where the first frame wants it
//     for (int tick = 0; tick < ticks; ++tick) {
//         placed = motion.place(*wind, tick / scene.tick_hz, (tick + 1) / scene.tick_hz);
//         wind->step(1.0 / scene.tick_hz);
//     }
//
// For any wind with `motors()`, `obstacles()`, `follow(point)` and `set_floor(height)`: windrow::Wind, windrow::vulkan::Wind, a
// host's own.
#pragma once

#include "scene/scene.h"

#include <concepts>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace windrow::scene {

/// A wind that a scene can be played in.
template <class Air>
concept MovableWind = requires(Air& air, glm::dvec3 point, double height) {
    { air.motors() } -> std::same_as<Motors&>;
    { air.obstacles() } -> std::same_as<Obstacles&>;
    { air.follow(point) } -> std::same_as<Result<void>>;
    { air.set_floor(height) } -> std::same_as<Result<void>>;
};

class SceneMotion {
  public:
    /// The scene must outlive it.
    explicit SceneMotion(const Scene& scene) : scene_(&scene), parts_(scene.motors.size()), bodies_(scene.obstacles.size()) {}

    /// Puts the box where the scene has it at time 0; no motor acts yet, and no obstacle is there. Rejections begin with the
    /// scene's file and path.
    template <MovableWind Air>
    Result<void> begin(Air& air) {
        return place_box(air, 0.0);
    }

    /// For one tick, from `start` to `end` [s]: the box and all that moves are put where they are at its end; motors and
    /// obstacles whose time holds the tick's middle are added, others removed. One that ended by itself does not begin again. Call
    /// it with ticks that follow on each other, before the wind's step.
    template <MovableWind Air>
    Result<void> place(Air& air, double start, double end) {
        if (auto placed = place_box(air, end); !placed)
            return placed;
        if (auto placed = place_motors(air.motors(), start, end); !placed)
            return placed;
        return place_obstacles(air.obstacles(), start, end);
    }

    /// A motor of the scene as it stands now.
    struct ActingMotor {
        const SceneMotor* motor;
        Motor now;
        /// Share of its full strength in the coming tick: its envelope's, or a burst's form, which is below 0 while it draws
        /// back.
        double strength = 1.0;
    };
    /// Those that act at a time [s], in the scene's order; not those that have ended by themselves. `motors`: the wind's.
    [[nodiscard]] std::vector<ActingMotor> acting(const Motors& motors, double time) const;

    /// An obstacle of the scene as it is at a time.
    struct StandingObstacle {
        const SceneObstacle* obstacle;
        Obstacle now;

        /// Whether the straight way between two places of the world passes through it or ends inside.
        [[nodiscard]] bool blocks(glm::dvec3 from, glm::dvec3 to) const;
    };
    /// Those that are there at a time [s], in the scene's order.
    [[nodiscard]] std::vector<StandingObstacle> standing(double time) const;

  private:
    /// A motor of the scene in the air. Its handle turns stale when the motor ends by itself; it does not begin again.
    struct MovedMotor {
        MotorId id;
        bool begun = false;
        double since = 0.0; ///< [s] of the scene's time, when it was added
    };

    template <MovableWind Air>
    Result<void> place_box(Air& air, double time) {
        if (!std::holds_alternative<std::monostate>(scene_->follow))
            if (const auto followed = air.follow(scene_->followed_point(time)); !followed)
                return rejection("follow", time, followed.error());
        if (!scene_->has_floor())
            return {};
        // Rows of their own interpolate the air where they move: they stay while the ground is among the lower half of the equal ones.
        const double wanted = scene_->floor_height(time);
        const auto& rows = scene_->air.rows;
        const double stays = rows ? 0.5 * equal_rows(*rows) : 0.0;
        if (floor_ && wanted >= *floor_ && wanted < *floor_ + stays)
            return {};
        if (const auto placed = air.set_floor(wanted); !placed)
            return rejection("floor", time, placed.error());
        floor_ = wanted;
        return {};
    }

    /// [m] Height of the equal rows above the floor: those of the law, or of a list the first.
    [[nodiscard]] static double equal_rows(const Rows& rows) {
        const std::vector<float>& heights = rows.heights;
        if (heights.empty())
            return rows.uniform * static_cast<double>(rows.first);
        std::size_t equal = 1;
        while (equal < heights.size() && heights[equal] - heights[equal - 1] <= 2.02f * heights[0])
            ++equal;
        return 2.0 * static_cast<double>(equal) * static_cast<double>(heights[0]);
    }

    [[nodiscard]] Error rejection(const char* key, double time, const std::string& why) const;
    Result<void> place_motors(Motors& motors, double start, double end);
    Result<void> place_motor(Motors& motors, const SceneMotor& motor, MovedMotor& part, double start, double end);
    Result<void> place_obstacles(Obstacles& obstacles, double start, double end);
    Result<void> place_obstacle(Obstacles& obstacles, const SceneObstacle& body, ObstacleId& id, double start, double end);
    /// The obstacle at a time [s].
    [[nodiscard]] Obstacle obstacle_at(const SceneObstacle& body, double time) const;

    const Scene* scene_;
    std::optional<double> floor_;    ///< [m] where it was put
    std::vector<MovedMotor> parts_;  ///< one for each of the scene's motors
    std::vector<ObstacleId> bodies_; ///< the same for its obstacles; none while it is not there
};

} // namespace windrow::scene
