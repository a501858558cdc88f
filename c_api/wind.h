/* The wind in a box that follows a player. One thread at a time may use a wind; two winds have no common state. A windrow_wind is on
   the CPU (windrow_wind_create) or on a device (windrow_vulkan_wind_create); both take the calls below, except where one is named. */
#ifndef WINDROW_C_API_WIND_H
#define WINDROW_C_API_WIND_H

#include "ambient.h"
#include "base.h"
#include "config.h"
#include "shader_blocks.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct windrow_event_log windrow_event_log; /* event_log.h */

typedef int32_t windrow_diffusion_method;
enum { WINDROW_DIFFUSION_NONE = 0, WINDROW_DIFFUSION_ONE_PASS = 1, WINDROW_DIFFUSION_IMPLICIT = 2 };

/* [ms] Wall-clock time of one step by stage. */
typedef struct windrow_stage_times {
    double sources, ambient, diffusion, advection, projection, obstacles, report, total;
} windrow_stage_times;

/* Report of a step (fluid/diagnostics.h). */
typedef struct windrow_diagnostics {
    uint32_t struct_size;
    int32_t stepped; /* 0: nothing was done */
    int32_t out_of_memory;
    int32_t regridded;
    float max_speed; /* [m/s] */
    float cfl;
    int32_t substeps;
    int32_t substeps_capped;
    float carried_time; /* [s] */
    int32_t motors_in_reach;
    int64_t limited_cells;
    int64_t repaired_cells;
    windrow_diffusion_method diffusion;
    float pressure_residual;
    int32_t pressure_solves;
    int32_t sealed_sources;
    double divergence_rms; /* [1/s] */
    double energy;         /* [m^5/s^2] */
    int32_t asleep;
    int32_t motors_lost;
    windrow_stage_times times_ms;
} windrow_diagnostics;
WINDROW_C_API windrow_result windrow_diagnostics_init(windrow_diagnostics* diagnostics, uint32_t struct_size);

/* Result of windrow_wind_advance. */
typedef struct windrow_advance {
    uint32_t struct_size;
    int32_t ticks;     /* that ran */
    double dropped;    /* [s] beyond config.ticks_max_per_call, not simulated */
    float factor;      /* of this frame between the last two ticks, 0 to 1 */
    uint32_t reserved; /* 0 */
} windrow_advance;
WINDROW_C_API windrow_result windrow_advance_init(windrow_advance* advance, uint32_t struct_size);

/* The box of a wind. */
typedef struct windrow_box {
    uint32_t struct_size;
    windrow_ivec3 cells;
    float cell_size;      /* [m] */
    windrow_vec3 size;    /* [m] from the low corner to the high one */
    windrow_dvec3 origin; /* [m] world position of the low corner */
    windrow_boundaries boundaries;
} windrow_box;
WINDROW_C_API windrow_result windrow_box_init(windrow_box* box, uint32_t struct_size);

/* --- Life ---------------------------------------------------------------------------------------------------------------- */

WINDROW_C_API windrow_result windrow_wind_create(const windrow_config* config, windrow_wind** wind);
/* Null is allowed. Of a wind on a device no recording is in flight. */
WINDROW_C_API void windrow_wind_destroy(windrow_wind* wind);
/* The whole state as bytes; on a device see windrow_vulkan_wind_saved. */
WINDROW_C_API windrow_result windrow_wind_save(const windrow_wind* wind, windrow_bytes** bytes);
/* A wind that continues from there. `parallel_for` may be null. */
WINDROW_C_API windrow_result windrow_wind_load(const void* bytes, uint64_t size, const windrow_parallel_for* parallel_for,
                                               windrow_wind** wind);
/* Notes every accepted call that changes the wind; null: no longer. The log outlives the wind or the next call of this. */
WINDROW_C_API windrow_result windrow_wind_record_to(windrow_wind* wind, windrow_event_log* log);
/* The config, as the wind has it now. What is behind its pointers belongs to the wind, until the next call of this. Gust tiles and
   maps are left out (null). */
WINDROW_C_API windrow_result windrow_wind_config(windrow_wind* wind, windrow_config* config);
/* [bytes] That the wind has allocated: on a device, of its memory. */
WINDROW_C_API uint64_t windrow_wind_memory_bytes(const windrow_wind* wind);

/* --- Time, on the CPU ---------------------------------------------------------------------------------------------------- */

/* Advances by dt [s] at once. `diagnostics` may be null. Allocates nothing, as in C++. */
WINDROW_C_API windrow_result windrow_wind_step(windrow_wind* wind, double dt, windrow_diagnostics* diagnostics);
/* Advances by a frame of dt [s] in fixed ticks. `advance` and `last`, of the last tick that ran, may be null. */
WINDROW_C_API windrow_result windrow_wind_advance(windrow_wind* wind, double dt, windrow_advance* advance,
                                                  windrow_diagnostics* last);

/* --- Place and ambient wind ---------------------------------------------------------------------------------------------- */

