/*
 * Settings of a wind. Each struct with `struct_size` is filled with defaults by its init function, which is called first:
 *
 *     windrow_canopy wheat;
 *     windrow_canopy_init(&wheat, sizeof wheat);
 *     config.canopy = &wheat;
 *
 * Structs behind pointers are read during the call alone. Units and ranges of each field: the settings() of the C++ struct of the same
 * name, and docs/scene_keys.md.
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

typedef int32_t windrow_boundary_kind;
enum {
    WINDROW_BOUNDARY_OPEN = 0,      /* the ambient wind is beyond */
    WINDROW_BOUNDARY_FREE_SLIP = 1, /* a wall without friction */
    WINDROW_BOUNDARY_NO_SLIP = 2,   /* a wall that drags the air */
    WINDROW_BOUNDARY_PERIODIC = 3   /* the opposite face is beyond; in pairs */
};
typedef struct windrow_boundary {
    windrow_boundary_kind kind;
    windrow_vec3 wall_velocity; /* [m/s] of a no-slip wall, in its own plane */
} windrow_boundary;
typedef struct windrow_boundaries {
    windrow_boundary x_low, x_high, y_low, y_high, z_low, z_high;
} windrow_boundaries;
WINDROW_C_API windrow_boundaries windrow_boundaries_all(windrow_boundary_kind kind);
/* Open air over a free-slip floor. */
WINDROW_C_API windrow_boundaries windrow_boundaries_open_over_floor(void);

/* Wind over open ground: log((z + z0) / z0). */
typedef struct windrow_log_profile {
    uint32_t struct_size;
    float roughness_length; /* [m] */
    float reference_height; /* [m] */
} windrow_log_profile;
WINDROW_C_API windrow_result windrow_log_profile_init(windrow_log_profile* profile, uint32_t struct_size);

/* A pattern that the mean wind carries along. */
typedef struct windrow_gusts {
    uint32_t struct_size;
    float intensity;               /* standard deviation over the mean speed; 0: none */
    float length;                  /* [m] from one gust to the next */
    uint32_t seed;                 /* of the pattern */
    const windrow_gust_tile* tile; /* the pattern itself, to be used by many winds; null: made from the seed */
} windrow_gusts;
WINDROW_C_API windrow_result windrow_gusts_init(windrow_gusts* gusts, uint32_t struct_size);

/* Drag of plants on the floor. */
typedef struct windrow_canopy {
    uint32_t struct_size;
    float height; /* [m] */
    float drag;   /* [1/m] */
} windrow_canopy;
WINDROW_C_API windrow_result windrow_canopy_init(windrow_canopy* canopy, uint32_t struct_size);

/* Roughness lengths by place. */
typedef struct windrow_roughness_map {
    uint32_t struct_size;
    uint32_t reserved;                 /* 0 */
    const windrow_height_map* lengths; /* [m] */
    windrow_dvec3 position;            /* [m] */
    windrow_vec3 scale;
    uint32_t reserved_2; /* 0 */
} windrow_roughness_map;
WINDROW_C_API windrow_result windrow_roughness_map_init(windrow_roughness_map* map, uint32_t struct_size);

/* Rough ground. */
typedef struct windrow_roughness {
    uint32_t struct_size;
    float length;                     /* [m] z0 */
    float longest_mixing;             /* [m] 0: no limit */
    uint32_t reserved;                /* 0 */
    const windrow_roughness_map* map; /* null: `length` everywhere */
} windrow_roughness;
WINDROW_C_API windrow_result windrow_roughness_init(windrow_roughness* roughness, uint32_t struct_size);

/* Rows of cells of unequal thickness. */
typedef struct windrow_rows {
    uint32_t struct_size;
    float first;           /* [m] thickness of the lowest rows */
    int32_t uniform;       /* how many rows are that thick */
    float ratio;           /* of distances above them */
    float top;             /* [m] height of the box; 0: by the ratio */
    uint32_t height_count; /* of `heights` */
    const float* heights;  /* [m] of the rows' centres, one a row, in place of the law; null: none */
} windrow_rows;
WINDROW_C_API windrow_result windrow_rows_init(windrow_rows* rows, uint32_t struct_size);

typedef int32_t windrow_scheme;
enum { WINDROW_SCHEME_SECOND_ORDER = 0, WINDROW_SCHEME_STABLE_FLUIDS = 1 };
typedef int32_t windrow_interpolation;
enum { WINDROW_INTERPOLATION_LINEAR = 0, WINDROW_INTERPOLATION_CUBIC = 1 };
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

typedef struct windrow_config {
    uint32_t struct_size;
    windrow_ivec3 cells;
    float cell_size; /* [m] */
    windrow_boundaries boundaries;
    int32_t follow_axes;                /* WINDROW_FOLLOW_*: bits, or the default, which is the axes with two open boundaries */
    windrow_dvec3 centre;               /* [m]; its height does not count over a floor */
    windrow_vec3 ambient;               /* [m/s] mean wind */
    uint32_t reserved;                  /* 0 */
    const windrow_log_profile* profile; /* null: the same wind at all heights */
    const windrow_gusts* gusts;         /* null: none, as the next three */
    const windrow_canopy* canopy;
    const windrow_roughness* roughness;
    const windrow_rows* rows;
    float blend_width;     /* [cells] */
    float viscosity;       /* [m^2/s] */
    float relaxation_time; /* [s] 0: never */
    float sleep_speed;     /* [m/s] 0: never */
    windrow_scheme scheme;
    windrow_interpolation interpolation;
    float max_cfl;
    int32_t max_substeps;
    int32_t pressure_solves; /* 0: two, eight in the first step of a flow */
    uint32_t stages;         /* WINDROW_STAGE_* */
    double ticks_hz;         /* fixed ticks a second of windrow_wind_advance */
    int32_t ticks_max_per_call;
    windrow_simd simd;
    windrow_parallel_for parallel_for;
    double floor; /* [m] height of the ground, where boundaries.y_low is a wall; default 0 */
} windrow_config;
/* The defaults: 32 x 16 x 32 cells of 1 m, open air, no wind. */
WINDROW_C_API windrow_result windrow_config_init(windrow_config* config, uint32_t struct_size);
/* All reasons why a config is invalid, one per line. */
WINDROW_C_API windrow_result windrow_config_validate(const windrow_config* config);

#ifdef __cplusplus
}
#endif

#endif
