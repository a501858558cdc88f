// The outer wind around the box: the host samples it (fluid/core/outer_air.h) and uploads D and p of the padded box behind the gust
// tile, where shaders/fluid/outer.glsl reads them. There are two fields, of a tick's start and end; the end is the next one's start,
// so that a tick uploads one of them, or both after a shift: 16 bytes a padded cell, 450 KiB of the default window.
#include "fluid/vulkan/air.h"

namespace windrow::vulkan {

namespace {

constexpr VkDeviceSize k_tile_bytes = VkDeviceSize{128} * 16 * 128 * sizeof(glm::vec4);

} // namespace

void Air::follow_outer(const CellChange& change) {
    if (!outer_)
        return;
    outer_stale_ = outer_stale_ || change.kind == CellChange::Kind::fill || !outer_->holds(change.window);
    if (change.kind == CellChange::Kind::fill)
        outer_->renew(change.window, config_.parallel_for);
    else
        outer_->move_to(change.window, config_.parallel_for);
}

void Air::begin_outer(VkCommandBuffer commands, const CellStep& step) {
    if (!outer_)
        return;
    outer_stale_ = outer_stale_ || !outer_->holds(*step.window);
    outer_->begin_step(*step.window, step.outer_way, config_.parallel_for);
    upload_outer(commands);
    upload_outer(commands, outer_->values_at_end(), !outer_turned_);
}

void Air::end_outer() {
    if (!outer_)
        return;
    outer_->end_step();
    outer_turned_ = !outer_turned_;
}

void Air::restore_outer(std::span<const float> values, CellIndex origin) {
    outer_->restore(values, origin);
    outer_stale_ = true;
}

void Air::upload_outer(VkCommandBuffer commands) {
    if (outer_ && std::exchange(outer_stale_, false))
        upload_outer(commands, outer_->values(), outer_turned_);
}

void Air::upload_outer(VkCommandBuffer commands, std::span<const glm::vec4> cells, bool second) {
    barrier(k_compute | k_transfer, k_transfer);
    const std::span<const std::byte> bytes = std::as_bytes(cells);
    const VkDeviceSize to = k_tile_bytes + (second ? bytes.size() : 0);
    // From host memory that stays: vkCmdUpdateBuffer copies it into fresh memory of the command buffer. A recording of 128 x 64 x 128
    // cells takes 6 ms of the CPU in place of 16 (llvmpipe).
    if (const auto at = fields_.outer.put(bytes))
        copy(commands, fields_.outer.buffer(), fields_.tile,
             VkBufferCopy{.srcOffset = *at, .dstOffset = to, .size = bytes.size()});
    else
        write(commands, fields_.tile, bytes, to);
    barrier(k_transfer, k_compute | k_transfer);
}

} // namespace windrow::vulkan
