#include "cli/vdb_frames.h"

#include "fluid/vdb/film_grid.h"

#include <algorithm>

namespace windrow::cli {
namespace {

vdb::Options options_of(const scene::VdbSetting& setting) {
    return {.name = setting.name,
            .form = setting.three_scalars ? vdb::Form::three_scalars : vdb::Form::one_vector,
            .precision = setting.precision == scene::VdbPrecision::half ? vdb::Precision::half : vdb::Precision::full,
            .up = setting.up == scene::VdbUp::z ? vdb::UpAxis::z : vdb::UpAxis::y,
            .format = setting.format == scene::VdbFormat::nanovdb ? vdb::Format::nanovdb : vdb::Format::openvdb};
}

/// Nothing: the cells of the air as they are.
std::optional<vdb::Region> region_of(const scene::VdbSetting& setting, const WindView& air) {
    if (!setting.holds_more())
        return std::nullopt;
    vdb::Region region = vdb::region_around(air, setting.margin, setting.voxel_size);
    if (setting.box) {
        region.low = setting.box->centre - 0.5 * glm::dvec3(setting.box->size);
        region.high = setting.box->centre + 0.5 * glm::dvec3(setting.box->size);
    }
    return region;
}

} // namespace

VdbFrames::VdbFrames(const scene::Scene& scene, std::filesystem::path folder, int digits, const ParallelFor& parallel_for)
    : scene_(&scene), sequence_{.folder = std::move(folder),
                                .prefix = "vel_",
                                .digits = digits,
                                .options = options_of(scene.vdb)},
      parallel_for_(parallel_for) {}

Fault VdbFrames::follow(const Playback& playback, double dt) {
    if (!scene_->vdb.grids.density)
        return {};
    const WindView air = playback.wind().view();
    if (!smoke_) {
        auto made = Tracer::create(air, parallel_for_);
        if (!made)
            return {made.error(), true};
        smoke_ = *std::move(made);
    }
    if (const auto carried = smoke_->step(air, playback.wind().obstacles().in_reach(), dt); !carried)
        return {carried.error(), true};
    const double time = playback.time();
    for (const scene::SceneSmoke& source : scene_->smoke)
        if (time >= source.from && time < source.until)
            smoke_->blow(source.path ? scene_->paths[*source.path].path.at(time) : source.position, source.radius);
    return {};
}

Fault VdbFrames::write(Playback& playback, std::int64_t number) {
    const auto frame = static_cast<int>(number);
    const auto shown = air_of(playback);
    if (!shown)
        return {shown.error(), true};
    const WindView& air = *shown;
    const auto region = region_of(scene_->vdb, air);
    if (!region) {
        auto grid = vdb::grid_of(playback.wind(), playback.wind().reader());
        if (!grid)
            return {grid.error(), true};
        grid->field = air.field();
        return written(*grid, frame, playback.time());
    }
    if (!smoke_)
        if (const Fault fault = follow(playback, 0.0))
            return fault;

    const scene::VdbGrids& grids = scene_->vdb.grids;
    const std::size_t cells = air.box().cell_count();
    std::vector<vdb::CellScalar> scalars;
    const auto made = detail::where_memory_lasts([&]() -> Result<void> {
        if (grids.divergence) {
            if (auto found = find_divergence(air, playback.wind().obstacles().in_reach()); !found)
                return found;
            scalars.push_back({"divergence", "1/s", divergence_});
        }
        if (grids.pressure) {
            pressure_.resize(cells);
            if (auto found = playback.wind().reader().write_pressure(pressure_); !found)
                return found;
            scalars.push_back({"pressure", "m^2/s^2", pressure_});
        }
        if (grids.density)
            scalars.push_back({"density", "1", smoke_->cells()});
        return {};
    });
    if (!made)
        return {made.error(), true};
    const auto film = vdb::film_grid(air, {.region = region,
                                           .speed = grids.speed,
                                           .vorticity = grids.vorticity,
                                           .obstacle = obstacle_,
                                           .scalars = scalars,
                                           .parallel_for = parallel_for_});
    if (!film)
        return {detail::message(scene_->file.string(), ": $.vdb: ", film.error()), false};
    return written(film->grid, frame, playback.time());
}

Result<std::vector<std::byte>> VdbFrames::save() const {
    return smoke_ ? smoke_->save() : std::vector<std::byte>();
}

Result<void> VdbFrames::load(std::span<const std::byte> bytes, const Playback& playback) {
    if (bytes.empty())
        return {};
    auto made = Tracer::load(bytes, playback.wind().view(), playback.wind().obstacles().in_reach(), parallel_for_);
    if (!made)
        return made.failure();
    smoke_ = *std::move(made);
    return {};
}

Result<WindView> VdbFrames::air_of(const Playback& playback) {
    const WindView air = playback.wind().view();
    obstacle_.clear();
    if (playback.wind().obstacles().count() == 0 || (playback.steps() > 0 && !scene_->vdb.holds_more()))
        return air;
    return detail::where_memory_lasts([&]() -> Result<WindView> {
        obstacle_.resize(air.field().size());
        if (auto marked = playback.wind().reader().write_obstacles(obstacle_); !marked)
            return marked.failure();
        if (playback.steps() > 0)
            return air;
        first_.assign(air.field().begin(), air.field().end());
        for (std::size_t cell = 0; cell < first_.size(); ++cell)
            if (obstacle_[cell] > 0.0f)
                first_[cell] = glm::vec4(0.0f);
        return WindView(air.box(), air.window(), air.blend_zone(), air.ambient(), first_);
    });
}

Result<void> VdbFrames::find_divergence(const WindView& air, std::span<const PlacedObstacle> obstacles) {
    if (!work_) {
        auto made = Workspace::create({.box = air.box(), .ambient = air.ambient().mean(), .parallel_for = parallel_for_});
        if (!made)
            return made.failure();
        work_ = *std::move(made);
        divergence_.resize(air.box().cell_count());
    }
    if (auto placed = work_->set_obstacles(obstacles); !placed)
        return placed;
    divergence(*work_, air.field(), divergence_);
    return {};
}

Fault VdbFrames::written(const vdb::VelocityGrid& grid, int number, double time) {
    const vdb::WriteResult result = sequence_.write(grid, number, time);
    if (result)
        return {};
    return {result.error(), result.problem() == vdb::Problem::disk_full || result.problem() == vdb::Problem::out_of_memory};
}

} // namespace windrow::cli
