// The ground memory on the GPU, inside the host's renderer: coupling/ground_memory.h as one compute pass.
//
//     auto ground = windrow::vulkan::GroundMemory::create(host, {});                      // fluid/vulkan/host.h: your device
//     (void)ground->follow(player);
//     if (auto done = ground->record(command_buffer, {.duration = dt, .walkers = walkers, .wind_lean = lean}); !done)
//         log(done.error());
//     bind(ground->texture(), ground->previous_texture(), ground->block(camera));         // shaders/coupling/windrow_ground.glsl
//
// Config, walkers and steps are those of windrow::GroundMemory, and texels are the same to rounding. It does not submit or
// wait: all work goes into the host's command buffer, to run on one queue in the order of recording.
#pragma once

#include "../../fluid/api.h"
#include "../../fluid/owned.h"
#include "../../fluid/vulkan/wind.h"
#include "../ground_config.h"
#include "../motion_blocks.h"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace windrow::vulkan {

/// A texture of n x n x 1 texels, in VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL for every shader stage that comes after the
/// recording in submission order.
struct GroundTexture {
    VkImage image = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE;
};

class WINDROW_API GroundMemory {
  public:
    /// Makes all buffers, images and pipelines; textures of RGBA16F, or of RGBA32F. Rejects what `validate` rejects, and a device
    /// that lacks something, with the reason. The host's device outlives the memory.
    [[nodiscard]] static Result<GroundMemory> create(const Host& host, const GroundConfig& config, Texel texel = Texel::half);

    /// As windrow::GroundMemory::follow.
    Result<void> follow(glm::dvec3 point);
    /// As windrow::GroundMemory::shift_origin. The textures stay; `block` and `next_place` are of the shifted world.
    Result<void> shift_origin(glm::dvec3 offset);
    /// Records a step outside of a render pass: one dispatch, a copy of some hundred bytes, barriers. Rejects what
    /// windrow::GroundMemory::advance rejects; nothing is recorded then. What is recorded must be submitted: the next step goes
    /// on from it.
    Result<void> record(VkCommandBuffer commands, const GroundStep& step, WindLeans leans = WindLeans::everywhere);

    /// Records a copy of all of it, as the last `record` left it, outside of a render pass. Takes 40 bytes a texel of memory that the
    /// host reads, once. Rejects a memory without a step, which has nothing to copy.
    Result<void> record_save(VkCommandBuffer commands);
    /// The bytes of windrow::GroundMemory::save, once for each `record_save`, when its commands have run, which the host waits for.
    /// They load here and on the CPU. The frame before the saved one is saved as that one.
    [[nodiscard]] Result<std::vector<std::byte>> saved();
    /// A memory that goes on from bytes of either backend. Its textures hold nothing before the first `record`, whose frame before
    /// is the one that was saved. Takes 48 to 56 bytes a texel more, for good. Rejects as windrow::GroundMemory::load and `create`.
    [[nodiscard]] static Result<GroundMemory> load(const Host& host, std::span<const std::byte> bytes, Texel texel = Texel::half);

    /// Two floats (x and z [rad]; beyond 1e3 or no numbers: 0) for each slot, x fastest: for WindLeans::each_texel, written by
    /// compute or transfer commands of the host's, recorded before `record`, which waits for them. Holds anything before the
    /// first write: fill it whole before the first `record` with WindLeans::each_texel. A shader finds a slot's place by
    /// `next_place` and windrow_ground_in_slot (shaders/numerics/ground.glsl).
    [[nodiscard]] VkBuffer lean_buffer() const;
    /// Walkers who touched the window in the last `record` and did not count, for lack of room.
    [[nodiscard]] int walkers_left_out() const;
    /// Position of the texels of the next step, relative to `anchor` [m].
    [[nodiscard]] GroundPlaceBlock next_place(glm::dvec3 anchor) const;

    /// Of the step last recorded, and of the one before; nothing before the first.
    [[nodiscard]] GroundTexture texture() const;
    [[nodiscard]] GroundTexture previous_texture() const;
    /// Their position relative to `anchor` [m]: the uniform buffer of the include.
    [[nodiscard]] GroundBlock block(glm::dvec3 anchor) const;
    [[nodiscard]] const GroundConfig& config() const;
    /// [bytes] Device memory in use.
    [[nodiscard]] std::uint64_t memory_bytes() const;
    /// [bytes] Device memory that was taken from the driver for it, in blocks with room left: at least `memory_bytes`.
    [[nodiscard]] std::uint64_t reserved_bytes() const;

    GroundMemory(GroundMemory&&) noexcept;
    GroundMemory& operator=(GroundMemory&&) noexcept;
    /// No recording of it is in flight.
    ~GroundMemory();

  private:
    struct State;
    explicit GroundMemory(std::unique_ptr<State> state);
    windrow::detail::Owned<State> state_;
};

} // namespace windrow::vulkan
