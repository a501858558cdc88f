// Canopy drag: du/dt = -c |u| u inside the canopy, c its drag per metre.
//
// Alone it has the exact solution u / (1 + c t |u|), which keeps the direction and is stable for any time; the step takes it
// whole, before the air moves. Based on: Raupach & Shaw 1982, Boundary-Layer Meteorology 22; Finnigan 2000, Annual Review of
// Fluid Mechanics 32.
#ifndef WINDROW_CANOPY_GLSL
#define WINDROW_CANOPY_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

// Share of a row of cells, `row` to `row` + 1, that lies between the ground and the canopy's top. All in cells above the box's
// low side.
WINDROW_FN float windrow_canopy_fraction(float row, float ground, float top) {
    return clamp(min(row + 1.0f, top) - max(row, ground), 0.0f, 1.0f);
}

// `way` [s/m]: drag per metre, times the time, times the share of the cell.
WINDROW_FN vec3 windrow_canopy_slowed(vec3 u, float way) { return way > 0.0f ? u / (1.0f + way * length(u)) : u; }

#endif
