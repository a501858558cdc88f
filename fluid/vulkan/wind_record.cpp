// A frame recorded: what the host asked for since the last one, the ticks that are due, the textures, the read-back.
//
// The device is ahead of what the host knows of it by the frames in flight. So the host decides by what it knows itself (which
// motors reach the box, whether the box moved), the device by what only it knows (the sub-steps), and sleep, which needs both,
// comes when a read-back tells that the air is still and nothing has acted since.
#include "fluid/message.h"
#include "fluid/vulkan/wind_state.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <utility>

namespace windrow::vulkan {

Work Wind::State::work_of(Work::Kind kind) const {
    return {.kind = kind, .ambient = ambient, .window = window, .kept = frames.has_value()};
}

void Wind::State::do_or_queue(Work work) {
    if (commands_ != VK_NULL_HANDLE)
        work.record(*air, commands_);
    else
        queue_.push(std::move(work));
}

bool Wind::State::begin(VkCommandBuffer commands, const Frame& frame) {
    if (commands == VK_NULL_HANDLE || frame.slot < -1 || frame.slot >= settings.frames_in_flight)
        return false;
    slot_before_ = slot_;
    slot_ = frame.slot >= 0 ? frame.slot : (slot_ + 1) % settings.frames_in_flight;
    ++recording_;
    take(slots[static_cast<std::size_t>(slot_)]);
    air->begin(slot_);
    commands_ = commands;
    if (clock)
        clock->begin(commands, slot_);
    dispatches = -air->dispatches();
    barriers = -air->barriers();
    ticked_ = false;
    blend_.reset();
    asked_ = !queue_.empty() || new_sides_;
    if (new_sides_)
        air->set_sides(*std::move(new_sides_));
    new_sides_.reset();
    queue_.record(*air, commands);
    return true;
}

void Wind::State::end(const Frame& frame) {
    set ^= 1;
    bool both = false;
    if (written_sets_ < 2) // the set that no frame was written to yet
        blend_ = blend_.value_or(1.0f);
    if (blend_) {
        air->show(commands_, *blend_, set, ticked_);
        ++written_sets_;
        if (written_sets_ == 1) { // the frame before the first is the first
            air->show(commands_, *blend_, set ^ 1, false);
            written_sets_ = 2;
            both = true;
        }
        if (frame.dt > 0.0 || asked_ || !frames || !queried_frame) // a pause between ticks changes nothing
            read_back(slots[static_cast<std::size_t>(slot_)]);
    }
    air->end(commands_);
    if (clock)
        clock->end(commands_);
    recorded_before = std::move(recorded);
    recorded.emplace(frame_now());
    if (both)
        recorded_before.emplace(frame_now());
    dispatches += air->dispatches();
    barriers += air->barriers();
    commands_ = VK_NULL_HANDLE;
}

void Wind::State::read_back(ReadBack& slot) {
    air->read_back(commands_, slot.buffer, settings.queries);
    slot.pending = true;
    slot.ticked = ticked_;
    slot.time = time;
    slot.recording = recording_;
    slot.tick = tick_;
    slot.frame = frame_now();
    slot.box = box();
    slot.rim = rim(slot.frame.rim_point);
}

windrow::Frame Wind::State::frame_now() const {
    if (frames)
        return {{}, frames->shown.window, frames->shown.rim_point, frames->shown.ambient, frames->shown.still};
    return {{}, window, follow_point, ambient, asleep};
}

bool Wind::State::take(ReadBack& slot) {
    if (!std::exchange(slot.pending, false) || slot.buffer.invalidate() != VK_SUCCESS)
        return false;
    const AirReport told = air->report(slot.buffer);
    if (slot.ticked) {
        repaired_ += told.repaired_cells;
        limited_ += told.limited_cells;
    }
    if (slot.recording < taken_recording_) // a host that does not take its slots in turns
        return false;
    taken_recording_ = slot.recording;
    report = told;
    report_tick_ = slot.tick;
    if (!settings.queries)
        return true;
    const auto cells = air->shown(slot.buffer);
    queried_cells.assign(cells.begin(), cells.end());
    queried_frame.emplace(windrow::Frame{{}, slot.frame.window, slot.frame.rim_point, slot.frame.ambient, slot.frame.still});
    queried_box = slot.box;
    queried_rim = slot.rim;
    queried_time = slot.time;
    return true;
}

bool Wind::State::collect(int slot) {
    if (slot < 0 || slot >= settings.frames_in_flight)
        return false;
    if (clock)
        clock->collect(slot);
    return take(slots[static_cast<std::size_t>(slot)]);
}

Diagnostics Wind::State::reported() {
    Diagnostics diagnostics;
    diagnostics.stepped = report_tick_ > 0;
    tell(diagnostics);
    tell_counts(diagnostics);
    return diagnostics;
}

Advance Wind::State::record(VkCommandBuffer commands, const Frame& frame) {
    if (!(frame.dt >= 0.0) || !std::isfinite(frame.dt) || !begin(commands, frame))
        return {};
    Advance done = advance(frame.dt);
    if (done.ticks > 0) // a host that reads no more than its ticks' reports misses none
        tell_counts(done.last);
    if (!done.last.out_of_memory)
        time += frame.dt - done.dropped;
    end(frame);
    return done;
}

Diagnostics Wind::State::record_step(VkCommandBuffer commands, const Frame& frame) {
    if (frames && frame.dt == 0.0) // between two ticks it stays there
        return record(commands, frame).last;
    if (!(frame.dt >= 0.0) || !std::isfinite(frame.dt) || !begin(commands, frame))
        return {};
    const bool slept = asleep;
    Diagnostics done = step(frame.dt);
    if (frame.dt > 0.0)
        tell_counts(done);
    time += frame.dt;
    if (!gusts_held_) {
        hold_gusts();
        blend_ = 1.0f;
    }
    if (!slept || !asleep || frame.dt == 0.0) // a pause shows what changed without a step
        unshown_ = 2;
    if (unshown_ > 0) { // asleep: until both sets of textures hold the air as it sleeps
        --unshown_;
        blend_ = 1.0f;
    }
    end(frame);
    return done;
}

Result<void> Wind::State::set_velocity(std::span<const glm::vec4> field) {
    const VkDeviceSize bytes = box().cell_count() * sizeof(glm::vec4);
    if (field.size_bytes() != bytes)
        return Error{windrow::detail::message("set_velocity got ", field.size(), " cells, but the box has ", box().cell_count(),
                                              ": give one for each of config().cells.")};
    Work work = work_of(Work::Kind::set);
    const bool has_room = windrow::detail::memory_lasts([&] {
        work.cells.resize(field.size());
        queue_.make_room();
    });
    if (!has_room)
        return windrow::detail::out_of_memory();
    std::transform(field.begin(), field.end(), work.cells.begin(), [](glm::vec4 u) { return glm::vec4(u.x, u.y, u.z, 0.0f); });
    do_or_queue(std::move(work));
    asleep = calm = filled_ = false;
    gusts_held_ = true;
    if (frames)
        frames->before_still = false;
    disturbed_tick_ = tick_ + 1;
    return {};
}

void Wind::State::reset() {
    fill_with_ambient();
    if (frames)
        fill_before();
    written_sets_ = 0; // the frame before the next is ambient too
}

void Wind::State::forget() {
    queue_.clear();
    air->forget();
    reset();
    for (ReadBack& slot : slots)
        slot.pending = false;
    if (clock)
        clock->forget();
    slot_ = slot_before_; // it is that slot's turn again
    report = {};
    disturbed_tick_ = tick_ + 1;
    asleep = false;
}

// --- The cells
// ------------------------------------------------------------------------------------------------------------------

void Wind::State::around_changed() {} // each work brings the ambient wind of its moment

Result<void> Wind::State::change_sides(const Sides& sides, bool kinds) {
    auto prepared =
        windrow::detail::where_memory_lasts([&] { return air->prepare(sides, kinds || (new_sides_ && new_sides_->tables)); });
    if (!prepared)
        return Error{prepared.error()};
    hold_gusts(); // as the old sides have them
    filled_ = false;
    disturbed_tick_ = tick_ + 1;
    new_sides_ = *std::move(prepared);
    return {};
}

void Wind::State::fill_cells() {
    do_or_queue(work_of(Work::Kind::fill));
    filled_ = gusts_held_ = true;
}

void Wind::State::fill_before() {
    do_or_queue(work_of(Work::Kind::fill_before));
}

void Wind::State::add_ambient_to_cells(float factor) {
    filled_ = false;
    disturbed_tick_ = tick_ + 1;
    Work work = work_of(Work::Kind::add_wind);
    work.factor = factor;
    do_or_queue(std::move(work));
}

void Wind::State::add_change_to_cells(glm::vec3 change, bool before_only) {
    filled_ = filled_ && before_only;
    disturbed_tick_ = tick_ + 1;
    Work work = work_of(Work::Kind::add_change);
    work.change = change;
    work.to_air = !before_only;
    do_or_queue(std::move(work));
}

void Wind::State::shift_cells(CellIndex by, bool exposed_hold_ambient) {
    Work work = work_of(Work::Kind::shift);
    work.move = {
        .by = by, .exposed_hold_ambient = exposed_hold_ambient, .kept = frames.has_value(), .lets_air_in = sources_of_air != 0};
    do_or_queue(std::move(work));
}

void Wind::State::begin_keeping() {
    keep_before();
}

void Wind::State::keep_before() {
    air->keep_before(commands_); // in a tick
}

void Wind::State::blend(float factor) {
    blend_ = factor;
}

// At the frame's own moment, between two ticks: the next tick that wakes fills anew.
void Wind::State::show_ambient() {
    blend_ = 1.0f;
    if (!ambient.gusting())
        return;
    air->fill(commands_, frames->shown.ambient, window);
    gusts_held_ = false;
}

void Wind::State::hold_gusts() {
    if (std::exchange(gusts_held_, true))
        return;
    do_or_queue(work_of(Work::Kind::fill));
    if (!frames)
        return;
    Work before = work_of(Work::Kind::fill_before);
    before.ambient.set_phase(frames->gust_phase_before);
    do_or_queue(std::move(before));
}

void Wind::State::step_cells(double dt, std::span<const windrow::detail::MotorReach> reached, Diagnostics& diagnostics) {
    ++tick_;
    hold_gusts();
    const bool renews = config.stages.projection && renew_sources(reached);
    if (!reached.empty() || renews)
        disturbed_tick_ = tick_;
    left_alone_ = std::exchange(filled_, false) && disturbed_tick_ != tick_ && ambient.uniform();
    const auto plants = canopy_rows();
    air->step(commands_, {.duration = dt,
                          .motors = reached,
                          .tile = motors.tile(ambient.tile()),
                          .ambient = &ambient,
                          .window = &window,
                          .canopy = plants ? glm::vec3(plants->drag, plants->ground, plants->top) : glm::vec3(0.0f),
                          .renews_sources = renews,
                          .lets_air_in = sources_of_air != 0,
                          .counts_on = std::exchange(ticked_, true)});
    ambient.advance(dt);
    tell(diagnostics);
    diagnostics.diffusion = config.stages.diffusion ? diffusion_method(config.viscosity, static_cast<float>(dt), config.cell_size)
                                                    : DiffusionMethod::none;
}

bool Wind::State::at_ambient() const {
    return left_alone_ || (report_tick_ > disturbed_tick_ && report.apart < config.sleep_speed);
}

// Asked only of air that was just laid to sleep: it is the ambient wind, which without gusts differs by height alone. With them the
// last read-back stands: no component was further from it than what counts as sleep.
void Wind::State::measure(Diagnostics& diagnostics) {
    if (ambient.gusting())
        return;
    diagnostics.max_speed = 0.0f;
    diagnostics.energy = 0.0;
    diagnostics.divergence_rms = 0.0;
    const auto h = static_cast<double>(config.cell_size);
    for (int j = 0; j < config.cells.y; ++j) {
        const glm::vec3 u = ambient.velocity(window.centre(0, j, 0));
        diagnostics.max_speed = std::max({diagnostics.max_speed, std::abs(u.x), std::abs(u.y), std::abs(u.z)});
        diagnostics.energy += 0.5 * static_cast<double>(glm::dot(u, u)) * h * h * h * config.cells.x * config.cells.z;
    }
}

// What the last read-back told, but for its counts.
void Wind::State::tell(Diagnostics& diagnostics) const {
    const auto h = static_cast<double>(config.cell_size);
    diagnostics.max_speed = report.largest_component;
    diagnostics.cfl = report.cfl;
    diagnostics.substeps = report.substeps;
    diagnostics.substeps_capped = report.substeps_capped;
    diagnostics.energy = 0.5 * report.squares * h * h * h;
    diagnostics.divergence_rms = std::sqrt(report.divergence_squares / static_cast<double>(box().cell_count()));
}

// Told once, and after the last tick of a recording: each begins a report of its own.
void Wind::State::tell_counts(Diagnostics& diagnostics) {
    diagnostics.limited_cells = std::exchange(limited_, 0);
    diagnostics.repaired_cells = std::exchange(repaired_, 0);
}

} // namespace windrow::vulkan
