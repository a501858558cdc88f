/* Plants in time, on the CPU: springs, the lag of fur, the memory of the ground (coupling/spring.h, cascade.h, ground_memory.h). */
#ifndef WINDROW_C_API_MOTION_H
#define WINDROW_C_API_MOTION_H

#include "base.h"
#include "plants.h"
#include "shader_blocks.h"

#ifdef __cplusplus
extern "C" {
#endif

/* --- Springs ------------------------------------------------------------------------------------------------------------- */

/* Made by ./dev schema from SpringClass. */
typedef struct windrow_spring_class {
    /* [Hz] 1e-4 to 1000, default 2.5. Natural frequency without damping. A lower one follows gusts later. */
    double frequency_hz;
    /* 0 to 1000, default 0.12. Damping ratio. 0: undamped; below 1: decaying oscillation; 1: critical; above 1: slow return.
       Crops and trees have 0.12, drag of the leaves included. */
    double damping;
} windrow_spring_class;
typedef int32_t windrow_spring_plant;
enum {
    WINDROW_SPRING_GRASS = 0,
    WINDROW_SPRING_WHEAT = 1,
    WINDROW_SPRING_ALFALFA = 2,
    WINDROW_SPRING_REED = 3,
    WINDROW_SPRING_LEAF = 4,
    WINDROW_SPRING_TWIG = 5,
    WINDROW_SPRING_BRANCH = 6,
    WINDROW_SPRING_TRUNK = 7
};
WINDROW_C_API windrow_result windrow_spring_class_of(windrow_spring_plant plant, windrow_spring_class* spring);

/* The coefficients of a step, once a frame and class. */
typedef struct windrow_spring_step {
    double place_place, place_velocity, place_target, velocity_place, velocity_velocity, velocity_target;
} windrow_spring_step;
/* `duration` [s], 0 or more. */
WINDROW_C_API windrow_result windrow_spring_step_make(const windrow_spring_class* spring, double duration,
                                                      windrow_spring_step* step);
WINDROW_C_API windrow_result windrow_spring_step_block(const windrow_spring_step* step, windrow_spring_block* block);
/* A frame of `duration` [s] for plants that swing on a device (windrow_blade_swing of windrow_plants.glsl). */
WINDROW_C_API windrow_result windrow_swing_step_make(const windrow_spring_class* spring, double duration,
                                                     windrow_swing_block* block);
/* Its four bands, whose frequencies are the class's times 2^(-3/8), 2^(-1/8), 2^(1/8) and 2^(3/8): windrow_spring_band of
   numerics/spring.glsl says which one a plant has. `bands` and `blocks` have room for four. */
WINDROW_C_API windrow_result windrow_spring_bands(const windrow_spring_class* spring, windrow_spring_class* bands);
WINDROW_C_API windrow_result windrow_swing_steps_make(const windrow_spring_class* spring, double duration,
                                                      windrow_swing_block* blocks);

/* Class of leaves that oscillate about their stalks (numerics/flutter.glsl). */
/* Made by ./dev schema from FlutterClass. */
typedef struct windrow_flutter_class {
    /* [Hz] 1e-4 to 1000, default 6. Of the leaf's torsion; leaves differ by up to 30 %. The default is that of springs::leaf. */
    double frequency_hz;
    /* [rad] 0 to 1.5, default 0.6. Largest turn to either side. 0: none. */
    float most;
    /* [m/s] 0 to 100, default 1.6. Wind from which on they flutter; 1.6 is where Beaufort's force 2 begins, at which leaves
       rustle. */
    float onset;
} windrow_flutter_class;
/* A frame of `duration` [s] that ends at `time` [s]. A null class: the default. */
WINDROW_C_API windrow_result windrow_flutter_step_make(const windrow_flutter_class* flutter, double time, double duration,
                                                       windrow_flutter_block* block);

/* Springs side by side, `count` numbers each: floats or doubles by the call. The last three may be null. */
typedef struct windrow_spring_batch {
    uint64_t count;
    void* place;
    void* velocity; /* [1/s] */
    const void* target_before;
    const void* target_now;
    void* place_remainder;
    void* velocity_remainder;
    void* place_previous;
} windrow_spring_batch;
WINDROW_C_API windrow_result windrow_springs_advance_float(const windrow_spring_step* step, const windrow_spring_batch* batch,
                                                           const windrow_parallel_for* parallel_for);
WINDROW_C_API windrow_result windrow_springs_advance_double(const windrow_spring_step* step, const windrow_spring_batch* batch,
                                                            const windrow_parallel_for* parallel_for);

/* --- Cascades: each stage follows the one before ------------------------------------------------------------------------- */

typedef struct windrow_cascade_step windrow_cascade_step;
/* `stages` of 1 to 4096. */
WINDROW_C_API windrow_result windrow_cascade_step_create(int32_t stages, windrow_cascade_step** step);
WINDROW_C_API void windrow_cascade_step_destroy(windrow_cascade_step* step);
/* A step of `duration` [s] at `rate` [1/s]. */
WINDROW_C_API windrow_result windrow_cascade_step_set(windrow_cascade_step* step, double rate, double duration);
/* Rows side by side: stage i of row k is value[(i - 1) * rows + k]; floats or doubles by the call. */
typedef struct windrow_cascade_batch {
    uint64_t rows;
    void* value;             /* stages * rows */
    const void* body_before; /* rows */
    const void* body_now;    /* rows */
    void* remainder;         /* as `value`, or null */
} windrow_cascade_batch;
WINDROW_C_API windrow_result windrow_cascades_advance_float(const windrow_cascade_step* step, const windrow_cascade_batch* batch,
                                                            const windrow_parallel_for* parallel_for);
WINDROW_C_API windrow_result windrow_cascades_advance_double(const windrow_cascade_step* step, const windrow_cascade_batch* batch,
                                                             const windrow_parallel_for* parallel_for);

typedef struct windrow_pose {
    windrow_dvec3 position; /* [m] in the world */
    windrow_dvec4 rotation; /* quaternion x, y, z, w, of any length but 0 */
    double scale;
} windrow_pose;
/* Made by ./dev schema from CascadeConfig. */
typedef struct windrow_cascade_config {
    uint32_t struct_size;
    /* 1 to 64, default 10. Number of stages. With more the tip waits and then moves at once, with fewer it drags: its lag
       spreads by lag / sqrt(stages). 10 is the choice of Bloodelic's stylised fur. */
    int32_t stages;
    /* [s] A number above 0, at most 60, default 0.25. Mean delay of the tip; shells lag in proportion to their height. 0.25 is
       visible and ends within a few frames. */
    double lag;
} windrow_cascade_config;
WINDROW_C_API windrow_result windrow_cascade_config_init(windrow_cascade_config* config, uint32_t struct_size);

/* The lag of one body's fur. */
typedef struct windrow_cascade windrow_cascade;
WINDROW_C_API windrow_result windrow_cascade_create(const windrow_cascade_config* config, const windrow_pose* body,
                                                    windrow_cascade** cascade);
WINDROW_C_API void windrow_cascade_destroy(windrow_cascade* cascade);
/* The whole state as bytes, and one that goes on from there. */
WINDROW_C_API windrow_result windrow_cascade_save(const windrow_cascade* cascade, windrow_bytes** bytes);
WINDROW_C_API windrow_result windrow_cascade_load(const void* bytes, uint64_t size, windrow_cascade** cascade);
WINDROW_C_API windrow_result windrow_cascade_advance(windrow_cascade* cascade, double duration, const windrow_pose* body);
WINDROW_C_API windrow_result windrow_cascade_reset(windrow_cascade* cascade, const windrow_pose* body);
WINDROW_C_API windrow_result windrow_cascade_move(windrow_cascade* cascade, windrow_dvec3 offset);
/* At a height of 0 (the body) to 1 (the tip), now or before the last advance. */
WINDROW_C_API windrow_result windrow_cascade_at(const windrow_cascade* cascade, double height, windrow_pose* pose);
WINDROW_C_API windrow_result windrow_cascade_previous_at(const windrow_cascade* cascade, double height, windrow_pose* pose);
/* Stages + 1 blocks, relative to `anchor` [m]; good until the next call with this cascade. */
WINDROW_C_API windrow_result windrow_cascade_shader_poses(windrow_cascade* cascade, windrow_dvec3 anchor,
                                                          const windrow_pose_block** poses, uint64_t* count);
WINDROW_C_API windrow_result windrow_cascade_previous_shader_poses(windrow_cascade* cascade, windrow_dvec3 anchor,
                                                                   const windrow_pose_block** poses, uint64_t* count);

/* --- Ground memory ------------------------------------------------------------------------------------------------------- */

/* Made by ./dev schema from GroundConfig. */
typedef struct windrow_ground_config {
    uint32_t struct_size;
    /* 8 to 512, default 128. Texels along each edge of its square window. 128 are 32 m at 0.25 m, and 1 MB on a device. */
    int32_t texels;
    /* Spring of the plants, one class for the window. Default: grass. */
    windrow_spring_class spring;
    /* [m] 0.01 to 100, default 0.25. Edge of a texel. At 0.25 a walker's radius covers several; with coarser ones a path looks
       like beads. */
    float texel_size;
    /* [rad] 0 to 2.5, default 1.4. Lean of plants right beside a walker of weight 1. pi/2 is flat, more points down; 1.4 is
       nearly flat. */
    float push;
    /* 0 to 1, default 0.5. Fraction of that lean that stays as a trail. 0: plants rise at once; 1: with trail_time alone. */
    float trail_fraction;
    /* [s] 0.01 to 1e6, default 20. Time in which a trail falls to 1/e. With 20 it is invisible after a minute. */
    float trail_time;
    /* [s] 0.01 to 1e6, default 0.8. Time in which the pressing falls to 1/e, about the time in which a blade rises. Pressed
       plants do not follow the wind. */
    float trample_time;
    /* [m] 0.001 to 100, default 0.4. Height of the feet above which they do not touch plants; 0.4 is knee-high grass. At half
       of it the weight is half. Feet that are deeper in the ground than this press less, and from twice of it nothing. */
    float clearance;
    /* [m] 0.001 to 12800, default 2. Width over which the memory fades to the lean of the wind at the window's edge; at most a
       quarter of the window. */
    float blend_width;
    /* [m/s] 0 (never) to 1e9, default 100. A walker that moved faster in the step has jumped: it stands at its new place and
       sweeps nothing on the way. As that of the wind (windrow_config.jump_speed). */
    float jump_speed;
    /* 1 to 256, default 64. Maximal number of walkers in the window per step. Of more, only the first ones count. */
    int32_t max_walkers;
    /* 0 */
    uint32_t reserved;
} windrow_ground_config;
WINDROW_C_API windrow_result windrow_ground_config_init(windrow_ground_config* config, uint32_t struct_size);

/* A foot, a body, a wheel. */
typedef struct windrow_ground_walker {
    windrow_dvec3 position;     /* [m] now */
    windrow_dvec3 previous;     /* [m] a step ago */
    float foot_height;          /* [m] above the ground, now */
    float previous_foot_height; /* [m] a step ago */
    float radius;               /* [m] */
    float weight;               /* 0 to 1 */
} windrow_ground_walker;
typedef struct windrow_ground_step {
    uint32_t struct_size;
    windrow_vec2 wind_lean; /* [rad] bend (x and z) that the wind holds plants at */
    uint32_t reserved;      /* 0 */
    double duration;        /* [s] */
    uint64_t walker_count;
    const windrow_ground_walker* walkers;
} windrow_ground_step;
WINDROW_C_API windrow_result windrow_ground_step_init(windrow_ground_step* step, uint32_t struct_size);
typedef struct windrow_ground_sample {
    windrow_vec2 lean; /* [rad] */
    float trample;     /* 0 to 1 */
    float trail;       /* [rad] */
} windrow_ground_sample;

typedef struct windrow_ground windrow_ground;
WINDROW_C_API windrow_result windrow_ground_create(const windrow_ground_config* config, const windrow_parallel_for* parallel_for,
                                                   windrow_ground** ground);
WINDROW_C_API void windrow_ground_destroy(windrow_ground* ground);
/* The whole state as bytes, and one that goes on from there. `parallel_for` may be null. */
WINDROW_C_API windrow_result windrow_ground_save(const windrow_ground* ground, windrow_bytes** bytes);
WINDROW_C_API windrow_result windrow_ground_load(const void* bytes, uint64_t size, const windrow_parallel_for* parallel_for,
                                                 windrow_ground** ground);
WINDROW_C_API windrow_result windrow_ground_follow(windrow_ground* ground, windrow_dvec3 point);
/* The origin of the host's world has moved: all places of the ground move by `offset` [m] of any length, of which x and z count. */
WINDROW_C_API windrow_result windrow_ground_shift_origin(windrow_ground* ground, windrow_dvec3 offset);
/* `wind_leans`, of `count` entries, one a texel; null: step.wind_lean everywhere. */
WINDROW_C_API windrow_result windrow_ground_advance(windrow_ground* ground, const windrow_ground_step* step,
                                                    const windrow_vec2* wind_leans, uint64_t count);
WINDROW_C_API int32_t windrow_ground_walkers_left_out(const windrow_ground* ground);
/* [m] x and z of what a slot holds after the next advance. */
WINDROW_C_API windrow_dvec2 windrow_ground_next_centre(const windrow_ground* ground, windrow_ivec2 slot);
WINDROW_C_API windrow_result windrow_ground_at(const windrow_ground* ground, windrow_dvec3 position,
                                               windrow_ground_sample* sample);
WINDROW_C_API windrow_result windrow_ground_previous_at(const windrow_ground* ground, windrow_dvec3 position,
                                                        windrow_ground_sample* sample);
/* For shaders: lean x, lean z, trample, length of the trail. Good until the next advance. */
WINDROW_C_API const windrow_vec4* windrow_ground_texels(const windrow_ground* ground, uint64_t* count);
WINDROW_C_API const windrow_vec4* windrow_ground_previous_texels(const windrow_ground* ground, uint64_t* count);
WINDROW_C_API windrow_result windrow_ground_block_of(const windrow_ground* ground, windrow_dvec3 anchor,
                                                     windrow_ground_block* block);

#ifdef __cplusplus
}
#endif

#endif
