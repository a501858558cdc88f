/*
 * Motors, the sources of momentum and volume: fans, gusts, passing bodies, jets, vortices, blasts (fluid/motor.h).
 *
 *     windrow_wake_motor wake;
 *     windrow_motor_id dog;
 *     windrow_wake_motor_init(&wake, sizeof wake);
 *     wake.radius = 0.6f;
 *     windrow_wind_add_wake(wind, &wake, &dog);
 *     windrow_wind_move_motor(wind, dog, position);
 */
#ifndef WINDROW_C_API_MOTORS_H
#define WINDROW_C_API_MOTORS_H

#include "base.h"
#include "wind.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Handle of a motor of one wind; all 0 names none. */
typedef struct windrow_motor_id {
    uint32_t slot, generation, owner;
} windrow_motor_id;

/* --- Parts of motors ----------------------------------------------------------------------------------------------------- */

typedef int32_t windrow_region_kind;
enum { WINDROW_REGION_SPHERE = 0, WINDROW_REGION_CAPSULE = 1, WINDROW_REGION_BOX = 2, WINDROW_REGION_CONE = 3 };
/* Where a motor acts. Made by the functions below; fields of other kinds are not read. */
typedef struct windrow_region {
    windrow_region_kind kind;
    float radius;           /* [m] sphere, capsule */
    windrow_vec3 half_axis; /* [m] capsule */
    windrow_vec3 half_size; /* [m] box */
    windrow_vec3 axis;      /* [m] cone */
    float start_radius;     /* [m] cone */
    float end_radius;       /* [m] cone */
} windrow_region;
WINDROW_C_API windrow_region windrow_region_sphere(float radius);
WINDROW_C_API windrow_region windrow_region_capsule(windrow_vec3 half_axis, float radius);
WINDROW_C_API windrow_region windrow_region_box(windrow_vec3 half_size);
WINDROW_C_API windrow_region windrow_region_cone(windrow_vec3 axis, float start_radius, float end_radius);

typedef int32_t windrow_law_kind;
enum { WINDROW_LAW_FORCE = 0, WINDROW_LAW_DRIVE = 1 };
/* How a motor acts. */
typedef struct windrow_law {
    windrow_law_kind kind;
    float acceleration; /* [m/s^2] force */
    float speed;        /* [m/s] drive */
    float rate;         /* [1/s] drive */
} windrow_law;
WINDROW_C_API windrow_law windrow_law_force(float acceleration);
WINDROW_C_API windrow_law windrow_law_drive(float speed, float rate);

/* How a wake acts. */
typedef struct windrow_wake_law {
    windrow_law_kind kind;
    float strength;    /* [1/s] force */
    float per_metre;   /* [1/m] drive */
    float entrainment; /* drive */
} windrow_wake_law;
WINDROW_C_API windrow_wake_law windrow_wake_law_force(float strength);
WINDROW_C_API windrow_wake_law windrow_wake_law_drive(float per_metre, float entrainment);

/* [s] Strength over time. */
typedef struct windrow_envelope {
    float attack, hold, decay, delay;
} windrow_envelope;

/* Eddies in what a motor blows. */
typedef struct windrow_turbulence {
    float intensity;
    float length; /* [m] 0: two radii */
    uint32_t seed;
} windrow_turbulence;

/* --- Motors -------------------------------------------------------------------------------------------------------------- */

typedef int32_t windrow_motor_kind;
enum {
    WINDROW_MOTOR_DIRECTIONAL = 0,
    WINDROW_MOTOR_WAKE = 1,
    WINDROW_MOTOR_JET = 2,
    WINDROW_MOTOR_VORTEX = 3,
    WINDROW_MOTOR_OMNI = 4,
    WINDROW_MOTOR_PRESSURE = 5
};

/* A fan, a gust, a draught. */
typedef struct windrow_directional_motor {
    uint32_t struct_size;
    windrow_vec3 direction; /* of any length */
    windrow_dvec3 position; /* [m] */
    windrow_region region;
    windrow_law law;
    windrow_envelope envelope;
    windrow_turbulence turbulence;
} windrow_directional_motor;
WINDROW_C_API windrow_result windrow_directional_motor_init(windrow_directional_motor* motor, uint32_t struct_size);

/* The wake of a moving body. */
typedef struct windrow_wake_motor {
    uint32_t struct_size;
    float radius;           /* [m] */
    windrow_dvec3 position; /* [m] */
    windrow_wake_law law;
    windrow_envelope envelope;
    windrow_turbulence turbulence;
    uint32_t reserved; /* 0 */
} windrow_wake_motor;
WINDROW_C_API windrow_result windrow_wake_motor_init(windrow_wake_motor* motor, uint32_t struct_size);

/* A nozzle. */
typedef struct windrow_jet_motor {
    uint32_t struct_size;
    windrow_vec3 direction; /* of any length */
    windrow_dvec3 position; /* [m] */
    float length;           /* [m] */
    float start_radius;     /* [m] */
    float end_radius;       /* [m] */
    windrow_law law;
    windrow_envelope envelope;
    windrow_turbulence turbulence;
} windrow_jet_motor;
WINDROW_C_API windrow_result windrow_jet_motor_init(windrow_jet_motor* motor, uint32_t struct_size);

