/*
 * Settings of a wind. Each struct with `struct_size` is filled with defaults by its init function, which is called first:
 *
 *     windrow_canopy wheat;
 *     windrow_canopy_init(&wheat, sizeof wheat);
 *     config.canopy = &wheat;
 *
 * Structs behind pointers are read during the call alone. A field's comment has its unit, range, default and meaning, from the table
 * of the C++ struct that is named before the C struct.
 */
#ifndef WINDROW_C_API_CONFIG_H
#define WINDROW_C_API_CONFIG_H

#include "base.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct windrow_wind windrow_wind;             /* wind.h */
typedef struct windrow_gust_tile windrow_gust_tile;   /* ambient.h */
typedef struct windrow_height_map windrow_height_map; /* obstacles.h */

/* Made by ./dev schema from BoundaryKind. */
typedef int32_t windrow_boundary_kind;
enum {
    WINDROW_BOUNDARY_OPEN = 0,      /* the ambient wind is beyond */
    WINDROW_BOUNDARY_FREE_SLIP = 1, /* a wall without friction */
    WINDROW_BOUNDARY_NO_SLIP = 2,   /* a wall that drags the air */
    WINDROW_BOUNDARY_PERIODIC = 3   /* the opposite face is beyond; in pairs */
};
/* Made by ./dev schema from Boundary. */
typedef struct windrow_boundary {
    /* Default WINDROW_BOUNDARY_OPEN. open: the ambient wind is beyond. free_slip: a wall without friction. no_slip: a wall
       that drags the air. periodic: the opposite face is beyond. */
    windrow_boundary_kind kind;
    /* [m/s] Each component -10000 to 10000, default (0, 0, 0). Velocity of a no-slip wall, in its own plane; 0 on every other
       kind. May change in every step. */
    windrow_vec3 wall_velocity;
} windrow_boundary;
/* Made by ./dev schema from Boundaries. */
typedef struct windrow_boundaries {
    /* At the low end of x. */
    windrow_boundary x_low;
    /* At its high end. */
    windrow_boundary x_high;
    /* Below: the floor. */
    windrow_boundary y_low;
    /* Above. */
    windrow_boundary y_high;
    /* At the low end of z. */
    windrow_boundary z_low;
    /* At its high end. */
    windrow_boundary z_high;
} windrow_boundaries;
WINDROW_C_API windrow_boundaries windrow_boundaries_all(windrow_boundary_kind kind);
/* Open air over a free-slip floor. */
WINDROW_C_API windrow_boundaries windrow_boundaries_open_over_floor(void);

/* Wind over open ground: log((z + z0) / z0). */
/* Made by ./dev schema from LogProfile. */
typedef struct windrow_log_profile {
    uint32_t struct_size;
    /* [m] 1e-6 to 100, default 0.03. z0: about a tenth of the height of what is on the ground. 0.0002 water, 0.03 short grass,
       1 wood. */
    float roughness_length;
    /* [m] 0.01 to 10000, default 10. Height at which the wind is the mean. 10 is where weather services measure. */
    float reference_height;
} windrow_log_profile;
WINDROW_C_API windrow_result windrow_log_profile_init(windrow_log_profile* profile, uint32_t struct_size);

/* A pattern that the mean wind carries along. */
/* Made by ./dev schema from Gusts. */
typedef struct windrow_gusts {
    uint32_t struct_size;
    /* 0 (none) to 1, default 0. Standard deviation of each horizontal component over the mean horizontal speed. 0 costs
       nothing, 0.15 is open country, 0.3 a gusty day. */
    float intensity;
    /* [m] 0.01 to 1e6, default 24. Distance from one gust to the next. A texel is a twelfth of it, the pattern repeats after
       128 texels; 24 makes texels of 2 m, which cells of 1 m resolve, and 256 m until it repeats. */
    float length;
    /* 0 to 4294967295, default 1. Seed of the pattern. */
    uint32_t seed;
    /* The pattern itself, for many winds to use one; null: made from the seed. */
    const windrow_gust_tile* tile;
} windrow_gusts;
WINDROW_C_API windrow_result windrow_gusts_init(windrow_gusts* gusts, uint32_t struct_size);

