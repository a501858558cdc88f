// Obstacles in a step of the cells (step.cpp): where they are, the pressure around them, and what reads beside them find.
#include "fluid/core/message.h"
#include "fluid/core/numerics.h"
#include "fluid/core/obstacle_record.h"
#include "fluid/core/wind_core.h"
#include "fluid/cpu/cells.h"
#include "fluid/cpu/stopwatch.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

namespace windrow::cpu {

bool Cells::place_obstacles(const CellStep& step, double early, Diagnostics& report) {
    if (!step.obstacles_changed && !place_again_ && !(bodies_move_ && report.substeps > 1))
        return false;
    const bool others = step.obstacles_moved || place_again_;
    if (others || bodies_move_)
        uncover();
    Stopwatch watch("windrow obstacles", report.times_ms.obstacles);
    const bool placed = detail::memory_lasts([&] {
        detail::make_room(placed_, step.obstacles.size());
        placed_.assign(step.obstacles.begin(), step.obstacles.end());
        detail::move_back(placed_, early);
        put_obstacles(unplaced_shift_);
        loads.place(placed_);
    });
    if (placed && work.state().has_solids())
        still_new_rooms();
    unplaced_shift_ = glm::ivec3(0);
    placed_anew_ = reading_stale_ = true;
    place_again_ = !placed;
    if (!placed) { // the air does without them in this step
        work.state().solids.reset();
        report.out_of_memory = true;
    }
    return others;
}

void Cells::put_obstacles(glm::ivec3 shift) {
    work.state().set_obstacles(placed_, shift);
    if (!work.state().has_solids())
        return;
    const std::size_t sheltered = work.state().solids->sheltered().size();
    detail::make_room(sheltered_air_, sheltered);
    sheltered_air_.resize(sheltered);
}

// Rows at another height: no list holds, and what frames show until the next tick has the bodies too.
void Cells::lift_obstacles(CellIndex by) {
    const glm::vec3 along(glm::vec3(unplaced_shift_ + glm::ivec3(by)) * box().cell_size);
    const auto rise = static_cast<float>(static_cast<double>(by.y) * box().rows->step());
    work.state().solid_keys.clear();
    work.state().solid_terms.clear();
    if (!detail::memory_lasts([&] {
            detail::follow_box(placed_, {along.x, rise, along.z}, box());
            put_obstacles(glm::ivec3(0));
        }))
        work.state().solids.reset();
    unplaced_shift_ = glm::ivec3(0);
    inside_is_air_ = place_again_ = reading_stale_ = true;
}

// Cells inside hold the body's velocity, but what it leaves is air, which slips along it: before the bodies are placed again, the
// cells take what a read from outside would find there, with a past.
void Cells::uncover() {
    if (!work.state().has_solids() || inside_is_air_)
        return;
    if (unplaced_shift_ == glm::ivec3(0))
        return extend_into_bodies();
    const Stopwatch watch("windrow obstacles", work.state().obstacles_ms);
    const SolidFlow flow = work.state().solid_flow();
    if (air.fresh)
        flow.extend_moved(air.velocity, {}, {}, unplaced_shift_);
    else
        flow.extend_moved(air.velocity, air.velocity_old, air.history, unplaced_shift_);
}

std::span<const Solids::InsideCell> Cells::inside_bodies() const {
    return work.state().solids ? work.state().solids->inside() : std::span<const Solids::InsideCell>();
}

// visit(n) for each cell of the box of now that was inside.
template <class Visit>
void Cells::for_each_inside_now(const Visit& visit) const {
    for (const Solids::InsideCell& cell : inside_bodies()) {
        const glm::ivec3 place = cell.place - unplaced_shift_;
        if (glm::all(glm::greaterThanEqual(place, glm::ivec3(0))) && glm::all(glm::lessThan(place, box().cells)))
            visit(box().index(place.x, place.y, place.z));
    }
}

void Cells::write_obstacles(std::span<float> cells) const {
    std::fill(cells.begin(), cells.end(), 0.0f);
    for_each_inside_now([&](std::size_t cell) { cells[cell] = 1.0f; });
}

// visit(cells) for each closed room.
template <class Visit>
void Cells::for_each_room(const Visit& visit) const {
    if (!work.state().has_solids())
        return;
    const Solids& solids = *work.state().solids;
    std::size_t first = 0;
    for (const std::uint32_t end : solids.room_ends()) {
        visit(solids.rooms().subspan(first, end - first));
        first = end;
    }
}

// Rooms that hold the wind although it never blew there: those of a box that is filled with it, and those whose last wall has come
// into the box. A room that a door closes keeps its air as it is.
void Cells::still_new_rooms() {
    const Solids& solids = *work.state().solids;
    const auto came_in = [&](std::uint32_t cell) { return solids.came_in(cell, unplaced_shift_); };
    const auto filled = [&](std::uint32_t cell) {
        const glm::ivec3 at = solids.place_of(cell);
        return air.fresh && air.velocity[cell] == ambient_at(at.x, at.y, at.z);
    };
    for_each_room([&](std::span<const std::uint32_t> room) {
        if (!std::any_of(room.begin(), room.end(), came_in) && !std::all_of(room.begin(), room.end(), filled))
            return;
        for (const std::uint32_t cell : room)
            air.velocity[cell] = air.velocity_old[cell] = air.history[cell] = glm::vec4(0.0f);
    });
}

// Whether a motor, a volume source or a moving wall can do work on the air of a room.
bool Cells::worked_on(std::span<const std::uint32_t> room) const {
    const Solids& solids = *work.state().solids;
    const auto width = static_cast<std::uint32_t>(box().cells.x);
    if (bodies_move_ && solids.walls_move(room))
        return true;
    return std::any_of(room.begin(), room.end(), [&](std::uint32_t cell) {
        const std::uint32_t row = cell / width, i = cell % width;
        const SourceField::Range driven = sources.driven(row);
        if (i >= driven.low && i < driven.high && sources.drive_row(row)[i].w > 0.0f)
            return true;
        if (const glm::vec4* const force = sources.force_row(row); force != nullptr && force[i] != glm::vec4(0.0f))
            return true;
        const std::span<const float> expansion = sources.expansion();
        return !expansion.empty() && expansion[cell] != 0.0f;
    });
}

// In cubes of the cell size.
double Cells::volume_of(std::uint32_t cell) const {
    return box().rows ? static_cast<double>(box().volume(work.state().solids->place_of(cell).y)) : 1.0;
}

// Without work the energy of a closed room does not grow. What the pressure's residual leaves at its walls would add some.
void Cells::bound_rooms(std::span<const glm::vec4> before, std::span<glm::vec4> after) {
    const Stopwatch watch("windrow obstacles", work.state().obstacles_ms);
    for_each_room([&](std::span<const std::uint32_t> room) {
        if (worked_on(room))
            return;
        const auto energy = [&](std::span<const glm::vec4> field) {
            double sum = 0.0;
            for (const std::uint32_t cell : room)
                sum += volume_of(cell) * static_cast<double>(glm::dot(field[cell], field[cell]));
            return sum;
        };
        const double had = energy(before), has = energy(after);
        if (!(has > had))
            return;
        const auto part = static_cast<float>(std::sqrt(had / has));
        for (const std::uint32_t cell : room)
            after[cell] *= part;
    });
}

PrescribedFlow Cells::prescribed() const {
    return {.ambient = around_.gusting() ? ambient_field_.data() : nullptr};
}

void Cells::project_around(std::span<glm::vec4> velocity, const Workspace::State::GradientNote& note, float guess_scale,
                           int solves, Diagnostics& report, const Beyond* beyond) {
    Workspace::State::SolidSolve around{
        .keeps_terms = true, .guess_scale = guess_scale, .prescribed = prescribed(), .solves = solves};
    work.state().project(velocity, {}, note, beyond, &around);
    potential_weight_ = work.state().other_solve == nullptr && !note.field.empty() ? note.weight : 0.0f;
    if (!work.state().has_solids())
        return;
    report.pressure_residual = around.residual;
    report.pressure_solves = around.solved;
    const Stopwatch watch("windrow obstacles", work.state().obstacles_ms);
    const bool has_history = !note.field.empty();
    loads.add(work.state().solid_flow(), work.state().potential.data(), has_history ? guess_scale : 0.0f, note.weight, note.kept);
}

Cells::KeptPotential Cells::kept_potential() const {
    if (air.fresh || !(potential_weight_ > 0.0f))
        return {};
    KeptPotential kept{.weight = potential_weight_, .cells = std::vector<float>(air.velocity.size())};
    work.state().copy_potential(kept.cells, 1.0f);
    return kept;
}

void Cells::set_kept_potential(const KeptPotential& kept) {
    potential_weight_ = kept.weight;
    if (kept.weight > 0.0f)
        work.state().set_potential(kept.cells);
}

// The kept q = (dt/2) grad p is w grad phi + k s q_old (shaders/numerics/history.glsl). The phi of the last solve is still there, and its
// part of the pressure is w phi as it acted. The rest is small where steps are equal, and is solved for anew: the wide difference that
// measures a gradient misses an eighth of a jump across a body, which would be taken up by a false slope of all the box.
void Cells::write_pressure(std::span<float> result) {
    std::fill(result.begin(), result.end(), 0.0f);
    if (air.fresh || !(air.dt_old > 0.0f))
        return;
    if (outer_) { // by what is beyond the box, which no solve of it knows
        std::copy_n(pressure_.data(), pressure_.size(), result.begin());
        return;
    }
    Workspace::State& state = work.state();
    const CellIndex shift = wind_.place.window.origin_cells - wind_.place.stepped.origin_cells;
    const bool has_potential = potential_weight_ > 0.0f && !(box().rows && shift.y != 0);
    Buffer<glm::vec4> rest(air.history.size()); // at first -grad phi, and phi in w
    std::vector<float> potential(has_potential ? rest.size() : 0), remaining(rest.size());
    if (has_potential) {
        state.copy_potential(potential, 1.0f);
        state.set_potential(potential); // with the slopes of faces
        state.take_gradient({state.potential.data(), state.pressure.pitch()}, rest, {});
        for (const Solids::InsideCell& cell : inside_bodies())
            rest[cell.cell] = glm::vec4(0.0f);
        for (std::size_t n = 0; n < rest.size(); ++n)
            rest[n].w = potential[n];
        if (shift != CellIndex(0))
            shift_field(rest, box().cells, shift, glm::vec4(0.0f));
    }
    const float factor = 2.0f * box().cell_size / air.dt_old;
    for (std::size_t n = 0; n < rest.size(); ++n) {
        const glm::vec4 acted = potential_weight_ * rest[n];
        result[n] = factor * acted.w;
        rest[n] = glm::vec4(glm::vec3(air.history[n]) + glm::vec3(acted), 0.0f);
    }
    Workspace::State::SolidSolve at_rest{.bodies_move = false, .solves = k_first_solves};
    state.project(rest, {}, {}, nullptr, &at_rest);
    state.copy_potential(remaining, factor);
    std::transform(remaining.begin(), remaining.end(), result.begin(), result.begin(), std::plus());
    if (has_potential)
        state.set_potential(potential);
    for_each_inside_now([&](std::size_t cell) { result[cell] = 0.0f; });
}

void Cells::seal_sources(std::span<const detail::MotorReach> reached, Diagnostics& report) {
    report.sealed_sources = 0;
    const std::span<float> expansion = sources.expansion();
    if (expansion.empty())
        return;
    for_each_room([&](std::span<const std::uint32_t> room) {
        double sum = 0.0, whole = 0.0;
        for (const std::uint32_t cell : room) {
            sum += volume_of(cell) * static_cast<double>(expansion[cell]);
            whole += volume_of(cell);
        }
        const auto mean = static_cast<float>(sum / whole);
        for (const std::uint32_t cell : room)
            expansion[cell] -= mean;
    });
    const bool closed = !config_.boundaries.has_open(0) && !config_.boundaries.has_open(1) && !config_.boundaries.has_open(2);
    for (const detail::MotorReach& motor : reached)
        if (motor.law == detail::MotorReach::Law::source)
            report.sealed_sources += closed || reaches_room(motor) ? 1 : 0;
}

bool Cells::reaches_room(const detail::MotorReach& motor) const {
    for (int k = motor.low.z; k < motor.high.z; ++k)
        for (int j = motor.low.y; j < motor.high.y; ++j)
            for (int i = motor.low.x; i < motor.high.x; ++i)
                if (in_room(box().index(i, j, k)))
                    return true;
    return false;
}

std::span<const float> Cells::open_parts(std::span<const detail::MotorReach> reached) {
    open_parts_.clear();
    if (!work.state().has_solids())
        return open_parts_;
    const Solids& solids = *work.state().solids;
    for (const detail::MotorReach& motor : reached) {
        if (motor.law != detail::MotorReach::Law::source)
            continue;
        float whole = 0.0f, open = 0.0f;
        for (int k = motor.low.z; k < motor.high.z; ++k)
            for (int j = motor.low.y; j < motor.high.y; ++j)
                for (int i = motor.low.x; i < motor.high.x; ++i) {
                    const glm::vec3 off = box().centre(i, j, k) - motor.centre;
                    const float weight = box().volume(j) * numerics::windrow_sphere_weight(off, motor.radius);
                    whole += weight;
                    const auto cell = static_cast<std::uint32_t>(box().index(i, j, k));
                    open += solids.inside(cell) || solids.in_room(cell) ? 0.0f : weight;
                }
        open_parts_.push_back(whole > 0.0f ? open / whole : 1.0f);
    }
    return open_parts_;
}

// From no guess: the flow of a burst is another in each step.
void Cells::project_sources(const FreeAir* beyond) {
    Workspace::State::SolidSolve around{.bodies_move = false, .solves = k_first_solves};
    work.state().project(source_flow, sources.expansion(), {}, beyond, &around);
    if (work.state().has_solids())
        loads.renew_sources(work.state().solid_flow(), work.state().potential.data());
}

// A read of the air beside a body finds air in the body too.
void Cells::extend_into_bodies() {
    if (!work.state().has_solids())
        return;
    const Stopwatch watch("windrow obstacles", work.state().obstacles_ms);
    const SolidFlow flow = work.state().solid_flow();
    if (air.fresh)
        flow.extend(air.velocity, {});
    else
        flow.extend_all(air.velocity, air.velocity_old, air.history);
}

// Cells inside bodies have no past but what uncover gives them.
void Cells::forget_inside() {
    for (const Solids::InsideCell& cell : inside_bodies()) {
        air.velocity_old[cell.cell] = air.velocity[cell.cell];
        air.history[cell.cell] = glm::vec4(0.0f);
    }
}

} // namespace windrow::cpu
