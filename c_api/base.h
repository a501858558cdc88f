/* Base of the C API: version, results, errors, vectors, hooks of the host. */
#ifndef WINDROW_C_API_BASE_H
#define WINDROW_C_API_BASE_H

#include "../fluid/version.h"

#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32) && defined(WINDROW_C_BUILDS)
#define WINDROW_C_API __declspec(dllexport)
#elif defined(_WIN32)
#define WINDROW_C_API __declspec(dllimport)
#elif defined(__GNUC__)
#define WINDROW_C_API __attribute__((visibility("default")))
#else
#define WINDROW_C_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* --- Version ------------------------------------------------------------------------------------------------------------- */

/* WINDROW_VERSION of the library that runs. The header's own is the macro. */
WINDROW_C_API uint32_t windrow_version(void);
/* The same as text, "0.1.0". */
WINDROW_C_API const char* windrow_version_string(void);

/* Parts that a build may leave out. Their functions are always there; without the part they return WINDROW_UNSUPPORTED. VDB is in a
   library of its own, libwindrow_openvdb-0.1.so, which its first call opens beside this one: so does a call that finds none. */
typedef int32_t windrow_part;
enum { WINDROW_PART_COUPLING = 0, WINDROW_PART_VDB = 1, WINDROW_PART_VULKAN = 2, WINDROW_PART_SCENE = 3 };
/* 1 if this library has the part. */
WINDROW_C_API int32_t windrow_has_part(windrow_part part);

/* --- Results ------------------------------------------------------------------------------------------------------------- */

/* WINDROW_OK, or a negative class of error. A call that fails changes nothing, except where it is documented. */
typedef int32_t windrow_result;
enum {
    WINDROW_OK = 0,
    WINDROW_REJECTED = -1,      /* an argument or a field is out of range, null or of another kind */
    WINDROW_STALE = -2,         /* the id names nothing: it was removed, or another wind gave it */
    WINDROW_OUT_OF_MEMORY = -3, /* free some and call again */
    WINDROW_CANNOT_WRITE = -4,  /* the file cannot be made there */
    WINDROW_DISK_FULL = -5,     /* the disk cannot hold the file */
    WINDROW_UNSUPPORTED = -6,   /* this build lacks the part, or this backend lacks the call */
    WINDROW_NOT_READY = -7,     /* nothing has come back from the device yet */
    WINDROW_DEVICE_LOST = -9,   /* make the device and what was made from it anew */
    WINDROW_UNEXPECTED = -8     /* an unexpected error inside the library: report it */
};

/* The sentence of the last call in this thread that failed: what is wrong, its value, the fix; all reasons, one a line. UTF-8. It is
   good until the next call of this thread that fails. Empty before the first; at most 8191 bytes, whole lines. Functions that return a value in place of a result
   return 0 for a null handle, and the sentence says which argument is null. */
WINDROW_C_API const char* windrow_last_error(void);

/* --- Numbers ------------------------------------------------------------------------------------------------------------- */

typedef struct windrow_vec2 {
    float x, y;
} windrow_vec2;
typedef struct windrow_vec3 {
    float x, y, z;
} windrow_vec3;
typedef struct windrow_vec4 {
    float x, y, z, w;
} windrow_vec4;
/* A quaternion, of any length but 0. */
typedef struct windrow_quat {
    float x, y, z, w;
} windrow_quat;
typedef struct windrow_dvec2 {
    double x, y;
} windrow_dvec2;
typedef struct windrow_dvec3 {
    double x, y, z;
} windrow_dvec3;
typedef struct windrow_dvec4 {
    double x, y, z, w;
} windrow_dvec4;
typedef struct windrow_ivec2 {
    int32_t x, y;
} windrow_ivec2;
typedef struct windrow_ivec3 {
    int32_t x, y, z;
} windrow_ivec3;
typedef struct windrow_uvec2 {
    uint32_t x, y;
} windrow_uvec2;

/* --- Hooks: set once, before the first object ---------------------------------------------------------------------------- */

typedef int32_t windrow_severity;
enum { WINDROW_SEVERITY_WARNING = 0, WINDROW_SEVERITY_ERROR = 1 };
/* Called with the sentence of each call that fails, and with warnings; by the thread that calls the library, or by a driver's. */
typedef void (*windrow_logger)(windrow_severity severity, const char* sentence, void* user);
/* Null: no longer. Set it while no other thread is inside the library. */
WINDROW_C_API void windrow_set_logger(windrow_logger logger, void* user);

/* Memory for the large arrays of all winds, at least 99 % of windrow_wind_memory_bytes on the CPU: cells, scratch and tables of the
   solver, tiles of gusts. `alignment` is a power of two from 64 on. Null is out of memory. Called by any thread that makes objects.
   Not covered: objects themselves, lists, strings, geometry, snapshots, logs, what OpenVDB and a driver allocate. */