/* Drag of plants on the floor. */
/* Made by ./dev schema from Canopy. */
typedef struct windrow_canopy {
    uint32_t struct_size;
    /* [m] 0 (none) to 1000, default 0.8. Height of the plants; 0.8 is ripe wheat. A cell that it fills in part is slowed by
       that fraction. */
    float height;
    /* [1/m] 0 (none) to 1000, default 0.6. Drag coefficient, 0.15 to 0.3, times leaf area in a volume of air: wheat 0.6 (0.2
       times leaves of 2.4 times the area of its ground), short grass 2 to 5, a forest 0.03 to 0.1. Based on: Shaw & Schumann
       1992, Boundary-Layer Meteorology 61 (0.15). */
    float drag;
} windrow_canopy;
WINDROW_C_API windrow_result windrow_canopy_init(windrow_canopy* canopy, uint32_t struct_size);

/* Roughness lengths by place. */
typedef struct windrow_roughness_map {
    uint32_t struct_size;
    uint32_t reserved; /* 0 */
    /* [m] Where a height map has heights; null is rejected. */
    const windrow_height_map* lengths;
    /* [m] Each component -1e12 to 1e12, default (0, 0, 0). World place of its first pixel; y does not count. */
    windrow_dvec3 position;
    /* Each component 1e-6 to 100000, default (1, 1, 1). Factor on its size along x and z, the metres of a pixel, and, y, on the
       lengths. */
    windrow_vec3 scale;
    uint32_t reserved_2; /* 0 */
} windrow_roughness_map;
WINDROW_C_API windrow_result windrow_roughness_map_init(windrow_roughness_map* map, uint32_t struct_size);

/* Rough ground. */
/* Made by ./dev schema from Roughness. */
typedef struct windrow_roughness {
    uint32_t struct_size;
    /* [m] 1e-6 to 100, default 0.03. Roughness length z0: about a tenth of the height of what is on the ground. 0.0002 water,
       0.03 short grass, 0.1 crops, 0.3 bushes, 1 wood. */
    float length;
    /* [m] 0 (no limit) to 100000, default 0. Longest mixing length. Over open ground eddies grow with the height; among
       buildings, which the grid resolves, about a twentieth of their height leaves the wakes unsteady. */
    float longest_mixing;
    /* 0 */
    uint32_t reserved;
    /* Lengths by place, instead of one. Default none. Null: none. */
    const windrow_roughness_map* map;
} windrow_roughness;
WINDROW_C_API windrow_result windrow_roughness_init(windrow_roughness* roughness, uint32_t struct_size);

/* Rows of cells of unequal thickness. */
/* Made by ./dev schema from Rows; by hand: heights, height_count. */
typedef struct windrow_rows {
    uint32_t struct_size;
    /* [m] A number above 0, at most 1e6, default 0.5. Thickness of the lowest rows. The lowest cell's centre is at half of it:
       .3 m resolves a log profile among grass. */
    float first;
    /* 1 to 2048, default 4. How many rows are that thick. Over hills as many as reach the highest ground, so that all ground
       is met by cells of one size. */
    int32_t uniform;
    /* 1 to 1.5, default 1.1. Distance between two rows above these over the distance below. Up to 1.15 the error stays that of
       equal rows of the mean thickness. */
    float ratio;
    /* [m] 0 (by the ratio) to 1e6, default 0. Height of the box. The ratio follows from it. With heights: where the box ends
       above the last one. */
    float top;
    /* of `heights` */
    uint32_t height_count;
    /* [m] of the rows' centres, one a row, in place of the law; null: none */
    const float* heights;
} windrow_rows;
WINDROW_C_API windrow_result windrow_rows_init(windrow_rows* rows, uint32_t struct_size);

