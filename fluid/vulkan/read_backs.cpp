#include "fluid/vulkan/read_backs.h"

#include "fluid/core/message.h"
#include "fluid/core/view_place.h"
#include "fluid/textures.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace windrow::vulkan {
namespace {

// First cell of a box of `size` cells around a point, within the wind's box.
glm::ivec3 low_around(const RecordedFrame& frame, const std::optional<glm::dvec3>& around, glm::ivec3 size) {
    const glm::dvec3 local = frame.frame.window.local(around.value_or(frame.frame.blend_centre));
    glm::ivec3 low(0);
    for (int axis = 0; axis < 3; ++axis) {
        const double most = frame.box.cells[axis] - size[axis], wanted = std::floor(local[axis] - 0.5 * size[axis] + 0.5);
        low[axis] = static_cast<int>(std::isfinite(wanted) ? std::clamp(wanted, 0.0, most) : std::floor(0.5 * most));
    }
    return low;
}

// A part of the frame's box as a box of its own: open where it ends within the box.
void cut(RecordedFrame& frame, glm::ivec3 low, glm::ivec3 size) {
    Boundaries& boundaries = frame.box.boundaries;
    const std::array<std::array<Boundary*, 2>, 3> faces = {{{&boundaries.x_low, &boundaries.x_high},
                                                            {&boundaries.y_low, &boundaries.y_high},
                                                            {&boundaries.z_low, &boundaries.z_high}}};
    for (int axis = 0; axis < 3; ++axis) {
        const bool whole = size[axis] == frame.box.cells[axis], periodic = frame.box.boundaries.periodic(axis);
        if (low[axis] > 0 || (periodic && !whole))
            *faces[static_cast<std::size_t>(axis)][0] = {};
        if (low[axis] + size[axis] < frame.box.cells[axis] || (periodic && !whole))
            *faces[static_cast<std::size_t>(axis)][1] = {};
    }
    frame.frame.window.origin_cells += CellIndex(low);
    frame.part = {.cells = size, .low = frame.part.low + low, .rows_low = low.y};
    frame.box.cells = frame.frame.window.cells = size;
}

WindrowPoint point_in(const RecordedFrame& frame, glm::dvec3 position) {
    const windrow::detail::ViewPlace place =
        windrow::detail::place_in(frame.box, frame.frame.window, frame.blend_zone, frame.frame.ambient, position);
    return {.low = place.low,
            .fraction = place.fraction,
            .high = place.high,
            .unused_a = 0,
            .between = place.between,
            .over_floor = static_cast<float>(position.y - frame.frame.window.origin().y),
            .ambient = frame.outer != nullptr && place.fraction < 1.0f ? frame.outer->velocity(position) : place.ambient,
            .unused_c = 0.0f};
}

} // namespace

glm::vec3 HalfView::velocity(glm::dvec3 position) const {
    if (samples_)
        return place_.velocity(position);
    const Box& box = place_.box();
    auto place = windrow::detail::place_in(box, place_.window(), place_.blend_zone(), place_.ambient(), position);
    if (place_.around().outer != nullptr && place.fraction < 1.0f)
        place.ambient = place_.around().outer->velocity(position);
    return windrow::detail::wind_at(place, [&](int i, int j, int k) { return glm::vec3(vector_of(cells_[box.index(i, j, k)])); });
}

void ReadBacks::make(const Air& air, int slots, const RecordedFrame& start) {
    const auto points = static_cast<std::size_t>(air.reads().points);
    held_ = slots;
    for (int n = 0; n <= slots; ++n) {
        readings_.push_back({.frame = start});
        readings_.back().points.reserve(points);
        readings_.back().bodies.reserve(static_cast<std::size_t>(air.reads().forces));
        if (n < slots)
            slots_.push_back({.reading = n});
    }
    places_.reserve(points);
}

Result<int> ReadBacks::begin(const Air& air, int slot) {
    const int next = slot >= 0 ? slot : (last_ + 1) % static_cast<int>(slots_.size());
    if (auto taken = take(air, next); !taken)
        return taken.failure();
    before_last_ = std::exchange(last_, next);
    ++recording_;
    return next;
}

