// The cells of a wind on the CPU under what its host does to them: they become ambient, move with the box, blend for a frame. The
// ambient wind lies cell by cell, halo included, where it is not the same everywhere.
#include "fluid/cpu/workspace.h"
#include "fluid/wind_state.h"

#include <algorithm>
#include <utility>

namespace windrow {
namespace {

// Visits the cells that a shift exposes: those whose value would come from outside.
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

} // namespace

// --- The wind around the box ---------------------------------------------------------------------------------------------

void Wind::State::make_room_around(const Gusts& gusts) {
    const auto make = [&](cpu::AmbientField& field) {
        if (field.cells() != window.cells)
            field = cpu::AmbientField(window.cells);
    };
    if (config.profile)
        make(mean_field);
    if (!(gusts.intensity > 0.0f))
        return;
    make(ambient_field);
    make(ambient_next);
    if (config.profile)
        profile_bends.reserve(work.state().carried_rules[1].size());
    reserve_solved();
}

void Wind::State::around_changed() {
    make_room_around(config.gusts);
    work.set_ambient(config.ambient);
    Workspace::State& around = work.state();
    around.mean_cells = around.ambient_cells = nullptr;
    const auto renew = [&](cpu::AmbientField& field, const AmbientWind& wind) {
        field.fill(wind, window, config.parallel_for);
        return field.data();
    };
    if (config.profile)
        around.ambient_cells = around.mean_cells = renew(mean_field, ambient.without_gusts());
    if (config.gusts.intensity > 0.0f) {
        around.ambient_cells = renew(ambient_field, ambient);
        if (config.profile)
            bend_profile();
    }
}

// Beyond a wall as transport sees it.
void Wind::State::bend_profile() {
    const std::vector<cpu::HaloRule>& rows = work.state().carried_rules[1];
    const auto profile = [&](std::size_t row) {
        const int j = rows[row].ambient ? static_cast<int>(row) - cpu::k_halo_low : rows[row].source;
        return ambient.profile_at(window.centre(0, j, 0).y);
    };
    profile_bends.assign(rows.size(), 0.0f);
    if (config.sides.periodic(1))
        return;
    for (std::size_t row = 1; row + 1 < rows.size(); ++row)
        profile_bends[row] = profile(row - 1) - 2.0f * profile(row) + profile(row + 1);
}

namespace {

// The first of the four floats of a cell in a padded field.
std::size_t padded_index(glm::ivec3 cells, int i, int j, int k) {
    const glm::ivec3 padded = cells + cpu::k_halo, at = glm::ivec3(i, j, k) + cpu::k_halo_low;
    return 4 * ((static_cast<std::size_t>(at.z) * padded.y + at.y) * padded.x + at.x);
}

glm::vec4 cell_at(const float* cell) {
    return {cell[0], cell[1], cell[2], 0.0f};
}

} // namespace

glm::vec4 Wind::State::ambient_at(int i, int j, int k) const {
    if (config.gusts.intensity > 0.0f)
        return cell_at(ambient_field.data() + padded_index(window.cells, i, j, k));
    return mean_at(i, j, k);
}

glm::vec4 Wind::State::mean_at(int i, int j, int k) const {
    return config.profile ? cell_at(mean_field.data() + padded_index(window.cells, i, j, k)) : glm::vec4(work.ambient(), 0.0f);
}

void Wind::State::add_ambient(std::span<glm::vec4> field, float factor) const {
    const glm::ivec3 cells = window.cells;
    config.parallel_for(cells.z, [&](int k) {
        for (int j = 0; j < cells.y; ++j) {
            const float* const around = ambient_field.data() + padded_index(cells, 0, j, k);
            glm::vec4* const row = field.data() + box().index(0, j, k);
            for (int i = 0; i < cells.x; ++i)
                row[i] += factor * cell_at(around + 4 * i);
        }
    });
}

void Wind::State::fill(std::span<glm::vec4> field) const {
    if (ambient.uniform())
        std::fill(field.begin(), field.end(), ambient_at(0, 0, 0));
    else
        for_each_exposed(window.cells, CellIndex(window.cells),
                         [&](std::size_t n, int i, int j, int k) { field[n] = ambient_at(i, j, k); });
}

void Wind::State::fill_exposed(std::span<glm::vec4> field, CellIndex shift) const {
    for_each_exposed(window.cells, shift, [&](std::size_t n, int i, int j, int k) { field[n] = ambient_at(i, j, k); });
}

void Wind::State::fill_cells() {
    held = false;
    air.fresh = true;
    air.owed_diffusion = 0.0f;
    std::fill_n(source_flow.data(), source_flow.size(), glm::vec4(0.0f));
}

void Wind::State::gusts_passed() {
    held = before_held = false;
}

// Cells of air that sleeps are written by whoever reads them first, in the reader's own thread: it may stand in a loop of its own.
void Wind::State::hold_ambient() {
    if (held)
        return;
    const std::lock_guard lock(holding);
    hold_ambient_alone({});
}

void Wind::State::hold_ambient_alone(const ParallelFor& parallel_for) {
    if (held)
        return;
    if (ambient.gusting())
        ambient_field.fill(ambient, window, parallel_for);
    fill(air.velocity);
    held = true;
}

void Wind::State::hold_gusts(std::span<glm::vec4> field, const AmbientWind& wind, const Window& place) {
    ambient_next.fill(wind, place, {});
    for_each_exposed(place.cells, CellIndex(place.cells), [&](std::size_t n, int i, int j, int k) {
        field[n] = cell_at(ambient_next.data() + padded_index(place.cells, i, j, k));
    });
}

void Wind::State::hold_frame(Frame& frame) {
    const std::atomic_ref held_already(frame.held);
    if (held_already)
        return;
    const std::lock_guard lock(holding);
    if (held_already)
        return;
    hold_gusts(frame.field, frame.ambient, frame.window);
    held_already = true;
}

void Wind::State::hold_before() {
    const std::lock_guard lock(holding);
    if (std::exchange(before_held, true) || !frames)
        return;
    AmbientWind then = ambient;
    then.set_phase(frames->gust_phase_before);
    hold_gusts(frames->before, then, window);
}

void Wind::State::fill_before() {
    fill(frames->before);
    before_held = true;
}

void Wind::State::add_ambient_to_cells(float factor) {
    const auto add = [&](std::span<glm::vec4> field) {
        for_each_exposed(window.cells, CellIndex(window.cells),
                         [&](std::size_t n, int i, int j, int k) { field[n] += factor * ambient_at(i, j, k); });
    };
    add(air.velocity);
    if (!air.fresh)
        add(air.velocity_old);
    if (frames)
        add(frames->before);
}

void Wind::State::add_change_to_cells(glm::vec3 change, bool before_only) {
    const auto add_change = [&](std::span<glm::vec4> field) {
        for (std::size_t row = 0, n = 0; n < field.size(); ++row) {
            const int j = static_cast<int>(row % static_cast<std::size_t>(window.cells.y));
            const glm::vec4 here(ambient.profile_at(window.centre(0, j, 0).y) * change, 0.0f);
            for (int i = 0; i < window.cells.x; ++i, ++n)
                field[n] += here;
        }
    };
    if (frames)
        add_change(frames->before);
    if (before_only)
        return;
    add_change(air.velocity);
    if (!air.fresh)
        add_change(air.velocity_old);
}

// --- Where the box lies -----------------------------------------------------------------------------------------------------

Result<void> Wind::State::change_sides(const Sides& sides, bool kinds) {
    hold_ambient(); // as the old sides have it
    hold_before();
    auto changed = work.set_sides(sides);
    air.fresh = air.fresh || (changed && kinds);
    return changed;
}

void Wind::State::shift_cells(CellIndex by, bool exposed_hold_ambient) {
    const auto shift_air = [&](std::span<glm::vec4> field) {
        shift_field(field, window.cells, by, exposed_hold_ambient ? ambient_at(0, 0, 0) : glm::vec4(0.0f));
        if (!ambient.uniform() && exposed_hold_ambient)
            fill_exposed(field, by);
    };
    shift_air(air.velocity);
    if (sources_of_air != 0)
        shift_field(source_flow, window.cells, by, glm::vec4(0.0f));
    if (frames)
        shift_air(frames->before);
    if (!air.fresh) {
        shift_air(air.velocity_old);
        shift_field(air.history, window.cells, by, glm::vec4(0.0f));
    }
}

// --- Between two ticks ------------------------------------------------------------------------------------------------------

void Wind::State::begin_keeping() {
    hold_ambient();
    before_held = true;
    const std::size_t cells = air.velocity.size();
    for (cpu::Buffer<glm::vec4>* field : {&frames->before, &frames->shown.field, &frames->shown_before.field}) {
        *field = cpu::Buffer<glm::vec4>(cells);
        std::copy_n(air.velocity.data(), cells, field->data());
    }
}

void Wind::State::keep_before() {
    hold_ambient_alone(config.parallel_for);
    before_held = true;
    std::copy_n(air.velocity.data(), air.velocity.size(), frames->before.data());
}

void Wind::State::show_ambient() {
    frames->shown.held = !ambient.gusting();
    if (!frames->shown.held)
        return;
    hold_ambient();
    std::copy_n(air.velocity.data(), air.velocity.size(), frames->shown.field.data());
}

void Wind::State::blend(float factor) {
    hold_ambient();
    hold_before();
    frames->shown.held = true;
    const std::size_t row_plane = static_cast<std::size_t>(window.cells.x) * static_cast<std::size_t>(window.cells.y);
    config.parallel_for(window.cells.z, [&](int plane) {
        const std::size_t first = row_plane * static_cast<std::size_t>(plane);
        for (std::size_t n = first; n < first + row_plane; ++n)
            frames->shown.field[n] = frames->before[n] + factor * (air.velocity[n] - frames->before[n]);
    });
}

} // namespace windrow