/* Made by ./dev schema from Scheme. */
typedef int32_t windrow_scheme;
enum { WINDROW_SCHEME_SECOND_ORDER = 0, WINDROW_SCHEME_STABLE_FLUIDS = 1 };
/* Made by ./dev schema from Interpolation. */
typedef int32_t windrow_interpolation;
enum { WINDROW_INTERPOLATION_LINEAR = 0, WINDROW_INTERPOLATION_CUBIC = 1, WINDROW_INTERPOLATION_CUBIC_32 = 2 };
/* Made by ./dev schema from Simd. */
typedef int32_t windrow_simd;
enum { WINDROW_SIMD_BEST = 0, WINDROW_SIMD_BASELINE = 1, WINDROW_SIMD_AVX2 = 2, WINDROW_SIMD_AVX512 = 3 };
/* 1 if this machine supports a level. */
WINDROW_C_API int32_t windrow_simd_runs(windrow_simd level);
/* "baseline", "avx2", "avx512"; for the best level the one that it stands for here. */
WINDROW_C_API const char* windrow_simd_name(windrow_simd level);

/* Axes that the box follows, as bits. */
enum { WINDROW_FOLLOW_DEFAULT = -1, WINDROW_FOLLOW_X = 1, WINDROW_FOLLOW_Y = 2, WINDROW_FOLLOW_Z = 4 };
/* Stages of a step, as bits. */
enum {
    WINDROW_STAGE_SOURCES = 1,
    WINDROW_STAGE_RELAXATION = 2,
    WINDROW_STAGE_DIFFUSION = 4,
    WINDROW_STAGE_ADVECTION = 8,
    WINDROW_STAGE_PROJECTION = 16,
    WINDROW_STAGE_ALL = 31
};

