// A wind on the CPU in shaders: its cells as textures, and what else shaders/coupling/windrow_wind.glsl reads.
//
//     auto wind = engine::CpuWind::create(device, config);
//     (void)(*wind)->air().advance(frame_seconds);             // or any other call of windrow::Wind
//     (void)(*wind)->record(frame.commands, frame.slot);       // copies 8 bytes a cell
//     renderer->record(frame, camera, **wind);                 // or WindSet::of, in place of a vulkan::Wind
//
// For a GPU that is full, or a software device: there the CPU steps the same air 20 to 40 times faster (docs/vulkan.md).
#pragma once

#include "../../fluid/vulkan/textures.h"
#include "../../fluid/wind.h"
#include "objects.h"

#include <memory>

namespace windrow::vegetation::engine {

class CpuWind {
  public:
    /// Rejects what windrow::Wind::create rejects, a device that lacks memory, and a box beyond its maxImageDimension3D. The
    /// device outlives it.
    [[nodiscard]] static Result<std::unique_ptr<CpuWind>> create(Device& device, const Config& config);
    /// For a wind that exists, as from a snapshot.
    [[nodiscard]] static Result<std::unique_ptr<CpuWind>> create(Device& device, windrow::Wind air);

    /// Advance it before `record`, and not between `record` and what samples it in the frame.
    [[nodiscard]] windrow::Wind& air() { return air_; }
    [[nodiscard]] const windrow::Wind& air() const { return air_; }

    /// Records a frame, once after each `advance` or `step`: writes the cells to mapped memory, and copies them for all shaders
    /// that come after. Outside of a render pass. What was recorded for the slot before is done, and what is recorded must be
    /// submitted. Rejects a slot out of range, an air that has other cells than the one of `create`, and, where gusts begin later,
    /// a lack of memory.
    Result<void> record(VkCommandBuffer commands, int slot);

    // --- As of vulkan::Wind, after the first `record` ------------------------------------------------------------------------
    [[nodiscard]] vulkan::Textures textures() const { return {.vectors = {images_[now_].image, images_[now_].view}}; }
    [[nodiscard]] vulkan::Textures previous_textures() const {
        return {.vectors = {images_[1 - now_].image, images_[1 - now_].view}};
    }
    [[nodiscard]] VkBuffer gust_buffer() const { return tile_; }
    /// [bytes] Device memory; it is the device's own (Device::memory_bytes).
    [[nodiscard]] std::uint64_t memory_bytes() const { return objects_.memory_bytes(); }

  private:
    CpuWind(Device& device, windrow::Wind air);
    void copy_cells(VkCommandBuffer commands, VkBuffer from, std::size_t image);
    /// Copies the gust tile where it is another than the one shown.
    void record_tile(VkCommandBuffer commands, std::size_t slot);

    Objects objects_;
    windrow::Wind air_;
    glm::ivec3 cells_;
    std::array<Image, 2> images_{}; ///< in turns: of this frame, of the one before
    std::size_t now_ = 0;
    bool begun_ = false;
    FrameBuffers staging_{};
    FrameBuffers tile_staging_{}; ///< for gusts that begin later
    VkBuffer tile_ = VK_NULL_HANDLE;
    std::shared_ptr<const GustTile> shown_{}; ///< what `tile_` holds
};

} // namespace windrow::vegetation::engine
