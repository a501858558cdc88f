/* Logs of the calls that change a wind, and their replay (fluid/event_log.h). */
#ifndef WINDROW_C_API_EVENT_LOG_H
#define WINDROW_C_API_EVENT_LOG_H

#include "base.h"
#include "wind.h"

#ifdef __cplusplus
extern "C" {
#endif

WINDROW_C_API windrow_result windrow_event_log_create(windrow_event_log** log);
/* No wind records to it any more. */
WINDROW_C_API void windrow_event_log_destroy(windrow_event_log* log);
WINDROW_C_API uint64_t windrow_event_log_count(const windrow_event_log* log);
/* 0 where memory was missing for an event: it is neither written nor replayed. */
WINDROW_C_API int32_t windrow_event_log_complete(const windrow_event_log* log);
WINDROW_C_API windrow_result windrow_event_log_clear(windrow_event_log* log);
WINDROW_C_API windrow_result windrow_event_log_to_bytes(const windrow_event_log* log, windrow_bytes** bytes);
WINDROW_C_API windrow_result windrow_event_log_from_bytes(const void* bytes, uint64_t size, windrow_event_log** log);
/* Repeats all calls on a wind on the CPU, in the state in which the log began. Stops at the first call that fails; those before it
   have changed the wind. */
WINDROW_C_API windrow_result windrow_event_log_replay(const windrow_event_log* log, windrow_wind* wind);

#ifdef __cplusplus
}
#endif

#endif
