// The state of the air in the host's memory: on its way from the device to a snapshot, or from a snapshot to the device.
#pragma once

#include "fluid/core/snapshot.h"
#include "fluid/vulkan/blocks.h"
#include "gpu/buffer.h"

#include <array>
#include <optional>

namespace windrow::vulkan {

/// Copies of the fields, one after another in time: `Air::save` records them, `fill` reads them once they are done.
class SavedAir {
  public:
    /// 80 bytes a cell. `faces`: closed ones of obstacles. `bodies`: with forces.
    [[nodiscard]] static Result<SavedAir> create(Device& device, glm::ivec3 cells, std::size_t faces, std::size_t bodies);
    /// Makes what the device wrote visible.
    [[nodiscard]] VkResult invalidate() const;
    /// Fills the gaps of a draft that was made when this was recorded. `shown`: the frame of then, with `ticks`.
    void fill(SnapshotDraft& draft, const std::optional<ShownFrame>& shown) const;

    // Of the recording:
    Buffer control, velocity, history, source_flow, before; ///< as Fields has them
    Buffer terms, loads;                                    ///< at closed faces, and of bodies; empty without
    glm::ivec3 cells{0}, torus{0};                          ///< of the box, WindrowStep::torus
    float factor = 1.0f;                                    ///< of the frame shown
};

/// What a loaded wind's first recording writes.
struct RestoredAir {
    /// Indexed by DeviceState, up to shown_before; empty where a wind has none.
    std::array<Buffer, 7> fields;
    bool fresh = true;
    float dt_old = 0.0f;          ///< [s]
    float undiffused_time = 0.0f; ///< [s]
    DeviceSurface surface{};
    std::vector<float> terms{};     ///< at its faces
    std::vector<BodyLoad> loads{};  ///< of its bodies
    Window window{};                ///< the box of the cells
    Window shown{}, shown_before{}; ///< the boxes of both frames
};

} // namespace windrow::vulkan
