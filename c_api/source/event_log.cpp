// Calls of event_log.h.
#include "fluid/event_log.h"

#include "c_api/event_log.h"
#include "c_api/source/tables.h"

using namespace windrow;
using namespace windrow::c_api;

WINDROW_EXPORT windrow_result windrow_event_log_create(windrow_event_log** log) {
    return create(log, []() -> Result<EventLog> { return EventLog{}; });
}
WINDROW_EXPORT void windrow_event_log_destroy(windrow_event_log* log) {
    delete log;
}
WINDROW_EXPORT uint64_t windrow_event_log_count(const windrow_event_log* log) {
    return value_of(log, "log", [&] { return static_cast<uint64_t>(log->log.events().size()); });
}
WINDROW_EXPORT int32_t windrow_event_log_complete(const windrow_event_log* log) {
    return value_of(log, "log", [&] { return log->log.complete() ? 1 : 0; });
}
WINDROW_EXPORT windrow_result windrow_event_log_clear(windrow_event_log* log) {
    return call({{log, "log"}}, [&]() -> Result<void> {
        log->log.clear();
        return {};
    });
}
WINDROW_EXPORT windrow_result windrow_event_log_to_bytes(const windrow_event_log* log, windrow_bytes** bytes) {
    if (bytes != nullptr)
        *bytes = nullptr;
    return call({{log, "log"}}, [&] { return create(bytes, [&] { return log->log.to_bytes(); }); });
}
WINDROW_EXPORT windrow_result windrow_event_log_from_bytes(const void* bytes, uint64_t size, windrow_event_log** log) {
    if (log != nullptr)
        *log = nullptr;
    return call({{bytes, "bytes"}}, [&] {
        return create(log, [&] {
            return EventLog::from_bytes({static_cast<const std::byte*>(bytes), static_cast<std::size_t>(size)});
        });
    });
}
WINDROW_EXPORT windrow_result windrow_event_log_replay(const windrow_event_log* log, windrow_wind* wind) {
    return call({{log, "log"}, {wind, "wind"}}, [&]() -> windrow_result {
        if (wind->cpu == nullptr)
            return fail(WINDROW_UNSUPPORTED,
                        "windrow_event_log_replay is for winds on the CPU: call windrow_vulkan_wind_replay.");
        return done(replay(log->log, *wind->cpu));
    });
}
