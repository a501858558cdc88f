// The debug view of wind.h.
#include "fluid/debug_lines.h"

#include "c_api/source/tables.h"
#include "c_api/wind.h"

#include <type_traits>

using namespace windrow;
using namespace windrow::c_api;

WINDROW_C_INIT(windrow_debug_view)

WINDROW_EXPORT windrow_result windrow_wind_debug_lines(const windrow_wind* wind, const windrow_debug_view* view,
                                                       windrow_debug_draw draw, void* user) {
    return call({{wind, "wind"}}, [&]() -> windrow_result {
        if (draw == nullptr)
            return fail_null("draw");
        const auto lines = [&](const DebugView& wanted) {
            return debug_lines(*wind->control, *wind->reader, wanted, [&](const DebugLine& line) {
                const windrow_debug_line shown{.begin = {line.from.x, line.from.y, line.from.z},
                                               .end = {line.to.x, line.to.y, line.to.z},
                                               .kind = static_cast<windrow_debug_kind>(line.kind),
                                               .speed = line.speed};
                draw(user, &shown);
            });
        };
        return view == nullptr ? done(lines({})) : with(view, lines);
    });
}
