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
#include <tuple>
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
    auto recorded = recording_;
    const auto backend = settings_.backend;
    if (auto done = read(fresh, document); !done)
        return done;
    if (settings_.draft)
        make_draft(fresh->picture);
    auto player = make_player(*fresh);
    if (!player) {
        recording_ = std::move(recorded);
        settings_.backend = backend;
        return player.failure();
    }
    std::swap(scene_, fresh); // the old one ends after its player
    const auto count = [&](const char* key) { return document.contains(key) ? document[key].size() : std::size_t{0}; };
    motors_read_ = count("motors");
    obstacles_read_ = count("obstacles");
    hills_ = scene_->air.obstacles.size() - obstacles_read_;
    motor_changed_.assign(motors_read_, false);
    obstacle_changed_.assign(scene_->air.obstacles.size(), false);
    motor_removed_ = motor_of_moment_ = motor_changed_;
    obstacle_removed_ = obstacle_changed_;
    document_ = std::move(document);
    air_read_ = scene_->air.air;
    return begin(*std::move(player));
}

Result<void> Session::restart() {
    (void)end_stroke(); // what it has made is in the scene; one that has made nothing ends without a word
    // What was added is there from the start; what was removed is gone, and keeps its place in the file's list without ever coming.
    auto settled = std::make_unique<program::PictureScene>(*scene_);
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
    std::vector<bool> timed;
    for (std::size_t n = 0; n < motor_of_moment_.size(); ++n)
        if (n < motors_read_ || !motor_removed_[n])
            timed.push_back(motor_of_moment_[n]);
    auto motors = std::pair(motor_removed_, motor_changed_), obstacles = std::pair(obstacle_removed_, obstacle_changed_);
    settle(settled->air.motors, motors_read_, motors.first, motors.second, motor_of_moment_);
    settle(settled->air.obstacles, obstacles_read_ + hills_, obstacles.first, obstacles.second, {});
    auto player = make_player(*settled);
    if (!player)
        return player.failure();
    std::swap(scene_, settled); // the old one ends after its player
    motor_of_moment_ = std::move(timed);
    std::tie(motor_removed_, motor_changed_) = std::move(motors);
    std::tie(obstacle_removed_, obstacle_changed_) = std::move(obstacles);
    return begin(*std::move(player));
}

Result<std::unique_ptr<program::SceneRenderer>> Session::make_player(program::PictureScene& scene) const {
    if (recording_)
        scene.air.outer.clear(); // they come with its snapshots
    return program::SceneRenderer::create(scene, {.size = settings_.size,
                                                  .samples = settings_.draft ? 1 : 4,
                                                  .backend = settings_.backend,
                                                  .max_blades = {},
                                                  .device = &device_,
                                                  .draft = settings_.draft,
                                                  .edited = true});
}

Result<void> Session::begin(std::unique_ptr<program::SceneRenderer> player) {
    const auto before = std::exchange(player_, std::move(player)); // it ends after the new one is made, whose pipelines it shares
    segments_.clear();
    rewound_.clear();
    stroke_.reset();
    owed_ = shown_ = latest_ = chased_ = 0.0;
    waits_ = false;
    return recording_ ? begin_recording() : begin_segment();
}

// --- Time --------------------------------------------------------------------------------------------------------------------

Wind& Session::wind(std::size_t place) {
    return place < levels() ? player_->levels()->wind(place) : *player_->air().cpu();
}

void Session::record_to(std::vector<EventLog>* logs) {
    for (std::size_t place = 0; place < levels(); ++place)
        wind(place).record_to(logs != nullptr ? &logs->at(place) : nullptr);
    wind().record_to(logs != nullptr ? &logs->back() : nullptr);
}

EventLog Session::part_of(const EventLog& log, std::size_t first, std::size_t end) {
    EventLog part;
    for (const Event& event : log.events().subspan(first, end - first))
        part.note(event);
    return part;
}

Session::Marks Session::marks_of(const std::vector<EventLog>& logs) {
    Marks marks;
    for (std::size_t place = 0; place < logs.size(); ++place) {
        const scene::SceneAir& air = place < levels() ? player_->levels()->air(place) : player_->scene_air();
        marks.push_back({air.state(), logs[place].events().size()});
    }
    return marks;
}

std::size_t Session::Segment::bytes() const {
    std::size_t sum = 0;
    for (const scene::SceneLevels::Kept& one : starts)
        sum += one.wind.size();
    return sum;
}

Result<void> Session::begin_segment() {
    Wind* const own = player_->air().cpu();
    if (own == nullptr)
        return {};
    auto segment = std::make_unique<Segment>();
    if (const scene::SceneLevels* const around = player_->levels()) {
        auto kept = around->keep();
        if (!kept)
            return kept.failure();
        segment->starts = *std::move(kept);
    }
    auto start = own->save();
    if (!start)
        return start.failure();
    segment->starts.push_back({*std::move(start), player_->scene_air().state()});
    segment->logs.resize(segment->starts.size());
    record_to(&segment->logs);
    segments_.push_back(std::move(segment));
    std::size_t bytes = 0;
    for (const auto& kept : segments_)
        bytes += kept->bytes();
    while (segments_.size() > 1 && ((!recording_ && time() - segments_.front()->time() > k_kept) || bytes > k_most_bytes)) {
        bytes -= segments_.front()->bytes();
        segments_.pop_front();
    }
    return {};
}

