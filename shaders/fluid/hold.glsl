// Drives and drag of a cell in a sub-step. Declare before: Drives as `drives`, the deposits' drag as `drag`.
#include "numerics/canopy.glsl"
#include "numerics/motors.glsl"
#include "numerics/splitting.glsl"

bool anything_holds() { return is_on(WINDROW_DRIVES | WINDROW_DRAG) || tick.canopy_drag > 0.0f; }

// [1/m]
float drag_of(ivec3 cell, int at) {
    float along = tick.canopy_drag * windrow_canopy_fraction(float(cell.y), tick.canopy_ground, tick.canopy_top);
    if (is_on(WINDROW_DRAG))
        along += drag[at];
    return along;
}

WindrowHold hold_of(ivec3 cell, int at) {
    WindrowHold hold;
    hold.drives = is_on(WINDROW_DRIVES) ? (WINDROW_OF_PLAN.substep_duration / tick.duration) * drives[at] : vec4(0.0f);
    hold.way = (0.5f * WINDROW_OF_PLAN.substep_duration) * drag_of(cell, at);
    return hold;
}
