/* A scalar that the wind of a box on the CPU carries along: smoke, dust, a dye (fluid/tracer.h). */
#ifndef WINDROW_C_API_TRACER_H
#define WINDROW_C_API_TRACER_H

#include "base.h"
#include "wind.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct windrow_tracer windrow_tracer;
/* All 0, in the box of a wind. `parallel_for` may be null. */
WINDROW_C_API windrow_result windrow_tracer_create(const windrow_wind* wind, const windrow_parallel_for* parallel_for,
                                                   windrow_tracer** tracer);
WINDROW_C_API void windrow_tracer_destroy(windrow_tracer* tracer);
/* The whole state as bytes, and one that goes on from there, with the wind of the same moment (windrow_wind_save). */
WINDROW_C_API windrow_result windrow_tracer_save(const windrow_tracer* tracer, windrow_bytes** bytes);
WINDROW_C_API windrow_result windrow_tracer_load(const void* bytes, uint64_t size, const windrow_wind* wind,
                                                 const windrow_parallel_for* parallel_for, windrow_tracer** tracer);
/* Carries it through the step of dt [s] that the wind has just made. */
WINDROW_C_API windrow_result windrow_tracer_step(windrow_tracer* tracer, const windrow_wind* wind, double dt);
/* Raises cells to 1 within `radius` [m] of a world point. */
WINDROW_C_API windrow_result windrow_tracer_blow(windrow_tracer* tracer, windrow_dvec3 point, float radius);
/* 0 to 1, a value a cell; good until the next step. */
WINDROW_C_API const float* windrow_tracer_cells(const windrow_tracer* tracer, uint64_t* count);

#ifdef __cplusplus
}
#endif

#endif