/* Made by ./dev schema from Config; by hand: follow_axes, relaxation_time, stages, ticks, ticks_hz, ticks_max_per_call. */
typedef struct windrow_config {
    uint32_t struct_size;
    /* [cells] Each component 1 to 2048, default (32, 16, 32). Cells along x, y, z; at most 67,108,864 in all. Odd sizes too.
       The default is 32 m around a player at 1 m, half as high. */
    windrow_ivec3 cells;
    /* [m] 1e-6 to 1e6, default 1. Edge of a cell; with rows of their own, along x and z. At 1 m a gust that a person notices
       spans several. */
    float cell_size;
    /* Boundary conditions of the six faces. Default: open everywhere; windrow_boundaries_open_over_floor adds ground. Periodic
       boundaries come in pairs. */
    windrow_boundaries boundaries;
    /* WINDROW_FOLLOW_*: bits, or the default, which is the axes with two open boundaries */
    int32_t follow_axes;
    /* [m] Each component -1e12 to 1e12, default (0, 0, 0). Point that the box is centred on at the start, to whole cells; for
       good on axes that do not follow. Its height does not count over a wall at boundaries.y_low: the box stands on floor. */
    windrow_dvec3 centre;
    /* [m/s] Each component -10000 to 10000, default (0, 0, 0). Mean wind: of the air at the start, of the inflow through open
       boundaries, of new cells. Its component along an axis that a wall closes is dropped. */
    windrow_vec3 ambient;
    /* 0 */
    uint32_t reserved;
    /* Wind over open ground: log((z + z0) / z0), 0 at the ground (the box's floor, or height 0 without one), the ambient wind
       at the reference height, more above. Default none: the same wind at all heights; windrow_log_profile_init for the
       profile with its own defaults. Null: none. */
    const windrow_log_profile* profile;
    /* A frozen pattern that the ambient wind carries along, outside the box and through it. Calm air has none. The pattern is
       not periodic in the box: it jumps at periodic boundaries. Null: the defaults. */
    const windrow_gusts* gusts;
    /* Drag of plants of uniform height and density on the floor, or at height 0 without one. The inflow, and the wind to which
       the air relaxes, is still the ambient wind. Default none, which costs nothing: plants then bend in the wind and do not
       slow it; windrow_canopy_init for wheat. Null: none. */
    const windrow_canopy* canopy;
    /* Rough ground: its drag, and the mixing of the air above it by turbulence. Default none, which costs nothing: the ground
       is smooth, and a profile is worn away by what the air does; windrow_roughness_init for short grass. Null: none. */
    const windrow_roughness* roughness;
    /* Rows of cells of unequal thickness, thin near the ground and thick aloft; windrow_rows_init for rows of half a metre
       that grow by a tenth from the fifth on. Default none, which costs nothing: all rows are cell_size thick. At most 128
       rows. Such a box keeps its height, which set_floor changes by whole lowest rows, and the air is then interpolated; it
       cannot repeat along y. Null: none. */
    const windrow_rows* rows;
    /* [cells] 0 (none) to 64, default 2. Width over which sampled wind fades to ambient at the boundaries along which the box
       follows. It ends one cell before the box does (two with ticks), so that a shift of the box moves nothing. Axes of fewer
       than 8 cells (10 with ticks) have none. */
    float blend_width;
    /* [m^2/s] 0 to 1e9, default 1.5e-5. Kinematic viscosity. Default: that of air, which at 1 m cells is below what the solver
       resolves and costs nothing. */
    float viscosity;
    /* [s] 0 (never) to 1e9, or -1, the default: 20; 200 while wind meets obstacles, whose lees 20 would fill. Time constant of
       the relaxation to the ambient wind. A collocated solver has no other damping of the checkerboard mode in still air. 0 is
       for analytic cases. */
    float relaxation_time;
    /* [m/s] 0 (never) to 10000, default 0.001. Air that differs from ambient by less everywhere, with no motor in reach and no
       gusts, sleeps: it becomes ambient, and a step costs microseconds until something acts. It does not sleep without a
       relaxation time or while viscosity acts. */
    float sleep_speed;
    /* Default WINDROW_SCHEME_SECOND_ORDER. Time scheme. second_order: semi-implicit semi-Lagrangian. stable_fluids: the
       classic split, first order. */
    windrow_scheme scheme;
    /* Default WINDROW_INTERPOLATION_CUBIC. Interpolation of the advection. linear: never overshoots, smooths. cubic: third
       order. cubic_32: reads 32 of its 64 cells, 1.00 to 1.05 of its error, less time without AVX-512. */
    windrow_interpolation interpolation;
    /* A number above 0, at most 1e6, default 2. Cells that the air may cross in one sub-step. Above 2 the backtrace may miss
       thin motors; large values are for tests of the raw step. */
    float max_cfl;
    /* 1 to 64, default 8. Maximal number of sub-steps in a step. Beyond max_cfl * max_substeps cells a step, speeds are
       limited (and counted). While obstacles move, the number follows from speeds of four steps ago and from what acts since. */
    int32_t max_substeps;
    /* 0 (two, eight in the first step of a flow) to 64, default 0. Direct solves of the pressure around obstacles in a
       sub-step. Each further solve costs about a fifth of a step; without obstacles in the box there is one. */
    int32_t pressure_solves;
    /* WINDROW_STAGE_* */
    uint32_t stages;
    /* 1 to 10000, default 30. Ticks a second. At 30, blended between ticks, leaves move as smoothly as at 144, at a fifth of
       the cost. */
    double ticks_hz;
    /* 1 to 1000, default 4. Maximal number of ticks in one call. Time beyond them is dropped and reported: a slow machine gets
       a slower wind, not an ever longer frame. */
    int32_t ticks_max_per_call;
    /* Default WINDROW_SIMD_BEST. Instructions of the hot loops. Default: the best that this machine runs. Each level gives one
       result, baseline the same on all machines. */
    windrow_simd simd;
    /* Threads of the host. Default: a serial loop; results do not depend on it. */
    windrow_parallel_for parallel_for;
    /* [m] -1e12 to 1e12, default 0. Height of the ground, where boundaries.y_low is a wall: the box's low side, to whole
       cells. Default 0. set_floor changes it. */
    double floor;
    /* [m/s] 0 (never) to 1e9, default 100. An obstacle or a wake that is moved faster has jumped: it is at its new place at
       once, at rest, and pushes no air on the way (windrow_diagnostics.jumps). Default 100: above what moves in a game's air,
       below a respawn over two metres. */
    float jump_speed;
    /* 0 */
    uint32_t reserved_2;
} windrow_config;
/* The defaults: 32 x 16 x 32 cells of 1 m, open air, no wind. */
WINDROW_C_API windrow_result windrow_config_init(windrow_config* config, uint32_t struct_size);
/* All reasons why a config is invalid, one per line. */
WINDROW_C_API windrow_result windrow_config_validate(const windrow_config* config);

#ifdef __cplusplus
}
#endif

#endif
