#include "vegetation/view/session.h"

#include "fluid/core/message.h"
#include "scene/json_document.h"
#include "scene/scene_reader.h"
#include "scene/text_file.h"
#include "vegetation/program/picture_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <system_error>
#include <utility>

namespace windrow::vegetation::view {
namespace {

using detail::message;

constexpr double k_kept = 60.0;                              // [s]
constexpr double k_segment = 1.0;                            // [s] between snapshots
constexpr double k_most_owed = 0.25;                         // [s] of a device that falls behind
constexpr std::size_t k_most_bytes = std::size_t{512} << 20; // of snapshots

scene::FrameTimes times_of(const scene::Scene& scene) {
    return scene.frame_times();
}

} // namespace

void make_draft(program::Picture& picture) {
    picture.clouds.cover = 0.0f;
    picture.trees.clear();
    picture.camera.shutter_deg = 0.0f;
    if (picture.grass.size() > 1)
        picture.grass.resize(1);
    for (program::GrassSource& layer : picture.grass) {
        grass::GrassSettings& field = layer.drawn.field;
        field.density = std::min(field.density, 3.0f);
        field.cut_distance = std::min(field.cut_distance, 24.0f);
        field.split_distance = std::min(field.split_distance, 0.5f);
        field.thin_from = std::max(field.thin_from, field.cut_distance);
        field.shadow_distance = 0.0f;
        field.max_chunks = std::min(field.max_chunks, 96);
        field.blade.width *= 4.0f;
        layer.drawn.max_blades = 4096;
    }
}

Result<std::unique_ptr<Session>> Session::open(engine::Device& device, const std::filesystem::path& file,
                                               const SessionSettings& settings) {
    std::unique_ptr<Session> made(new Session(device, file, settings));
    if (auto ready = made->reload(); !ready)
        return ready.failure();
    return made;
}

Result<void> Session::read(std::unique_ptr<program::PictureScene>& made, nlohmann::json& document) {
    std::error_code none;
    if (file_.extension() == ".log" || std::filesystem::is_directory(file_, none))
        return read_recording(made, document);
    windrow::detail::InputBudget budget;
    const auto text = scene::read_text_file(file_, {.max_bytes = scene::k_max_scene_bytes}, budget);
    if (!text)
        return text.failure();
    auto parsed = scene::parse_json(*text, file_.string());
    if (!parsed)
        return parsed.failure();
    auto read = program::read_picture_scene_text(*text, file_);
    if (!read)
        return read.failure();
    document = *std::move(parsed);
    made = std::make_unique<program::PictureScene>(*std::move(read));
    return {};
}

Result<void> Session::reload() {
    std::unique_ptr<program::PictureScene> fresh;
    nlohmann::json document;
    if (auto done = read(fresh, document); !done)
        return done;
    if (settings_.draft)
        make_draft(fresh->picture);
    std::swap(scene_, fresh);
    const auto count = [&](const char* key) { return document.contains(key) ? document[key].size() : std::size_t{0}; };
    motors_read_ = count("motors");
    obstacles_read_ = count("obstacles");
    hills_ = scene_->air.obstacles.size() - obstacles_read_;
    motor_changed_.assign(motors_read_, false);
    obstacle_changed_.assign(scene_->air.obstacles.size(), false);
    motor_removed_ = motor_of_moment_ = motor_changed_;
    stroke_.reset();
    obstacle_removed_ = obstacle_changed_;
    document_ = std::move(document);
    air_read_ = scene_->air.air;
    auto before = std::move(player_); // ends after the new one is made, whose pipelines it shares
    auto begun = begin();
    before.reset();
    return begun;
}

Result<void> Session::restart() {
    // What was added is there from the start; what was removed is gone, and keeps its place in the file's list without ever coming.
    const std::vector<bool> timed = std::exchange(motor_of_moment_, {});
    const auto settle = [&](auto& list, std::size_t first_added, std::vector<bool>& removed, std::vector<bool>& changed,
                            const std::vector<bool>& keeps_time) {
        for (std::size_t n = list.size(); n-- > 0;) {
            const auto at = static_cast<std::ptrdiff_t>(n);
            if (removed[n] && n >= first_added) {
                list.erase(list.begin() + at);
                removed.erase(removed.begin() + at);
                changed.erase(changed.begin() + at);
            } else if (removed[n]) {
                list[n].until = list[n].from;
            } else if (n >= first_added && (keeps_time.empty() || !keeps_time[n])) {
                list[n].from = 0.0;
            }
        }
    };
    for (std::size_t n = 0; n < timed.size(); ++n)
        if (n < motors_read_ || !motor_removed_[n])
            motor_of_moment_.push_back(timed[n]);
    stroke_.reset();
    settle(scene_->air.motors, motors_read_, motor_removed_, motor_changed_, timed);
    settle(scene_->air.obstacles, obstacles_read_ + hills_, obstacle_removed_, obstacle_changed_, {});
    auto before = std::move(player_); // ends after the new one is made, whose pipelines it shares
    auto begun = begin();
    before.reset();
    return begun;
}

Result<void> Session::begin() {
    auto player = program::SceneRenderer::create(*scene_, {.size = settings_.size,
                                                           .samples = settings_.draft ? 1 : 4,
                                                           .backend = settings_.backend,
                                                           .max_blades = {},
                                                           .device = &device_,
                                                           .draft = settings_.draft,
                                                           .edited = true});
    if (!player)
        return player.failure();
    player_ = *std::move(player);
    segments_.clear();
    owed_ = shown_ = latest_ = chased_ = 0.0;
    waits_ = false;
    return recording_ ? begin_recording() : begin_segment();
}

// --- Time --------------------------------------------------------------------------------------------------------------------

Result<void> Session::begin_segment() {
    Wind* const wind = player_->air().cpu();
    if (wind == nullptr)
        return {};
    auto start = wind->save();
    if (!start)
        return start.failure();
    std::size_t bytes = start->size();
    for (const auto& segment : segments_)
        bytes += segment->start.size();
    while (!segments_.empty() && ((!recording_ && time() - segments_.front()->state.time > k_kept) || bytes > k_most_bytes)) {
        bytes -= segments_.front()->start.size();
        segments_.pop_front();
    }
    auto segment = std::make_unique<Segment>();
    segment->start = *std::move(start);
    segment->state = player_->scene_air().state();
    wind->record_to(&segment->log);
    segments_.push_back(std::move(segment));
    return {};
}

Result<void> Session::step() {
    Wind* const wind = player_->air().cpu();
    const scene::FrameTimes times = times_of(scene_->air);
    const std::int64_t next = steps() + 1;
    if (wind == nullptr) { // its frame records the step
        owed_ = std::max(owed_, 0.0) + times.length_of_step(next);
        return {};
    }
    forget_future();
    if (time() - segments_.back()->state.time >= k_segment - 1e-9)
        if (auto begun = begin_segment(); !begun)
            return begun;
    if (recording_)
        return play_recorded(*wind);
    if (auto moved = move_hand(times.time_of_step(next)); !moved)
        return moved;
    if (auto placed = player_->scene_air().advance_to(*wind, times.time_of_step(next)); !placed)
        return placed;
    if (const Diagnostics last = wind->step(times.length_of_step(next)); last.out_of_memory)
        return Error{"there is no memory for the air's next step; give the scene fewer cells."};
    Segment& segment = *segments_.back();
    segment.steps.push_back({player_->scene_air().state(), segment.log.events().size()});
    latest_ = time();
    return {};
}

Result<void> Session::play(double seconds) {
    owed_ += seconds;
    if (player_->air().cpu() == nullptr) {
        owed_ = std::min(owed_, k_most_owed);
        return {};
    }
    owed_ = std::max(owed_, chased_ - time());
    const auto next_length = [&] {
        if (!recording_)
            return times_of(scene_->air).length_of_step(steps() + 1);
        const auto next = static_cast<std::size_t>(steps()) + 1;
        return next < recording_->marks.size() ? recording_->marks[next].time - time() : std::numeric_limits<double>::infinity();
    };
    const auto whole = static_cast<std::int64_t>(std::min((owed_ + 1e-9) / next_length(), static_cast<double>(k_most_steps)));
    if (whole > 0 && !recording_) // the hand goes evenly through the steps of a frame
        if (auto moved = move_hand(times_of(scene_->air).time_of_step(steps() + whole)); !moved)
            return moved;
    for (int n = 0; n < k_most_steps; ++n) {
        const double length = next_length();
        if (owed_ + 1e-9 < length)
            return {};
        owed_ -= length;
        if (auto done = step(); !done)
            return done;
    }
    owed_ = 0.0;
    return {};
}

double Session::earliest() const {
    if (recording_)
        return 0.0;
    return segments_.empty() ? time() : segments_.front()->state.time;
}

void Session::forget_future() {
    while (segments_.size() > 1 && segments_.back()->state.time > time() + 1e-9)
        segments_.pop_back();
    latest_ = time();
}

Result<void> Session::seek(double asked) {
    Wind* const wind = player_->air().cpu();
    if (wind == nullptr)
        return Error{"the air of a device is not kept: choose the solver on the CPU to go back in time."};
    stroke_.reset();
    chased_ = 0.0;
    if (recording_) // the last step at or before it
        for (const Recording::Mark& mark : recording_->marks)
            if (mark.time <= asked + 1e-9)
                chased_ = mark.time;
    if (recording_ && asked < segments_.front()->state.time)
        return begin_recording();
    std::size_t at = segments_.size() - 1;
    while (at > 0 && segments_[at]->state.time > asked + 1e-9)
        --at;
    Segment& segment = *segments_[at];
    std::size_t count = 0;
    while (count < segment.steps.size() && segment.steps[count].state.time <= asked + 1e-9)
        ++count;
    auto loaded = Wind::load(segment.start, wind->config().parallel_for);
    if (!loaded)
        return loaded.failure();
    if (count > 0) {
        EventLog prefix;
        for (const Event& event : segment.log.events().first(segment.steps[count - 1].events))
            prefix.note(event);
        if (auto replayed = replay(prefix, *loaded); !replayed)
            return replayed;
        // Handles of a loaded wind are those of any other: the scene's, which an earlier wind gave.
        auto bytes = loaded->save();
        if (!bytes)
            return bytes.failure();
        loaded = Wind::load(*bytes, wind->config().parallel_for);
        if (!loaded)
            return loaded.failure();
    }
    const double latest = latest_;
    wind->record_to(nullptr);
    *wind = *std::move(loaded);
    restore(count > 0 ? segment.steps[count - 1].state : segment.state);
    latest_ = latest;
    owed_ = 0.0;
    return {};
}

void Session::restore(scene::SceneAir::State state) {
    // An owner is of the wind that is gone.
    for (auto& motor : state.motors)
        motor.id = motor.id.unowned();
    for (auto& id : state.obstacles)
        id = id.unowned();
    for (auto& id : state.wakes)
        id = id.unowned();
    player_->scene_air().restore(state);
}

Result<void> Session::record(const engine::Frame& frame, const render::Camera& camera, bool copied) {
    const bool cpu = player_->air().cpu() != nullptr;
    const double start = cpu ? std::min(shown_, time()) : time();
    double end = time();
    const std::int64_t before = steps();
    std::int64_t whole = 0;
    if (!cpu) {
        const scene::FrameTimes times = times_of(scene_->air);
        whole = static_cast<std::int64_t>((owed_ + 1e-9) / times.length_of_step(before + 1));
        if (whole > 0) {
            end = times.time_of_step(before + whole);
            owed_ -= end - start;
            if (auto moved = move_hand(end); !moved)
                return moved;
        }
    }
    shown_ = end;
    latest_ = std::max(latest_, end);
    if (auto done = player_->record(frame, {.start = start, .end = end, .camera = camera, .copied = copied, .stepped = cpu});
        !done)
        return done;
    if (whole > 1) { // the clock of the air counts a frame as one
        scene::SceneAir::State state = player_->scene_air().state();
        state.steps = before + whole;
        player_->scene_air().restore(state);
    }
    return {};
}

// --- Changes -----------------------------------------------------------------------------------------------------------------

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
    const MotorId id = player_->scene_air().motor(place);
    if (wind().motors().find(id) != nullptr)
        if (auto set = wind().motors().set(id, motor); !set)
            return set;
    scene_->air.motors[place].motor = motor;
    motor_changed_[place] = true;
    return {};
}

