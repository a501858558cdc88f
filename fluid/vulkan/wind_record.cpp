// Recording of a frame: the host's requests since the last one, the ticks that are due, the textures, the read-back.
#include "fluid/vulkan/wind_state.h"

#include <cmath>
#include <utility>

namespace windrow::vulkan {

bool Wind::State::begin(VkCommandBuffer commands, const Frame& frame) {
    if (!(frame.dt >= 0.0) || !std::isfinite(frame.dt) || commands == VK_NULL_HANDLE)
        return false;
    if (frame.slot != -1 && !read_backs.has(frame.slot))
        return false;
    const int slot = read_backs.begin(*cells.air, frame.slot);
    if (clock)
        clock->begin(commands, slot);
    dispatches = -cells.air->dispatches();
    barriers = -cells.air->barriers();
    asked_ = cells.begin(commands, slot);
    return true;
}

// True where both sets are of this frame: the frame before the first is the first.
bool Wind::State::write_textures(VkCommandBuffer commands) {
    cells.air->show(commands, *cells.blend, textures.current, cells.air->stepped());
    if (++textures.written != 1)
        return false;
    cells.air->show(commands, *cells.blend, textures.current ^ 1, false);
    ++textures.written;
    return true;
}

void Wind::State::end(VkCommandBuffer commands, const Frame& frame) {
    textures.current ^= 1;
    if (textures.written < 2) // the set that no frame was written to yet
        cells.blend = cells.blend.value_or(1.0f);
    bool both = false;
    if (cells.blend) {
        both = write_textures(commands);
        if (frame.dt > 0.0 || asked_ || !core.frames || !read_backs.frame()) { // a pause between ticks changes nothing
            if (before_read_back)
                before_read_back(commands);
            if (clock)
                clock->begin_read_back(commands);
            read_backs.record(*cells.air, commands, frame_now());
        }
    }
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
            .tick = cells.rest.tick};
}

bool Wind::State::collect(int slot) {
    if (!read_backs.has(slot))
        return false;
    if (clock)
        clock->collect(slot);
    return read_backs.take(*cells.air, slot);
}

Diagnostics Wind::State::reported() {
    Diagnostics diagnostics;
    diagnostics.stepped = read_backs.tick() > 0;
    read_backs.report_to(diagnostics, core.box());
    read_backs.take_counts(diagnostics);
    return diagnostics;
}

Advance Wind::State::record(VkCommandBuffer commands, const Frame& frame) {
    if (!begin(commands, frame))
        return {};
    Advance done = core.advance(frame.dt);
    if (done.ticks > 0) // a host that reads no more than its ticks' reports misses none
        read_backs.take_counts(done.last);
    if (!done.last.out_of_memory)
        time += frame.dt - done.dropped;
    end(commands, frame);
    return done;
}

Diagnostics Wind::State::record_step(VkCommandBuffer commands, const Frame& frame) {
    if (core.frames && frame.dt == 0.0) // between two ticks it stays there
        return record(commands, frame).last;
    if (!begin(commands, frame))
        return {};
    const bool slept = core.sleep.asleep();
    Diagnostics done = core.step(frame.dt);
    if (frame.dt > 0.0)
        read_backs.take_counts(done);
    time += frame.dt;
    if (cells.hold_gusts())
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

void Wind::State::reset() {
    core.reset();
    textures.written = 0; // the frame before the next is ambient too
}

void Wind::State::forget() {
    cells.forget();
    reset();
    read_backs.forget();
    if (clock)
        clock->forget();
    cells.rest.disturb();
    core.sleep.stir();
}

} // namespace windrow::vulkan
