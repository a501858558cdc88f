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
#include <utility>

namespace windrow::vulkan {

void Wind::State::do_or_queue(Work work) {
    if (commands_ != VK_NULL_HANDLE)
        work(commands_);
    else
        queue_.push_back(std::move(work));
}

bool Wind::State::begin(VkCommandBuffer commands, const Frame& frame) {
    if (commands == VK_NULL_HANDLE || frame.slot < 0 || frame.slot >= settings.frames_in_flight)
        return false;
    take(slots[static_cast<std::size_t>(frame.slot)]);
    commands_ = commands;
    dispatches = -air->dispatches();
    barriers = -air->barriers();
    ticked_ = false;
    blend_.reset();
    for (const Work& work : std::exchange(queue_, {}))
        work(commands);
    return true;
}

void Wind::State::end(const Frame& frame) {
    set ^= 1;
    if (written_sets_ < 2) // the set that no frame was written to yet
        blend_ = blend_.value_or(1.0f);
    if (blend_) {
        air->show(commands_, *blend_, set, ticked_);
        ++written_sets_;
        if (written_sets_ == 1) { // the frame before the first is the first
            air->show(commands_, *blend_, set ^ 1, false);
            written_sets_ = 2;
        }
        ReadBack& slot = slots[static_cast<std::size_t>(frame.slot)];
        air->read_back(commands_, slot.buffer);
        slot.pending = true;
        slot.time = time;
        slot.tick = tick_;
        slot.frame = frame_now();
    }
    recorded_before = std::move(recorded);
    recorded.emplace(frame_now());
    dispatches += air->dispatches();
    barriers += air->barriers();
    commands_ = VK_NULL_HANDLE;
}

windrow::Frame Wind::State::frame_now() const {
    if (frames)
        return {{}, frames->shown.window, frames->shown.rim_point, frames->shown.ambient, frames->shown.still};
    return {{}, window, follow_point, ambient, asleep};
}

bool Wind::State::take(ReadBack& slot) {
    if (!std::exchange(slot.pending, false) || slot.buffer.invalidate() != VK_SUCCESS)
        return false;
    const auto cells = air->shown(slot.buffer);
    queried_cells.assign(cells.begin(), cells.end());
    queried_frame.emplace(windrow::Frame{{}, slot.frame.window, slot.frame.rim_point, slot.frame.ambient, slot.frame.still});
    queried_box = box();
    queried_time = slot.time;
    report = air->report(slot.buffer);
    report_tick_ = slot.tick;
    return true;
}

bool Wind::State::collect(int slot) {
    return slot >= 0 && slot < settings.frames_in_flight && take(slots[static_cast<std::size_t>(slot)]);
}

Diagnostics Wind::State::reported() const {
    Diagnostics diagnostics;
    diagnostics.stepped = report_tick_ > 0;
    tell(diagnostics);
    return diagnostics;
}

Advance Wind::State::record(VkCommandBuffer commands, const Frame& frame) {
    if (!(frame.dt >= 0.0) || !std::isfinite(frame.dt) || !begin(commands, frame))
        return {};
    const Advance done = advance(frame.dt);
    end(frame);
    return done;
}

Diagnostics Wind::State::record_step(VkCommandBuffer commands, const Frame& frame) {
    if (!(frame.dt >= 0.0) || !std::isfinite(frame.dt) || !begin(commands, frame))
        return {};
    const bool slept = asleep;
    const Diagnostics done = step(frame.dt);
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
                                              ": give box().cell_count().")};
    std::vector<glm::vec4> cells(field.size());
    std::transform(field.begin(), field.end(), cells.begin(), [](glm::vec4 u) { return glm::vec4(u.x, u.y, u.z, 0.0f); });
    do_or_queue([this, cells = std::move(cells)](VkCommandBuffer commands) { air->upload(commands, cells); });
    asleep = calm = false;
    disturbed_tick_ = tick_ + 1;
    return {};
}

