// The air's state to the host's memory and back: all that is kept from one tick to the next.
#include "fluid/core/message.h"
#include "fluid/vulkan/air.h"
#include "fluid/vulkan/saved_air.h"

#include <bit>
#include <cstring>
#include <utility>

namespace windrow::vulkan {

static_assert(std::endian::native == std::endian::little, "cells are copied as they lie");

// --- From the device ---------------------------------------------------------------------------------------------------------

Result<SavedAir> SavedAir::create(Device& device, glm::ivec3 cells, std::size_t faces, std::size_t bodies) {
    SavedAir saved;
    saved.cells = cells;
    const glm::u64vec3 axes(cells);
    const VkDeviceSize field = axes.x * axes.y * axes.z * sizeof(glm::vec4);
    const auto make = [&](Buffer& buffer, VkDeviceSize bytes) -> Result<void> {
        auto made = Buffer::create(device, bytes, MemoryUse::readback);
        if (!made)
            return made.failure().after("the wind was not saved: ");
        buffer = *std::move(made);
        return {};
    };
    if (auto made = make(saved.control, sizeof(WindrowControl)); !made)
        return made.failure();
    if (auto made = make(saved.velocity, 2 * field); !made)
        return made.failure();
    for (Buffer* buffer : {&saved.history, &saved.source_flow, &saved.before})
        if (auto made = make(*buffer, field); !made)
            return made.failure();
    if (faces > 0)
        if (auto made = make(saved.terms, faces * sizeof(float)); !made)
            return made.failure();
    if (bodies > 0)
        if (auto made = make(saved.loads, bodies * sizeof(float) * WINDROW_LOAD); !made)
            return made.failure();
    return saved;
}

// As BodyLoad is archived behind its handle, from the words of loads.comp.
static void write_load(const std::byte* from, std::byte* to) {
    float words[WINDROW_LOAD];
    std::memcpy(words, from, sizeof(words));
    *to++ = std::byte{words[3 * WINDROW_PUSHED - 1] > 0.0f}; // in the box: closed faces of the sum
    for (const float word : words) {
        const double value = word;
        std::memcpy(to, &value, sizeof(value));
        to += sizeof(value);
    }
}

VkResult SavedAir::invalidate() const {
    for (const Buffer* buffer : {&control, &velocity, &history, &source_flow, &before})
        if (const VkResult result = buffer->invalidate(); result != VK_SUCCESS)
            return result;
    for (const Buffer* buffer : {&terms, &loads})
        if (buffer->bytes() > 0)
            if (const VkResult result = buffer->invalidate(); result != VK_SUCCESS)
                return result;
    return VK_SUCCESS;
}

void SavedAir::fill(SnapshotDraft& draft, const std::optional<ShownFrame>& shown) const {
    WindrowControl found{};
    std::memcpy(&found, control.mapped(), sizeof(found));
    const auto size = glm::u64vec3(cells);
    const std::size_t count = size.x * size.y * size.z;
    const auto cell_of = [&](std::size_t n) { return glm::ivec3(n % size.x, n / size.x % size.y, n / size.x / size.y); };
    const auto value = [&](const Buffer& buffer, std::size_t n, std::size_t slot = 0) { // of the cell n, as pass.glsl finds it
        const glm::u64vec3 place((cell_of(n) + torus) % cells);
        glm::vec4 cell;
        std::memcpy(&cell, buffer.mapped() + (slot * count + (place.z * size.y + place.y) * size.x + place.x) * sizeof(cell),
                    sizeof(cell));
        return cell;
    };
    const WindrowPlan& plan = found.plan;
    const std::size_t now = static_cast<std::size_t>(plan.first_slot + plan.substeps) % 2;
    const bool ambient = shown && shown->still && shown->ambient.gusting();
    const auto shown_cell = [&](std::size_t n) { // as shown.glsl
        if (ambient) {
            const glm::ivec3 cell = cell_of(n);
            return glm::vec4(shown->ambient.velocity(shown->window.centre(cell.x, cell.y, cell.z)), 0.0f);
        }
        const glm::vec4 u = value(velocity, n, now), then = value(before, n);
        return factor == 1.0f || plan.nonfinite_cells + found.nonfinite_cells > 0 ? u : then + factor * (u - then);
    };
    std::size_t term = 0, load = 0;
    for (const SnapshotDraft::Gap& gap : draft.gaps) {
        std::byte* const to = draft.bytes.data() + gap.at;
        const auto copy = [&](const void* from) { std::memcpy(to, from, gap.bytes); };
        const auto fill = [&](const auto& cell) {
            for (std::size_t n = 0; n < gap.bytes / sizeof(glm::vec4); ++n) {
                const glm::vec4 u = cell(n);
                std::memcpy(to + n * sizeof(u), &u, sizeof(u));
            }
        };
        switch (gap.state) {
        case DeviceState::velocity:
            fill([&](std::size_t n) { return value(velocity, n, now); });
            break;
        case DeviceState::velocity_old:
            fill([&](std::size_t n) { return value(velocity, n, 1 - now); });
            break;
        case DeviceState::history:
            fill([&](std::size_t n) { return value(history, n); });
            break;
        case DeviceState::source_flow:
            fill([&](std::size_t n) { return value(source_flow, n); });
            break;
        case DeviceState::before:
            fill([&](std::size_t n) { return value(before, n); });
            break;
        case DeviceState::shown:
        case DeviceState::shown_before:
            fill(shown_cell);
            break;
        case DeviceState::dt_old:
            copy(&plan.substep_duration);
            break;
        case DeviceState::undiffused_time:
            copy(&plan.undiffused_time);
            break;
        case DeviceState::surface_term:
            copy(terms.mapped() + sizeof(float) * term++);
            break;
        case DeviceState::body_load:
            write_load(loads.mapped() + sizeof(float) * WINDROW_LOAD * load++, to);
            break;
        }
    }
}

void Air::save(VkCommandBuffer commands, SavedAir& saved) {
    place_exposed(commands);
    keep(commands);
    barrier(k_compute | k_transfer, k_transfer);
    copy(commands, fields_.control, saved.control);
    copy(commands, fields_.velocity, saved.velocity);
    copy(commands, fields_.history, saved.history);
    copy(commands, fields_.source_flow, saved.source_flow);
    copy(commands, fields_.before, saved.before);
    for (const auto& [to, at] :
         {std::pair{&saved.terms, history_at(history_slot_)}, std::pair{&saved.loads, loads_at(history_slot_)}})
        if (to->bytes() > 0) {
            const VkBufferCopy region{.srcOffset = at, .dstOffset = 0, .size = to->bytes()};
            device_->functions().vkCmdCopyBuffer(commands, fields_.around.handle(), to->handle(), 1, &region);
        }
    barrier(k_transfer, VK_PIPELINE_STAGE_HOST_BIT | k_compute | k_transfer);
    saved.factor = shown_factor_;
    saved.torus = torus_;
}

// --- To the device -----------------------------------------------------------------------------------------------------------

void Air::make_room_to_restore() {
    retired_.reserve(retired_.capacity() + std::tuple_size_v<decltype(RestoredAir::fields)>);
}

void Air::restore(VkCommandBuffer commands, RestoredAir&& air, const AmbientWind& ambient) {
    const Window window = air.window;
    write_step(commands, block_of(ambient, window), ambient);
    const auto load = [&](DeviceState state, const Buffer& to, VkDeviceSize at = 0) {
        const Buffer& from = air.fields[static_cast<std::size_t>(state)];
        if (from.bytes() == 0)
            return false;
        barrier(k_compute | k_transfer, k_transfer);
        copy(commands, from, to, at);
        barrier(k_transfer, k_compute | k_transfer);
        return true;
    };
    window_ = window;
    restore_obstacles(commands, std::move(air.surface), std::move(air.terms), air.loads);
    // Both sets of textures, from the field that then takes the air.
    const auto show_as = [&](int set, const Window& place) {
        window_ = place;
        show(commands, 1.0f, set, false);
        window_ = window;
    };
    if (load(DeviceState::shown, fields_.velocity))
        show_as(0, air.shown);
    if (load(DeviceState::shown_before, fields_.velocity))
        show_as(1, air.shown_before);
    const bool frames = load(DeviceState::before, fields_.before);
    (void)load(DeviceState::velocity, fields_.velocity);
    if (!frames)
        for (const int set : {0, 1})
            show(commands, 1.0f, set, false);
    (void)load(DeviceState::velocity_old, fields_.velocity, fields_.velocity.bytes() / 2); // the other slot
    (void)load(DeviceState::history, fields_.history);
    (void)load(DeviceState::source_flow, fields_.source_flow);
    barrier(k_compute | k_transfer, k_transfer);
    wait(commands);
    const auto set = [&](std::size_t at, float value) {
        device_->functions().vkCmdUpdateBuffer(commands, fields_.control.handle(), at, sizeof(value), &value);
    };
    constexpr std::size_t k_plan = offsetof(WindrowControl, plan);
    for (const std::size_t at : {k_plan + offsetof(WindrowPlan, substep_duration), offsetof(WindrowControl, last_duration)})
        set(at, air.dt_old);
    for (const std::size_t at : {k_plan + offsetof(WindrowPlan, undiffused_time), offsetof(WindrowControl, last_undiffused)})
        set(at, air.undiffused_time);
    barrier(k_transfer, k_compute | k_transfer);
    fresh_ = air.fresh;
    counted_ = false;
    for (Buffer& field : air.fields)
        if (field.bytes() > 0)
            retired_.push_back({std::move(field), slot_});
}

} // namespace windrow::vulkan
