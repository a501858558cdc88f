// Wind of a frame between ticks: a blend of the last two ticks, and that of the frame before.
//
//   u = u_before + factor (u_now - u_before)
//
// of the last two ticks in the box of today: continuous in time, at most a tick old.
#pragma once

#include "fluid/core/tick_clock.h"
#include "fluid/core/window_history.h"
#include "fluid/track.h"

#include <utility>

namespace windrow {

/// The wind of one frame, without its cells.
struct ShownFrame {
    Window window;
    glm::dvec3 blend_centre{0.0}; ///< [m]
    AmbientWind ambient;
    bool still = false; ///< the air slept: its cells are `ambient` in `window`

    void shift_origin(const OriginShift& shift) {
        shift.move(window);
        shift.move(blend_centre);
        shift.move(ambient);
    }
};

/// Source of the cells of a frame.
struct FrameBlend {
    float factor = 0.0f;    ///< of the way from the tick before to now
    bool still = false;     ///< the air slept in both: the cells are the ambient wind of the frame's moment
    bool unchanged = false; ///< the cells of the frame before the last one are those of this frame already
};

/// The air now, as FrameHistory needs it.
struct AirNow {
    Window window;
    glm::dvec3 point{0.0}; ///< [m]
    const AmbientWind& ambient;
    bool asleep = false;
};

struct FrameHistory {
    explicit FrameHistory(const AirNow& now)
        : point_before(now.point), gust_phase_before(now.ambient.phase()), shown{now.window, now.point, now.ambient},
          shown_before(shown), follow(now.point) {}

    // At the tick before the last one:
    bool before_still = false;         ///< the air slept
    glm::dvec3 point_before{0.0};      ///< [m] what the box was centred on
    glm::dvec3 gust_phase_before{0.0}; ///< [m]
    TickClock clock;
    ShownFrame shown, shown_before;
    Track follow; ///< of the point that the box follows

    void shift_origin(const OriginShift& shift) {
        for (ShownFrame* const frame : {&shown, &shown_before})
            frame->shift_origin(shift);
        shift.move(point_before);
        AmbientWind before = shown.ambient;
        before.set_phase(shift.moved_phase(gust_phase_before, before.period()));
        gust_phase_before = before.phase();
        follow.shift(shift.offset);
    }
    /// A tick begins: what is now becomes what was before it.
    void keep(const AirNow& now);
    /// A frame `factor` of the way from the tick before to now; the one shown becomes the one before.
    [[nodiscard]] FrameBlend show(const AirNow& now, double factor);
};

} // namespace windrow
