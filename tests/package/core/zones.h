// The host's profiler, as Windrow's files see it.
#pragma once

extern "C" void game_zone_begin(const char* name);
extern "C" void game_zone_end();

#define WINDROW_ZONE_BEGIN(name) game_zone_begin(name)
#define WINDROW_ZONE_END() game_zone_end()
