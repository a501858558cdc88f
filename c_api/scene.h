/*
 * A scene file, played in a wind on the CPU: the same air as that of `windrow run` (scene/scene_air.h, docs/scenes.md).
 *
 *     windrow_scene* scene = NULL;
 *     if (windrow_scene_load("fan.json", NULL, &scene) != WINDROW_OK)
 *         return puts(windrow_last_error()), 2;
 *     while (windrow_scene_time(scene) < windrow_scene_duration(scene))
 *         windrow_scene_step(scene, NULL);
 *     windrow_wind_velocity(windrow_scene_wind(scene), leaf, &velocity);
 *     windrow_scene_destroy(scene);
 *
 * Motors and obstacles come, move and go as the file says; a host may add more to the wind. The files that a scene names are sought beside
 * it: OBJ, .vox, and heights as PGM, ESRI grids or raw numbers.
 */
#ifndef WINDROW_C_API_SCENE_H
#define WINDROW_C_API_SCENE_H

#include "base.h"
#include "motors.h"
#include "obstacles.h"
#include "wind.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct windrow_scene windrow_scene;
/* Reads the file `path` (UTF-8) and begins its air at time 0. A fault of the file is one sentence, a line each. The logger is warned of
   what the air lacks. `parallel_for` may be null. */
WINDROW_C_API windrow_result windrow_scene_load(const char* path, const windrow_parallel_for* parallel_for,
                                                windrow_scene** scene);
/* The same from `size` bytes of JSON; `path` begins the sentences, and the files that it names are sought beside it. */
WINDROW_C_API windrow_result windrow_scene_parse(const char* text, uint64_t size, const char* path,
                                                 const windrow_parallel_for* parallel_for, windrow_scene** scene);
/* The wind too. */
WINDROW_C_API void windrow_scene_destroy(windrow_scene* scene);
/* Its wind, which takes all calls of wind.h, motors.h and obstacles.h but its own end, its own time and windrow_wind_shift_origin: the
   scene places what it has by its own numbers. It is the scene's. */
WINDROW_C_API windrow_wind* windrow_scene_wind(windrow_scene* scene);
/* The number of winds around that (`air.outer`). */
WINDROW_C_API int32_t windrow_scene_outer_count(const windrow_scene* scene);
/* One of them by its place, 0 the nearest; null where there is none. They are the scene's too, and take the same calls. To save all as
   winds of the host's own, save each and load the outermost first (windrow_wind_load_inside). */
WINDROW_C_API windrow_wind* windrow_scene_outer_wind(windrow_scene* scene, int32_t place);

/* Writes a wind as a scene file that `windrow run` and windrow_scene_load play: its settings, motors, obstacles and drag as they are now,
   from time 0 on. The air of this moment is not in it (windrow_wind_save). Its wind is one that was created so, to the bit; bodies that
   are turned and directions, to rounding; winds around it may stand one of their cells elsewhere. Of a scene's own wind the file has
   what is in the air now: motors come with its first step. `path` is UTF-8; `duration` [s] above 0; `tick_hz`: steps a second at
   least, 60 is that of most scenes.
   Rejects wakes, meshes, voxel grids, grounds and maps of roughness, which a scene has paths or files for. */
WINDROW_C_API windrow_result windrow_wind_write_scene(const windrow_wind* wind, const char* path, double duration,
                                                      double tick_hz);

/* One step, as `windrow run` makes it: at most a tick of the scene, so that frames are at the ends of steps. `diagnostics` may be null. */
WINDROW_C_API windrow_result windrow_scene_step(windrow_scene* scene, windrow_diagnostics* diagnostics);
/* A frame of dt [s] in the fixed ticks of the wind (windrow_wind_advance); for a game's loop. Either this or steps. */
WINDROW_C_API windrow_result windrow_scene_advance(windrow_scene* scene, double dt, windrow_advance* advance);
/* [s] */
WINDROW_C_API double windrow_scene_time(const windrow_scene* scene);
WINDROW_C_API double windrow_scene_duration(const windrow_scene* scene);
/* Frames a second of the files that `windrow run` writes. */
WINDROW_C_API double windrow_scene_frames_per_second(const windrow_scene* scene);

/* Number of its motors, and the name of one, by its place in the file; null where there is none. */
WINDROW_C_API int32_t windrow_scene_motor_count(const windrow_scene* scene);
WINDROW_C_API const char* windrow_scene_motor_name(const windrow_scene* scene, int32_t place);
WINDROW_C_API int32_t windrow_scene_obstacle_count(const windrow_scene* scene);
WINDROW_C_API const char* windrow_scene_obstacle_name(const windrow_scene* scene, int32_t place);
/* The first that is in the air under a name. WINDROW_STALE: the scene has it at other times; WINDROW_REJECTED: it has none. */
WINDROW_C_API windrow_result windrow_scene_motor(const windrow_scene* scene, const char* name, windrow_motor_id* id);
WINDROW_C_API windrow_result windrow_scene_obstacle(const windrow_scene* scene, const char* name, windrow_obstacle_id* id);

/* The clock and the air as bytes. */
WINDROW_C_API windrow_result windrow_scene_save(const windrow_scene* scene, windrow_bytes** bytes);
/* Goes on from there, in a scene of the same file. Handles of its motors, obstacles and winds stay good; arrays of its winds do not, and
   recordings end. */
WINDROW_C_API windrow_result windrow_scene_restore(windrow_scene* scene, const void* bytes, uint64_t size);

#ifdef __cplusplus
}
#endif

#endif
