#include "cli/frame_writer.h"

#include "fluid/core/message.h"
#if WINDROW_WITH_VDB
#include "cli/vdb_frames.h"
#endif

#include <algorithm>
#include <chrono>
#include <string_view>
#include <utility>

namespace windrow::cli {

#if !WINDROW_WITH_VDB
class VdbFrames {};
#endif

namespace {

using detail::message;
using Clock = std::chrono::steady_clock;

[[maybe_unused]] double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

#if WINDROW_WITH_IMAGES
/// More paths than this would fill the picture: then a body draws its last second only, and none before and after it acts.
constexpr std::size_t k_max_whole_paths = 8;

/// The part of a path that its body has just passed.
Trail fresh_trail_of(const std::string& name, const scene::ScenePath& path, double time) {
    const double begin = time - 1.0;
    Trail trail{.name = name, .points = {path.path.at(begin)}, .now = path.path.at(time), .followed = false};
    for (const scene::PathPoint& point : path.path.points())
        if (point.time > begin && point.time < time)
            trail.points.push_back(point.position);
    trail.points.push_back(trail.now);
    return trail;
}

/// A path as the pictures draw it; a recording of an hour is thinned to what a picture can show.
Trail trail_of(const std::string& name, const scene::ScenePath& path, double time) {
    constexpr std::size_t k_max_drawn = 2000;
    const auto& points = path.path.points();
    const std::size_t stride = points.size() / k_max_drawn + 1;
    Trail trail{.name = name, .points = {}, .now = path.path.at(time), .followed = false};
    for (std::size_t i = 0; i < points.size(); i += stride)
        trail.points.push_back(points[i].position);
    if (!points.empty())
        trail.points.push_back(points.back().position);
    return trail;
}

Fault fault_of(const Result<void>& drawn) {
    const std::string& sentence = drawn.error();
    const bool machine = sentence.starts_with(k_disk_fault);
    return {machine ? sentence.substr(k_disk_fault.size()) : sentence, machine};
}
#endif

} // namespace

FrameWriter::FrameWriter(const scene::Scene& scene, std::filesystem::path folder, bool images, bool vdb,
                         std::vector<FieldFormat> fields, const Frames& frames, [[maybe_unused]] const ParallelFor& parallel_for)
    : scene_(&scene), folder_(std::move(folder)), images_(images), vdb_(vdb), fields_(std::move(fields)), first_(frames.first),
      last_(frames.first + frames.count - 1), digits_(4) {
    for (std::int64_t limit = 10'000; limit <= last_; limit *= 10)
        ++digits_;
#if WINDROW_WITH_VDB
    if (vdb_)
        vdb_frames_ = std::make_unique<VdbFrames>(scene, folder_, digits_, parallel_for);
#endif
}

FrameWriter::~FrameWriter() = default;

Fault FrameWriter::follow([[maybe_unused]] const Playback& playback, [[maybe_unused]] double dt) {
#if WINDROW_WITH_VDB
    if (vdb_frames_)
        return vdb_frames_->follow(playback, dt);
#endif
    return {};
}

Fault FrameWriter::write(Playback& playback, std::int64_t n) {
    const std::int64_t frame = first_ + n;
    if (images_)
        if (auto fault = write_picture(playback, frame))
            return fault;
    if (vdb_)
        if (auto fault = write_vdb(playback, frame))
            return fault;
    return fields_.empty() ? Fault{} : write_fields(playback, frame);
}

Fault FrameWriter::write_picture([[maybe_unused]] const Playback& playback, [[maybe_unused]] std::int64_t frame) {
#if WINDROW_WITH_IMAGES
    const auto begin = Clock::now();
    const double time = playback.time();
    const std::vector<Playback::ActingMotor> acting = playback.acting();
    const bool many = scene_->paths.size() > k_max_whole_paths;
    std::vector<Trail> trails;
    for (std::size_t i = 0; i < scene_->paths.size(); ++i) {
        const auto* followed = std::get_if<std::size_t>(&scene_->follow);
        const bool leads = followed != nullptr && *followed == i;
        const bool acts = std::any_of(acting.begin(), acting.end(), [&](const auto& body) { return body.motor->path == i; });
        const bool holds_angles = std::any_of(scene_->obstacles.begin(), scene_->obstacles.end(),
                                              [&](const scene::SceneObstacle& body) { return body.turn_path == i; });
        if (holds_angles || (many && !leads && !acts))
            continue;
        // A trail that has the name of a wake or an obstacle is drawn as that body.
        std::string name = scene_->paths[i].name;
        for (const scene::SceneMotor& motor : scene_->motors)
            if (motor.path == i && std::holds_alternative<WakeMotor>(motor.motor))
                name = motor.name;
        for (const scene::SceneObstacle& obstacle : scene_->obstacles)
            if (obstacle.path == i)
                name = obstacle.name == scene::SceneObstacle{}.name ? "" : obstacle.name;
        trails.push_back((many && !leads ? fresh_trail_of : trail_of)(name, scene_->paths[i], time));
        trails.back().followed = leads;
    }
    std::vector<NamedMotor> motors;
    for (const Playback::ActingMotor& body : acting)
        motors.push_back({body.motor->name, body.now, body.strength});
    std::vector<NamedObstacle> obstacles;
    for (const auto& body : playback.standing())
        obstacles.push_back({body.obstacle->name == scene::SceneObstacle{}.name ? "" : body.obstacle->name, body.now});
    PictureSettings settings;
    settings.title = scene_->name;
    settings.width = scene_->pictures.width;
    settings.speed_scale = scene_->pictures.speed_scale;
    settings.flow = scene_->pictures.flow;
    settings.above_ground = scene_->pictures.above_ground;
    settings.slice_point = scene_->followed_point(time);
    settings.slice_point.y = (scene_->pictures.above_ground ? playback.wind().origin().y
                              : scene_->has_floor()         ? scene_->floor_height(time)
                                                            : settings.slice_point.y) +
                             scene_->pictures.slice_height;
    settings.slice_point.z += scene_->pictures.slice_z;
    for (const scene::SceneMotor& motor : scene_->motors)
        ++settings.motors_of_scene[motor.motor.index()];
    parts_ = frame_parts(playback.wind(), settings);
    const std::filesystem::path file = folder_ / images_of().name(frame);
    const auto drawn = draw_frame(playback.wind(), time, trails, motors, obstacles, settings, file);
    picture_seconds_ += seconds_since(begin);
    if (!drawn)
        return fault_of(drawn);
    pictures_.push_back(file);
#endif
    return {};
}

Fault FrameWriter::write_vdb([[maybe_unused]] Playback& playback, [[maybe_unused]] std::int64_t frame) {
#if WINDROW_WITH_VDB
    const auto begin = Clock::now();
    const Fault fault = vdb_frames_->write(playback, frame);
    vdb_seconds_ += seconds_since(begin);
    if (fault)
        return fault;
    ++vdbs_;
#endif
    return {};
}

// Before the first step the cells inside bodies hold the velocity of bodies that have appeared, 0, as after each step their body's.
Fault FrameWriter::write_fields(const Playback& playback, std::int64_t frame) {
    const auto written = detail::where_memory_lasts([&]() -> Result<void> {
        const WindView air = playback.wind().view();
        std::vector<float> inside(air.field().size());
        if (auto marked = playback.wind().reader().write_obstacles(inside); !marked)
            return marked;
        FieldGrid grid = field_grid(air, inside);
        grid.time = playback.time();
        for (std::size_t cell = 0; playback.steps() == 0 && cell < grid.velocity.size(); ++cell)
            if (grid.obstacle[cell] > 0.0f)
                grid.velocity[cell] = glm::vec4(0.0f);
        for (const FieldFormat format : fields_) {
            if (auto file = write_field(folder_ / files_of(format).name(frame), format, grid); !file)
                return file;
            ++fields_written_;
        }
        return {};
    });
    return written ? Fault{} : Fault{.sentence = written.error(), .machine = written.failure().fault != windrow::Fault::rejected};
}

Fault FrameWriter::write_contact_sheet() {
#if WINDROW_WITH_IMAGES
    if (pictures_.empty())
        return {};
    const auto begin = Clock::now();
    constexpr std::size_t k_max_on_sheet = 12;
    const std::size_t count = std::min(k_max_on_sheet, pictures_.size());
    std::vector<std::filesystem::path> chosen;
    for (std::size_t i = 0; i < count; ++i)
        chosen.push_back(pictures_[count == 1 ? 0 : i * (pictures_.size() - 1) / (count - 1)]);
    const std::filesystem::path file = folder_ / "contact_sheet.png";
    const auto drawn = draw_contact_sheet(chosen, file, parts_);
    picture_seconds_ += seconds_since(begin);
    if (!drawn)
        return fault_of(drawn);
    contact_sheet_ = true;
#endif
    return {};
}

std::string FrameWriter::clear_other_frames(scene::Extent extent) const {
    return scene::clear_other_frames(folder_, kept_files(), last_, extent);
}

Result<std::vector<std::byte>> FrameWriter::save() const {
#if WINDROW_WITH_VDB
    if (vdb_frames_)
        return vdb_frames_->save();
#endif
    return std::vector<std::byte>();
}

Result<void> FrameWriter::load([[maybe_unused]] std::span<const std::byte> bytes, [[maybe_unused]] const Playback& playback,
                               std::int64_t count) {
    for (std::int64_t frame = first_; frame < first_ + count; ++frame) {
        for (const scene::FrameFiles& files : kept_files())
            if (const std::filesystem::path file = folder_ / files.name(frame); !std::filesystem::is_regular_file(file))
                return Error{message(file.string(), ": is missing, though the run is past this frame: drop --resume.")};
        if (images_)
            pictures_.push_back(folder_ / images_of().name(frame));
    }
    vdbs_ = vdb_ ? static_cast<std::size_t>(count) : 0;
    fields_written_ = fields_.size() * static_cast<std::size_t>(count);
#if WINDROW_WITH_VDB
    if (vdb_frames_)
        return vdb_frames_->load(bytes, playback);
#endif
    return {};
}

std::vector<scene::FrameFiles> FrameWriter::kept_files() const {
    std::vector<scene::FrameFiles> kept;
    if (images_)
        kept.push_back(images_of());
    if (vdb_)
        kept.push_back({"vel_", scene_->vdb.format == scene::VdbFormat::nanovdb ? ".nvdb" : ".vdb", digits_});
    for (const FieldFormat format : fields_) {
        kept.push_back(files_of(format));
        if (format == FieldFormat::raw)
            kept.push_back({"wind_", ".raw.json", digits_});
    }
    return kept;
}

scene::FrameFiles FrameWriter::files_of(FieldFormat format) const {
    return {"wind_", message(".", name_of(format)), digits_};
}

scene::FrameFiles FrameWriter::images_of() const {
    return {"frame_", ".png", digits_};
}

} // namespace windrow::cli
