// Drag of deposits on the device: a float a cell, in the order of the fields. The host finds it (drag_field.h), and uploads the cells
// that are others with the step.
//
// Behind the cells the buffer has room for as many floats on their way: cells of a slab are not neighbours in memory, so that they
// travel together and are copied to their places there.
#include "fluid/core/message.h"
#include "fluid/vulkan/air.h"

#include <algorithm>
#include <cstddef>

namespace windrow::vulkan {

void Air::renew_drag(VkCommandBuffer commands, const CellStep& step) {
    const bool plants_differ = step.drag_change.any() || drag_.any() != step.drag.any() ||
                               (step.drag.any() && drag_origin_ != step.window->origin_cells);
    reading_stale_ = reading_stale_ || (plants_differ && reading_maker_.law().acts());
    // Its cells are where the fields' are, which only a shift of the cells moves: calm air is filled anew in the new box.
    const glm::ivec3 cells = config_.cells;
    const auto turned = glm::ivec3((step.window->origin_cells - drag_origin_) % CellIndex(cells)) - (torus_ - drag_torus_);
    drag_stale_ = drag_stale_ || turned % cells != glm::ivec3(0);
    drag_ = step.drag;
    drag_origin_ = step.window->origin_cells;
    drag_torus_ = torus_;
    holds_drag_ = false;
    drag_stale_ = drag_stale_ || step.drag_change.whole;
    if (!step.drag.any()) {
        drag_stale_ = drag_stale_ || step.drag_change.any();
        return;
    }
    if (drag_stale_ || step.drag_change.count > 0) {
        barrier(k_compute | k_transfer, k_transfer);
        bool made = true;
        if (fields_.drag.bytes() < 2 * sizeof(float) * box().cell_count()) {
            made = make_room_for_drag();
            drag_stale_ = true;
        }
        lacks_drag_ = !made;
        if (!made) // the air does without it in this step
            return;
        if (drag_stale_) {
            upload_drag(commands, step.drag, {glm::ivec3(0), config_.cells});
        } else {
            for (int n = 0; n < step.drag_change.count; ++n)
                upload_drag(commands, step.drag, step.drag_change.ranges[static_cast<std::size_t>(n)]);
        }
        barrier(k_transfer, k_compute);
        drag_stale_ = false;
    }
    holds_drag_ = true;
}

bool Air::make_room_for_drag() {
    return detail::memory_lasts([&] {
               drag_words_.reserve(box().cell_count());
               drag_copies_.reserve(std::size_t{2} * static_cast<std::size_t>(config_.cells.y) *
                                    static_cast<std::size_t>(config_.cells.z));
               retired_.reserve(retired_.size() + 1);
               retired_passes_.reserve(retired_passes_.size() + 1);
           }) &&
           replace(fields_.drag, 2 * sizeof(float) * box().cell_count()) && bind_anew(false);
}

void Air::upload_drag(VkCommandBuffer commands, const DragCells& drag, const detail::CellRange& range) {
    const glm::ivec3 cells = config_.cells;
    const std::size_t all = box().cell_count();
    drag_words_.clear();
    drag_copies_.clear();
    const auto copy = [&](int from, int to, int j, int k) {
        if (from >= to)
            return;
        const glm::ivec3 place = (glm::ivec3(from, j, k) + torus_) % cells;
        const float* const row = drag.drag.data() + box().index(0, j, k);
        drag_copies_.push_back({.srcOffset = sizeof(float) * (all + drag_words_.size()),
                                .dstOffset = sizeof(float) * box().index(place.x, place.y, place.z),
                                .size = sizeof(float) * static_cast<VkDeviceSize>(to - from)});
        drag_words_.insert(drag_words_.end(), row + from, row + to);
    };
    const int seam = std::clamp(cells.x - torus_.x, range.low.x, range.high.x); // where a row begins anew in memory
    for (int k = range.low.z; k < range.high.z; ++k)
        for (int j = range.low.y; j < range.high.y; ++j) {
            copy(range.low.x, seam, j, k);
            copy(seam, range.high.x, j, k);
        }
    if (drag_words_.empty())
        return;
    barrier(k_transfer, k_transfer);
    write(commands, fields_.drag, std::as_bytes(std::span(drag_words_)), sizeof(float) * all);
    barrier(k_transfer, k_transfer);
    wait(commands);
    device_->functions().vkCmdCopyBuffer(commands, fields_.drag.handle(), fields_.drag.handle(),
                                         static_cast<std::uint32_t>(drag_copies_.size()), drag_copies_.data());
}

} // namespace windrow::vulkan
