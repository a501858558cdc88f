/* The wind in a box that follows a player. One thread at a time may use a wind; two winds have no common state, except where one is inside the other. A windrow_wind is on
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

/* Made by ./dev schema from DiffusionMethod. */
typedef int32_t windrow_diffusion_method;
enum { WINDROW_DIFFUSION_NONE = 0, WINDROW_DIFFUSION_ONE_PASS = 1, WINDROW_DIFFUSION_IMPLICIT = 2 };

/* [ms] Wall-clock time of one step by stage. */
/* Made by ./dev schema from StageTimes. */
typedef struct windrow_stage_times {
    /* [ms] Motors, NaN guard, speed limit. */
    double sources;
    /* [ms] The ambient wind cell by cell; 0 without gusts. */
    double ambient;
    /* [ms] Viscosity, and the mixing over rough ground. */
    double diffusion;
    /* [ms] Transport of the velocity, gathering the carried field included. */
    double advection;
    /* [ms] Direct solves of the pressure, further ones around obstacles too. */
    double projection;
    /* [ms] Rasterisation, and all passes over faces and cells at obstacles. */
    double obstacles;
    /* [ms] Energy, largest speed, divergence. */
    double report;
    /* [ms] The whole step, with what belongs to no stage: a moved box, for one. */
    double total;
} windrow_stage_times;

