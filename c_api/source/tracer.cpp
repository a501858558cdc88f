// Calls of tracer.h.
#include "fluid/tracer.h"

#include "c_api/source/tables.h"
#include "c_api/tracer.h"

using namespace windrow;
using namespace windrow::c_api;

struct windrow_tracer {
    Tracer tracer;
};

namespace {
Error needs_cpu() {
    return Error{"a tracer is carried by a wind on the CPU: sample the textures of a wind on a device in a shader."};
}
} // namespace

WINDROW_EXPORT windrow_result windrow_tracer_create(const windrow_wind* wind, const windrow_parallel_for* parallel_for,
                                                    windrow_tracer** tracer) {
    if (tracer != nullptr)
        *tracer = nullptr;
    return call({{wind, "wind"}}, [&] {
        return create(tracer, [&]() -> Result<Tracer> {
            if (wind->cpu == nullptr)
                return needs_cpu();
            return Tracer::create(wind->cpu->view(), loop_of(parallel_for));
        });
    });
}
WINDROW_EXPORT windrow_result windrow_tracer_save(const windrow_tracer* tracer, windrow_bytes** bytes) {
    return tracer == nullptr ? fail_null("tracer") : create(bytes, [&] { return tracer->tracer.save(); });
}
WINDROW_EXPORT windrow_result windrow_tracer_load(const void* bytes, uint64_t size, const windrow_wind* wind,
                                                  const windrow_parallel_for* parallel_for, windrow_tracer** tracer) {
    if (tracer != nullptr)
        *tracer = nullptr;
    return call({{bytes, "bytes"}, {wind, "wind"}}, [&] {
        return create(tracer, [&]() -> Result<Tracer> {
            if (wind->cpu == nullptr)
                return needs_cpu();
            return Tracer::load({static_cast<const std::byte*>(bytes), static_cast<std::size_t>(size)}, wind->cpu->view(),
                                wind->cpu->obstacles().in_reach(), loop_of(parallel_for));
        });
    });
}
WINDROW_EXPORT void windrow_tracer_destroy(windrow_tracer* tracer) {
    delete tracer;
}
WINDROW_EXPORT windrow_result windrow_tracer_step(windrow_tracer* tracer, const windrow_wind* wind, double dt) {
    return call({{tracer, "tracer"}, {wind, "wind"}}, [&]() -> Result<void> {
        if (wind->cpu == nullptr)
            return needs_cpu();
        return tracer->tracer.step(wind->cpu->view(), wind->cpu->obstacles().in_reach(), dt);
    });
}
WINDROW_EXPORT windrow_result windrow_tracer_blow(windrow_tracer* tracer, windrow_dvec3 point, float radius) {
    return call({{tracer, "tracer"}}, [&]() -> Result<void> {
        tracer->tracer.blow(to_cpp(point), radius);
        return {};
    });
}
WINDROW_EXPORT const float* windrow_tracer_cells(const windrow_tracer* tracer, uint64_t* count) {
    return value_of(tracer, "tracer", [&] {
        if (count != nullptr)
            *count = tracer->tracer.cells().size();
        return tracer->tracer.cells().data();
    });
}
