// The cells of a wind as its core uses them (wind_core.h): on the CPU (cpu/cells.h) or on a device (vulkan/device_cells.h).
//
// A change carries the ambient wind of its time. So a storage may apply it later; it compares the ambient wind with that of its
// cells instead of being notified.
#pragma once

#include "fluid/ambient.h"
#include "fluid/boundaries.h"
#include "fluid/config.h"
#include "fluid/core/frame_history.h"
#include "fluid/core/numerics.h"
#include "fluid/core/solve_policy.h"
#include "fluid/diagnostics.h"
#include "fluid/drag_field.h"
#include "fluid/motor_reach.h"
#include "fluid/obstacle.h"
#include "fluid/window.h"

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <vector>

namespace windrow {

/// One change of the cells.
struct CellChange {
    enum class Kind : std::uint8_t {
        fill,         ///< the air becomes ambient, with no past and no flow of volume sources
        fill_before,  ///< the air of the tick before becomes ambient
        shift,        ///< the air stays where it is while the box moves by `by`; exposed cells have no past
        add_change,   ///< of the mean wind, by its profile: `change`
        add_wind,     ///< `factor` times the ambient wind
        set,          ///< the air becomes `cells`, with no past, and so does that of the tick before
        keep,         ///< the air of the tick before becomes that of now
        begin_frames, ///< as `keep`; the frames shown become the air of now too
        end_frames,   ///< no air but that of now is kept
    };
    Kind kind = Kind::fill;
    AmbientWind ambient; ///< after the change
    Window window;       ///< as `ambient`
    bool kept = false;   ///< the air of the tick before is kept, and changes too
    bool to_air = true;  ///< of add_change: false changes only the air of the tick before
    float factor = 0.0f; ///< 1 or -1
    glm::vec3 change{0.0f};
    CellIndex by{0};
    bool exposed_hold_ambient = true;   ///< else 0
    bool has_source_flow = false;       ///< the velocity holds a flow of volume sources, which moves too
    std::span<const glm::vec4> cells{}; ///< good during the call alone
};

/// What a backend found after a tick of the core's count; tick 0: nothing was measured.
struct MeasuredSpeed {
    std::uint64_t tick = 0;
    float largest = 0.0f; ///< [m/s] velocity component
    bool still = false;   ///< nothing acted, and all components were within Config::sleep_speed of the ambient wind
};
/// Of the last tick, and of those before it that a backend reports together.
using MeasuredSpeeds = std::array<MeasuredSpeed, 5>;

/// Rows of cells among plants: drag per metre, and heights of ground and top in cells above the box's low boundary.
struct CanopyRows {
    float drag = 0.0f; ///< [1/m] 0: none
    float ground = 0.0f, top = 0.0f;
    /// [1/m] Of a row.
    [[nodiscard]] float drag_of(int row) const {
        return drag > 0.0f ? drag * numerics::windrow_canopy_fraction(static_cast<float>(row), ground, top) : 0.0f;
    }
};

/// A step of the air.
struct CellStep {
    std::uint64_t tick = 0; ///< SpeedBound::tick
    double duration = 0.0;  ///< [s]
    /// As many sub-steps, each with its own place of the obstacles; 0: none moves, the storage counts by the speed that it finds.
    int substeps = 0;
    std::span<const detail::MotorReach> motors{};
    /// Those that meet the box, where they are at the end of the step.
    std::span<const detail::PlacedObstacle> obstacles{};
    bool obstacles_changed = false;         ///< they are not those of the last step, moved, or the box did
    bool obstacles_moved = false;           ///< some came, went or moved
    std::shared_ptr<const GustTile> tile{}; ///< of the motors' eddies; null: none has any
    AmbientWind* ambient = nullptr;         ///< at the start of the step; the storage advances it to the end
    const Window* window = nullptr;
    CanopyRows canopy{};
    DragCells drag{};
    DragChange drag_change{};     ///< since the last step
    float relaxation_time = 0.0f; ///< [s] to the ambient wind; 0: never
    bool renews_sources = false;  ///< the volume sources are not those of the last step
    bool has_source_flow = false; ///< the velocity holds a flow of theirs, after this step's change
    bool kept = false;            ///< the air of the tick before is kept
    bool may_rest = false;        ///< nothing acts: whether the air is still is measured
    bool rests = false;           ///< the air becomes ambient after this step and sleeps
    float outer_way = 1.0f;       ///< of the way to the outer wind of now, which the step goes
    float outer_speed = 0.0f;     ///< [m/s] largest component of that; 0: there is none
};

/// Memory needs of the next calls.
struct CellNeeds {
    double step = 0.0;            ///< [s] longest step; 0: none
    const Gusts* gusts = nullptr; ///< around the box
    bool frames = false;          ///< CellChange::begin_frames
    bool set = false;             ///< CellChange::set
};

class CellStorage {
  public:
    virtual ~CellStorage() = default;
    /// Changes no cell; throws std::bad_alloc where memory is missing. After it the calls that it was made for do not fail.
    virtual void make_room(const CellNeeds& needs) = 0;
    /// Applies the boundary conditions; `kinds`: not only wall velocities differ. On an error nothing has changed.
    [[nodiscard]] virtual Result<void> set_boundaries(const Boundaries& boundaries, bool kinds) = 0;
    virtual void apply(const CellChange& change) = 0;
    /// True where the air has come to rest: it is ambient now, with no past, and the report is that of the ambient air. A replay
    /// on a device does as it was recorded, all else as the step says.
    [[nodiscard]] virtual bool step(const CellStep& step, Diagnostics& report) = 0;
    /// Makes the frame to show, after FrameHistory::show.
    virtual void show(const FrameBlend& blend) = 0;
    /// The frame shown and the one before it become the air of now: of a wind that was reset.
    virtual void show_air() = 0;
    /// The air was filled and not stepped or set since.
    [[nodiscard]] virtual bool filled() const { return false; }
    /// Of the newest tick whose speed the host knows.
    [[nodiscard]] virtual MeasuredSpeeds measured() const = 0;
    /// Why the storage cannot hold such gusts.
    [[nodiscard]] virtual Result<void> check(const Gusts&) const { return {}; }
    /// The world's origin has moved, and with it all that the core has. No cell changes.
    virtual void shift_origin(const OriginShift& shift) = 0;
    /// Memory for the vectors of all cells, between two calls; empty where the storage has none in the host's memory.
    [[nodiscard]] virtual std::span<glm::vec4> spare() { return {}; }
};

/// What a wind keeps for an inner one, and of its own outer one; empty without.
struct LevelState {
    std::vector<float> pressure{}, pressure_before{}; ///< [m^2/s^2] of the cells; a device keeps none
    float shown_factor = 1.0f;
    bool filled = false;        ///< and not stepped since
    std::vector<float> outer{}; ///< D and p of padded cells
    CellIndex outer_origin{0};
};

/// Both blow alike, at the same places.
[[nodiscard]] inline bool same_wind(const AmbientWind& a, const AmbientWind& b) {
    return a.mean() == b.mean() && a.phase() == b.phase() && a.ground() == b.ground() && a.gust_axes() == b.gust_axes() &&
           a.settings().gusts.intensity == b.settings().gusts.intensity && a.period() == b.period() && a.tile() == b.tile();
}

} // namespace windrow
