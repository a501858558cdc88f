// A recording of a host's own session: the snapshot that it began with, and the log of all calls after it (fluid/event_log.h).
#include "fluid/core/message.h"
#include "fluid/files/input_file.h"
#include "scene/json_document.h"
#include "vegetation/program/picture_reader.h"
#include "vegetation/view/session.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <system_error>
#include <utility>

namespace windrow::vegetation::view {
namespace {

using detail::message;

constexpr std::size_t k_most_file = std::size_t{1} << 30; // [bytes]

Result<std::string> bytes_of(const std::filesystem::path& file) {
    return windrow::detail::read_input(file, {.folder = {}, .max_bytes = k_most_file});
}

std::span<const std::byte> as_bytes(const std::string& text) {
    return std::as_bytes(std::span(text));
}

/// [s] By which a call goes on; 0 of any other.
double step_of(const Event& event) {
    if (const auto* const stepped = std::get_if<Stepped>(&event))
        return stepped->dt;
    const auto* const advanced = std::get_if<Advanced>(&event);
    return advanced != nullptr ? advanced->dt : 0.0;
}

/// A level meadow around a box of air.
nlohmann::json plain_scene(const std::string& name, const Config& air, const Box& box, glm::dvec3 origin) {
    const glm::dvec3 size(box.size()), middle = origin + 0.5 * size;
    const double around = 2.0 * std::max(size.x, size.z);
    const double floor = air.boundaries.y_low.solid() ? origin.y : std::min(origin.y, 0.0);
    const glm::dvec3 eye = middle + glm::dvec3(0.9 * size.x, 0.6 * size.y, 0.9 * size.z);
    return {{"name", name},
            {"picture",
             {{"camera", {{"position", {eye.x, eye.y, eye.z}}, {"target", {middle.x, floor + 0.3 * size.y, middle.z}}}},
              {"ground", {{"corner", {middle.x - 0.5 * around, floor, middle.z - 0.5 * around}}, {"extent", {around, around}}}},
              {"grass", {{{"class", "grass"}, {"length", 0.4}}}}}}};
}

} // namespace

Result<void> Session::read_recording(std::unique_ptr<program::PictureScene>& made, nlohmann::json& document) {
    const std::filesystem::path folder = std::filesystem::is_directory(file_) ? file_ : file_.parent_path();
    const std::filesystem::path log_file = std::filesystem::is_directory(file_) ? folder / "events.log" : file_;
    std::size_t around = 0;
    std::error_code none;
    while (std::filesystem::exists(RecordedFiles(folder, around + 1).start, none))
        ++around;
    Recording recording;
    std::shared_ptr<Wind> wind;
    for (std::size_t left = around + 1; left > 0; --left) { // from the outermost in
        RecordedFiles files(folder, left - 1);
        if (left == 1)
            files.log = log_file;
        const auto log_bytes = bytes_of(files.log);
        if (!log_bytes)
            return log_bytes.failure();
        auto log = EventLog::from_bytes(as_bytes(*log_bytes));
        if (!log)
            return log.failure().after(files.log.string() + " is no recording: ");
        const auto start = bytes_of(files.start);
        if (!start)
            return Error{message(start.error(), " A recording needs start.wind beside its log: the bytes of Wind::save.")};
        auto loaded = Wind::load(as_bytes(*start), {}, wind);
        if (!loaded)
            return loaded.failure().after(files.start.string() + ": ");
        wind = std::make_shared<Wind>(*std::move(loaded));
        const Config& config = wind->config();
        if (left > 1)
            recording.levels.insert(recording.levels.begin(), {.cells = config.cells,
                                                               .cell_size = config.cell_size,
                                                               .rows = config.rows,
                                                               .blend_width = config.blend_width,
                                                               .ticks = config.ticks});
        recording.starts.emplace_back(as_bytes(*start).begin(), as_bytes(*start).end());
        recording.logs.push_back(*std::move(log));
    }
    recording.marks = Recording::marks_of(recording.logs);
    if (recording.marks.size() < 2)
        return Error{message(log_file.string(), " has no step: record a host that calls step or advance.")};

    // Its surroundings: those of the scene beside it, or a level meadow.
    const std::filesystem::path beside = folder / "scene.json";
    const bool has_scene = std::filesystem::exists(beside, none);
    std::string text = plain_scene(log_file.stem().string(), wind->config(), wind->box(), wind->origin()).dump();
    if (has_scene) {
        auto read = bytes_of(beside);
        if (!read)
            return read.failure();
        text = *std::move(read);
    }
    auto parsed = scene::parse_json(text, beside.string());
    if (!parsed)
        return parsed.failure();
    auto scene = program::read_picture_scene_text(text, beside);
    if (!scene)
        return scene.failure();
    scene::Scene& air = scene->air;
    air.air = wind->config(); // what acts is in the log
    air.motors.clear();
    air.obstacles.clear();
    air.drag.clear();
    air.planted.clear();
    air.carried.clear();
    air.follow = std::monostate{};
    air.outer.clear();
    air.floor = wind->config().floor;
    air.duration = recording.marks.back().time;
    document = *std::move(parsed);
    document.erase("motors");
    document.erase("obstacles");
    made = std::make_unique<program::PictureScene>(*std::move(scene));
    recording_ = std::move(recording);
    settings_.backend = program::Backend::cpu; // which keeps the past
    return {};
}

// A wind around the box has made all steps that begin before that of the box ends.
std::vector<Session::Recording::Mark> Session::Recording::marks_of(std::span<const EventLog> logs) {
    std::vector<Mark> made{{0.0, std::vector<std::size_t>(logs.size(), 0)}};
    std::vector<double> around(logs.size() - 1, 0.0); // [s] so far
    const std::span<const Event> own = logs.back().events();
    for (std::size_t n = 0; n < own.size(); ++n) {
        const double dt = step_of(own[n]);
        if (!(dt > 0.0))
            continue;
        Mark mark = made.back();
        mark.time += dt;
        mark.events.back() = n + 1;
        for (std::size_t place = 0; place < around.size(); ++place) {
            const std::span<const Event> events = logs[place].events();
            for (std::size_t next = mark.events[place]; next < events.size() && around[place] < mark.time - 1e-9; ++next)
                if (const double step = step_of(events[next]); step > 0.0) {
                    around[place] += step;
                    mark.events[place] = next + 1;
                }
        }
        made.push_back(std::move(mark));
    }
    return made;
}

Result<void> Session::begin_recording() {
    record_to(nullptr);
    segments_.clear();
    rewound_.clear();
    scene_->air.outer = recording_->levels;
    std::vector<scene::SceneLevels::Kept> starts;
    for (std::size_t place = 0; place < recording_->starts.size(); ++place) {
        const std::size_t around = recording_->starts.size() - 1 - place;
        const scene::SceneAir air = around > 0 ? scene::SceneAir(scene_->air, around - 1) : scene::SceneAir::within(scene_->air);
        starts.push_back({recording_->starts[place], air.state()});
    }
    auto levels = levels_from(starts);
    if (!levels)
        return levels.failure();
    if (auto done = player_->frames().wait(); !done)
        return done;
    if (levels->size() > 0)
        player_->take_levels(*std::move(levels));
    player_->scene_air().restore(starts.back().air);
    shown_ = 0.0;
    if (auto gone = go_on(starts.back().wind, program::Backend::cpu); !gone)
        return gone;
    return begin_segment();
}

Result<void> Session::play_recorded() {
    const auto next = static_cast<std::size_t>(steps()) + 1;
    if (next >= recording_->marks.size())
        return {};
    const Recording::Mark &before = recording_->marks[next - 1], &after = recording_->marks[next];
    for (std::size_t place = 0; place < recording_->logs.size(); ++place)
        if (auto replayed = replay(part_of(recording_->logs[place], before.events[place], after.events[place]), wind(place));
            !replayed)
            return replayed.failure().after(message("at ", before.time, " s: "));
    scene::SceneAir::State state = player_->scene_air().state();
    state.time = after.time;
    state.steps = static_cast<std::int64_t>(next);
    player_->scene_air().restore(state);
    Segment& segment = *segments_.back();
    segment.steps.push_back(marks_of(segment.logs));
    latest_ = time();
    return {};
}

} // namespace windrow::vegetation::view
