// Save and load of a wind on a device: the host's state at the time of a recording, the cells once its slot is done.
#include "fluid/core/message.h"
#include "fluid/vulkan/wind.h"
#include "fluid/vulkan/wind_state.h"

#include <cstring>
#include <utility>

namespace windrow::vulkan {

// A save that is recorded. The textures and what is read back are recorded already.
void Wind::State::record_save(VkCommandBuffer commands) {
    save_error.clear();
    bool noted = windrow::detail::memory_lasts([&] {
        put_save_away();
        const DeviceSurface surface = cells.air->surface();
        auto air = SavedAir::create(cells.air->device(), core.config.cells, surface.keys.size(),
                                    surface.load_duration > 0.0f ? surface.placed.size() : 0);
        if (!air) {
            save_error = air.error();
            return;
        }
        cells.materialise_gusts();
        cells.refill(core.ambient, core.window());
        auto draft = draft_snapshot(core, cells.air->fresh(), surface, level_state());
        save.emplace(WindSave{.slot = slot, .air = *std::move(air), .draft = std::move(draft), .shown = {}});
        if (core.frames)
            save->shown.emplace(core.frames->shown);
    });
    if (!noted) {
        if (save && save->slot == slot) // not recorded yet
            save.reset();
        save_failed_ = true;
        return;
    }
    save_failed_ = false;
    if (save)
        cells.air->save(commands, save->air);
}

// A device keeps no pressure for a wind inside it: there is none.
LevelState Wind::State::level_state() const {
    LevelState level;
    if (const OuterAir* const outer = cells.air->outer()) {
        for (const glm::vec4& cell : outer->values())
            level.outer.insert(level.outer.end(), {cell.x, cell.y, cell.z, cell.w});
        level.outer_origin = outer->origin();
        level.filled = cells.filled();
    }
    return level;
}

Result<std::vector<std::byte>> Wind::State::saved() {
    return windrow::detail::where_memory_lasts([&]() -> Result<std::vector<std::byte>> {
        if (save_failed_)
            return windrow::detail::out_of_memory();
        if (!save_error.empty())
            return Error{save_error};
        if (!save)
            return Error{"no wind is saved: record a frame with Frame::save, once for each call of saved."};
        if (!save->done)
            return Error{detail::message("the saved frame is still in flight: record or collect its slot ", save->slot,
                                         " again, then call saved.")};
        if (const VkResult result = save->air.invalidate(); result != VK_SUCCESS)
            return call_error("vkInvalidateMappedMemoryRanges", "the saved wind", result);
        save->air.fill(save->draft, save->shown);
        auto bytes = finish_snapshot(std::move(save->draft));
        save.reset();
        return bytes;
    });
}

namespace {

Result<Buffer> upload_of(Device& device, std::span<const glm::vec4> cells) {
    auto made = Buffer::create(device, cells.size_bytes(), MemoryUse::upload);
    if (made)
        std::memcpy(made->mapped(), cells.data(), cells.size_bytes());
    return made;
}

// The cells on their way to the device.
Result<RestoredAir> restored(Device& device, LoadedWind& from) {
    RestoredAir air;
    air.fresh = from.fresh;
    air.undiffused_time = from.undiffused_time;
    Result<void> made_all;
    const auto put = [&](DeviceState state, std::span<const glm::vec4> field) {
        if (!made_all)
            return;
        auto made = upload_of(device, field);
        if (made)
            air.fields[static_cast<std::size_t>(state)] = *std::move(made);
        else
            made_all = made.failure();
    };
    put(DeviceState::velocity, from.velocity);
    if (!from.fresh) {
        put(DeviceState::velocity_old, from.velocity_old);
        put(DeviceState::history, from.history);
        air.dt_old = from.dt_old;
    }
    if (from.core.source_name != 0)
        put(DeviceState::source_flow, from.source_flow);
    if (from.core.frames) {
        put(DeviceState::before, from.before);
        put(DeviceState::shown, from.shown);
        put(DeviceState::shown_before, from.shown_before);
    }
    air.surface = {.placed = std::move(from.surface.placed),
                   .inside_is_air = from.surface.inside_is_air,
                   .keys = std::move(from.surface.keys),
                   .shift = from.surface.shift,
                   .load_duration = from.surface.duration};
    air.terms = std::move(from.surface.terms);
    air.loads = std::move(from.surface.loads);
    if (from.core.frames) {
        air.shown = from.core.frames->shown.window;
        air.shown_before = from.core.frames->shown_before.window;
    }
    if (!made_all)
        return made_all.failure().after("the snapshot's cells were not loaded: ");
    return air;
}

} // namespace

Result<void> Wind::State::continue_from(LoadedWind from) {
    if (from.core.frames) // windows name the rows of their wind, and that one ends
        from.core.frames->shown.window.rows = from.core.frames->shown_before.window.rows = core.rows.get();
    auto air = restored(cells.air->device(), from);
    if (!air)
        return air.failure();
    core.place = from.core.place;
    core.ambient = from.core.ambient;
    core.motors = std::move(from.core.motors);
    core.obstacles = std::move(from.core.obstacles);
    core.drag = std::move(from.core.drag);
    core.source_name = from.core.source_name;
    core.sleep = from.core.sleep;
    core.speed = from.core.speed;
    core.speed.note_read(from.velocity, core.ambient, core.window());
    core.frames = from.core.frames;
    core.place.window.rows = core.rows.get();
    core.obstacles.set_rows(core.rows.get());
    cells.continue_from(*std::move(air), from.level.filled);
    if (core.config.stages.sources)
        cells.air->set_drag(core.drag.cells_in(core.window(), core.config.boundaries), core.window());
    if (!from.level.outer.empty())
        cells.air->restore_outer(from.level.outer, from.level.outer_origin);
    textures.written = 2; // by the first recording, before all else
    recorded.emplace(core.shown());
    recorded_before.emplace(core.frames ? core.frames->shown_before : core.shown());
    return {};
}

Result<Wind> Wind::load(const Host& host, std::span<const std::byte> bytes, const Settings& settings,
                        std::shared_ptr<const windrow::Wind> outer) {
    return windrow::detail::where_memory_lasts([&]() -> Result<Wind> {
        OuterUndo undo(outer);
        auto saved = windrow::Wind::load(bytes, {}, outer);
        if (!saved)
            return saved.failure();
        auto wind = make(host, saved->config(), settings, std::move(outer), true);
        if (!wind)
            return wind;
        if (auto taken = wind->state().continue_from(windrow::loaded(*saved)); !taken)
            return taken.failure();
        undo.succeed();
        return wind;
    });
}

Result<std::vector<std::byte>> Wind::saved() {
    return state_->saved();
}

} // namespace windrow::vulkan
