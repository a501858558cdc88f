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

/* Made by ./dev schema from Region. */
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

/* Made by ./dev schema from Law. */
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
/* Made by ./dev schema from Envelope. */
typedef struct windrow_envelope {
    /* [s] 0 to 1e9, default 0. Time in which it rises. */
    float attack;
    /* [s] At least 0, default infinity. Time at full strength. Default infinity: until the motor is removed. */
    float hold;
    /* [s] 0 to 1e9, default 0. Time in which it falls, after the hold. */
    float decay;
    /* [s] 0 to 1e9, default 0. Time before it begins to rise, in which the motor rests: gusts that are added together come one
       by one. */
    float delay;
} windrow_envelope;

/* Eddies in what a motor blows. */
/* Made by ./dev schema from Turbulence. */
typedef struct windrow_turbulence {
    /* 0 (none) to 1, default 0.05. Standard deviation over U of a horizontal component of what leaves the region. At 0.05 jets
       spread as measured ones do. 0 costs nothing. */
    float intensity;
    /* [m] 0 (two radii) to 1e6, default 0. Size of the largest eddies; most are a third of that. 0: two radii of the region
       (of a box, two of its smallest half sizes). */
    float length;
    /* 0 to 4294967295, default 0. Selects a part of the pattern: motors of the same kind, age and seed have the same eddies. */
    uint32_t seed;
} windrow_turbulence;

/* --- Motors -------------------------------------------------------------------------------------------------------------- */

/* Made by ./dev schema from Motor. */
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
/* Made by ./dev schema from DirectionalMotor. */
typedef struct windrow_directional_motor {
    uint32_t struct_size;
    /* A finite vector that is not 0, default (1, 0, 0). Any length; normalised on creation. */
    windrow_vec3 direction;
    /* [m] Each component -1e12 to 1e12, default (0, 0, 0). Centre of the region; first end of a cone. */
    windrow_dvec3 position;
    /* Region in which it acts: fully in the middle, falling smoothly to 0 at the edge. */
    windrow_region region;
    /* Law of its action on the air. */
    windrow_law law;
    /* Strength over time. */
    windrow_envelope envelope;
    /* Eddies in what it blows. */
    windrow_turbulence turbulence;
} windrow_directional_motor;
WINDROW_C_API windrow_result windrow_directional_motor_init(windrow_directional_motor* motor, uint32_t struct_size);

/* The wake of a moving body. */
/* Made by ./dev schema from WakeMotor. */
typedef struct windrow_wake_motor {
    uint32_t struct_size;
    /* [m] A number above 0, at most 1e6, default 0.5. Radius of the body. */
    float radius;
    /* [m] Each component -1e12 to 1e12, default (0, 0, 0). Start of the path. */
    windrow_dvec3 position;
    /* Law of its action on the air. */
    windrow_wake_law law;
    /* Strength over time. */
    windrow_envelope envelope;
    /* Eddies in the wake. Default none: a wake makes its own. */
    windrow_turbulence turbulence;
    /* 0 */
    uint32_t reserved;
} windrow_wake_motor;
WINDROW_C_API windrow_result windrow_wake_motor_init(windrow_wake_motor* motor, uint32_t struct_size);

/* A nozzle. */
/* Made by ./dev schema from JetMotor. */
typedef struct windrow_jet_motor {
    uint32_t struct_size;
    /* A finite vector that is not 0, default (1, 0, 0). Any length; normalised on creation. */
    windrow_vec3 direction;
    /* [m] Each component -1e12 to 1e12, default (0, 0, 0). The nozzle. */
    windrow_dvec3 position;
    /* [m] A number above 0, at most 1e6, default 6. Length over which it pushes. The air carries the jet on beyond it. */
    float length;
    /* [m] A number above 0, at most 1e6, default 0.5. Radius at the nozzle. */
    float start_radius;
    /* [m] A number above 0, at most 1e6, default 1.5. Radius at the end; equal to start_radius: a cylinder. */
    float end_radius;
    /* Law of its action on the air, at the nozzle. */
    windrow_law law;
    /* Strength over time. */
    windrow_envelope envelope;
    /* Eddies in the jet: they make it roll up and spread. */
    windrow_turbulence turbulence;
} windrow_jet_motor;
WINDROW_C_API windrow_result windrow_jet_motor_init(windrow_jet_motor* motor, uint32_t struct_size);

/* Turns the air about an axis. */
/* Made by ./dev schema from VortexMotor. */
typedef struct windrow_vortex_motor {
    uint32_t struct_size;
    /* A finite vector that is not 0, default (0, 1, 0). Any length; normalised on creation. */
    windrow_vec3 axis;
    /* [m] Each component -1e12 to 1e12, default (0, 0, 0). The middle. */
    windrow_dvec3 position;
    /* [m] A number above 0, at most 1e6, default 4. Distance from the axis beyond which nothing acts. */
    float radius;
    /* [m] A number above 0, at most 1e6, default 4. Along the axis, from the middle to each end. */
    float half_length;
    /* -10 to 10, default 0. Speed along the axis in the middle over the swirl. A dust devil has about 0.5. */
    float lift;
    /* Law of its action on the air, where it is fastest. */
    windrow_law law;
    /* Strength over time. */
    windrow_envelope envelope;
    /* 0 */
    uint32_t reserved;
} windrow_vortex_motor;
WINDROW_C_API windrow_result windrow_vortex_motor_init(windrow_vortex_motor* motor, uint32_t struct_size);

/* Air that comes out of a ball or vanishes in it. */
/* Made by ./dev schema from OmniMotor. */
typedef struct windrow_omni_motor {
    uint32_t struct_size;
    /* [m] A number above 0, at most 1e6, default 2. Radius of the ball. */
    float radius;
    /* [m] Each component -1e12 to 1e12, default (0, 0, 0). Centre of the ball. */
    windrow_dvec3 position;
    /* [m/s] -10000 to 10000, default 5. Outward speed at the radius; negative draws in. */
    float speed;
    /* Strength over time. */
    windrow_envelope envelope;
    /* 0 */
    uint32_t reserved;
} windrow_omni_motor;
WINDROW_C_API windrow_result windrow_omni_motor_init(windrow_omni_motor* motor, uint32_t struct_size);

/* A burst. */
/* Made by ./dev schema from PressureMotor. */
typedef struct windrow_pressure_motor {
    uint32_t struct_size;
    /* [m] A number above 0, at most 1e6, default 2. Radius of the ball. */
    float radius;
    /* [m] Each component -1e12 to 1e12, default (0, 0, 0). Centre of the ball. */
    windrow_dvec3 position;
    /* [m/s] -10000 to 10000, default 20. Outward speed at the radius in the first moment; negative: an implosion. */
    float speed;
    /* [s] A number above 0, at most 1e9, default 0.2. T: duration of the outflow before the inflow. */
    float duration;
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
