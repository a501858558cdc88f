/*
 * Windrow in C: the wind in a box that follows a player, for every language that calls C.
 *
 *     windrow_config config;
 *     windrow_wind* wind = NULL;
 *     windrow_config_init(&config, sizeof config);
 *     config.ambient.x = 3.0f;
 *     if (windrow_wind_create(&config, &wind) != WINDROW_OK)
 *         return puts(windrow_last_error()), 2;
 *     windrow_wind_follow(wind, player);
 *     windrow_wind_advance(wind, 1.0 / 60.0, NULL, NULL);
 *     windrow_wind_velocity(wind, leaf, &velocity);
 *     windrow_wind_destroy(wind);
 *
 * Right-handed, y up, metres and seconds. Positions are double. docs/c_api.md has the rules of memory, threads, errors and
 * versions. Each call is one of the C++ API; the C++ headers document ranges, defaults and behaviour in full.
 */
#ifndef WINDROW_WINDROW_H
#define WINDROW_WINDROW_H

#include "c_api/ambient.h"
#include "c_api/base.h"
#include "c_api/config.h"
#include "c_api/drag.h"
#include "c_api/event_log.h"
#include "c_api/motion.h"
#include "c_api/motors.h"
#include "c_api/obstacles.h"
#include "c_api/operators.h"
#include "c_api/plants.h"
#include "c_api/scene.h"
#include "c_api/shader_blocks.h"
#include "c_api/tracer.h"
#include "c_api/vdb.h"
#include "c_api/vulkan_ground.h"
#include "c_api/vulkan_host.h"
#include "c_api/vulkan_wind.h"
#include "c_api/wind.h"

#endif
