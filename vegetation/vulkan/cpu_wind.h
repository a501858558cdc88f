// A wind on the CPU in shaders: its cells as textures, and what else shaders/coupling/windrow_wind.glsl reads.
//
//     auto wind = engine::CpuWind::create(device, config);
//     (void)(*wind)->air().advance(frame_seconds);             // any call of windrow::Wind
//     (*wind)->record(frame.commands, frame.slot);             // copies 16 bytes a cell
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
    /// Rejects what windrow::Wind::create rejects, and a device that lacks memory. The device outlives it.
    [[nodiscard]] static Result<std::unique_ptr<CpuWind>> create(Device& device, const Config& config);

    [[nodiscard]] windrow::Wind& air() { return air_; }
    [[nodiscard]] const windrow::Wind& air() const { return air_; }

    /// Writes the cells of this frame and of the one before to mapped memory (windrow::Wind::view, previous_view), and records their
    /// copy for all shaders that come after. Outside of a render pass; what was recorded for the slot before is done.
    void record(VkCommandBuffer commands, int slot);

    // --- As of vulkan::Wind ------------------------------------------------------------------------------------------------
    [[nodiscard]] vulkan::Textures textures() const { return {.vectors = {images_[0].image, images_[0].view}}; }
    [[nodiscard]] vulkan::Textures previous_textures() const { return {.vectors = {images_[1].image, images_[1].view}}; }
    [[nodiscard]] FrameBlock frame_block(glm::dvec3 anchor, const Sampling& sampling = {}) const {
        return air_.frame_block(anchor, sampling);
    }
    [[nodiscard]] VkBuffer gust_buffer() const { return tile_; }
    [[nodiscard]] const Config& config() const { return air_.config(); }
    /// [bytes] Device memory; it is the device's own (Device::memory_bytes).
    [[nodiscard]] std::uint64_t memory_bytes() const { return objects_.memory_bytes(); }

  private:
    CpuWind(Device& device, windrow::Wind air);
    /// Copies the gust tile where it is another than the one shown: 4 MiB, once.
    void record_tile(VkCommandBuffer commands, int slot);

    Objects objects_;
    windrow::Wind air_;
    std::array<Image, 2> images_{}; ///< of this frame, of the one before
    FrameBuffers staging_{};        ///< the cells of both
    FrameBuffers tile_staging_{};
    VkBuffer tile_ = VK_NULL_HANDLE;
    std::shared_ptr<const GustTile> shown_{}; ///< what `tile_` holds
};

} // namespace windrow::vegetation::engine