Result<void> Session::move_motor(std::size_t place, glm::dvec3 position) {
    if (auto can = can_change(); !can)
        return can;
    const MotorId id = player_->scene_air().motor(place);
    if (wind().motors().find(id) != nullptr)
        if (auto moved = wind().motors().move(id, position); !moved)
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
    const MotorId id = player_->scene_air().motor(place);
    if (wind().motors().find(id) != nullptr)
        if (auto removed = wind().motors().remove(id); !removed)
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
    const ObstacleId id = player_->scene_air().obstacle(place);
    if (wind().obstacles().find(id) != nullptr)
        if (auto set = wind().obstacles().set(id, obstacle); !set)
            return set;
    scene_->air.obstacles[place].obstacle = obstacle;
    obstacle_changed_[place] = true;
    return player_->change({.obstacles = true});
}

Result<void> Session::move_obstacle(std::size_t place, glm::dvec3 position, glm::quat orientation) {
    if (auto can = can_change(); !can)
        return can;
    const ObstacleId id = player_->scene_air().obstacle(place);
    if (wind().obstacles().find(id) != nullptr)
        if (auto moved = wind().obstacles().move(id, position, orientation); !moved)
            return moved;
    scene_->air.obstacles[place].obstacle.position = position;
    scene_->air.obstacles[place].obstacle.orientation = orientation;
    obstacle_changed_[place] = true;
    return {};
}

Result<std::size_t> Session::add_obstacle(const Obstacle& obstacle, std::string name) {
    if (auto can = can_change(); !can)
        return can.failure();
    if (auto valid = validate(obstacle); !valid)
        return valid.failure();
    scene_->air.obstacles.push_back({.name = std::move(name), .obstacle = obstacle, .path = {}, .turn_path = {}, .from = time()});
    obstacle_changed_.push_back(true);
    obstacle_removed_.push_back(false);
    player_->scene_air().take_appended();
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
    const Config& now = wind().config();
    if (air.ambient != now.ambient)
        if (auto set = wind().set_ambient(air.ambient); !set)
            return set;
    if (air.gusts.intensity != now.gusts.intensity || air.gusts.length != now.gusts.length || air.gusts.seed != now.gusts.seed) {
        Gusts gusts = air.gusts;
        gusts.tile = now.gusts.tile;
        if (auto set = wind().set_gusts(gusts); !set)
            return set;
    }
    waits_ = true;
    scene_->air.air = air;
    return {};
}

} // namespace windrow::vegetation::view
