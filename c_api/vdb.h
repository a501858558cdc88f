/* Winds as OpenVDB files (fluid/vdb/vdb_export.h). */
#ifndef WINDROW_C_API_VDB_H
#define WINDROW_C_API_VDB_H

#include "base.h"
#include "wind.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef int32_t windrow_vdb_form;
enum { WINDROW_VDB_ONE_VECTOR = 0, WINDROW_VDB_THREE_SCALARS = 1 };
typedef int32_t windrow_vdb_precision;
enum { WINDROW_VDB_FULL = 0, WINDROW_VDB_HALF = 1 };
typedef int32_t windrow_vdb_up;
enum { WINDROW_VDB_UP_Y = 0, WINDROW_VDB_UP_Z = 1 };
typedef int32_t windrow_vdb_format;
enum { WINDROW_VDB_OPENVDB = 0, WINDROW_VDB_NANOVDB = 1 };
/* 1 if this build writes NanoVDB. */
WINDROW_C_API int32_t windrow_vdb_has_nanovdb(void);
typedef struct windrow_vdb_options {
    uint32_t struct_size;
    /* Grids of the velocity. Default WINDROW_VDB_ONE_VECTOR. */
    windrow_vdb_form form;
    /* Name of the grid, without '/' and control characters. Null, the default: "vel". */
    const char* name;
    /* Bits of a value. Default WINDROW_VDB_FULL. WINDROW_VDB_HALF rejects winds above 65504 m/s. */
    windrow_vdb_precision precision;
    /* Axis that points up in the file. Default WINDROW_VDB_UP_Y. */
    windrow_vdb_up up;
    /* [s] Any finite time of the wind; stored as windrow_time. Default 0. */
    double time;
    /* Number of the frame, any; stored as windrow_frame. Default 0. */
    int32_t frame;
    /* Default WINDROW_VDB_OPENVDB. WINDROW_VDB_NANOVDB is rejected where windrow_vdb_has_nanovdb returns 0. */
    windrow_vdb_format format;
} windrow_vdb_options;
WINDROW_C_API windrow_result windrow_vdb_options_init(windrow_vdb_options* options, uint32_t struct_size);

/* Writes the cells of a wind as they are now, with the cells inside obstacles. `path` is UTF-8. `options` may be null. On a device: the
   last read-back, without obstacles. */
WINDROW_C_API windrow_result windrow_vdb_write(const windrow_wind* wind, const char* path, const windrow_vdb_options* options);
/* A frame of a sequence: folder / prefix 0001 .vdb. `options` may be null; its time and frame are replaced. */
WINDROW_C_API windrow_result windrow_vdb_write_frame(const windrow_wind* wind, const char* folder, const char* prefix,
                                                     int32_t digits, int32_t frame, double time,
                                                     const windrow_vdb_options* options);
/* A further grid over the same cells, of numbers or of vectors. */
typedef struct windrow_vdb_scalar {
    const char* name;
    const char* units;   /* such as "1/s"; null: none */
    const float* values; /* one a cell */
    float outside;       /* background value */
    uint32_t reserved;   /* 0 */
} windrow_vdb_scalar;
typedef struct windrow_vdb_vector {
    const char* name;
    const char* units;
    const windrow_vec4* values;
} windrow_vdb_vector;
/* A box of cells in memory of the host. */
typedef struct windrow_vdb_grid {
    uint32_t struct_size;
    windrow_ivec3 cells;
    windrow_dvec3 origin; /* [m] of the low corner */
    windrow_vec3 outside; /* [m/s] background value */
    float cell_size;      /* [m] */
    uint64_t count;       /* of `field`: x * y * z */
    const windrow_vec4* field;
    const float* obstacle; /* as many: 1 inside obstacles, else 0; null: none */
    float cell_height;     /* [m] along y; 0: cell_size */
    uint32_t scalar_count;
    uint32_t vector_count;
    uint32_t reserved; /* 0 */
    const windrow_vdb_scalar* scalars;
    const windrow_vdb_vector* vectors;
} windrow_vdb_grid;
WINDROW_C_API windrow_result windrow_vdb_grid_init(windrow_vdb_grid* grid, uint32_t struct_size);
WINDROW_C_API windrow_result windrow_vdb_write_grid(const windrow_vdb_grid* grid, const char* path,
                                                    const windrow_vdb_options* options);

/* What a film shows: the wind in its box and around it, on voxels of one size (fluid/vdb/film_grid.h). Outside of the box a voxel holds
   the ambient wind with its profile and gusts. */
typedef struct windrow_vdb_film {
    uint32_t struct_size;
    int32_t has_region; /* 1: low and high; 0, the default: the box, and `margin` more on each side, none below a wall */
    windrow_dvec3 low;  /* [m] corners in the world, grown to whole voxels */
    windrow_dvec3 high;
    double margin;     /* [m] */
    float voxel_size;  /* [m] 0, the default: that of the cells */
    int32_t speed;     /* 1: adds the grid `speed` [m/s] */
    int32_t vorticity; /* 1: adds the grid of vectors `vorticity` [1/s] */
    uint32_t scalar_count;
    const windrow_vdb_scalar* scalars; /* further grids, one value a cell of the box; outside of it they fade to 0 */
} windrow_vdb_film;
WINDROW_C_API windrow_result windrow_vdb_film_init(windrow_vdb_film* film, uint32_t struct_size);
/* Writes a frame, with the cells inside obstacles. `options` may be null. */
WINDROW_C_API windrow_result windrow_vdb_write_film(const windrow_wind* wind, const windrow_vdb_film* film, const char* path,
                                                    const windrow_vdb_options* options);

#ifdef __cplusplus
}
#endif

#endif