Result<void> Session::step() {
    Wind* const own = player_->air().cpu();
    const scene::FrameTimes times = times_of(scene_->air);
    const std::int64_t next = steps() + 1;
    if (own == nullptr) { // its frame records the step
        owed_ = std::max(owed_, 0.0) + times.length_of_step(next);
        return {};
    }
    forget_future();
    if (time() - segments_.back()->time() >= k_segment - 1e-9)
        if (auto begun = begin_segment(); !begun)
            return begun;
    if (recording_)
        return play_recorded();
    const double end = times.time_of_step(next);
    if (auto moved = move_hand(end); !moved)
        return moved;
    if (scene::SceneLevels* const around = player_->levels())
        if (auto advanced = around->advance_to(end); !advanced)
            return advanced;
    if (auto placed = player_->scene_air().advance_to(*own, end); !placed)
        return placed;
    if (const Diagnostics last = own->step(times.length_of_step(next)); last.out_of_memory)
        return Error{"there is no memory for the air's next step; give the scene fewer cells."};
    Segment& segment = *segments_.back();
    segment.steps.push_back(marks_of(segment.logs));
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
    return segments_.empty() ? time() : segments_.front()->time();
}

void Session::forget_future() {
    while (segments_.size() > 1 && segments_.back()->time() > time() + 1e-9)
        segments_.pop_back();
    latest_ = time();
    if (rewound_.empty())
        return;
    // What comes is noted behind what was played up to here, and behind what was changed here.
    Segment& segment = *segments_.back();
    while (!segment.steps.empty() && segment.steps.back().back().air.time > time() + 1e-9)
        segment.steps.pop_back();
    for (std::size_t place = 0; place < segment.logs.size(); ++place) {
        EventLog& log = segment.logs[place];
        EventLog whole = part_of(log, 0, segment.steps.empty() ? 0 : segment.steps.back()[place].events);
        for (const Event& event : rewound_[place].events())
            whole.note(event);
        log = std::move(whole);
    }
    record_to(&segment.logs);
    rewound_.clear();
}

Result<void> Session::seek(double asked) {
    Wind* const own = player_->air().cpu();
    if (own == nullptr)
        return Error{"the air of a device is not kept: choose the solver on the CPU to go back in time."};
    (void)end_stroke(); // now: its end is of this moment, not of the one that is asked for
    chased_ = 0.0;
    if (recording_) // the last step at or before it
        for (const Recording::Mark& mark : recording_->marks)
            if (mark.time <= asked + 1e-9)
                chased_ = mark.time;
    if (recording_ && asked < segments_.front()->time())
        return begin_recording();
    std::size_t at = segments_.size() - 1;
    while (at > 0 && segments_[at]->time() > asked + 1e-9)
        --at;
    const Segment& segment = *segments_[at];
    std::size_t count = 0;
    while (count < segment.steps.size() && segment.steps[count].back().air.time <= asked + 1e-9)
        ++count;
    auto around = levels_from(segment.starts);
    if (!around)
        return around.failure();
    auto loaded = Wind::load(segment.starts.back().wind, own->config().parallel_for, around->nearest());
    if (!loaded)
        return loaded.failure();
    for (std::size_t step = 0; step < count; ++step)
        for (std::size_t place = 0; place < segment.logs.size(); ++place) {
            const EventLog calls = part_of(segment.logs[place], step > 0 ? segment.steps[step - 1][place].events : 0,
                                           segment.steps[step][place].events);
            if (auto replayed = replay(calls, place < around->size() ? around->wind(place) : *loaded); !replayed)
                return replayed;
        }
    if (count > 0) {
        // Handles of a loaded wind are those of any other: the scene's, which an earlier wind gave.
        auto kept = around->keep();
        if (!kept)
            return kept.failure();
        for (std::size_t place = 0; place < kept->size(); ++place)
            (*kept)[place].air = segment.steps[count - 1][place].air;
        auto bytes = loaded->save();
        if (!bytes)
            return bytes.failure();
        kept->push_back({*std::move(bytes), segment.steps[count - 1].back().air});
        around = levels_from(*kept);
        if (!around)
            return around.failure();
        loaded = Wind::load(kept->back().wind, own->config().parallel_for, around->nearest());
        if (!loaded)
            return loaded.failure();
    }
    record_to(nullptr);
    *own = *std::move(loaded);
    if (around->size() > 0)
        player_->take_levels(*std::move(around));
    player_->scene_air().restore((count > 0 ? segment.steps[count - 1].back().air : segment.starts.back().air).unowned());
    rewound_.assign(segment.logs.size(), {});
    record_to(&rewound_);
    owed_ = 0.0;
    return {};
}

Result<scene::SceneLevels> Session::levels_from(std::span<const scene::SceneLevels::Kept> starts) {
    const auto around = starts.first(starts.size() - 1);
    return scene::SceneLevels::restore(scene_->air, around.empty() ? ParallelFor{} : player_->level_threads(), around);
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

} // namespace windrow::vegetation::view
