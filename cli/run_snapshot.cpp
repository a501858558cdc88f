#include "cli/run_snapshot.h"

#include "fluid/core/archive.h"
#include "fluid/core/obstacle_record.h"
#include "fluid/files/input_file.h"
#include "fluid/version.h"

#include <limits>
#include <utility>

namespace windrow::cli {
namespace {

using detail::message;

constexpr detail::Format k_head_format{"WINDRUN ", 1, "snapshot of a run", "windrow run --snapshot-every"};

std::span<const std::byte> bytes_of(std::string_view text) {
    return std::as_bytes(std::span(text));
}
std::string_view text_of(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

} // namespace

Result<RunIdentity> identity_of(const scene::Scene& scene, std::string flags) {
    const auto text = detail::read_input(scene.file, {.max_bytes = std::numeric_limits<std::size_t>::max() / 2});
    if (!text)
        return text.failure();
    return detail::where_memory_lasts([&]() -> Result<RunIdentity> {
        detail::Writer writer(text->size());
        writer(detail::checksum(bytes_of(*text)), scene.air);
        for (const scene::SceneObstacle& body : scene.obstacles)
            writer(body.obstacle);
        for (const scene::ScenePath& path : scene.paths)
            for (const scene::PathPoint& point : path.path.points())
                writer(point.time, point.position);
        // What files of the picture put into the air: heights below walkers, bodies of meshes, trees on their ground.
        for (const scene::Carried& body : scene.carried) {
            const scene::MotionPath& path = scene.paths[body.path].path;
            writer(body.front.x, body.front.y);
            for (const scene::PathPoint& point : path.points())
                writer(body.middle_at(path, point.time));
        }
        for (const scene::PlantedStand& planted : scene.planted)
            for (const DragDeposit& deposit : drag_of(planted.stand, planted.ground))
                writer(deposit);
        flags += message(" --simd ", name_of(scene.air.simd), " (" WINDROW_VERSION_STRING ")");
        return RunIdentity{.scene = detail::checksum(std::move(writer).take()), .flags = std::move(flags)};
    });
}

Result<bool> RunSnapshot::read(const RunIdentity& run) {
    if (!std::filesystem::exists(file_))
        return false;
    auto bytes = detail::read_input(file_, {.max_bytes = std::numeric_limits<std::size_t>::max() / 2});
    if (!bytes)
        return bytes.failure();
    bytes_ = *std::move(bytes);
    const std::string hint = " Remove it, or drop --resume.";
    auto parts = split_parts(bytes_of(bytes_));
    if (!parts)
        return parts.failure().after(message(file_.string(), ": "));
    parts_ = *std::move(parts);
    std::uint64_t scene = 0;
    const auto head = detail::read_sealed(part("run"), k_head_format, [&](detail::Reader& reader) { reader(scene, frames_); });
    if (!head)
        return head.failure().after(message(file_.string(), ": "));
    if (text_of(part("flags")) != run.flags)
        return Error{message(file_.string(), ": is of a run with \"", text_of(part("flags")), "\", this one has \"", run.flags,
                             "\": give the same flags, or drop --resume.")};
    if (scene != run.scene)
        return Error{message(file_.string(), ": the scene or a file that it names has changed since: drop --resume.")};
    return true;
}

Probes::Tables RunSnapshot::tables() const {
    return {.probes = text_of(part("probes.csv")), .forces = text_of(part("forces.csv"))};
}

std::string_view RunSnapshot::timings_csv() const {
    return text_of(part("timings.csv"));
}

Result<Playback> RunSnapshot::playback(const scene::Scene& scene, const ParallelFor& threads) const {
    auto made = Playback::load(scene, threads, part("levels"), part("wind"), part("air"));
    if (!made)
        return made.failure().after(message(file_.string(), ": "));
    return made;
}

Result<void> RunSnapshot::restore(FrameWriter& writer, Timings& timings, const Playback& playback) const {
    if (auto figures =
            detail::read_sealed(part("timings"), k_head_format, [&](detail::Reader& reader) { Timings::pass(reader, timings); });
        !figures)
        return figures.failure().after(message(file_.string(), ": "));
    return writer.load(part("frames"), playback, frames_);
}

Fault RunSnapshot::write(const RunIdentity& run, std::int64_t frames, Playback& playback, const FrameWriter& writer,
                         const Probes& probes, const Timings& timings, const OutputFile* csv) const {
    const auto file = detail::where_memory_lasts([&]() -> Result<std::vector<std::byte>> {
        const auto wind = playback.wind().on_cpu()->save();
        if (!wind)
            return wind.failure();
        const auto levels = playback.levels().save();
        if (!levels)
            return levels.failure();
        const auto shown = writer.save();
        if (!shown)
            return shown.failure();
        detail::Writer head(64), figures(64);
        head(run.scene, frames);
        Timings::pass(figures, timings);
        const auto head_bytes = std::move(head).finish(k_head_format), figure_bytes = std::move(figures).finish(k_head_format);
        const auto air = playback.air().save();
        const Probes::Tables tables = probes.tables();
        return join_parts({{{"run", head_bytes},
                            {"flags", bytes_of(run.flags)},
                            {"levels", *levels},
                            {"wind", *wind},
                            {"air", air},
                            {"frames", *shown},
                            {"timings", figure_bytes},
                            {"probes.csv", bytes_of(tables.probes)},
                            {"forces.csv", bytes_of(tables.forces)},
                            {"timings.csv", bytes_of(csv != nullptr ? std::string_view(csv->text()) : std::string_view())}}});
    });
    if (!file)
        return {file.error(), true};
    detail::NewFile out(file_);
    return out.write({reinterpret_cast<const char*>(file->data()), file->size()}) && out.publish()
               ? Fault{}
               : write_fault(file_, out.error());
}

void RunSnapshot::clear() {
    parts_.clear();
    bytes_ = std::string();
}

void RunSnapshot::remove() const {
    std::error_code absent;
    std::filesystem::remove(file_, absent);
}

std::span<const std::byte> RunSnapshot::part(std::string_view name) const {
    const auto found = find_part(parts_, name);
    return found ? *found : std::span<const std::byte>();
}

} // namespace windrow::cli
