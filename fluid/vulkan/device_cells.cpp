// Cells on the device. The device is ahead of the host by the frames in flight. The host decides by its own data (motors in
// reach of the box, a move of the box). The device decides by its own data (the sub-steps). Sleep needs both: the core decides by
// what a read-back says of the tick SpeedBound::k_delay before.
#include "fluid/vulkan/device_cells.h"

#include "fluid/core/message.h"
#include "fluid/core/wind_core.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

namespace windrow::vulkan {

using Kind = CellChange::Kind;

DeviceCells::DeviceCells(const WindCore& wind, const ReadBacks& read_backs, std::unique_ptr<Air> cells)
    : air(std::move(cells)), wind_(wind), read_backs_(read_backs) {
    queue_.make_room();
}

void DeviceCells::make_room(const CellNeeds& needs) {
    queue_.make_room(needs.set ? wind_.box().cell_count() : 0);
}

Result<void> DeviceCells::set_boundaries(const Boundaries& boundaries, bool kinds) {
    auto prepared = windrow::detail::where_memory_lasts(
        [&] { return air->prepare(boundaries, kinds || (new_sides_ && new_sides_->tables)); });
    if (!prepared)
        return prepared.failure();
    materialise_gusts(); // with the old boundaries
    new_sides_ = *std::move(prepared);
    return {};
}

void DeviceCells::record(const CellChange& change) {
    if (commands_ != VK_NULL_HANDLE)
        air->apply(commands_, change);
    else
        queue_.push(change);
}

void DeviceCells::refill(const AmbientWind& ambient, const Window& window) {
    if (filled_ && wind_.outer)
        record({.kind = Kind::fill, .ambient = ambient, .window = window, .kept = wind_.frames.has_value()});
}

void DeviceCells::apply(const CellChange& change) {
    if (change.kind == Kind::keep || change.kind == Kind::set)
        refill(change.ambient, change.window);
    record(change);
    filled_ = change.kind == Kind::fill || (filled_ && change.kind != Kind::set && change.kind != Kind::keep);
    if (change.kind == Kind::fill || change.kind == Kind::set)
        held_at_ = wind_.sleep.drift;
}

Result<void> DeviceCells::check(const Gusts& gusts) const {
    if ((gusts.intensity > 0.0f || gusts.tile) && !air->holds_gusts())
        return Error{"This wind was created without memory for gusts: set Settings::gusts, or give the config gusts."};
    return {};
}

// What a loaded wind measured is in its snapshot.
MeasuredSpeeds DeviceCells::measured() const {
    const std::uint64_t last = read_backs_.tick();
    const AirReport& report = read_backs_.report();
    MeasuredSpeeds speeds{};
    for (std::uint64_t n = 0; n < speeds.size() && n < last && last - n > loaded_tick_; ++n)
        speeds[n] = {.tick = last - n,
                     .largest = n == 0 ? report.largest_component : report.largest_before[n - 1],
                     .still = (report.still >> n & 1u) != 0};
    return speeds;
}

bool DeviceCells::materialise_gusts() {
    if (std::exchange(held_at_, wind_.sleep.drift) == wind_.sleep.drift)
        return false;
    CellChange change{.kind = Kind::fill, .ambient = wind_.ambient, .window = wind_.window(), .kept = wind_.frames.has_value()};
    record(change);
    if (wind_.frames) {
        change.kind = Kind::fill_before;
        change.ambient.set_phase(wind_.frames->gust_phase_before);
        record(change);
    }
    return true;
}

bool DeviceCells::step(const CellStep& step, Diagnostics& report) {
    materialise_gusts();
    refill(*step.ambient, *step.window);
    filled_ = false;
    const bool dictated = !dictated_.empty();
    TickRecorded tick{};
    if (dictated) {
        tick = dictated_.front();
        dictated_.pop_front();
    } else {
        const Air::Recorded recorded = recording_of(step);
        tick = {.substeps = static_cast<std::uint8_t>(recorded.substeps), .limits = recorded.limits, .rests = step.rests};
    }
    air->step(commands_, step, {.substeps = tick.substeps, .limits = tick.limits});
    report.out_of_memory = air->lacks_obstacles() || air->lacks_drag();
    report.sealed_sources = air->sealed_sources();
    report.sealed_rooms = air->sealed_rooms();
    if (const Solids* const solids = air->solids())
        report.filling_obstacles = solids->filling();
    if (wind_.log != nullptr)
        wind_.log->note(tick);
    step.ambient->advance(step.duration);
    read_backs_.report_to(report, wind_.box());
    report.diffusion = wind_.config.stages.diffusion
                           ? diffusion_method(wind_.config.viscosity, static_cast<float>(step.duration), wind_.box().finest())
                           : DiffusionMethod::none;
    if (!tick.rests)
        return false;
    apply({.kind = Kind::fill, .ambient = *step.ambient, .window = *step.window, .kept = step.kept});
    report_ambient(step, report);
    return true;
}

Air::Recorded DeviceCells::recording_of(const CellStep& step) const {
    if (step.substeps > 0)
        return {.substeps = step.substeps, .limits = step.substeps == wind_.config.max_substeps};
    const AirReport& report = read_backs_.report();
    const double speed = wind_.speed.after(known_tick(), report.largest_component, report.apart);
    const auto substeps_in = [&](double time) {
        return std::ceil(speed * time / static_cast<double>(wind_.config.cell_size * wind_.config.max_cfl));
    };
    const double most = wind_.config.max_substeps, behind = static_cast<double>(report.carried_time);
    return {.substeps = static_cast<int>(std::clamp(substeps_in(step.duration + behind), 1.0, most)),
            .limits = substeps_in(step.duration) > most};
}

// Report of air at rest: the ambient wind, which without gusts differs by height alone. With gusts the last read-back is
// reported: each component was within the sleep threshold of the ambient wind.
void DeviceCells::report_ambient(const CellStep& step, Diagnostics& report) const {
    if (step.ambient->gusting())
        return;
    report.max_speed = 0.0f;
    report.energy = 0.0;
    report.divergence_rms = 0.0;
    const glm::ivec3 cells = step.window->cells;
    const auto h = static_cast<double>(step.window->cell_size);
    for (int j = 0; j < cells.y; ++j) {
        const glm::vec3 u = step.ambient->velocity(step.window->centre(0, j, 0));
        report.max_speed = std::max({report.max_speed, std::abs(u.x), std::abs(u.y), std::abs(u.z)});
        const double volume = static_cast<double>(wind_.box().volume(j)) * h * h * h;
        report.energy += 0.5 * static_cast<double>(glm::dot(u, u)) * volume * cells.x * cells.z;
    }
}

// Sleeping air is shown at the frame's own time, between two ticks: the next waking tick fills it again.
void DeviceCells::show(const FrameBlend& shown) {
    if (shown.unchanged)
        return;
    blend = shown.still ? 1.0f : shown.factor;
    if (!shown.still || !wind_.ambient.gusting())
        return;
    record({.kind = Kind::fill, .ambient = wind_.frames->shown.ambient, .window = wind_.window()});
    held_at_ = k_unheld;
}

bool DeviceCells::begin(VkCommandBuffer commands, int slot) {
    air->begin(slot);
    commands_ = commands;
    blend.reset();
    const bool waited = waits();
    if (restored_)
        air->restore(commands, *std::move(restored_), wind_.ambient);
    restored_.reset();
    if (new_sides_)
        air->set_boundaries(commands, *std::move(new_sides_));
    new_sides_.reset();
    queue_.record(*air, commands);
    return waited;
}

void DeviceCells::end() {
    air->end(commands_);
    commands_ = VK_NULL_HANDLE;
}

void DeviceCells::continue_from(RestoredAir&& restored, bool filled) {
    air->make_room_to_restore();
    restored.window = wind_.window();
    queue_.clear();
    queue_.make_room();
    loaded_tick_ = wind_.speed.tick();
    filled_ = filled;
    held_at_ = wind_.sleep.drift;
    restored_ = std::move(restored);
}

void DeviceCells::forget() {
    queue_.clear();
    restored_.reset();
    air->forget();
}

void DeviceCells::shift_origin(const OriginShift& shift) {
    air->shift_origin(shift);
    queue_.shift_origin(shift);
    if (restored_) {
        shift.move(restored_->window);
        shift.move(restored_->shown);
        shift.move(restored_->shown_before);
    }
    when_shifted(shift);
}

} // namespace windrow::vulkan
