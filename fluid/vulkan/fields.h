// Device memory of one wind: fields, tables, and buffers between host and passes.
//
// A field of cells holds four floats a cell. Its cells are in the order of box.h, from a cell that moves with the box and around
// (WindrowStep::torus). With N cells and P padded cells (five more an axis), in bytes:
//   velocity                                                                    32 N: now and a sub-step ago
//   history, force, drives, source_flow, arrived, diffused, before              16 N each
//   padded                                                                      32 P, 48 P with gusts
//   tile, with an outer wind                                                    4 MiB and 32 P, 16 P more a slot in host memory
//   expansion, hat, potential                                                   4 N each; hat_x too where the solve is in slabs
//   drag                                                                        8 N, with the first deposit
#pragma once

#include "fluid/box.h"
#include "fluid/motors.h"
#include "fluid/vulkan/host_blocks.h"
#include "fluid/vulkan/textures.h"
#include "gpu/device.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace windrow::vulkan {

struct Fields {
    /// Throws nothing, rejects what the device cannot hold. `motors` and `sums` count entries; `commands` counts dispatches of a
    /// tick.
    struct Sizes {
        glm::ivec3 cells{0};
        std::uint32_t table_floats = 1;
        std::uint32_t commands = 1;
        std::uint32_t sums = 1;
        bool diffuses = false; ///< else `diffused` is a stand-in
        bool rough = false;    ///< else `layer` is empty
        bool rows = false;     ///< of unequal thickness: their table is behind the step
        bool gusts = false;    ///< else `tile` is one
        bool outer = false;    ///< an outer wind's values are behind the tile
        bool slabs = false;    ///< else `hat_x` is a stand-in
        Texel texel = Texel::half;
        TextureSet textures = TextureSet::vectors;     ///< what it has not stays empty
        std::uint32_t slots = 1;                       ///< that the host reads
        VkDeviceSize slot_bytes = 32;                  ///< the report, then what the host asked for
        std::uint32_t points = 0;                      ///< that the host may ask for in a frame
        VkExternalMemoryHandleTypeFlagBits exported{}; ///< textures; 0: not
    };
    [[nodiscard]] static Result<Fields> create(Device& device, const Sizes& sizes);

    HostBlocks step, motors; ///< of a tick: WindrowStep with the rows behind it; WindrowMotor
    HostBlocks outer;        ///< an outer wind's values on their way to the tile, one field a slot; empty without
    Buffer control, shapes, commands, rules, tables, tile;
    Buffer velocity, history, force, drives, source_flow, arrived, diffused, before;
    Buffer padded, expansion, hat, hat_x, potential, sums;
    /// Around obstacles; stand-ins until there is one. Tables (solids.glsl), WindrowAround and its words, the last correction
    /// and the sum of those before it, the direction.
    Buffer solids, around, correction, direction;
    /// Of deposits: c [1/m] of each cell, and behind them cells on their way; a stand-in until there is one.
    Buffer drag;
    Buffer reading;            ///< tables of SurfaceReading; a stand-in until there are some
    Buffer layer;              ///< over rough ground: tables of SurfaceLayer
    Buffer points;             ///< WindrowPoint; empty without
    std::vector<Buffer> slots; ///< mapped; WindrowReport, then cells or winds
    /// [0] and [1]: of this frame and of the last, in turns. Four components; x, y, z.
    Image3D vectors[2], axes[2][3];
    /// Those whose buffer this is; null: it is another.
    [[nodiscard]] const HostBlocks* blocks_of(const Buffer* buffer) const {
        return buffer == &step.buffer() ? &step : buffer == &motors.buffer() ? &motors : nullptr;
    }
    /// The images of a frame that there are, at most four: the bindings of Pass::show.
    template <class Use>
    void each_image(int frame, const Use& use) const {
        for (const Image3D* image : {&vectors[frame], &axes[frame][0], &axes[frame][1], &axes[frame][2]})
            if (image->handle() != VK_NULL_HANDLE)
                use(*image);
    }
};

/// Most motors of a tick: what Motors can hold, wakes in pieces.
inline constexpr std::uint32_t k_max_motors = Motors::k_capacity * std::uint32_t{Track::k_max_segments};

} // namespace windrow::vulkan