/* Report of a step (fluid/diagnostics.h). */
/* Made by ./dev schema from Diagnostics. */
typedef struct windrow_diagnostics {
    uint32_t struct_size;
    /* 0 or 1. The step ran. False: dt was 0, negative or not finite, or out_of_memory; nothing was done. */
    int32_t stepped;
    /* 0 or 1. The system has no memory that the step needs: the wind is unchanged. Free some and call again. On a device only
       its obstacles find none: the step ran without them. */
    int32_t out_of_memory;
    /* 0 or 1. The box, with rows of its own, was at another height in the last step: air that stayed in it was interpolated.
       After `advance`, in any of its ticks. */
    int32_t regridded;
    /* [m/s] Largest component of the velocity after the step. */
    float max_speed;
    /* Largest component * dt / h after the sources, before sub-steps and limit: how many cells the air would cross at once. */
    float cfl;
    /* Number of sub-steps: ceil(cfl / max_cfl), at most max_substeps; while obstacles move, of a bound of the speed that is
       known before the step. */
    int32_t substeps;
    /* 0 or 1. More sub-steps were needed than allowed: speeds were limited. */
    int32_t substeps_capped;
    /* [s] Time that the next steps make up for, on a device whose speeds rose further than its host could foresee; 0 on the
       CPU. */
    float carried_time;
    /* Motors that acted in the box; a wake counts once per segment of its path. In free air also a volume source outside of
       the box that makes 1 cm/s in it. */
    int32_t motors_in_reach;
    /* Cells whose speed was scaled down to max_cfl * max_substeps cells a step, before the air moved or, where forces and
       pressure had made them faster, after it. */
    int64_t limited_cells;
    /* Cells that held NaN or infinity and were set to ambient. */
    int64_t repaired_cells;
    /* How viscosity acted: not at all, in one explicit pass, or by a direct solve. */
    windrow_diffusion_method diffusion;
    /* What the pressure's solution leaves of the divergence at the surfaces of obstacles, relative to that before it. 0
       without obstacles in the box. */
    float pressure_residual;
    /* Direct solves of the pressure in the last sub-step. 0 without obstacles in the box. */
    int32_t pressure_solves;
    /* Volume sources in air that no opening joins to the boundary of the box. What comes out of one there is taken out again,
       evenly, from all air of that room: incompressible air cannot leave it. */
    int32_t sealed_sources;
    /* [1/s] Root mean square of the central divergence that the collocated projection leaves. */
    double divergence_rms;
    /* [m^5/s^2] Kinetic energy of the box per unit of density: sum of u^2 / 2 h^3. */
    double energy;
    /* 0 or 1. The air had relaxed to the ambient wind and no motor acted: the step did nothing. The other figures, those of
       gusts too, stay as in the step that fell asleep. Gusts go on. */
    int32_t asleep;
    /* Motors that act on no air where they are: under the ground, or farther outside of the box than its size, on an axis
       along which it does not follow. A mistake in most scenes. */
    int32_t motors_lost;
    /* [ms] Wall-clock time by stage. */
    windrow_stage_times times_ms;
    /* Obstacles and wakes that were moved faster than jump_speed: they were there at once, without a push. */
    int32_t jumps;
    /* 0 */
    uint32_t reserved;
    /* Obstacles that turned by more than a sixth of a turn in the step, or whose outermost place went farther than a cell by
       it: their blades meet the air at few places. The moment on a blade of 4 cells and more is some 10 % off then, on a
       thinner one up to a half. A vortex motor is the wind of a fast rotor. */
    int32_t fast_turns;
    /* 0 */
    uint32_t reserved_2;
    /* Obstacles, grounds aside, of which each fills more than half of the box, so that little wind is left: a mistake of units
       in most scenes. Lengths are metres. */
    int32_t filling_obstacles;
    /* 0 */
    uint32_t reserved_3;
    /* Parts of the air without an opening whose volume moving walls change: a closed room, or all air of a box without an open
       boundary. Incompressible air cannot leave: it takes the change evenly, as if it were pressed together, and its pressure
       is relative to none. */
    int32_t sealed_rooms;
    /* 0 */
    uint32_t reserved_4;
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
/* Inside `outer`, on the CPU, which is around its box in place of the ambient wind. The config gives no mean wind, profile or gusts:
   they are those of `outer`. Each frame, advance `outer` first. It stays in memory until its last inner wind is destroyed; one
   thread at a time uses the two. Inside a wind on the CPU a wind on a device fits too: windrow_vulkan_wind_create_inside. */
WINDROW_C_API windrow_result windrow_wind_create_inside(const windrow_config* config, const windrow_wind* outer,
                                                        windrow_wind** wind);
/* Null is allowed. Of a wind on a device no recording is in flight. */
WINDROW_C_API void windrow_wind_destroy(windrow_wind* wind);
/* The whole state as bytes; on a device see windrow_vulkan_wind_saved. */
WINDROW_C_API windrow_result windrow_wind_save(const windrow_wind* wind, windrow_bytes** bytes);
/* A wind that continues from there. `parallel_for` may be null. */
WINDROW_C_API windrow_result windrow_wind_load(const void* bytes, uint64_t size, const windrow_parallel_for* parallel_for,
                                               windrow_wind** wind);
/* The same of a wind inside another one: load `outer` first. */
WINDROW_C_API windrow_result windrow_wind_load_inside(const void* bytes, uint64_t size, const windrow_parallel_for* parallel_for,
                                                      const windrow_wind* outer, windrow_wind** wind);
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
/* The origin of the host's world has moved: all places that the wind holds move by `offset` [m], whole cells, and no air changes. */
WINDROW_C_API windrow_result windrow_wind_shift_origin(windrow_wind* wind, windrow_dvec3 offset);
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
typedef int32_t windrow_field_format;
enum {
    WINDROW_FIELD_FGA = 0, /* Unreal Engine */
    WINDROW_FIELD_VF = 1,  /* Unity */
    WINDROW_FIELD_RAW = 2, /* a 3D texture of halfs; its size and place in NAME.raw.json */
    WINDROW_FIELD_NPZ = 3, /* numpy */
    WINDROW_FIELD_VTI = 4  /* ParaView */
};
/* Writes the cells, with those inside obstacles where the format holds them, as a file of an engine or an analyst. FGA is z up,
   left-handed, in centimetres; VF y up, left-handed, in metres; the others have the axes of the library. Rows of unequal thickness are
   sampled at the centres of equal cells. `path` is UTF-8; `time` [s] is written where the format has it. */
WINDROW_C_API windrow_result windrow_wind_write_field(const windrow_wind* wind, const char* path, windrow_field_format format,
                                                      double time);
/* Nearest half of a float, and back. */
WINDROW_C_API uint16_t windrow_to_half(float value);
WINDROW_C_API float windrow_from_half(uint16_t half);

/* --- Debug view ---------------------------------------------------------------------------------------------------------- */

/* What a line belongs to; hosts have a colour for each. */
typedef int32_t windrow_debug_kind;
enum { WINDROW_DEBUG_BOX = 0, WINDROW_DEBUG_MOTOR = 1, WINDROW_DEBUG_OBSTACLE = 2, WINDROW_DEBUG_ARROW = 3 };
typedef struct windrow_debug_line {
    windrow_dvec3 begin; /* [m] in the world */
    windrow_dvec3 end;
    windrow_debug_kind kind;
    float speed; /* [m/s] of the wind at an arrow's foot; 0 of others */
} windrow_debug_line;
/* Receives each line; it must not change the wind. */
typedef void (*windrow_debug_draw)(void* user, const windrow_debug_line* line);
typedef struct windrow_debug_view {
    uint32_t struct_size;
    int32_t box;       /* 1 (default): draws the box of air */
    int32_t motors;    /* 1 (default): draws where each motor acts, and its direction */
    int32_t obstacles; /* 1 (default): draws forms; a mesh or a voxel grid as the box that holds it, no ground */
    int32_t arrows;    /* along the longer level axis, 0 (none) to 256, default 16: a view still shows 256 arrows apart */
    float seconds;     /* [s] above 0, at most 1e6, default 0.2: an arrow is as long as the way of the air in this time */
    double height;     /* [m] -1e6 to 1e6, default 1: of the arrows above the box's low face, where players are */
} windrow_debug_view;
WINDROW_C_API windrow_result windrow_debug_view_init(windrow_debug_view* view, uint32_t struct_size);
/* Calls `draw` for each line of the box, the motors, the obstacles and the arrows, in an order that does not change. `view` may be null:
   the defaults. Arrows on a device are the ambient wind's before its first read-back. A host that does not call it pays nothing. */
WINDROW_C_API windrow_result windrow_wind_debug_lines(const windrow_wind* wind, const windrow_debug_view* view,
                                                      windrow_debug_draw draw, void* user);

/* Uniform blocks for shaders, relative to `anchor` [m]. `sampling` may be null. */
WINDROW_C_API windrow_result windrow_wind_window_block(const windrow_wind* wind, windrow_dvec3 anchor,
                                                       windrow_window_block* block);
WINDROW_C_API windrow_result windrow_wind_frame_block(const windrow_wind* wind, windrow_dvec3 anchor,
                                                      const windrow_sampling* sampling, windrow_frame_block* block);

#ifdef __cplusplus
}
#endif

#endif
