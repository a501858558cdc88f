// Recording of a frame: the host's requests since the last one, the ticks that are due, the textures, the read-back.
#include "fluid/core/message.h"
#include "fluid/core/replay.h"
#include "fluid/vulkan/wind_state.h"

#include <cmath>
#include <utility>

namespace windrow::vulkan {

Result<void> Wind::State::check(VkCommandBuffer commands, const Frame& frame) const {
    detail::Reasons reasons;
    if (commands == VK_NULL_HANDLE)
        reasons.add("commands is null: give a command buffer that is being recorded.");
    if (!(frame.dt >= 0.0) || !std::isfinite(static_cast<float>(frame.dt)))
        reasons.add("dt is ", frame.dt, ": give the finite seconds since the last frame, from 0.");
    if (frame.slot != -1 && !read_backs.has(frame.slot))
        reasons.add("slot is ", frame.slot, ": give one from 0 to ", settings.frames_in_flight - 1,
                    " (Settings::frames_in_flight), or -1 for the next in turn.");
    return reasons.outcome();
}

// All that can fail, before anything changes.
Result<void> Wind::State::begin(VkCommandBuffer commands, const Frame& frame) {
    if (auto checked = check(commands, frame); !checked)
        return checked;
    if (!windrow::detail::memory_lasts([&] { cells.make_room({}); }))
        return windrow::detail::out_of_memory();
    const auto taken = read_backs.begin(*cells.air, frame.slot);
    if (!taken)
        return taken.failure();
    slot = *taken;
    note_done(slot);
    if (clock)
        clock->begin(commands, slot);
    dispatches = -cells.air->dispatches();
    barriers = -cells.air->barriers();
    asked_ = cells.begin(commands, slot);
    return {};
}

// True where both sets are of this frame: the frame before the first is the first.
bool Wind::State::write_textures(VkCommandBuffer commands, bool reads) {
    cells.air->show(commands, *cells.blend, textures.current, cells.air->stepped(),
                    reads ? std::optional(read_backs.next()) : std::nullopt);
    if (++textures.written != 1)
        return false;
    cells.air->show(commands, *cells.blend, textures.current ^ 1, false);
    ++textures.written;
    return true;
}

void Wind::State::end(VkCommandBuffer commands, const Frame& frame) {
    if (std::exchange(cells.shows_anew, false)) // the frame before this one is this one too
        textures.written = 0;
    textures.current ^= 1;
    // The set that no frame was written to yet; a wind that was loaded asleep is read once.
    if (textures.written < 2 || !read_backs.recorded_any())
        cells.blend = cells.blend.value_or(1.0f);
    // A pause between ticks changes nothing.
    const bool changed = cells.blend && (frame.dt > 0.0 || asked_ || !core.frames || read_backs.frame() == nullptr);
    const ReadPlaces places{.around = frame.around, .points = frame.points};
    const bool reads = changed || read_backs.asks(*cells.air, frame_now(), places);
    const bool both = cells.blend && write_textures(commands, reads);
    if (reads) {
        const RecordedFrame now = frame_now();
        if (before_read_back)
            before_read_back(commands);
        if (clock)
            clock->begin_read_back(commands);
        read_backs.record(*cells.air, commands, now, places);
    }
    if (frame.save)
        record_save(commands);
    cells.end();
    if (clock)
        clock->end(commands);
    recorded_before = std::move(recorded);
    recorded.emplace(core.shown());
    if (both)
        recorded_before = recorded;
    dispatches += cells.air->dispatches();
    barriers += cells.air->barriers();
}

RecordedFrame Wind::State::frame_now() const {
    const ShownFrame shown = core.shown();
    return {.frame = shown,
            .box = core.box(),
            .blend_zone = core.blend_zone(shown.blend_centre),
            .time = time,
            .tick = core.speed.tick(),
            .reading = cells.air->reading(),
            .part = cells.air->sampled_part(),
            .outer = core.outer.get()};
}

bool Wind::State::collect(int number) {
    if (!read_backs.has(number))
        return false;
    note_done(number);
    if (clock)
        clock->collect(number);
    const auto taken = read_backs.take(*cells.air, number);
    return taken && *taken;
}

// Of the frame that was taken last, whose cells are `own`; by the first query of the frame.
ShownCells Wind::State::sampled(const std::function<std::span<const glm::vec4>()>& own) const {
    const RecordedFrame* const read = read_backs.frame();
    if (read == nullptr || !read->reading)
        return {};
    const std::lock_guard lock(sampling_);
    if (sampled_of_ != read_backs.recording()) {
        sampled_.resize(read->box.cell_count());
        read->reading->show(own(), read->part, sampled_, ParallelFor{});
        sampled_of_ = read_backs.recording();
    }
    WallLaw law = read->reading->law();
    if (read->part.rows_low > 0) // the part has no floor
        law.lowest = -1e30f;
    return {
        .cells = sampled_, .law = law, .reading = read->reading.get(), .low = read->part.low, .rows_low = read->part.rows_low};
}

Diagnostics Wind::State::diagnostics() const {
    Diagnostics diagnostics;
    diagnostics.stepped = read_backs.tick() > 0;
    read_backs.report_to(diagnostics, core.box());
    return diagnostics;
}

Diagnostics Wind::State::reported() {
    Diagnostics once = diagnostics();
    read_backs.take_counts(once);
    return once;
}

Result<Advance> Wind::State::record(VkCommandBuffer commands, const Frame& frame) {
    if (auto begun = begin(commands, frame); !begun)
        return begun.failure();
    Advance done = core.advance(frame.dt);
    if (done.ticks > 0) // a host that reads no more than its ticks' reports misses none
        read_backs.take_counts(done.last);
    time += frame.dt - done.dropped;
    end(commands, frame);
    return done;
}

Result<Diagnostics> Wind::State::record_step(VkCommandBuffer commands, const Frame& frame) {
    if (core.frames && frame.dt == 0.0) { // between two ticks it stays there
        auto paused = record(commands, frame);
        if (!paused)
            return paused.failure();
        return paused->last;
    }
    if (auto begun = begin(commands, frame); !begun)
        return begun.failure();
    const bool slept = core.sleep.asleep();
    Diagnostics done = core.step(frame.dt);
    if (frame.dt > 0.0)
        read_backs.take_counts(done);
    time += frame.dt;
    if (cells.materialise_gusts())
        cells.blend = 1.0f;
    if (!slept || !core.sleep.asleep() || frame.dt == 0.0) // a pause shows what changed without a step
        textures.stale = 2;
    if (textures.stale > 0) { // asleep: until both sets of textures hold the sleeping air
        --textures.stale;
        cells.blend = 1.0f;
    }
    end(commands, frame);
    return done;
}

void Wind::State::forget() {
    cells.forget();
    core.reset();
    read_backs.forget();
    if (save && !save->done && save->slot == slot) // of the recording that was thrown away
        save.reset();
    if (clock)
        clock->forget();
    core.sleep.stir();
}

namespace {

struct RecordedTime {
    Wind& wind;
    const std::function<Result<void>(const std::function<void(VkCommandBuffer)>&)>& run;

    template <class Report>
    [[nodiscard]] Result<Report> recorded(Result<Report> (Wind::*call)(VkCommandBuffer, const Frame&), double dt) const {
        Result<Report> report{Report{}};
        if (auto ran = run([&](VkCommandBuffer commands) { report = (wind.*call)(commands, {.dt = dt}); }); !ran)
            return ran.failure();
        return report;
    }
    [[nodiscard]] Result<Diagnostics> step(double dt) const { return recorded(&Wind::record_step, dt); }
    [[nodiscard]] Result<Advance> advance(double dt) const { return recorded(&Wind::record, dt); }
    void record(const TickRecorded& tick) const { wind.state().cells.dictate(tick); }
};

} // namespace

Result<void> replay(const EventLog& log, Wind& wind,
                    const std::function<Result<void>(const std::function<void(VkCommandBuffer)>&)>& run) {
    return windrow::detail::replay(log, wind, RecordedTime{wind, run});
}

} // namespace windrow::vulkan
