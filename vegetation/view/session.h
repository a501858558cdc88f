// A scene that a person plays and changes: its air step by step, the minute before, and the scene file.
//
//     auto session = view::Session::open(device, "meadow.json", {});
//     (void)(*session)->play(1.0 / 60.0);                              // whole steps of the scene's own clock
//     (void)(*session)->set_motor(0, stronger);                        // what windrow::validate rejects changes nothing
//     (void)(*session)->seek((*session)->time() - 10.0);
//     (void)(*session)->save("meadow_edited.json");
//
// On the CPU the steps are those of `windrow run`, to the same bits. Each second of the last minute is kept as a snapshot, and all
// calls after it as an event log: seeking loads the one and replays the other. A motor or obstacle that is added comes at that
// moment and one that is removed ends then, so the past stays as it was; a saved scene has it from its beginning.
#pragma once

#include "fluid/event_log.h"
#include "vegetation/program/scene_renderer.h"

#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace windrow::vegetation::view {

/// A look that a software device draws in time: no trees, no clouds, one layer of few blades, no shadows of grass.
void make_draft(program::Picture& picture);

struct SessionSettings {
    bool draft = false;
    std::optional<program::Backend> backend{};
    glm::ivec2 size{960, 540}; ///< [px]
};

class Session {
  public:
    /// Rejects what the reader, the air and the renderer reject. The device outlives it.
    [[nodiscard]] static Result<std::unique_ptr<Session>> open(engine::Device& device, const std::filesystem::path& file,
                                                               const SessionSettings& settings);

    [[nodiscard]] const program::PictureScene& scene() const { return *scene_; }
    [[nodiscard]] program::SceneRenderer& player() { return *player_; }
    [[nodiscard]] WindControl& wind() { return player_->air().control(); }
    [[nodiscard]] const WindReader& reader() const { return player_->air().reader(); }
    [[nodiscard]] const SessionSettings& settings() const { return settings_; }
    [[nodiscard]] const std::filesystem::path& file() const { return file_; }

    // --- Time ----------------------------------------------------------------------------------------------------------------
    /// [s]
    [[nodiscard]] double time() const { return player_->scene_air().time(); }
    [[nodiscard]] std::int64_t steps() const { return player_->scene_air().steps(); }
    /// Adds to the time that is to be played, and makes the whole steps of it, at most `k_most_steps`: what is beyond is dropped.
    static constexpr int k_most_steps = 64;
    Result<void> play(double seconds);
    /// One step.
    Result<void> step();
    /// [s] The earliest moment that `seek` reaches; time() where there is none, as on a device.
    [[nodiscard]] double earliest() const;
    [[nodiscard]] double latest() const { return latest_; }
    /// The last step at or before a moment from earliest() to latest(). The next step forgets what was after it.
    Result<void> seek(double time);
    /// From time 0, with all that was changed.
    Result<void> restart();
    /// Reads the file again and begins with it; where it is rejected nothing changes.
    Result<void> reload();

    /// Records a frame: the air as it is now.
    Result<void> record(const engine::Frame& frame, const render::Camera& camera, bool copied);

    // --- Changes: one that is rejected changes nothing ---------------------------------------------------------------------------
    [[nodiscard]] const std::vector<scene::SceneMotor>& motors() const { return scene_->air.motors; }
    [[nodiscard]] const std::vector<scene::SceneObstacle>& obstacles() const { return scene_->air.obstacles; }
    /// Whether the motor is in the air now.
    [[nodiscard]] bool acts(std::size_t place) const;
    [[nodiscard]] bool removed_motor(std::size_t place) const { return motor_removed_[place]; }
    [[nodiscard]] bool removed_obstacle(std::size_t place) const { return obstacle_removed_[place]; }
    /// Of the file or added here; hills of the picture's ground are not.
    [[nodiscard]] bool can_change_obstacle(std::size_t place) const;
    Result<void> set_motor(std::size_t place, const Motor& motor);
    Result<void> move_motor(std::size_t place, glm::dvec3 position);
    Result<std::size_t> add_motor(const Motor& motor, std::string name);
    Result<void> remove_motor(std::size_t place);
    Result<void> set_obstacle(std::size_t place, const Obstacle& obstacle);
    Result<void> move_obstacle(std::size_t place, glm::dvec3 position, glm::quat orientation);
    Result<std::size_t> add_obstacle(const Obstacle& obstacle, std::string name);
    Result<void> remove_obstacle(std::size_t place);
    /// At once: ambient wind, gusts, boundaries. The rest acts from the next `restart`.
    Result<void> set_air(const Config& air);
    [[nodiscard]] const Config& air() const { return scene_->air.air; }
    /// Settings that wait for `restart`.
    [[nodiscard]] bool waits() const { return waits_; }

    // --- Files -------------------------------------------------------------------------------------------------------------------
    /// The scene with all changes, from its beginning. It names the same files, and belongs into the same folder.
    Result<void> save(const std::filesystem::path& file) const;
    /// Of the minute that is kept: start.wind (Wind::save), events.log (EventLog), scene.json, into a folder that exists.
    Result<void> save_log(const std::filesystem::path& folder) const;

  private:
    /// A snapshot, and all that came after it until the next one.
    struct Segment {
        std::vector<std::byte> start{};
        scene::SceneAir::State state{}; ///< there
        EventLog log{};
        struct Step {
            scene::SceneAir::State state{};
            std::size_t events = 0; ///< so far
        };
        std::vector<Step> steps{};
    };

    Session(engine::Device& device, std::filesystem::path file, const SessionSettings& settings)
        : device_(device), file_(std::move(file)), settings_(settings) {}
    Result<void> read(std::unique_ptr<program::PictureScene>& scene, nlohmann::json& document) const;
    Result<void> begin();
    Result<void> begin_segment();
    void forget_future();
    [[nodiscard]] nlohmann::json motor_json(std::size_t place) const;
    [[nodiscard]] nlohmann::json obstacle_json(std::size_t place) const;

    engine::Device& device_;
    std::filesystem::path file_;
    SessionSettings settings_;
    nlohmann::json document_{};
    std::unique_ptr<program::PictureScene> scene_{};
    Config air_read_{};                                            ///< as the file has it
    std::size_t motors_read_ = 0, obstacles_read_ = 0, hills_ = 0; ///< of the file: those come first
    std::vector<bool> motor_changed_{}, obstacle_changed_{};
    std::vector<bool> motor_removed_{}, obstacle_removed_{};
    std::unique_ptr<program::SceneRenderer> player_{};
    std::deque<std::unique_ptr<Segment>> segments_{};
    double owed_ = 0.0;   ///< [s] to be played
    double shown_ = 0.0;  ///< [s] of the frame before
    double latest_ = 0.0; ///< [s]
    bool waits_ = false;
};

} // namespace windrow::vegetation::view
