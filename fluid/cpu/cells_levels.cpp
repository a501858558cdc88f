// Cells among other winds: what is around a box, the ambient wind or an outer one (outer_wind.h), and what an inner box needs of these.
#include "fluid/core/wind_core.h"
#include "fluid/cpu/cells.h"

#include <algorithm>
#include <cmath>
#include <glm/vector_relational.hpp>
#include <utility>
#include <vector>

namespace windrow::cpu {

// --- The wind around ---------------------------------------------------------------------------------------------------------

glm::vec4 Cells::rest_at(std::size_t n, int i, int j, int k) const {
    if (in_room(n))
        return glm::vec4(0.0f);
    const glm::vec4 mean = around_.gusting() ? glm::vec4(0.0f) : mean_at(i, j, k);
    return outer_ ? mean + outer_->at(i, j, k) : mean;
}

glm::vec4 Cells::around_at(std::size_t n, int i, int j, int k) const {
    return in_room(n) ? glm::vec4(0.0f) : ambient_at(i, j, k) + change_at(i, j, k);
}

// Stops at the first cell that still moves: the cost is small until the air has relaxed to the ambient wind.
bool Cells::at_ambient() const {
    const glm::ivec3 cells = box().cells;
    const bool around_bodies = work.state().has_solids();
    std::size_t n = 0;
    for (int k = 0; k < cells.z; ++k)
        for (int j = 0; j < cells.y; ++j)
            for (int i = 0; i < cells.x; ++i, ++n) {
                if (around_bodies && work.state().solids->inside(static_cast<std::uint32_t>(n)))
                    continue;
                const glm::vec4 apart = air.velocity[n] - around_at(n, i, j, k);
                if (!(std::abs(apart.x) < config_.sleep_speed && std::abs(apart.y) < config_.sleep_speed &&
                      std::abs(apart.z) < config_.sleep_speed))
                    return false;
            }
    return true;
}

// The advection reads the outer wind where it reads the ambient one.
void Cells::advect_among(const Transport& transport, std::span<glm::vec4> result) {
    Workspace::State& state = work.state();
    if (!outer_)
        return windrow::advect(work, transport, result);
    outer_->compose({.carried = {state.mean_cells, state.ambient},
                     .traced = {state.ambient_cells, state.ambient},
                     .dt = transport.dt,
                     .fresh = air.fresh,
                     .relaxes = transport.relaxation != 1.0f},
                    config_.parallel_for);
    const float* const mean = std::exchange(state.mean_cells, outer_->carried());
    const float* const wind = std::exchange(state.ambient_cells, outer_->traced());
    windrow::advect(work, transport, result);
    state.mean_cells = mean;
    state.ambient_cells = wind;
}

// --- For an inner box --------------------------------------------------------------------------------------------------------

bool Cells::asleep() const {
    return wind_.sleep.asleep();
}

void Cells::keep_pressure() {
    if (!pressure_.empty())
        return;
    Buffer<float> before(air.velocity.size());
    pressure_ = Buffer<float>(air.velocity.size());
    pressure_before_ = std::move(before);
}

float Cells::shown_pressure(std::size_t cell) const {
    return wind_.frames ? pressure_before_[cell] + shown_factor_ * (pressure_[cell] - pressure_before_[cell]) : pressure_[cell];
}

Cells::ShownAmbient Cells::shown_ambient() const {
    ShownAmbient shown{wind_.ambient, wind_.ambient};
    if (wind_.frames) {
        shown.before.set_phase(wind_.frames->gust_phase_before);
        shown.factor = shown_factor_;
    }
    return shown;
}

void Cells::for_each_filled(const std::function<void(std::uint32_t, glm::vec3)>& visit) const {
    const SampledCells& sampled = shown_sample();
    if (sampled.reading)
        sampled.reading->for_each_filled(frames.before.empty() ? air.velocity : frames.shown.cells, sampled.part, visit);
}

// The history q = (dt/2) grad p of a sub-step is w grad phi + k q_old (shaders/numerics/history.glsl), and so is p.
void Cells::note_pressure(float dt, const numerics::WindrowPast& past) {
    if (pressure_.empty())
        return;
    const Workspace::State& state = work.state();
    const glm::ivec3 cells = box().cells;
    const float weight = 2.0f * box().cell_size / dt * past.weight, kept = air.fresh ? 0.0f : past.kept * air.dt_old / dt;
    config_.parallel_for(cells.z, [&](int k) {
        for (int j = 0; j < cells.y; ++j) {
            float* const row = pressure_.data() + box().index(0, j, k);
            const float* const phi =
                state.potential.data() + (static_cast<std::size_t>(k) * cells.y + j) * state.pressure.pitch();
            for (int i = 0; i < cells.x; ++i)
                row[i] = weight * phi[i] + kept * row[i];
        }
    });
}

// New cells have the outer wind's pressure, or that outside.
void Cells::shift_pressure(const CellChange& change) {
    if (pressure_.empty())
        return;
    const glm::ivec3 cells = box().cells, by(change.by);
    const bool lifts = box().rows && change.by.y != 0;                  // other rows: the next step finds it
    const std::span<float> moved(&spare().data()->x, pressure_.size()); // between two steps
    for (Buffer<float>* const field : {&pressure_, &pressure_before_}) {
        std::size_t n = 0;
        for (int k = 0; k < cells.z; ++k)
            for (int j = 0; j < cells.y; ++j)
                for (int i = 0; i < cells.x; ++i, ++n) {
                    const glm::ivec3 from = glm::ivec3(i, j, k) + by;
                    const bool stays =
                        !lifts && glm::all(glm::greaterThanEqual(from, glm::ivec3(0))) && glm::all(glm::lessThan(from, cells));
                    moved[n] = stays    ? (*field)[box().index(from.x, from.y, from.z)]
                               : outer_ ? outer_->pressure_at(i, j, k)
                                        : 0.0f;
                }
        std::copy(moved.begin(), moved.end(), field->data());
    }
}

LevelState Cells::level_state() const {
    const auto copied = [](std::span<const float> field) { return std::vector<float>(field.begin(), field.end()); };
    LevelState level{.pressure = copied(pressure_),
                     .pressure_before = copied(pressure_before_),
                     .shown_factor = shown_factor_,
                     .filled = filled_};
    if (outer_) {
        level.outer = copied({&outer_->values().data()->x, 4 * outer_->values().size()});
        level.outer_origin = outer_->origin();
    }
    return level;
}

bool Cells::set_level_state(const LevelState& level) {
    const std::size_t cells = air.velocity.size();
    if (level.outer.size() != (outer_ ? 4 * outer_->values().size() : 0) ||
        level.pressure.size() != level.pressure_before.size() || (!level.pressure.empty() && level.pressure.size() != cells) ||
        !(level.shown_factor >= 0.0f && level.shown_factor <= 1.0f))
        return false;
    if (!level.pressure.empty()) {
        keep_pressure();
        std::copy(level.pressure.begin(), level.pressure.end(), pressure_.data());
        std::copy(level.pressure_before.begin(), level.pressure_before.end(), pressure_before_.data());
    }
    shown_factor_ = level.shown_factor;
    filled_ = level.filled;
    if (outer_)
        outer_->restore(level.outer, level.outer_origin);
    return true;
}

} // namespace windrow::cpu
