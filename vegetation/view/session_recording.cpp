// A recording of a host's own session: the snapshot that it began with, and the log of all calls after it (fluid/event_log.h).
#include "fluid/core/message.h"
#include "fluid/files/input_file.h"
#include "scene/json_document.h"
#include "vegetation/program/picture_reader.h"
#include "vegetation/view/session.h"

#include <algorithm>
#include <cmath>
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
    const auto log_bytes = bytes_of(log_file);
    if (!log_bytes)
        return log_bytes.failure();
    auto log = EventLog::from_bytes(as_bytes(*log_bytes));
    if (!log)
        return log.failure().after(log_file.string() + " is no recording: ");
    const auto start = bytes_of(folder / "start.wind");
    if (!start)
        return Error{message(start.error(), " A recording needs start.wind beside its log: the bytes of Wind::save.")};
    auto wind = Wind::load(as_bytes(*start));
    if (!wind)
        return wind.failure().after((folder / "start.wind").string() + ": ");

    Recording recording;
    recording.start.assign(as_bytes(*start).begin(), as_bytes(*start).end());
    recording.marks.push_back({});
    const std::span<const Event> events = log->events();
    for (std::size_t n = 0; n < events.size(); ++n) {
        double dt = 0.0;
        if (const auto* const stepped = std::get_if<Stepped>(&events[n]))
            dt = stepped->dt;
        else if (const auto* const advanced = std::get_if<Advanced>(&events[n]))
            dt = advanced->dt;
        if (dt > 0.0)
            recording.marks.push_back({recording.marks.back().time + dt, n + 1});
    }
    if (recording.marks.size() < 2)
        return Error{message(log_file.string(), " has no step: record a host that calls step or advance.")};
    recording.log = *std::move(log);

    // Its surroundings: those of the scene beside it, or a level meadow.
    const std::filesystem::path beside = folder / "scene.json";
    std::error_code none;
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

Result<void> Session::begin_recording() {
    wind().record_to(nullptr);
    segments_.clear();
    scene::SceneAir::State state = player_->scene_air().state();
    state.time = 0.0;
    state.steps = 0;
    player_->scene_air().restore(state);
    shown_ = 0.0;
    if (auto gone = go_on(recording_->start, program::Backend::cpu); !gone)
        return gone;
    return begin_segment();
}

Result<void> Session::play_recorded(Wind& wind) {
    const auto next = static_cast<std::size_t>(steps()) + 1;
    if (next >= recording_->marks.size())
        return {};
    EventLog calls;
    const std::size_t first = recording_->marks[next - 1].events;
    for (const Event& event : recording_->log.events().subspan(first, recording_->marks[next].events - first))
        calls.note(event);
    if (auto replayed = replay(calls, wind); !replayed)
        return replayed.failure().after(message("at ", recording_->marks[next - 1].time, " s: "));
    scene::SceneAir::State state = player_->scene_air().state();
    state.time = recording_->marks[next].time;
    state.steps = static_cast<std::int64_t>(next);
    player_->scene_air().restore(state);
    Segment& segment = *segments_.back();
    segment.steps.push_back({state, segment.log.events().size()});
    latest_ = time();
    return {};
}

} // namespace windrow::vegetation::view
