/* The ambient wind: mean wind, log profile, gusts; around the box of a wind, or by itself without any air solver. */
#ifndef WINDROW_C_API_AMBIENT_H
#define WINDROW_C_API_AMBIENT_H

#include "base.h"
#include "config.h"
#include "shader_blocks.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Conversion of the wind to the wind that acts on a plant. */
/* Made by ./dev schema from Sampling. */
typedef struct windrow_sampling {
    uint32_t struct_size;
    /* 0 to 1000, default 1. Factor on the wind; 0: no wind acts. */
    float strength;
    /* [m/s] 0 to 1e6, default 60. Upper bound of the speed, after the strength. 60 is the strongest storm. */
    float limit;
    /* 0 (none) to 1, default 0. Small-scale detail over the local speed; a bound, typical detail is a quarter of it. Needs a
       tile (windrow_ambient_wind_tile): without gusts, give windrow_gusts.tile. */
    float detail;
    /* [m] 0.001 to 1e6, default 1. Distance from one ripple to the next, rounded so that a whole number of ripples fits a gust
       (at most its length): then one phase moves both. 1 is what cells of 1 m leave out. */
    float detail_length;
} windrow_sampling;
WINDROW_C_API windrow_result windrow_sampling_init(windrow_sampling* sampling, uint32_t struct_size);
WINDROW_C_API windrow_result windrow_sampling_validate(const windrow_sampling* sampling);

/* The pattern of gusts, constant after creation: 128 x 16 x 128 texels of four floats. */
WINDROW_C_API windrow_result windrow_gust_tile_bake(uint32_t seed, windrow_gust_tile** tile);
/* What uses the tile keeps it. */
WINDROW_C_API void windrow_gust_tile_destroy(windrow_gust_tile* tile);
/* Its seed and a checksum of its texels, as bytes. */
WINDROW_C_API windrow_result windrow_gust_tile_save(const windrow_gust_tile* tile, windrow_bytes** bytes);
/* Bakes the tile again, some 5 ms, and compares its texels with the checksum. Damaged bytes, and those of a library whose pattern is
   another one, are rejected. */
WINDROW_C_API windrow_result windrow_gust_tile_load(const void* bytes, uint64_t size, windrow_gust_tile** tile);
WINDROW_C_API const windrow_vec4* windrow_gust_tile_texels(const windrow_gust_tile* tile, uint64_t* count);

typedef struct windrow_ambient_wind windrow_ambient_wind;
/* Made by ./dev schema from AmbientWind::Settings. */
typedef struct windrow_ambient_settings {
    uint32_t struct_size;
    /* [m/s] Each component -10000 to 10000, default (0, 0, 0). Mean wind, at the reference height if there is a profile. 0 is
       still air, which has no gusts either. */
    windrow_vec3 mean;
    /* Default none: the same wind at all heights. Null: none. */
    const windrow_log_profile* profile;
    /* Default none. Null: the defaults. */
    const windrow_gusts* gusts;
    /* [m] -1e12 to 1e12, default 0. World height of the ground: where the profile begins and gusts are mirrored. */
    double ground;
} windrow_ambient_settings;
WINDROW_C_API windrow_result windrow_ambient_settings_init(windrow_ambient_settings* settings, uint32_t struct_size);

WINDROW_C_API windrow_result windrow_ambient_wind_create(const windrow_ambient_settings* settings,
                                                         windrow_ambient_wind** ambient);
/* A copy of the ambient wind around a wind's box, of this frame or of the last one. */
WINDROW_C_API windrow_result windrow_ambient_wind_of(const windrow_wind* wind, int32_t frame, windrow_ambient_wind** ambient);
WINDROW_C_API void windrow_ambient_wind_destroy(windrow_ambient_wind* ambient);
WINDROW_C_API windrow_result windrow_ambient_wind_advance(windrow_ambient_wind* ambient, double dt);
WINDROW_C_API windrow_result windrow_ambient_wind_set_mean(windrow_ambient_wind* ambient, windrow_vec3 mean);
WINDROW_C_API windrow_result windrow_ambient_wind_set_ground(windrow_ambient_wind* ambient, double height);
WINDROW_C_API windrow_result windrow_ambient_wind_set_phase(windrow_ambient_wind* ambient, windrow_dvec3 phase);
WINDROW_C_API windrow_dvec3 windrow_ambient_wind_phase(const windrow_ambient_wind* ambient);
/* [m] Period of the gusts along x and z. */
WINDROW_C_API double windrow_ambient_wind_period(const windrow_ambient_wind* ambient);
WINDROW_C_API windrow_vec3 windrow_ambient_wind_mean(const windrow_ambient_wind* ambient);
WINDROW_C_API double windrow_ambient_wind_ground(const windrow_ambient_wind* ambient);
/* Factor of the mean wind at a world height [m]. */
WINDROW_C_API float windrow_ambient_wind_profile_at(const windrow_ambient_wind* ambient, double height);
/* [m/s] */
WINDROW_C_API windrow_result windrow_ambient_wind_velocity(const windrow_ambient_wind* ambient, windrow_dvec3 position,
                                                           windrow_vec3* velocity);
/* [m/s] That acts on a plant; `velocity` is the wind there, and receives what acts. */
WINDROW_C_API windrow_result windrow_ambient_wind_felt(const windrow_ambient_wind* ambient, windrow_dvec3 position,
                                                       const windrow_sampling* sampling, windrow_vec3* velocity);
WINDROW_C_API windrow_result windrow_ambient_wind_block(const windrow_ambient_wind* ambient, windrow_dvec3 anchor,
                                                        const windrow_sampling* sampling, windrow_ambient_block* block);
/* Its tile, null where it has none; destroy it. */
WINDROW_C_API windrow_result windrow_ambient_wind_tile(const windrow_ambient_wind* ambient, windrow_gust_tile** tile);

/* A spatially uniform gust by a closed formula. */
typedef struct windrow_uniform_gust {
    uint32_t struct_size;
    /* [m/s] Mean over a period, exactly. Default 4: leaves move. */
    float mean;
    /* [m/s] Peak over the mean; the lull is 0.58 of it below. Default 2: never calm, never a storm. */
    float amplitude;
    /* [s] From peak to peak, above 0; otherwise the mean blows. Default 8: as trees sway. */
    float period;
    /* Multiplies the speed; normally of length 1. Default along x. */
    windrow_vec3 direction;
    uint32_t reserved; /* 0 */
} windrow_uniform_gust;
WINDROW_C_API windrow_result windrow_uniform_gust_init(windrow_uniform_gust* gust, uint32_t struct_size);
WINDROW_C_API windrow_result windrow_uniform_gust_velocity(const windrow_uniform_gust* gust, double time, windrow_vec3* velocity);

#ifdef __cplusplus
}
#endif

#endif
