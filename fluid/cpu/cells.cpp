// Operations of a wind's core on the cells on the CPU. The ambient wind is stored cell by cell, halo included, where it is not
// uniform.
#include "fluid/cpu/cells.h"

#include "fluid/core/obstacle_record.h"
#include "fluid/core/wind_core.h"
#include "fluid/cpu/workspace.h"
#include "fluid/grid/box_rules.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <utility>

namespace windrow::cpu {
namespace {

// Visits the cells that a shift exposes: those with a source outside the box.
template <class Visit>
void for_each_exposed(glm::ivec3 cells, CellIndex shift, const Visit& visit) {
    const auto outside = [&](int axis, int index) { return index + shift[axis] < 0 || index + shift[axis] >= cells[axis]; };
    std::size_t n = 0;
    for (int k = 0; k < cells.z; ++k)
        for (int j = 0; j < cells.y; ++j)
            for (int i = 0; i < cells.x; ++i, ++n)
                if (outside(2, k) || outside(1, j) || outside(0, i))
                    visit(n, i, j, k);
}

glm::vec4 cell_at(const float* cell) {
    return {cell[0], cell[1], cell[2], 0.0f};
}

// Four floats of a cell at a time, over a box.
template <class Visit>
void for_each_cell(glm::ivec3 cells, const Visit& visit) {
    for_each_exposed(cells, CellIndex(cells), visit);
}

} // namespace

Cells::Cells(const WindCore& wind, Workspace workspace, Cells* outer)
    : work(std::move(workspace)), air(box().cell_count()), sources(box().cells), wind_(wind), config_(wind.config),
      around_(wind.ambient), reading_maker_(box(), wind.config) {
    if (outer != nullptr) {
        outer_.emplace(box(), *outer);
        keep_pressure();
    }
    make_room_around(config_.gusts);
    if (wind_.rough()) {
        layer_.emplace(box(), *config_.roughness);
        diffused_ = Buffer<glm::vec4>(air.velocity.size());
    }
    // A step of up to k_longest_prepared does not allocate: the memory for its viscosity is allocated here.
    make_room_for_viscosity(diffusion_method(config_.viscosity, WindCore::k_longest_prepared, box().finest()));
}

// --- Room --------------------------------------------------------------------------------------------------------------------

void Cells::make_room(const CellNeeds& needs) {
    if (needs.gusts != nullptr)
        make_room_around(*needs.gusts);
    if (needs.step > 0.0)
        make_room_for_step(static_cast<float>(needs.step));
    if (needs.frames && frames.before.empty())
        frames = std::exchange(frames_before_, {});
    if (needs.frames && frames.before.empty()) {
        const std::size_t cells = air.velocity.size();
        frames = {.before = Buffer<glm::vec4>(cells),
                  .shown = {.cells = Buffer<glm::vec4>(cells)},
                  .shown_before = {.cells = Buffer<glm::vec4>(cells)}};
    }
}

void Cells::make_room_around(const Gusts& gusts) {
    const auto make = [&](AmbientField& field) {
        if (field.cells() != box().cells)
            field = AmbientField(box().cells);
    };
    if (config_.profile)
        make(mean_field_);
    if (!(gusts.intensity > 0.0f))
        return;
    make(ambient_field_);
    make(ambient_next_);
    if (config_.profile)
        profile_bends_.reserve(work.state().carried_rules[1].size());
    reserve_solved();
}

void Cells::make_room_for_step(float dt) {
    if (config_.stages.sources && config_.stages.projection && wind_.motors.has_volume_source()) {
        if (source_flow.empty())
            source_flow = Buffer<glm::vec4>(air.velocity.size());
        reserve_solved();
        if (config_.boundaries.in_free_air()) {
            free_air_.make_room(box());
            open_parts_.reserve(Motors::k_capacity);
        }
    }
    if (wind_.viscous(dt))
        make_room_for_viscosity(diffusion_method(config_.viscosity, air.undiffused_time + dt, box().finest()));
}

void Cells::make_room_for_viscosity(DiffusionMethod method) {
    if (method != DiffusionMethod::none && diffused_.empty())
        diffused_ = Buffer<glm::vec4>(air.velocity.size());
    if (method == DiffusionMethod::implicit)
        work.state().reserve_diffusion();
}

void Cells::reserve_solved() {
    if (solved.empty())
        solved = Buffer<glm::vec4>(air.velocity.size());
}

// --- The wind around the box -------------------------------------------------------------------------------------------------

void Cells::renew_around(const AmbientWind& ambient, const Window& window, const ParallelFor& parallel_for) {
    if (!around_stale_ && same_wind(around_, ambient) && around_origin_cells_ == window.origin_cells)
        return;
    around_ = ambient;
    around_origin_cells_ = window.origin_cells;
    around_stale_ = false;
    work.set_ambient(config_.ambient);
    Workspace::State& around = work.state();
    around.mean_cells = around.ambient_cells = nullptr;
    const auto renew = [&](AmbientField& field, const AmbientWind& wind) {
        field.fill(wind, window, parallel_for);
        return field.data();
    };
    if (config_.profile)
        around.ambient_cells = around.mean_cells = renew(mean_field_, ambient.without_gusts());
    if (ambient.settings().gusts.intensity > 0.0f) {
        around.ambient_cells = renew(ambient_field_, ambient);
        if (config_.profile)
            bend_profile(window);
    }
}

// The profile beyond a wall, for transport.
void Cells::bend_profile(const Window& window) {
    const detail::HostVector<HaloRule>& rows = work.state().carried_rules[1];
    const auto profile = [&](std::size_t row) {
        const int j = rows[row].ambient ? static_cast<int>(row) - k_halo_low : rows[row].source;
        return around_.profile_at(window.centre(0, j, 0).y);
    };
    profile_bends_.assign(rows.size(), 0.0f);
    if (config_.boundaries.periodic(1))
        return;
    for (std::size_t row = 1; row + 1 < rows.size(); ++row)
        profile_bends_[row] = profile(row - 1) - 2.0f * profile(row) + profile(row + 1);
}

glm::vec4 Cells::ambient_at(int i, int j, int k) const {
    if (around_.settings().gusts.intensity > 0.0f)
        return cell_at(ambient_field_.data() + 4 * padded_index(box().cells, {i, j, k}));
    return mean_at(i, j, k);
}

glm::vec4 Cells::mean_at(int i, int j, int k) const {
    return config_.profile ? cell_at(mean_field_.data() + 4 * padded_index(box().cells, {i, j, k}))
                           : glm::vec4(work.ambient(), 0.0f);
}

glm::vec4 Cells::wind_at(std::size_t n, int i, int j, int k) const {
    return in_room(n) ? glm::vec4(0.0f) : ambient_at(i, j, k);
}

// [m/s] All that is prescribed, of cells of a row: from number n at `cell` on. Where it is nothing, returns false and writes nothing.
bool Cells::write_prescribed(std::size_t n, glm::ivec3 cell, std::span<glm::vec4> winds) const {
    if (!has_source_flow() && !around_.gusting())
        return false;
    std::fill(winds.begin(), winds.end(), glm::vec4(0.0f));
    if (has_source_flow())
        for (std::size_t i = 0; i < winds.size(); ++i)
            winds[i] += source_flow[n + i];
    if (around_.gusting())
        for (std::size_t i = 0; i < winds.size(); ++i)
            winds[i] += wind_at(n + i, cell.x + static_cast<int>(i), cell.y, cell.z);
    return true;
}

bool Cells::in_room(std::size_t n) const {
    if (!work.state().has_solids())
        return false;
    const Solids& solids = *work.state().solids;
    if (unplaced_shift_ == glm::ivec3(0))
        return solids.in_room(static_cast<std::uint32_t>(n));
    const glm::ivec3 placed = solids.place_of(static_cast<std::uint32_t>(n)) + unplaced_shift_;
    return glm::all(glm::greaterThanEqual(placed, glm::ivec3(0))) && glm::all(glm::lessThan(placed, box().cells)) &&
           solids.in_room(static_cast<std::uint32_t>(box().index(placed.x, placed.y, placed.z)));
}

void Cells::add_ambient(std::span<glm::vec4> field, float factor) {
    const std::span<const std::uint32_t> sheltered =
        work.state().has_solids() ? work.state().solids->sheltered() : std::span<const std::uint32_t>();
    for (std::size_t n = 0; n < sheltered.size(); ++n)
        sheltered_air_[n] = field[sheltered[n]];
    const glm::ivec3 cells = box().cells;
    config_.parallel_for(cells.z, [&](int k) {
        for (int j = 0; j < cells.y; ++j) {
            const float* const around = ambient_field_.data() + 4 * padded_index(cells, {0, j, k});
            glm::vec4* const row = field.data() + box().index(0, j, k);
            for (int i = 0; i < cells.x; ++i)
                row[i] += factor * cell_at(around + 4 * i);
        }
    });
    for (std::size_t n = 0; n < sheltered.size(); ++n)
        field[sheltered[n]] = sheltered_air_[n];
}

void Cells::fill(std::span<glm::vec4> field) const {
    if (around_.uniform() && !outer_)
        std::fill(field.begin(), field.end(), ambient_at(0, 0, 0));
    else
        for_each_cell(box().cells,
                      [&](std::size_t n, int i, int j, int k) { field[n] = ambient_at(i, j, k) + change_at(i, j, k); });
}

// --- Changes -----------------------------------------------------------------------------------------------------------------

Result<void> Cells::set_boundaries(const Boundaries& boundaries, bool kinds) {
    materialise_air(); // with the old boundaries
    materialise_before();
    auto changed = work.set_boundaries(boundaries);
    air.fresh = air.fresh || (changed && kinds);
    inside_is_air_ = inside_is_air_ || (changed && kinds); // another periodic axis is another neighbour
    around_stale_ = reading_stale_ = true;
    sampled_.held = false;
    return changed;
}

void Cells::apply(const CellChange& change) {
    renew_around(change.ambient, change.window, config_.parallel_for);
    sampled_.held = false;
    // Cells that a host sets before a first step are beside the outer wind of now, not beside that of the fill.
    if (outer_ && (change.kind == CellChange::Kind::fill || (change.kind == CellChange::Kind::set && filled_)))
        outer_->renew(change.window, config_.parallel_for);
    else if (outer_)
        outer_->move_to(change.window, config_.parallel_for);
    switch (change.kind) {
    case CellChange::Kind::fill:
        filled_ = true;
        return fill_air();
    case CellChange::Kind::fill_before:
        fill(frames.before);
        std::fill_n(pressure_before_.data(), pressure_before_.size(), 0.0f);
        before_held_at_ = wind_.sleep.drift;
        return;
    case CellChange::Kind::shift:
        return shift(change);
    case CellChange::Kind::add_change:
        return add_change(change);
    case CellChange::Kind::add_wind:
        return add_wind(change);
    case CellChange::Kind::set:
        return set(change.cells);
    case CellChange::Kind::keep:
        refill();
        return keep();
    case CellChange::Kind::begin_frames:
        keep();
        return show_air();
    case CellChange::Kind::end_frames:
        frames_before_ = std::exchange(frames, {});
        return;
    }
}

void Cells::fill_air() {
    held_at_ = k_unheld;
    air.fresh = inside_is_air_ = true;
    air.undiffused_time = 0.0f;
    loads.clear();
    std::fill_n(source_flow.data(), source_flow.size(), glm::vec4(0.0f));
    std::fill_n(pressure_.data(), pressure_.size(), 0.0f);
}

// Air that is filled and not stepped yet is that of the outer wind as the step finds it, whoever read it before.
void Cells::refill() {
    if (std::exchange(filled_, false) && outer_)
        held_at_ = k_unheld;
}

void Cells::set(std::span<const glm::vec4> cells) {
    filled_ = false;
    std::transform(cells.begin(), cells.end(), air.velocity.data(), [](glm::vec4 u) { return glm::vec4(u.x, u.y, u.z, 0.0f); });
    held_at_ = wind_.sleep.drift;
    air.fresh = inside_is_air_ = true;
    air.undiffused_time = 0.0f;
    if (!frames.before.empty())
        keep();
}

void Cells::add_wind(const CellChange& change) {
    const auto add = [&](std::span<glm::vec4> field) {
        for_each_cell(box().cells, [&](std::size_t n, int i, int j, int k) { field[n] += change.factor * wind_at(n, i, j, k); });
    };
    add(air.velocity);
    if (!air.fresh)
        add(air.velocity_old);
    if (change.kept)
        add(frames.before);
}

void Cells::add_change(const CellChange& change) {
    const auto add = [&](std::span<glm::vec4> field) {
        for (std::size_t row = 0, n = 0; n < field.size(); ++row) {
            const int j = static_cast<int>(row % static_cast<std::size_t>(box().cells.y));
            const glm::vec4 here(around_.profile_at(change.window.centre(0, j, 0).y) * change.change, 0.0f);
            for (int i = 0; i < box().cells.x; ++i, ++n)
                if (!in_room(n))
                    field[n] += here;
        }
    };
    if (change.kept)
        add(frames.before);
    if (!change.to_air)
        return;
    add(air.velocity);
    if (!air.fresh)
        add(air.velocity_old);
}

SurfaceHistory Cells::surface_history() const {
    const Workspace::State& state = work.state();
    SurfaceHistory history;
    history.loads.assign(loads.loads().begin(), loads.loads().end());
    history.duration = loads.duration();
    if (state.solid_keys.empty() || glm::any(glm::greaterThanEqual(glm::abs(unplaced_shift_), box().cells)))
        return history; // no cell of the box has any terms
    if (state.has_solids())
        history.placed = placed_;
    history.inside_is_air = inside_is_air_;
    history.keys = state.solid_keys;
    history.terms.assign(state.solid_terms.begin(), state.solid_terms.begin() + static_cast<std::ptrdiff_t>(history.keys.size()));
    history.shift = unplaced_shift_;
    return history;
}

void Cells::set_surface_history(SurfaceHistory&& history) {
    work.state().solid_keys = std::move(history.keys);
    work.state().solid_terms = std::move(history.terms);
    placed_ = std::move(history.placed);
    detail::follow_box(placed_, glm::vec3(0.0f), box()); // forged ones may be anywhere
    put_obstacles(glm::ivec3(0));
    inside_is_air_ = history.inside_is_air;
    unplaced_shift_ = history.shift;
    reading_stale_ = true;
    loads.restore(std::move(history.loads), history.duration);
}

void Cells::shift(const CellChange& change) {
    const bool lifts = box().rows && change.by.y != 0;
    const auto exposed_wind = [&](int i, int j, int k) {
        return (change.exposed_hold_ambient ? ambient_at(i, j, k) : glm::vec4(0.0f)) + change_at(i, j, k);
    };
    const auto shift_field = [&](std::span<glm::vec4> field, glm::ivec3 cells, CellIndex by, glm::vec4 fresh) {
        windrow::shift_field(field, cells, lifts ? CellIndex(by.x, 0, by.z) : by, fresh);
        if (!lifts)
            return;
        const bool ambient =
            (outer_ || change.exposed_hold_ambient) && field.data() != source_flow.data() && field.data() != air.history.data();
        lift_field(field, cells, *box().rows, by.y, config_.parallel_for,
                   [&](int i, int j, int k) { return ambient ? exposed_wind(i, j, k) : glm::vec4(0.0f); });
    };
    const auto shift_air = [&](std::span<glm::vec4> field) {
        shift_field(field, box().cells, change.by, change.exposed_hold_ambient ? ambient_at(0, 0, 0) : glm::vec4(0.0f));
        if (outer_ || (!around_.uniform() && change.exposed_hold_ambient))
            for_each_exposed(box().cells, lifts ? CellIndex(change.by.x, 0, change.by.z) : change.by,
                             [&](std::size_t n, int i, int j, int k) { field[n] = exposed_wind(i, j, k); });
    };
    if (lifts) // the lists, which hold in no other rows, go
        uncover();
    shift_air(air.velocity);
    if (lifts && work.state().solids)
        lift_obstacles(change.by);
    else
        unplaced_shift_ += glm::ivec3(change.by);
    if (change.has_source_flow)
        shift_field(source_flow, box().cells, change.by, glm::vec4(0.0f));
    if (change.kept)
        shift_air(frames.before);
    shift_pressure(change);
    if (!air.fresh) {
        shift_air(air.velocity_old);
        shift_field(air.history, box().cells, change.by, glm::vec4(0.0f));
    }
}

void Cells::keep() {
    materialise_air_alone(config_.parallel_for);
    before_held_at_ = wind_.sleep.drift;
    std::copy_n(air.velocity.data(), air.velocity.size(), frames.before.data());
    std::copy_n(pressure_.data(), pressure_.size(), pressure_before_.data());
}

// --- Lazy writes of ambient cells --------------------------------------------------------------------------------------------

bool Cells::has_source_flow() const {
    return wind_.source_name != 0;
}

// Called by the first reader, in the reader's own thread, which may run a loop of its own.
void Cells::materialise_air() {
    if (held_at_ == wind_.sleep.drift)
        return;
    const std::lock_guard lock(holding_);
    materialise_air_alone({});
}

void Cells::materialise_air_alone(const ParallelFor& parallel_for) {
    if (held_at_ == wind_.sleep.drift)
        return;
    renew_around(wind_.ambient, wind_.window(), parallel_for);
    sampled_.held = false;
    if (outer_)
        outer_->renew(wind_.window(), parallel_for);
    fill(air.velocity);
    held_at_ = wind_.sleep.drift;
}

void Cells::materialise_gusts(std::span<glm::vec4> field, const AmbientWind& wind, const Window& window) {
    ambient_next_.fill(wind, window, {});
    for_each_cell(window.cells, [&](std::size_t n, int i, int j, int k) {
        field[n] = cell_at(ambient_next_.data() + 4 * padded_index(window.cells, {i, j, k}));
    });
}

void Cells::materialise_frame(FrameCells::Field& field, const ShownFrame& frame) {
    const std::atomic_ref held(field.held);
    if (held)
        return;
    const std::lock_guard lock(holding_);
    if (held)
        return;
    materialise_gusts(field.cells, frame.ambient, frame.window);
    field.sampled.held = false;
    held = true;
}

void Cells::materialise_before() {
    const std::lock_guard lock(holding_);
    if (std::exchange(before_held_at_, wind_.sleep.drift) == wind_.sleep.drift || !wind_.frames)
        return;
    AmbientWind then = wind_.ambient;
    then.set_phase(wind_.frames->gust_phase_before);
    materialise_gusts(frames.before, then, wind_.window());
}

void Cells::set_held() {
    held_at_ = before_held_at_ = wind_.sleep.drift;
}

void Cells::materialise_all() {
    materialise_air();
    materialise_before();
    if (!wind_.frames)
        return;
    materialise_frame(frames.shown, wind_.frames->shown);
    materialise_frame(frames.shown_before, wind_.frames->shown_before);
}

std::size_t Cells::memory_bytes() const {
    return work.memory_bytes() + air.memory_bytes() + frames.memory_bytes() + frames_before_.memory_bytes() + diffused_.bytes() +
           sources.memory_bytes() + mean_field_.memory_bytes() + ambient_field_.memory_bytes() + ambient_next_.memory_bytes() +
           (profile_bends_.size() + open_parts_.capacity()) * sizeof(float) + source_flow.bytes() + free_air_.memory_bytes() +
           solved.bytes() + (layer_ ? layer_->memory_bytes() : 0) + loads.memory_bytes() + pressure_.bytes() +
           pressure_before_.bytes() + (outer_ ? outer_->memory_bytes() : 0) + sheltered_air_.capacity() * sizeof(glm::vec4) +
           sampled_.cells.bytes() + reading_maker_.memory_bytes();
}

} // namespace windrow::cpu
