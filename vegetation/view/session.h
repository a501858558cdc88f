// A scene that a person plays and changes: its air step by step, the minute before, and the scene file.
//
//     auto session = view::Session::open(device, "meadow.json", {});
//     (void)(*session)->play(1.0 / 60.0);                              // whole steps of the scene's own clock
//     (void)(*session)->set_motor(0, stronger);                        // what windrow::validate rejects changes nothing
//     (void)(*session)->seek((*session)->time() - 10.0);
//     (void)(*session)->save("meadow_edited.json");
//
// On the CPU the steps are those of `windrow run`, to the same bits. Each second of the last minute is kept as a snapshot, and all
// calls after it as an event log: seeking loads the one and replays the other. Winds around the box have snapshots and logs too. A
// motor or obstacle that is added comes at that moment and one that is removed ends then, so the past stays as it was; a saved scene has it from its beginning.
#pragma once

#include "fluid/event_log.h"
#include "vegetation/program/scene_renderer.h"
#include "vegetation/view/slice.h"

#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
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
    /// The winds around the box, from the outermost in: so many, which are on the CPU with either solver.
    [[nodiscard]] std::size_t levels() const { return player_->levels() != nullptr ? player_->levels()->size() : 0; }
    [[nodiscard]] Wind& level(std::size_t place) { return player_->levels()->wind(place); }
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
    [[nodiscard]] double latest() const { return recording_ ? recording_->marks.back().time : latest_; }
    /// The last step at or before a moment from earliest() to latest(). The next step forgets what was after it.
    Result<void> seek(double time);
    /// From time 0, with all that was changed. Where the air is rejected nothing changes.
    Result<void> restart();
    /// Reads the file again and begins with it. Where either is rejected nothing changes.
    Result<void> reload();

    // --- The solver ------------------------------------------------------------------------------------------------------------
    [[nodiscard]] program::Backend solver() { return player_->air().backend(); }
    /// The air goes over to the other solver as a snapshot, and on from there. The past is kept by the one on the CPU alone.
    Result<void> set_solver(program::Backend backend);
    /// How far both solvers come apart from the air of now.
    struct Difference {
        double time = 0.0;    ///< [s] where they began
        int ticks = 0;        ///< that both made
        float largest = 0.0f; ///< [m/s] of any cell
        float fastest = 0.0f; ///< [m/s] the fastest cell
    };
    /// Copies of the air make so many ticks on each; the air itself stays as it is.
    Result<Difference> compare_solvers(int ticks);

    // --- The hand: what it does is in the scene that is saved, at its own time -----------------------------------------------------
    enum class Hand { press, comb };
    /// A stroke from its first place over the ground on, while the scene plays: a wake as fast as the hand, and a walker who presses
    /// the grass of the ground's memory; of a comb a row of walkers, each a texel wide, who lay it along their way.
    Result<void> begin_stroke(Hand hand, glm::dvec3 place, float radius);
    void stroke_to(glm::dvec3 place);
    /// Rejects a stroke in which no time has passed.
    Result<void> end_stroke();
    [[nodiscard]] bool strokes() const { return stroke_.has_value(); }
    /// A burst from here and now.
    Result<std::size_t> blast(glm::dvec3 place, float radius, float speed);
    /// A push of the air from now on, with an end of its own.
    Result<std::size_t> gust(const DirectionalMotor& motor);
    /// A dab of a brush: grass of a layer comes, or that of all layers goes. At least as wide as the mask's corners are apart.
    Result<void> paint(std::size_t layer, glm::dvec3 place, float radius, bool erases);
    /// After the dabs of a stroke: the ground has its look by them.
    Result<void> end_painting();
    /// [m] The smallest brush that a layer's mask shows.
    [[nodiscard]] float finest_brush(std::size_t layer) const;

    // --- A recording: the file is a log, or the folder of one ------------------------------------------------------------------------
    /// Whether a host's own session is played: its calls are in the log, and it cannot be changed.
    [[nodiscard]] bool is_recording() const { return recording_.has_value(); }
    /// Whether steps lead to a moment that was asked for.
    [[nodiscard]] bool chases() const { return chased_ > time() + 1e-9; }

    /// Works a slice of the air of now out.
    Result<void> look(Slice& slice, SliceOf what, double height, double step);

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
    /// Of the minute that is kept: start.wind (Wind::save), events.log (EventLog), scene.json, into a folder that exists. The wind
    /// around the box is outer_1.wind and outer_1.log, the one around that outer_2.
    Result<void> save_log(const std::filesystem::path& folder) const;

  private:
    /// Where a wind is at the end of a step: the scene in it, and the events of its log so far.
    struct Mark {
        scene::SceneAir::State air{};
        std::size_t events = 0;
    };
    /// Of each wind, from the outermost in: the box is the last.
    using Marks = std::vector<Mark>;
    /// Snapshots of these, and all that came after them until the next ones.
    struct Segment {
        std::vector<scene::SceneLevels::Kept> starts{};
        std::vector<EventLog> logs{};
        std::vector<Marks> steps{};

        [[nodiscard]] double time() const { return starts.back().air.time; }
        [[nodiscard]] std::size_t bytes() const;
    };

    /// A stroke of the hand that is under way.
    struct StrokeNow {
        Hand hand = Hand::press;
        float radius = 0.5f;
        glm::dvec3 place{0.0}, way{1.0, 0.0, 0.0};
        std::string name{};
        std::vector<std::size_t> paths{}; ///< its teeth; empty: it has not begun
        std::size_t motor = 0;
    };
    /// The files of a log: of the box, and of the wind so many levels around it.
    struct RecordedFiles {
        RecordedFiles(const std::filesystem::path& folder, std::size_t around);
        std::filesystem::path start, log;
    };
    /// Logs of a host's calls, of each wind as above, and where each step of the box ends.
    struct Recording {
        std::vector<std::vector<std::byte>> starts{};
        std::vector<EventLog> logs{};
        std::vector<scene::SceneLevel> levels{}; ///< as Scene::outer has them
        struct Mark {
            double time = 0.0;                 ///< [s]
            std::vector<std::size_t> events{}; ///< of each log so far
        };
        std::vector<Mark> marks{}; ///< of no step, then of each
        [[nodiscard]] static std::vector<Mark> marks_of(std::span<const EventLog> logs);
    };

    Session(engine::Device& device, std::filesystem::path file, const SessionSettings& settings)
        : device_(device), file_(std::move(file)), settings_(settings) {}
    Result<void> read(std::unique_ptr<program::PictureScene>& scene, nlohmann::json& document);
    [[nodiscard]] Result<std::unique_ptr<program::SceneRenderer>> make_player(program::PictureScene& scene) const;
    Result<void> begin(std::unique_ptr<program::SceneRenderer> player);
    Result<void> begin_segment();
    void forget_future();
    /// On the CPU: of a place as in Marks.
    [[nodiscard]] Wind& wind(std::size_t place);
    /// From now on, one for each wind; null: none.
    void record_to(std::vector<EventLog>* logs);
    [[nodiscard]] Marks marks_of(const std::vector<EventLog>& logs);
    /// Events from one to before another.
    [[nodiscard]] static EventLog part_of(const EventLog& log, std::size_t first, std::size_t end);
    /// The winds around the box, whose own snapshot is the last.
    [[nodiscard]] Result<scene::SceneLevels> levels_from(std::span<const scene::SceneLevels::Kept> starts);
    /// The same moment in an air that goes on from a snapshot.
    Result<void> go_on(std::span<const std::byte> bytes, program::Backend backend);
    /// A change of the air in each wind that has what it changes.
    Result<void> in_each(const std::function<Result<void>(WindControl&, scene::SceneAir&)>& change);
    void take_appended();
    [[nodiscard]] std::int64_t step_at(double time) const;
    Result<void> begin_teeth();
    /// The hand is at its place at the end of the coming steps.
    Result<void> move_hand(double end);
    Result<std::size_t> add_moment(scene::SceneMotor motor);
    [[nodiscard]] Result<void> can_change() const;
    [[nodiscard]] Result<void> has_whole_strokes() const;
    Result<void> read_recording(std::unique_ptr<program::PictureScene>& scene, nlohmann::json& document);
    Result<void> begin_recording();
    Result<void> play_recorded();
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
    std::vector<bool> motor_of_moment_{}; ///< added, with its own times
    std::optional<StrokeNow> stroke_{};
    std::optional<Recording> recording_{};
    double chased_ = 0.0; ///< [s]
    int strokes_made_ = 0;
    std::unique_ptr<program::SceneRenderer> player_{};
    std::deque<std::unique_ptr<Segment>> segments_{};
    std::vector<EventLog> rewound_{}; ///< what was changed since `seek`, of each wind; empty after the next step
    double owed_ = 0.0;               ///< [s] to be played
    double shown_ = 0.0;              ///< [s] of the frame before
    double latest_ = 0.0;             ///< [s]
    bool waits_ = false;
};

} // namespace windrow::vegetation::view