bool ReadBacks::asks(const Air& air, const RecordedFrame& frame, const ReadPlaces& places) const {
    const Reads& reads = air.reads();
    if (reads.kind == ReadBack::points)
        return !places.points.empty();
    return reads.kind == ReadBack::box && low_around(frame, places.around, reads.cells) != low_;
}

void ReadBacks::record(Air& air, VkCommandBuffer commands, const RecordedFrame& frame, const ReadPlaces& places) {
    Slot& slot = slots_[static_cast<std::size_t>(last_)];
    const Reads& reads = air.reads();
    Reading& reading = readings_[static_cast<std::size_t>(slot.reading)];
    reading.frame = frame;
    ReadRequest request{.slot = slot.reading};
    if (reads.kind == ReadBack::box) {
        request.low = low_around(frame, places.around, reads.cells);
        low_ = request.low;
        cut(reading.frame, request.low, reads.cells);
    }
    if (reads.kind == ReadBack::points) {
        const auto points = places.points.first(std::min(places.points.size(), static_cast<std::size_t>(reads.points)));
        reading.points.assign(points.begin(), points.end());
        places_.clear();
        for (const glm::dvec3 position : points)
            places_.push_back(point_in(frame, position));
        request.points = places_;
    }
    reading.bodies.clear();
    reading.duration = air.step_duration();
    const auto bodies = air.bodies();
    for (const auto& body : bodies.first(std::min(bodies.size(), static_cast<std::size_t>(reads.forces))))
        reading.bodies.emplace_back(body.slot, body.generation);
    air.read_back(commands, request);
    slot.pending = true;
    slot.ticked = air.stepped();
    slot.recording = recording_;
    recorded_any_ = true;
}

Result<bool> ReadBacks::take(const Air& air, int number) {
    Slot& slot = slots_[static_cast<std::size_t>(number)];
    if (!slot.pending)
        return false;
    if (const VkResult result = air.slot(slot.reading).invalidate(); result != VK_SUCCESS)
        return call_error("vkInvalidateMappedMemoryRanges", detail::message("the read-back of slot ", number), result);
    slot.pending = false;
    const AirReport found = air.report(slot.reading);
    if (slot.ticked) {
        repaired_ += found.repaired_cells;
        limited_ += found.limited_cells;
    }
    if (slot.recording < taken_recording_) // a host that does not take its slots in turns
        return false;
    taken_recording_ = slot.recording;
    report_ = found;
    std::swap(held_, slot.reading);
    tick_ = held().frame.tick;
    return true;
}

ObstacleForce ReadBacks::force_on(const Air& air, std::uint32_t slot, std::uint32_t generation) const {
    if (taken_recording_ == 0)
        return {};
    const auto& bodies = held().bodies;
    const auto found = std::find(bodies.begin(), bodies.end(), std::pair(slot, generation));
    if (found == bodies.end())
        return {};
    return force_of(air.push_on(held_, static_cast<int>(found - bodies.begin())), held().duration);
}

void ReadBacks::forget() {
    for (Slot& slot : slots_)
        slot.pending = false;
    last_ = before_last_;
    report_ = {};
}

void ReadBacks::report_to(Diagnostics& diagnostics, const Box& box) const {
    const auto h = static_cast<double>(box.cell_size);
    diagnostics.max_speed = report_.largest_component;
    diagnostics.cfl = report_.cfl;
    diagnostics.substeps = report_.substeps;
    diagnostics.substeps_capped = report_.substeps_capped;
    diagnostics.carried_time = report_.carried_time;
    diagnostics.pressure_residual = report_.pressure_residual;
    diagnostics.pressure_solves = report_.pressure_solves;
    diagnostics.energy = 0.5 * report_.squares * h * h * h;
    diagnostics.divergence_rms = std::sqrt(report_.divergence_squares / static_cast<double>(box.cell_count()));
}

void ReadBacks::take_counts(Diagnostics& diagnostics) {
    diagnostics.limited_cells = std::exchange(limited_, 0);
    diagnostics.repaired_cells = std::exchange(repaired_, 0);
}

void ReadBacks::shift_origin(const OriginShift& shift) {
    for (Reading& reading : readings_) {
        reading.frame.frame.shift_origin(shift);
        shift.move(reading.frame.blend_zone.point);
        for (glm::dvec3& point : reading.points)
            shift.move(point);
    }
}

} // namespace windrow::vulkan
