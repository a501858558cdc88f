// A wind around the box that is another, larger wind: what a sub-step takes of it. D is the outer wind less the ambient one, p its
// kinematic pressure [m^2/s^2], both at a cell's centre. With c = dt/2, or dt in a step without a past, beyond open boundaries
//
//   carried   U - (dt/2) grad p        pressure   phi / h = c p / h        wind of the divergence   W = D + c grad p
//
// fluid/cpu/outer_wind.h has the whole.
#ifndef WINDROW_LEVELS_GLSL
#define WINDROW_LEVELS_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

// D and p, `way` of the way through a step.
WINDROW_FN vec4 windrow_outer_between(vec4 start, vec4 end, float way) { return start + way * (end - start); }

// [s] c
WINDROW_FN float windrow_outer_factor(float dt, bool has_past) { return has_past ? 0.5f * dt : dt; }

// [s] By which the pressure has pushed carried values at departure: half a step, but in a step without a past, which takes all at
// its end.
WINDROW_FN float windrow_outer_departs(float dt, bool has_past) { return has_past ? 0.5f * dt : 0.0f; }

// [m/s^2] Slope of the pressure between two centres that are `apart` [m].
WINDROW_FN float windrow_outer_slope(float low, float high, float apart) { return (high - low) / apart; }

// [m/s] phi / h
WINDROW_FN float windrow_outer_potential(float p, float factor, float cell_size) { return factor / cell_size * p; }

// [m/s] W along an axis.
WINDROW_FN float windrow_outer_pushed(float along, float factor, float slope) { return along + factor * slope; }

#endif
