// Scopes of the library in a host's profiler. A host that builds Windrow defines two macros in a header of its own and names it:
//
//     #define WINDROW_ZONE_BEGIN(name) nvtxRangePushA(name)      // name: a string literal, "windrow advection"
//     #define WINDROW_ZONE_END() nvtxRangePop()
//     cmake -D WINDROW_PROFILER_HEADER=/game/windrow_zones.h
//
// Zones nest and end on the thread that began them: the one that steps, follows or records. Without the header no code is made.
#pragma once

#ifdef WINDROW_PROFILER_HEADER
#include WINDROW_PROFILER_HEADER
#endif
#if defined(WINDROW_ZONE_BEGIN) != defined(WINDROW_ZONE_END)
#error "The header of WINDROW_PROFILER_HEADER defines one of WINDROW_ZONE_BEGIN(name) and WINDROW_ZONE_END(): define both."
#endif
#ifndef WINDROW_ZONE_BEGIN
#define WINDROW_ZONE_BEGIN(name) static_cast<void>(name)
#define WINDROW_ZONE_END() static_cast<void>(0)
#endif

namespace windrow::detail {

class Zone {
  public:
    explicit Zone([[maybe_unused]] const char* name) { WINDROW_ZONE_BEGIN(name); }
    ~Zone() { WINDROW_ZONE_END(); }
    Zone(const Zone&) = delete;
    Zone& operator=(const Zone&) = delete;
};

} // namespace windrow::detail
