// Where the box lies, and what blows around it.
//
// A shift moves the air that stays inside to the bit; cells that it exposes hold the ambient wind, with no past. Around the box
// blows the mean wind, the same everywhere or by its profile, and gusts: cell by cell, halo included, where it is not the same
// everywhere.
#include "fluid/cpu/workspace.h"
#include "fluid/wind_state.h"

#include <algorithm>
#include <cmath>

namespace windrow {
namespace {

// Gusts have no component along an axis that a wall closes; the ground alone is their mirror, which they already respect.
glm::vec3 gust_axes(const Sides& sides) {
    return {sides.has_solid(0) ? 0.0f : 1.0f, sides.y_high.solid() ? 0.0f : 1.0f, sides.has_solid(2) ? 0.0f : 1.0f};
}

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

void Wind::State::renew_ambient() {
    ambient.set_gust_axes(gust_axes(config.sides));
    (void)ambient.set_mean(work.ambient());
    (void)ambient.set_ground(config.sides.y_low.solid() ? window.origin().y : 0.0);
    Workspace::State& around = work.state();
    around.mean_cells = around.ambient_cells = nullptr;
    const auto renew = [&](cpu::AmbientField& field, const AmbientWind& wind) {
        if (field.cells() != window.cells)
            field = cpu::AmbientField(window.cells);
        field.fill(wind, window, config.parallel_for);
        return field.data();
    };
    if (config.profile)
        around.ambient_cells = around.mean_cells = renew(mean_field, ambient.without_gusts());
    if (config.gusts.intensity > 0.0f) {
        around.ambient_cells = renew(ambient_field, ambient);
        reserve_solved();
    }
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

void Wind::State::fill_with_ambient() {
    fill(air.velocity);
    air.fresh = true;
    std::fill_n(source_flow.data(), source_flow.size(), glm::vec4(0.0f));
    sources_of_air = 0;
    calm = true;
}

void Wind::State::add_ambient_to_air(float factor) {
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

void Wind::State::change_ambient(glm::vec3 wind) {
    if (config.gusts.intensity > 0.0f) { // gusts are as strong as the mean wind: all of it changes
        exchange_ambient([&] { work.set_ambient(wind); });
        return;
    }
    const glm::vec3 before = work.ambient();
    work.set_ambient(wind);
    const glm::vec3 change = work.ambient() - before;
    renew_ambient();
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
    asleep = false;
    if (calm) { // still ambient, and to the bit
        fill_with_ambient();
        return;
    }
    add_change(air.velocity);
    if (!air.fresh)
        add_change(air.velocity_old);
}

// --- Where the box lies -----------------------------------------------------------------------------------------------------

Rim Wind::State::rim(glm::dvec3 point) const {
    Rim rim{.point = point, .reach = glm::vec3(0.0f), .width = config.rim};
    const float inset = frames ? 2.0f : 1.0f; // between ticks, the point is up to a tick behind the box
    for (int axis = 0; axis < 3; ++axis) {
        const float reach = 0.5f * static_cast<float>(window.cells[axis]) - inset;
        if (config.rim > 0.0f && follow_axes[axis] && reach >= config.rim + 1.0f)
            rim.reach[axis] = reach;
    }
    return rim;
}

void Wind::State::follow(glm::dvec3 point) {
    CellIndex origin = window.centred_on(point);
    for (int axis = 0; axis < 3; ++axis)
        if (!follow_axes[axis])
            origin[axis] = window.origin_cells[axis];
    follow_point = point;
    shift_to(origin);
}

void Wind::State::shift_to(CellIndex origin_cells) {
    const CellIndex shift = origin_cells - window.origin_cells;
    if (shift == CellIndex(0))
        return;
    if (shift.y != 0 && asleep && !ambient.uniform())
        asleep = false; // at another height, another wind to report
    // Gusts stand on the ground: where it moves, so do they, and what the air holds of them with it.
    const bool gusts_move = shift.y != 0 && config.sides.y_low.solid() && config.gusts.intensity > 0.0f && !calm;
    if (gusts_move)
        add_ambient_to_air(-1.0f);
    window.origin_cells = origin_cells;
    renew_ambient();
    const bool beyond =
        std::abs(shift.x) >= window.cells.x || std::abs(shift.y) >= window.cells.y || std::abs(shift.z) >= window.cells.z;
    if (beyond || calm) {
        if (beyond || !ambient.uniform())
            fill_with_ambient();
        if (frames && !(frames->before_still && ambient.uniform()))
            fill(frames->before);
        return;
    }
    const auto shift_air = [&](std::span<glm::vec4> field) {
        shift_field(field, window.cells, shift, gusts_move ? glm::vec4(0.0f) : ambient_at(0, 0, 0));
        if (!ambient.uniform() && !gusts_move)
            fill_exposed(field, shift);
    };
    shift_air(air.velocity);
    if (sources_of_air != 0)
        shift_field(source_flow, window.cells, shift, glm::vec4(0.0f));
    if (frames)
        shift_air(frames->before);
    if (!air.fresh) {
        shift_air(air.velocity_old);
        shift_field(air.history, window.cells, shift, glm::vec4(0.0f));
    }
    if (gusts_move)
        add_ambient_to_air(1.0f);
}

} // namespace windrow
