// Snapshot of a wind whose cells are elsewhere, by the text of Wind::save: the host's state is written at one time, the cells are
// filled in later.
#pragma once

#include "fluid/api.h"
#include "fluid/core/wind_core.h"
#include "fluid/solids/loads.h"

#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

namespace windrow {

/// State that a device holds.
enum class DeviceState : std::uint8_t {
    // 16 bytes a cell
    velocity,
    velocity_old,
    history,
    source_flow,
    before,       ///< air at the tick before the last one
    shown,        ///< cells of the frame shown last
    shown_before, ///< of the frame before it
    // floats [s]
    dt_old,
    undiffused_time,
    surface_term, ///< [m/s] of the pressure's history at one closed face of an obstacle; all in order
    body_load     ///< BodyLoad behind its handle, of one obstacle; all in order
};

/// Snapshot with gaps.
struct SnapshotDraft {
    struct Gap {
        DeviceState state;
        std::size_t at; ///< in `bytes`
        std::size_t bytes;
    };
    std::vector<std::byte> bytes{};
    std::vector<Gap> gaps{};
};

/// SurfaceHistory without what a device holds.
struct DeviceSurface {
    std::vector<PlacedObstacle> placed{};
    bool inside_is_air = false;
    std::vector<std::uint32_t> keys{};
    glm::ivec3 shift{0};        ///< cells by which the box has moved since they were placed
    float load_duration = 0.0f; ///< [s] of the step whose forces on all of `placed` the device holds; 0: it finds none
};

/// The state of the host now. `fresh`: the cells have no past. The frame before the one shown is written as that one: a device
/// does not hold its cells. Throws std::bad_alloc.
[[nodiscard]] WINDROW_INTERNAL SnapshotDraft draft_snapshot(const WindCore& core, bool fresh, const DeviceSurface& surface,
                                                            const LevelState& level = {});
/// The bytes of Wind::save, once all gaps are filled. Throws std::bad_alloc.
[[nodiscard]] WINDROW_INTERNAL std::vector<std::byte> finish_snapshot(SnapshotDraft&& draft);

/// A wind that Wind::load made, as a device takes it over. It refers to the wind.
struct LoadedWind {
    WindCore& core;
    bool fresh = true;                           ///< the cells have no past
    float dt_old = 0.0f, undiffused_time = 0.0f; ///< [s]
    std::span<const glm::vec4> velocity{};
    std::span<const glm::vec4> velocity_old{}, history{};         ///< unset where they are fresh
    std::span<const glm::vec4> source_flow{};                     ///< empty without
    std::span<const glm::vec4> before{}, shown{}, shown_before{}; ///< with ticks
    SurfaceHistory surface{};
    LevelState level{};
};
[[nodiscard]] WINDROW_INTERNAL LoadedWind loaded(Wind& wind);

} // namespace windrow
