// The air of a scene, played in a wind on either backend: the box that follows, its floor, the motors and obstacles that come, move
// and go, and the wakes of what its picture moves.
//
//     auto air = windrow::scene::SceneAir(scene);
//     auto placed = air.begin(*wind);                                  // the box and the obstacles are where the first frame has them
//     for (int tick = 1; tick <= ticks; ++tick) {
//         placed = air.advance_to(*wind, tick / scene.tick_hz);        // what moves, then the air
//         wind->step(1.0 / scene.tick_hz);
//     }
//     (void)wind->motors().set(air.motor("fan", wind->motors()), stronger);    // by its name in the scene
//
// It has the clock of the scene and the handles; the wind has the air. Both are saved, and go on with the same bits.
#pragma once

#include "fluid/wind_control.h"
#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace windrow::scene {

class SceneAir {
  public:
    /// The scene must outlive it.
    explicit SceneAir(const Scene& scene);
    /// In a level around the scene's box: `level` of Scene::outer. What is not wider than its cells is left out: of a body the second
    /// of its three widths counts, of a motor its region. `begin` of a scene with levels needs this or `within`.
    SceneAir(const Scene& scene, std::size_t level);
    /// In the box of a scene whose levels are played too (scene_levels.h).
    [[nodiscard]] static SceneAir within(const Scene& scene);

    /// Time 0 in a wind that has nothing of the scene yet: the box is where the scene has it, obstacles that are there at 0 stand
    /// in it, and the air is the ambient wind. No motor acts yet. Rejections, of all calls, begin with the scene's file and path.
    Result<void> begin(WindControl& wind);
    /// To be called before the wind's step or frame from time() to `end` [s]: the box and all that moves are put where they are at
    /// its end; motors and obstacles whose time holds the middle are added, others removed. One that ended by itself does not
    /// begin again. Wakes sweep from where they were.
    Result<void> advance_to(WindControl& wind, double end);
    /// For a step of another wind before the first frame: what acts at time() is put into it.
    Result<void> hold(WindControl& wind) { return place(wind, state_.time); }
    /// Air before the first frame: at least `seconds` in equal steps of 1 / `hz`, with all that acts at time() and nothing that
    /// moves. `step` advances the wind by `dt` [s]; `left` more steps follow.
    using Step = std::function<Result<void>(double dt, std::int64_t left)>;
    Result<void> warm_up(WindControl& wind, double seconds, double hz, const Step& step);

    /// [s]
    [[nodiscard]] double time() const { return state_.time; }
    /// Steps of the clock so far.
    [[nodiscard]] std::int64_t steps() const { return state_.steps; }
    [[nodiscard]] const Scene& scene() const { return *scene_; }

    /// Handle of the first motor or obstacle of that name which is in the air, by the list of the wind; names none where there is none.
    [[nodiscard]] MotorId motor(std::string_view name, const Motors& motors) const;
    [[nodiscard]] ObstacleId obstacle(std::string_view name, const Obstacles& obstacles) const;
    /// Of the scene's obstacle at a place in its list; names none while that is not in the air.
    [[nodiscard]] ObstacleId obstacle(std::size_t place) const { return state_.obstacles.at(place); }
    /// The same of a motor, until it ends.
    [[nodiscard]] MotorId motor(std::size_t place) const { return state_.motors.at(place).id; }
    /// After motors or obstacles were appended to the scene's lists: they come into the air when their time begins.
    void take_appended();

    /// A motor of the scene as it stands now.
    struct ActingMotor {
        const SceneMotor* motor;
        Motor now;
        /// Share of its full strength in the coming tick: its envelope's, or a burst's form, which is below 0 while it draws
        /// back.
        double strength = 1.0;
    };
    /// Those that act at time(), in the scene's order; not those that have ended by themselves. `motors`: the wind's.
    [[nodiscard]] std::vector<ActingMotor> acting(const Motors& motors) const;

    /// An obstacle of the scene as it is at a time.
    struct StandingObstacle {
        const SceneObstacle* obstacle;
        Obstacle now;

        /// Whether the straight way between two places of the world passes through it or ends inside.
        [[nodiscard]] bool blocks(glm::dvec3 from, glm::dvec3 to) const;
    };
    /// Those that are there at a time [s], in the scene's order.
    [[nodiscard]] std::vector<StandingObstacle> standing(double time) const;

    /// Clock and handles, to be kept beside what Wind::save returns: a few bytes a motor and an obstacle.
    [[nodiscard]] std::vector<std::byte> save() const;
    /// Goes on where `save` was called, with the wind that was loaded. Rejects changed bytes and those of a scene with other
    /// numbers of motors, obstacles or wakes; then nothing has changed.
    [[nodiscard]] Result<void> load(std::span<const std::byte> bytes);

    // --- The same in memory: a host that goes back in time --------------------------------------------------------------------
    /// A motor of the scene in the air. Its handle turns stale when the motor ends by itself; it does not begin again.
    struct MovedMotor {
        MotorId id{};
        bool begun = false;
        double since = 0.0; ///< [s] of the scene's time, when it was added
    };
    struct State {
        double time = 0.0;
        std::int64_t steps = 0;
        std::optional<double> floor{};       ///< [m] where it was put
        std::vector<MovedMotor> motors{};    ///< one for each of the scene's
        std::vector<ObstacleId> obstacles{}; ///< the same; none while it is not there
        std::vector<MotorId> wakes{};        ///< one for each of Scene::carried; none before it is placed

        /// For a wind that was loaded: an owner is of the one that is gone.
        [[nodiscard]] State unowned() const;
    };
    [[nodiscard]] const State& state() const { return state_; }
    /// Goes on where `state` was returned, with the wind of that moment. What was appended to the scene since then comes again.
    void restore(const State& state);

  private:
    template <class Archive>
    static void pass(Archive& archive, auto& state);
    [[nodiscard]] State state_of_begin() const;

    Result<void> place(WindControl& wind, double end);
    Result<void> place_box(WindControl& wind, double time);
    [[nodiscard]] Error rejection(const char* key, double time, const std::string& why) const;
    Result<void> place_motors(Motors& motors, double end);
    Result<void> place_motor(Motors& motors, const SceneMotor& motor, MovedMotor& part, double end);
    Result<void> place_obstacles(Obstacles& obstacles, double end);
    Result<void> place_obstacle(Obstacles& obstacles, const SceneObstacle& body, ObstacleId& id, double end);
    Result<void> place_wakes(Motors& motors, double end);
    /// The obstacle at a time [s].
    [[nodiscard]] Obstacle obstacle_at(const SceneObstacle& body, double time) const;
    [[nodiscard]] glm::dquat orientation_at(const SceneObstacle& body, double time) const;
    /// [rad] By which it turns, however often.
    [[nodiscard]] glm::dvec3 turned(const SceneObstacle& body, double start, double end) const;

    const Scene* scene_;
    State state_;
    float cell_size_;    ///< [m]
    const Rows* rows_;   ///< null: none
    float least_ = 0.0f; ///< [m] width from which on something is in this level
    bool levels_played_ = false;
};

} // namespace windrow::scene