typedef void* (*windrow_allocate)(size_t bytes, size_t alignment, void* user);
typedef void (*windrow_release)(void* memory, size_t bytes, size_t alignment, void* user);
/* Both or neither; null: the library's own. Rejected while memory of the other allocator is held. */
WINDROW_C_API windrow_result windrow_set_allocator(windrow_allocate allocate, windrow_release release, void* user);
/* [bytes] Held from the allocator now. */
WINDROW_C_API uint64_t windrow_allocated_bytes(void);

/* Which way the host's x, y, z point. In all of them x is the library's x. */
typedef int32_t windrow_axes;
enum {
    WINDROW_AXES_Y_UP_RIGHT = 0, /* the library's own, Godot's: right-handed */
    WINDROW_AXES_Y_UP_LEFT = 1,  /* Unity's: z is the library's -z */
    WINDROW_AXES_Z_UP_RIGHT = 2, /* Blender's: y is the library's -z */
    WINDROW_AXES_Z_UP_LEFT = 3   /* Unreal's: y is the library's z */
};
/* The host's axes, and its unit of length [m], 1e-6 to 1e6; default: the library's own axes and 1. From then on every call speaks them:
   what the headers give in m is in the unit, m/s in units a second, m^2 in square units, N in kg units/s^2, Pa in kg/(unit s^2). Init
   functions fill in defaults for the unit; "y", "height" and "low y face" of a comment are what points up. Axes of rotation, spins and
   moments follow the screw of the host. Set them before the first struct is filled, while no other thread is inside the library.
   Objects, snapshots, logs, scenes and files do not depend on them, so that hosts of other axes load them.
   The library's own, in metres, stay: arrays and views of cells and texels (windrow_wind_field, windrow_wind_set_field,
   windrow_wind_write_vectors, tracers, windrow_ground_texels, the fields of operators.h, windrow_vdb_grid, what a device reads back,
   and the origin that comes with them), the blocks and textures of shaders, and the values that a sentence of an error names. */
WINDROW_C_API windrow_result windrow_set_axes(windrow_axes axes, double unit);
/* From a place of the host to the library's own [m], for shaders and arrays of cells: 16 numbers, column by column; its inverse takes
   a velocity of the library's to the host's. */
WINDROW_C_API windrow_result windrow_axes_matrix(double* matrix);

/* A host's parallel loop: calls task(argument, i) once for each i in [0, count), in any order and on any threads, and returns when all
   are done. It must not throw. Results do not depend on the number of threads. */
typedef void (*windrow_task)(void* argument, int32_t index);
typedef void (*windrow_run)(void* context, int32_t count, windrow_task task, void* argument);
typedef struct windrow_parallel_for {
    windrow_run run; /* null: a serial loop in the caller's thread */
    void* context;   /* handed to `run`; outlives every object that was made with it */
} windrow_parallel_for;

/* A small pool for hosts without a job system. */
typedef struct windrow_thread_pool windrow_thread_pool;
/* `threads` in all, the caller's included; 0: one a core. */
WINDROW_C_API windrow_result windrow_thread_pool_create(int32_t threads, windrow_thread_pool** pool);
WINDROW_C_API void windrow_thread_pool_destroy(windrow_thread_pool* pool);
WINDROW_C_API int32_t windrow_thread_pool_size(const windrow_thread_pool* pool);
/* The loop to hand to a config. The pool outlives what was made with it. */
WINDROW_C_API windrow_parallel_for windrow_thread_pool_parallel_for(windrow_thread_pool* pool);

/* --- Bytes that the library made: a snapshot, a log ---------------------------------------------------------------------- */

typedef struct windrow_bytes windrow_bytes;
WINDROW_C_API const uint8_t* windrow_bytes_data(const windrow_bytes* bytes);
WINDROW_C_API uint64_t windrow_bytes_size(const windrow_bytes* bytes);
WINDROW_C_API void windrow_bytes_destroy(windrow_bytes* bytes);

/* Several saved states in one file, each under a name of 1 to 64 letters: the air, the ground's trails, smoke. */
typedef struct windrow_saved_part {
    const char* name;
    const void* bytes;
    uint64_t size;
} windrow_saved_part;
/* At most 4096 parts. */
WINDROW_C_API windrow_result windrow_parts_join(const windrow_saved_part* parts, uint64_t count, windrow_bytes** file);
/* The part with a name, within `bytes`, a file that windrow_parts_join made. Rejects another file, and a name that it lacks. */
WINDROW_C_API windrow_result windrow_parts_find(const void* bytes, uint64_t size, const char* name, const void** part,
                                                uint64_t* part_size);

#ifdef __cplusplus
}
#endif

#endif
