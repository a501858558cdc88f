#include "fluid/core/message.h"
#include "fluid/files/new_file.h"
#include "scene/setting_writer.h"
#include "vegetation/view/session.h"

#include <string_view>
#include <system_error>

namespace windrow::vegetation::view {
namespace {

using detail::message;
using nlohmann::json;
using scene::write_object;
using scene::write_value;
using scene::written;

Result<void> write_bytes(const char* what, const std::filesystem::path& file, std::span<const std::byte> bytes) {
    return windrow::detail::write_file(what, file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

/// Shapes of numbers alone; one of a file stays as the scene names it.
std::optional<json> shape_json(const Shape& shape) {
    return std::visit(
        []<class Kind>(const Kind& kind) -> std::optional<json> {
            if constexpr (std::same_as<Kind, MeshShape> || std::same_as<Kind, VoxelShape> || std::same_as<Kind, Ground>)
                return std::nullopt;
            else
                return json{{Kind::k_name, write_object(kind)}};
        },
        shape);
}

/// The keys of `air`; of the roughness the length alone, since its map is a file.
json air_json(const Config& air) {
    json object = json::object();
    for_each_setting(air, [&]<class Row>(const Row& row, const auto& member) {
        using Member = std::remove_cvref_t<decltype(member)>;
        if constexpr (Row::k_stored != Stored::everywhere) {
        } else if constexpr (std::same_as<Member, std::optional<Roughness>>) {
            if (member)
                object[row.name]["length"] = written(member->length);
        } else if constexpr (windrow::detail::k_is_optional<Member>) {
            if (member)
                object[row.name] = write_value(*member);
        } else {
            object[row.name] = write_value(member);
        }
    });
    return object;
}

} // namespace

Session::RecordedFiles::RecordedFiles(const std::filesystem::path& folder, std::size_t around)
    : start(folder / (around > 0 ? message("outer_", around, ".wind") : "start.wind")),
      log(folder / (around > 0 ? message("outer_", around, ".log") : "events.log")) {}

json Session::motor_json(std::size_t place) const {
    const scene::SceneMotor& motor = scene_->air.motors[place];
    const bool read = place < motors_read_;
    if (read && !motor_changed_[place])
        return document_["motors"][place];
    json object = std::visit([](const auto& kind) { return write_object(kind); }, motor.motor);
    object["kind"] = std::visit([](const auto& kind) { return std::string(kind.k_name); }, motor.motor);
    object["name"] = motor.name;
    if (object.contains("envelope") && !object["envelope"].contains("hold")) // without an end there is no fall
        object["envelope"].erase("decay");
    if (read) // when it acts, and along what, is not changed here
        for (const char* const key : {"from", "until", "path"})
            if (document_["motors"][place].contains(key))
                object[key] = document_["motors"][place][key];
    if (motor_of_moment_[place]) {
        object["from"] = motor.from;
        if (std::isfinite(motor.until))
            object["until"] = motor.until;
        if (motor.path)
            object["path"] = scene_->air.paths[*motor.path].name;
    }
    if (motor.path || std::holds_alternative<WakeMotor>(motor.motor))
        object.erase("position");
    return object;
}

json Session::obstacle_json(std::size_t place) const {
    const scene::SceneObstacle& body = scene_->air.obstacles[place];
    const bool read = place < obstacles_read_;
    json object = read ? document_["obstacles"][place] : json::object();
    if (read && !obstacle_changed_[place])
        return object;
    object["name"] = body.name;
    if (!body.path)
        object["position"] = written(body.obstacle.position);
    if (!body.turn_path && body.obstacle.orientation != glm::quat(1.0f, 0.0f, 0.0f, 0.0f))
        object["turn_deg"] = written(scene::turn_of(body.obstacle.orientation));
    else if (!body.turn_path)
        object.erase("turn_deg");
    if (auto shape = shape_json(body.obstacle.shape))
        object["shape"] = *std::move(shape);
    object["surface"] = write_value(body.obstacle.surface);
    return object;
}

Result<void> Session::has_whole_strokes() const {
    if (stroke_ && !stroke_->paths.empty()) // its paths and walkers come into the document as it ends
        return Error{"a stroke of the hand is under way: release the button, then save."};
    return {};
}

Result<void> Session::save(const std::filesystem::path& file) const {
    if (auto can = can_change(); !can)
        return Error{"a recording has no scene to save: save the scene that its host began with."};
    if (auto whole = has_whole_strokes(); !whole)
        return whole;
    json document = document_;
    const auto list = [&](const char* key, std::size_t first, std::size_t skipped, std::size_t count,
                          const std::vector<bool>& removed, const auto& one) {
        json made = json::array();
        for (std::size_t n = 0; n < count; ++n)
            if (!removed[n] && (n < first || n >= first + skipped))
                made.push_back(one(n));
        if (!made.empty() || document.contains(key))
            document[key] = std::move(made);
    };
    list("motors", motors_read_, 0, scene_->air.motors.size(), motor_removed_, [&](std::size_t n) { return motor_json(n); });
    list("obstacles", obstacles_read_, hills_, scene_->air.obstacles.size(), obstacle_removed_,
         [&](std::size_t n) { return obstacle_json(n); });
    const json before = air_json(air_read_), now = air_json(scene_->air.air);
    for (const auto& [key, value] : now.items())
        if (key == "roughness" && before.contains(key) && before[key] != value)
            document["air"][key].update(value);
        else if (!before.contains(key) || before[key] != value)
            document["air"][key] = value;
    for (const auto& [key, value] : before.items())
        if (!now.contains(key) && document.contains("air"))
            document["air"].erase(key);
    return windrow::detail::write_file("scene", file, document.dump(4) + "\n");
}

Result<void> Session::save_log(const std::filesystem::path& folder) const {
    if (segments_.empty())
        return Error{"the air of a device is not kept: choose the solver on the CPU to save a log."};
    if (auto strokes = has_whole_strokes(); !strokes)
        return strokes;
    for (std::size_t place = 0; place <= levels(); ++place) {
        EventLog whole;
        for (const auto& segment : segments_)
            for (const Event& event : segment->logs[place].events())
                whole.note(event);
        const auto bytes = whole.to_bytes();
        if (!bytes)
            return bytes.failure();
        const RecordedFiles files(folder, levels() - place);
        if (auto written = write_bytes("snapshot", files.start, segments_.front()->starts[place].wind); !written)
            return written;
        if (auto written = write_bytes("log", files.log, *bytes); !written)
            return written;
    }
    // Of an earlier log: a reader would take it for one more wind around these.
    const RecordedFiles beyond(folder, levels() + 1);
    std::error_code error;
    std::filesystem::remove(beyond.start, error);
    if (error)
        return Error{message(beyond.start.string(), " cannot be removed, and belongs to another log: ", error.message(), ".")};
    return save(folder / "scene.json");
}

} // namespace windrow::vegetation::view