void Wind::State::reset() {
    fill_with_ambient();
    if (frames)
        fill_before();
    written_sets_ = 0; // the frame before the next is ambient too
}

// --- The cells
// ------------------------------------------------------------------------------------------------------------------

void Wind::State::around_changed() {} // each work brings the ambient wind of its moment

Result<void> Wind::State::sides_changed(bool kinds) {
    disturbed_tick_ = tick_ + 1;
    do_or_queue([this, kinds, sides = config.sides](VkCommandBuffer) { air->set_sides(sides, kinds); });
    return {};
}

void Wind::State::fill_cells() {
    do_or_queue([this, wind = ambient, place = window](VkCommandBuffer commands) { air->fill(commands, wind, place); });
}

void Wind::State::fill_before() {
    do_or_queue([this, wind = ambient, place = window](VkCommandBuffer commands) { air->fill_before(commands, wind, place); });
}

void Wind::State::add_ambient_to_cells(float factor) {
    disturbed_tick_ = tick_ + 1;
    do_or_queue([this, factor, kept = frames.has_value(), wind = ambient, place = window](VkCommandBuffer commands) {
        air->add_wind(commands, factor, kept, wind, place);
    });
}

void Wind::State::add_change_to_cells(glm::vec3 change, bool before_only) {
    disturbed_tick_ = tick_ + 1;
    do_or_queue([this, change, before_only, kept = frames.has_value(), wind = ambient, place = window](VkCommandBuffer commands) {
        air->add_change(commands, change, !before_only, kept, wind, place);
    });
}

void Wind::State::shift_cells(CellIndex by, bool exposed_hold_ambient) {
    do_or_queue([this, by, exposed_hold_ambient, wind = ambient, place = window](VkCommandBuffer commands) {
        air->shift(commands, by, exposed_hold_ambient, wind, place);
    });
}

void Wind::State::begin_keeping() {
    keep_before();
}

void Wind::State::keep_before() {
    do_or_queue([this](VkCommandBuffer commands) { air->keep_before(commands); });
}

void Wind::State::blend(float factor) {
    blend_ = factor;
}

void Wind::State::step_cells(double dt, std::span<const windrow::detail::MotorReach> reached, Diagnostics& diagnostics) {
    ++tick_;
    time += dt;
    ticked_ = true;
    const bool renews = config.stages.projection && renew_sources(reached);
    if (!reached.empty() || renews || ambient.gusting())
        disturbed_tick_ = tick_;
    air->step(commands_, {.duration = dt,
                          .motors = reached,
                          .ambient = &ambient,
                          .window = &window,
                          .renews_sources = renews,
                          .lets_air_in = sources_of_air != 0});
    ambient.advance(dt);
    tell(diagnostics);
    diagnostics.diffusion = config.stages.diffusion ? diffusion_method(config.viscosity, static_cast<float>(dt), config.cell_size)
                                                    : DiffusionMethod::none;
}

bool Wind::State::at_ambient() const {
    return report_tick_ > disturbed_tick_ && report.apart < config.sleep_speed;
}

void Wind::State::measure(Diagnostics& diagnostics) {
    tell(diagnostics);
}

// What the last read-back told.
void Wind::State::tell(Diagnostics& diagnostics) const {
    const auto h = static_cast<double>(config.cell_size);
    diagnostics.max_speed = report.largest_component;
    diagnostics.cfl = report.cfl;
    diagnostics.substeps = report.substeps;
    diagnostics.substeps_capped = report.substeps_capped;
    diagnostics.limited_cells = report.limited_cells;
    diagnostics.repaired_cells = report.repaired_cells;
    diagnostics.energy = 0.5 * report.squares * h * h * h;
    diagnostics.divergence_rms = std::sqrt(report.divergence_squares / static_cast<double>(box().cell_count()));
}

} // namespace windrow::vulkan
