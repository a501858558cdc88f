// What frames and views show of the cells: the air between two ticks, and beside surfaces as readers find it (solids/reading.h).
#include "fluid/core/message.h"
#include "fluid/core/wind_core.h"
#include "fluid/cpu/cells.h"

#include <algorithm>
#include <utility>

namespace windrow::cpu {

// --- Beside surfaces ---------------------------------------------------------------------------------------------------------

ShownCells SampledCells::shown() const {
    if (!reading)
        return {};
    return {.cells = cells, .law = reading->law(), .reading = reading.get(), .low = part.low, .rows_low = part.rows_low};
}

// The reading of the obstacles as they were placed last.
void Cells::renew_reading() {
    const Workspace::State& state = work.state();
    Window window = wind_.window();
    if (state.has_solids())
        window.origin_cells -= CellIndex(unplaced_shift_);
    else if (drag_.any())
        window.origin_cells = drag_origin_;
    if (!reading_stale_ && (reading_origin_ == window.origin_cells || !reading_maker_.depends_on_place()))
        return;
    reading_.reset();
    reading_stale_ = false;
    reading_origin_ = window.origin_cells;
    if (state.has_solids() || wall_law(config_, box()).acts())
        reading_ = reading_maker_.make(state.has_solids() ? state.solids.get() : nullptr, config_.boundaries, window, drag_);
}

void Cells::sample(std::span<const glm::vec4> from, const Window& window, SampledCells& sampled,
                   const ParallelFor& parallel_for) {
    const bool made = detail::memory_lasts([&] {
        renew_reading();
        sampled.reading = reading_;
        if (reading_ && sampled.cells.empty())
            sampled.cells = Buffer<glm::vec4>(from.size());
    });
    if (!made) { // as the air's own
        sampled.reading.reset();
        reading_stale_ = true;
    }
    if (sampled.reading) {
        sampled.part = {.cells = box().cells, .low = glm::ivec3(window.origin_cells - reading_origin_), .rows_low = 0};
        sampled.reading->show(from, sampled.part, sampled.cells, parallel_for);
    }
    std::atomic_ref(sampled.held) = true;
}

// By the first reader, in the reader's own thread.
void Cells::sample_once(std::span<const glm::vec4> from, const Window& window, SampledCells& sampled) {
    const std::atomic_ref held(sampled.held);
    if (held)
        return;
    const std::lock_guard lock(holding_);
    if (!held)
        sample(from, window, sampled, {});
}

// --- Frames ------------------------------------------------------------------------------------------------------------------

void Cells::show_air() {
    if (frames.before.empty())
        return;
    materialise_air();
    for (FrameCells::Field* field : {&frames.shown, &frames.shown_before}) {
        field->held = true;
        std::copy_n(air.velocity.data(), field->cells.size(), field->cells.data());
        sample(field->cells, wind_.window(), field->sampled, config_.parallel_for);
    }
}

void Cells::show(const FrameBlend& blend) {
    std::swap(frames.shown, frames.shown_before);
    if (blend.unchanged)
        return;
    FrameCells::Field& shown = frames.shown;
    shown_factor_ = blend.factor;
    shown.held = !blend.still || !wind_.ambient.gusting();
    shown.sampled.held = false;
    if (!shown.held)
        return;
    materialise_air();
    if (blend.still) {
        std::copy_n(air.velocity.data(), air.velocity.size(), shown.cells.data());
        return sample(shown.cells, wind_.frames->shown.window, shown.sampled, config_.parallel_for);
    }
    materialise_before();
    const std::size_t row_plane = static_cast<std::size_t>(box().cells.x) * static_cast<std::size_t>(box().cells.y);
    config_.parallel_for(box().cells.z, [&](int plane) {
        const std::size_t first = row_plane * static_cast<std::size_t>(plane);
        for (std::size_t n = first; n < first + row_plane; ++n)
            shown.cells[n] = frames.before[n] + blend.factor * (air.velocity[n] - frames.before[n]);
    });
    sample(shown.cells, wind_.frames->shown.window, shown.sampled, config_.parallel_for);
}

// --- Reading -----------------------------------------------------------------------------------------------------------------

WindView Cells::air_view() {
    materialise_air();
    sample_once(air.velocity, wind_.window(), sampled_);
    return {box(),
            wind_.window(),
            wind_.blend_zone(wind_.place.point),
            wind_.ambient,
            air.velocity,
            wind_.config.simd,
            sampled_.shown(),
            {wind_.outer.get(), false}};
}

WindView Cells::view(FrameCells::Field& field, const ShownFrame& frame) {
    materialise_frame(field, frame);
    sample_once(field.cells, frame.window, field.sampled);
    return {box(),
            frame.window,
            wind_.blend_zone(frame.blend_centre),
            frame.ambient,
            field.cells,
            wind_.config.simd,
            field.sampled.shown(),
            {wind_.outer.get(), &field == &frames.shown_before}};
}

WindView Cells::shown_view(bool before) {
    if (!wind_.frames)
        return air_view();
    return before ? view(frames.shown_before, wind_.frames->shown_before) : view(frames.shown, wind_.frames->shown);
}

} // namespace windrow::cpu
