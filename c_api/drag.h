/*
 * Deposits of drag: plants, hedges, fences and nets that slow the air (fluid/drag_field.h).
 *
 *     windrow_belt_drag hedge;
 *     windrow_drag_id planted;
 *     windrow_belt_drag_init(&hedge, sizeof hedge);
 *     hedge.height = 3.0f;
 *     windrow_wind_add_belt_drag(wind, &hedge, &planted);
 */
#ifndef WINDROW_C_API_DRAG_H
#define WINDROW_C_API_DRAG_H

#include "base.h"
#include "wind.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Handle of a deposit of one wind; all 0 names none. */
typedef struct windrow_drag_id {
    uint32_t slot, generation, owner;
} windrow_drag_id;

/* Made by ./dev schema from DragDeposit. */
typedef int32_t windrow_drag_kind;
enum { WINDROW_DRAG_PLANT = 0, WINDROW_DRAG_BELT = 1 };

/* A plant, or anything porous that a box along the axes surrounds: a bush, a crown, a net. */
/* Made by ./dev schema from PlantDrag. */
typedef struct windrow_plant_drag {
    uint32_t struct_size;
    /* [m] A number above 0, at most 10000, default 1. Half of its width along x and z. Below one cell its drag is spread over
       two cells. */
    float radius;
    /* [m] Each component -1e12 to 1e12, default (0, 0, 0). Its foot. */
    windrow_dvec3 position;
    /* [m] 0 to 10000, default 0. Height of its lowest leaves over its foot, below `height`: 0 for a bush, the bare stem of a
       tree. */
    float base;
    /* [m] A number above 0, at most 10000, default 2. Height of its top over its foot. */
    float height;
    /* [m^2] 0 (none) to 1e6, default 2. Drag area: drag coefficient times frontal area, of all leaves and twigs together. The
       default is half of the default's front of 4 m^2. */
    float area;
    /* 0 */
    uint32_t reserved;
} windrow_plant_drag;
WINDROW_C_API windrow_result windrow_plant_drag_init(windrow_plant_drag* plant, uint32_t struct_size);

/* A hedge, a row of trees, a fence, a net: a strip between two places. */
/* Made by ./dev schema from BeltDrag. */
typedef struct windrow_belt_drag {
    uint32_t struct_size;
    /* [m] A number above 0, at most 10000, default 2. Thickness, across its length. Below two cells its drag is spread over
       two cells. */
    float width;
    /* [m] Each component -1e12 to 1e12, default (-5, 0, 0). Its foot at one end. */
    windrow_dvec3 start;
    /* [m] Each component -1e12 to 1e12, default (5, 0, 0). Its foot at the other end, 1 mm to 1e4 m away along x and z.
       Between them the foot rises evenly. */
    windrow_dvec3 end;
    /* [m] A number above 0, at most 10000, default 2. Height over its foot. */
    float height;
    /* 0 (none) to 10000, default 2. Sum of c across its thickness, half of the pressure loss coefficient of a screen: 2 is a
       fence that is half open (Wilson 1985). */
    float resistance;
} windrow_belt_drag;
WINDROW_C_API windrow_result windrow_belt_drag_init(windrow_belt_drag* belt, uint32_t struct_size);

/* --- The deposits of a wind, at most 262144 ------------------------------------------------------------------------------ */

/* `id` may be null. */
WINDROW_C_API windrow_result windrow_wind_add_plant_drag(windrow_wind* wind, const windrow_plant_drag* plant,
                                                         windrow_drag_id* id);
WINDROW_C_API windrow_result windrow_wind_add_belt_drag(windrow_wind* wind, const windrow_belt_drag* belt, windrow_drag_id* id);
/* `count` plants, one after the other: all of them or, where one is rejected, none. `ids` has room for as many, or is null. */
WINDROW_C_API windrow_result windrow_wind_add_plants(windrow_wind* wind, const windrow_plant_drag* plants, uint64_t count,
                                                     windrow_drag_id* ids);
/* Replaces a deposit whole; its kind may change. */
WINDROW_C_API windrow_result windrow_wind_set_plant_drag(windrow_wind* wind, windrow_drag_id id, const windrow_plant_drag* plant);
WINDROW_C_API windrow_result windrow_wind_set_belt_drag(windrow_wind* wind, windrow_drag_id id, const windrow_belt_drag* belt);
/* The deposit as it is; rejected where it is of another kind. */
WINDROW_C_API windrow_result windrow_wind_get_plant_drag(const windrow_wind* wind, windrow_drag_id id, windrow_plant_drag* plant);
WINDROW_C_API windrow_result windrow_wind_get_belt_drag(const windrow_wind* wind, windrow_drag_id id, windrow_belt_drag* belt);
/* WINDROW_STALE for an id that names no deposit. */
WINDROW_C_API windrow_result windrow_wind_drag_kind(const windrow_wind* wind, windrow_drag_id id, windrow_drag_kind* kind);
WINDROW_C_API windrow_result windrow_wind_remove_drag(windrow_wind* wind, windrow_drag_id id);
WINDROW_C_API int32_t windrow_wind_drag_count(const windrow_wind* wind);

/* What the air does to a deposit. */
typedef struct windrow_drag_force {
    uint32_t struct_size;
    windrow_vec3 force; /* [N] */
    float in_box;       /* fraction of its drag area that the force is of: the rest is outside of the cells that are read */
} windrow_drag_force;
WINDROW_C_API windrow_result windrow_drag_force_init(windrow_drag_force* force, uint32_t struct_size);
/* Of the cells as they are after the last step or tick; on a device of those that came back last, which it needs. */
WINDROW_C_API windrow_result windrow_wind_drag_force_on(const windrow_wind* wind, windrow_drag_id id, windrow_drag_force* force);

#ifdef __cplusplus
}
#endif

#endif