/* Centres the box on a point, to whole cells. */
WINDROW_C_API windrow_result windrow_wind_follow(windrow_wind* wind, windrow_dvec3 point);
/* [m] Height of the box's low y face, to whole cells. */
WINDROW_C_API windrow_result windrow_wind_set_floor(windrow_wind* wind, double height);
WINDROW_C_API windrow_result windrow_wind_box(const windrow_wind* wind, windrow_box* box);
WINDROW_C_API windrow_dvec3 windrow_wind_origin(const windrow_wind* wind);
/* x * y * z: entries of the arrays below. */
WINDROW_C_API uint64_t windrow_wind_cell_count(const windrow_wind* wind);
WINDROW_C_API windrow_result windrow_wind_set_ambient(windrow_wind* wind, windrow_vec3 ambient);
WINDROW_C_API windrow_vec3 windrow_wind_ambient(const windrow_wind* wind);
WINDROW_C_API windrow_result windrow_wind_set_gusts(windrow_wind* wind, const windrow_gusts* gusts);
WINDROW_C_API windrow_result windrow_wind_set_boundaries(windrow_wind* wind, const windrow_boundaries* boundaries);

/* --- Setting the air ----------------------------------------------------------------------------------------------------- */

/* [m/s] Of the cell whose centre is at a world point. */
typedef void (*windrow_velocity_at)(void* user, const windrow_dvec3* centre, windrow_vec3* velocity);
WINDROW_C_API windrow_result windrow_wind_set_velocity(windrow_wind* wind, windrow_velocity_at velocity_at, void* user);
/* From an array of x, y, z, 0 for each cell, x fastest, then y, then z. `count`: cells. */
WINDROW_C_API windrow_result windrow_wind_set_field(windrow_wind* wind, const windrow_vec4* cells, uint64_t count);
/* All cells become the ambient wind. */
WINDROW_C_API windrow_result windrow_wind_reset(windrow_wind* wind);

/* --- Reading the air: of this frame with `advance`, of the last step with `step`; on a device of the last read-back ------ */

typedef int32_t windrow_frame;
/* Previous: for motion vectors, on the CPU. */
enum { WINDROW_FRAME_NOW = 0, WINDROW_FRAME_PREVIOUS = 1 };

/* [m/s] At a world point. */
WINDROW_C_API windrow_result windrow_wind_velocity(const windrow_wind* wind, windrow_dvec3 position, windrow_vec3* velocity);
/* [m/s] That acts on a plant there. */
WINDROW_C_API windrow_result windrow_wind_felt(const windrow_wind* wind, windrow_dvec3 position, const windrow_sampling* sampling,
                                               windrow_vec3* velocity);

typedef int32_t windrow_number;
enum { WINDROW_NUMBER_FLOAT = 0, WINDROW_NUMBER_DOUBLE = 1 };
/* Many points at once. */
typedef struct windrow_query {
    uint32_t struct_size;
    windrow_frame frame;
    uint64_t count;                   /* of points */
    const void* positions;            /* x, y, z each [m] */
    windrow_number number;            /* of a coordinate; default double */
    uint32_t position_stride;         /* [bytes] from one to the next; 0: dense */
    windrow_dvec3 anchor;             /* [m] added to each position: floats relative to a camera */
    float* velocities;                /* receives x, y, z each [m/s] */
    uint32_t velocity_stride;         /* [bytes]; 0: dense */
    uint32_t reserved;                /* 0 */
    const windrow_sampling* sampling; /* the wind that acts on plants there; null: the air's */
} windrow_query;
WINDROW_C_API windrow_result windrow_query_init(windrow_query* query, uint32_t struct_size);
WINDROW_C_API windrow_result windrow_wind_sample(const windrow_wind* wind, const windrow_query* query);

/* Format of texels. */
typedef int32_t windrow_texel;
enum { WINDROW_TEXEL_HALF = 0, WINDROW_TEXEL_FLOAT = 1 };
/* One texture of x, y, z, 0. `count`: numbers behind `texels`, four for each cell. */
WINDROW_C_API windrow_result windrow_wind_write_vectors(const windrow_wind* wind, windrow_frame frame, windrow_texel texel,
                                                        void* texels, uint64_t count);
/* Three textures, one an axis. `count`: numbers behind each, one for each cell. */
WINDROW_C_API windrow_result windrow_wind_write_axes(const windrow_wind* wind, windrow_frame frame, windrow_texel texel, void* x,
                                                     void* y, void* z, uint64_t count);
/* 1 for each cell whose centre is inside an obstacle, else 0. */
WINDROW_C_API windrow_result windrow_wind_write_obstacles(const windrow_wind* wind, float* cells, uint64_t count);
/* [m^2/s^2] Pressure over the air's density at the end of the last step, one value a cell; on the CPU. Allocates. */
WINDROW_C_API windrow_result windrow_wind_write_pressure(windrow_wind* wind, float* cells, uint64_t count);
/* The cells, and where their box was; the memory is the wind's, until its next change. `origin` may be null. */
WINDROW_C_API windrow_result windrow_wind_field(const windrow_wind* wind, windrow_frame frame, const windrow_vec4** cells,
                                                uint64_t* count, windrow_dvec3* origin);
/* Nearest half of a float, and back. */
WINDROW_C_API uint16_t windrow_to_half(float value);
WINDROW_C_API float windrow_from_half(uint16_t half);

/* Uniform blocks for shaders, relative to `anchor` [m]. `sampling` may be null. */
WINDROW_C_API windrow_result windrow_wind_window_block(const windrow_wind* wind, windrow_dvec3 anchor,
                                                       windrow_window_block* block);
WINDROW_C_API windrow_result windrow_wind_frame_block(const windrow_wind* wind, windrow_dvec3 anchor,
                                                      const windrow_sampling* sampling, windrow_frame_block* block);

#ifdef __cplusplus
}
#endif

#endif
