/*
 * The operators of a step (advection, diffusion, projection) on arrays of the host's own (fluid/operators.h): smoke on the host's wind,
 * a velocity field made free of divergence, a method compared with an analytic case.
 *
 *     windrow_config box;
 *     windrow_workspace* work = NULL;
 *     windrow_config_init(&box, sizeof box);
 *     box.cells.x = 64, box.cells.y = 64, box.cells.z = 1;
 *     windrow_workspace_create(&box, &work);
 *     windrow_project(work, velocity, NULL, NULL, 64 * 64);
 *
 * A field has one entry a cell, x fastest, then y, then z; a velocity is x, y, z in m/s and 0. `count` is the number of cells, checked in
 * each call. Arrays of velocities are aligned to 16 bytes. All calls run on the CPU.
 */
#ifndef WINDROW_C_API_OPERATORS_H
#define WINDROW_C_API_OPERATORS_H

#include "base.h"
#include "config.h"
#include "obstacles.h"
#include "wind.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Tables and scratch for one box; holds no field. Calls with the same workspace must not overlap in time. */
typedef struct windrow_workspace windrow_workspace;
/* For the box of a config: its cells, cell_size, rows and boundaries, with its ambient wind, simd and parallel_for. The config is checked
   whole; what else it has is of a wind alone. */
WINDROW_C_API windrow_result windrow_workspace_create(const windrow_config* config, windrow_workspace** work);
WINDROW_C_API void windrow_workspace_destroy(windrow_workspace* work);
/* x * y * z: entries of each field. */
WINDROW_C_API uint64_t windrow_workspace_cell_count(const windrow_workspace* work);
/* [bytes] That it has allocated. */
WINDROW_C_API uint64_t windrow_workspace_memory_bytes(const windrow_workspace* work);
/* Obstacles stay; they are gone where memory for them is missing. */
WINDROW_C_API windrow_result windrow_workspace_set_boundaries(windrow_workspace* work, const windrow_boundaries* boundaries);
/* The wind beyond open boundaries. */
WINDROW_C_API windrow_result windrow_workspace_set_ambient(windrow_workspace* work, windrow_vec3 ambient);
/* Replaces the obstacles that every operator sees: `count` of them, one after the other, at most 65,535. Positions are relative to the
   box's corner that is low in the library's own axes (windrow_set_axes). `velocities` [m/s] and `spins` [rad/s], one for each, may be null: at rest. */
WINDROW_C_API windrow_result windrow_workspace_set_obstacles(windrow_workspace* work, const windrow_obstacle* obstacles,
                                                             const windrow_vec3* velocities, const windrow_vec3* spins,
                                                             uint64_t count);
/* [m^4/s] Pressure force on an obstacle, by its place in that list, times the length of the step, over the air's density: the momentum
   that the last projection took from the air and gave to it. */
WINDROW_C_API windrow_result windrow_workspace_impulse_on(const windrow_workspace* work, uint64_t obstacle,
                                                          windrow_vec3* impulse);

/* A velocity to move, and the wind that moves it. */
typedef struct windrow_transport {
    uint32_t struct_size;
    float dt;                            /* [s] at least 0 */
    const windrow_vec4* carried;         /* what moves; beyond open boundaries it is the ambient wind */
    const windrow_vec4* velocity;        /* the wind at the start of the step */
    const windrow_vec4* velocity_old;    /* the wind one step earlier; null: steady over the step */
    const windrow_vec4* history;         /* history_scale times this is subtracted from `carried` as it is read; null: none */
    float history_scale;                 /* default 0 */
    float extrapolation;                 /* dt over the step before, 0 to 2, default 1: how far velocity_old reaches on */
    float relaxation;                    /* factor on carried - ambient as it is read, 0 to 1, default 1 */
    windrow_interpolation interpolation; /* default cubic */
} windrow_transport;
WINDROW_C_API windrow_result windrow_transport_init(windrow_transport* transport, uint32_t struct_size);
/* result(x) = carried at where the air of x was dt ago, by the second-order trajectory (Hortal 2002). `result` may be any of the fields
   but `velocity`, and shares no part of its memory with the others. */
WINDROW_C_API windrow_result windrow_advect(windrow_workspace* work, const windrow_transport* transport, windrow_vec4* result,
                                            uint64_t count);

/* A scalar on the same wind: smoke, seeds, a dye. */
typedef struct windrow_scalar_transport {
    uint32_t struct_size;
    float dt; /* [s] at least 0 */
    const float* carried;
    const windrow_vec4* velocity;
    float outside;   /* value beyond open boundaries, default 0; walls mirror the scalar */
    int32_t clamped; /* 1: no result leaves the range of the eight values around its departure point; order 2.6 for 3 */
    windrow_interpolation interpolation; /* default cubic */
    uint32_t reserved;                   /* 0 */
} windrow_scalar_transport;
WINDROW_C_API windrow_result windrow_scalar_transport_init(windrow_scalar_transport* transport, uint32_t struct_size);
/* `result` is an array of its own. */
WINDROW_C_API windrow_result windrow_advect_scalar(windrow_workspace* work, const windrow_scalar_transport* transport,
                                                   float* result, uint64_t count);

/* result = field after dt [s] of diffusion with a viscosity [m^2/s]; `result` is not `field`. `method`, which may be null, becomes the one
   that the library took by r = viscosity * dt / h^2: none below 1e-4 (a copy), one pass up to 1/12, a direct solve above. */
WINDROW_C_API windrow_result windrow_diffuse(windrow_workspace* work, const windrow_vec4* field, float viscosity, float dt,
                                             windrow_vec4* result, windrow_diffusion_method* method, uint64_t count);
/* Allocates the memory of the direct solve now, so that no later call does. */
WINDROW_C_API windrow_result windrow_workspace_reserve_diffusion(windrow_workspace* work);

/* [1/s] Central divergence at cell centres, as the projection sees it. */
WINDROW_C_API windrow_result windrow_divergence(windrow_workspace* work, const windrow_vec4* velocity, float* result,
                                                uint64_t count);
/* Solves L phi = rhs in place, L the 7-point Laplacian [1/m^2], directly. In a box without an open boundary the mean of rhs is dropped and
   phi has mean 0. */
WINDROW_C_API windrow_result windrow_solve_poisson(windrow_workspace* work, float* rhs_then_phi, uint64_t count);
/* velocity -= grad phi with L phi = div velocity - expansion: what remains of the divergence falls as h^2. `gradient`, which may be null,
   receives grad phi; `expansion` [1/s], which may be null, is the divergence that sources of volume want. Cells inside obstacles take
   their velocity. */
WINDROW_C_API windrow_result windrow_project(windrow_workspace* work, windrow_vec4* velocity, windrow_vec4* gradient,
                                             const float* expansion, uint64_t count);

#ifdef __cplusplus
}
#endif

#endif