/* Turns the air about an axis. */
typedef struct windrow_vortex_motor {
    uint32_t struct_size;
    windrow_vec3 axis;      /* of any length */
    windrow_dvec3 position; /* [m] */
    float radius;           /* [m] */
    float half_length;      /* [m] */
    float lift;
    windrow_law law;
    windrow_envelope envelope;
    uint32_t reserved; /* 0 */
} windrow_vortex_motor;
WINDROW_C_API windrow_result windrow_vortex_motor_init(windrow_vortex_motor* motor, uint32_t struct_size);

/* Air that comes out of a ball or vanishes in it. */
typedef struct windrow_omni_motor {
    uint32_t struct_size;
    float radius;           /* [m] */
    windrow_dvec3 position; /* [m] */
    float speed;            /* [m/s] */
    windrow_envelope envelope;
    uint32_t reserved; /* 0 */
} windrow_omni_motor;
WINDROW_C_API windrow_result windrow_omni_motor_init(windrow_omni_motor* motor, uint32_t struct_size);

/* A burst. */
typedef struct windrow_pressure_motor {
    uint32_t struct_size;
    float radius;           /* [m] */
    windrow_dvec3 position; /* [m] */
    float speed;            /* [m/s] */
    float duration;         /* [s] */
} windrow_pressure_motor;
WINDROW_C_API windrow_result windrow_pressure_motor_init(windrow_pressure_motor* motor, uint32_t struct_size);

/* --- The motors of a wind, at most 4096 ---------------------------------------------------------------------------------- */

/* `id` may be null for a motor that ends by itself. */
WINDROW_C_API windrow_result windrow_wind_add_directional(windrow_wind* wind, const windrow_directional_motor* motor,
                                                          windrow_motor_id* id);
WINDROW_C_API windrow_result windrow_wind_add_wake(windrow_wind* wind, const windrow_wake_motor* motor, windrow_motor_id* id);
WINDROW_C_API windrow_result windrow_wind_add_jet(windrow_wind* wind, const windrow_jet_motor* motor, windrow_motor_id* id);
WINDROW_C_API windrow_result windrow_wind_add_vortex(windrow_wind* wind, const windrow_vortex_motor* motor, windrow_motor_id* id);
WINDROW_C_API windrow_result windrow_wind_add_omni(windrow_wind* wind, const windrow_omni_motor* motor, windrow_motor_id* id);
WINDROW_C_API windrow_result windrow_wind_add_pressure(windrow_wind* wind, const windrow_pressure_motor* motor,
                                                       windrow_motor_id* id);

/* Replaces a motor whole; its kind may change. */
WINDROW_C_API windrow_result windrow_wind_set_directional(windrow_wind* wind, windrow_motor_id id,
                                                          const windrow_directional_motor* motor);
WINDROW_C_API windrow_result windrow_wind_set_wake(windrow_wind* wind, windrow_motor_id id, const windrow_wake_motor* motor);
WINDROW_C_API windrow_result windrow_wind_set_jet(windrow_wind* wind, windrow_motor_id id, const windrow_jet_motor* motor);
WINDROW_C_API windrow_result windrow_wind_set_vortex(windrow_wind* wind, windrow_motor_id id, const windrow_vortex_motor* motor);
WINDROW_C_API windrow_result windrow_wind_set_omni(windrow_wind* wind, windrow_motor_id id, const windrow_omni_motor* motor);
WINDROW_C_API windrow_result windrow_wind_set_pressure(windrow_wind* wind, windrow_motor_id id,
                                                       const windrow_pressure_motor* motor);

/* The motor as it is; rejected where it is of another kind. */
WINDROW_C_API windrow_result windrow_wind_get_directional(const windrow_wind* wind, windrow_motor_id id,
                                                          windrow_directional_motor* motor);
WINDROW_C_API windrow_result windrow_wind_get_wake(const windrow_wind* wind, windrow_motor_id id, windrow_wake_motor* motor);
WINDROW_C_API windrow_result windrow_wind_get_jet(const windrow_wind* wind, windrow_motor_id id, windrow_jet_motor* motor);
WINDROW_C_API windrow_result windrow_wind_get_vortex(const windrow_wind* wind, windrow_motor_id id, windrow_vortex_motor* motor);
WINDROW_C_API windrow_result windrow_wind_get_omni(const windrow_wind* wind, windrow_motor_id id, windrow_omni_motor* motor);
WINDROW_C_API windrow_result windrow_wind_get_pressure(const windrow_wind* wind, windrow_motor_id id,
                                                       windrow_pressure_motor* motor);

/* WINDROW_STALE for an id that names no motor; so a host asks whether a motor is still there. */
WINDROW_C_API windrow_result windrow_wind_motor_kind(const windrow_wind* wind, windrow_motor_id id, windrow_motor_kind* kind);
/* To where it is at the end of the coming step or frame. */
WINDROW_C_API windrow_result windrow_wind_move_motor(windrow_wind* wind, windrow_motor_id id, windrow_dvec3 position);
WINDROW_C_API windrow_result windrow_wind_remove_motor(windrow_wind* wind, windrow_motor_id id);
WINDROW_C_API int32_t windrow_wind_motor_count(const windrow_wind* wind);

#ifdef __cplusplus
}
#endif

#endif
