// The debug view of wind.h, drawn by fluid/debug_draw.h.
#include "c_api/source/tables.h"
#include "c_api/wind.h"
#include "fluid/core/message.h"
#include "fluid/debug_draw.h"

#include <algorithm>
#include <glm/geometric.hpp>

using namespace windrow;
using namespace windrow::c_api;

WINDROW_C_INIT(windrow_debug_view)

namespace {

constexpr int k_most_arrows = 256, k_arrow_lines = 3;

Result<void> check(const DebugView& view) {
    if (view.arrows < 0 || view.arrows > k_most_arrows)
        return Error{detail::message("arrows is ", view.arrows, ": give 0 to ", k_most_arrows, " along the longer level axis.")};
    if (!(view.seconds > 0.0f && view.seconds <= 1e6f))
        return Error{detail::message("seconds is ", view.seconds, " s: give a time above 0, at most 1e6.")};
    if (!(view.height >= -1e6 && view.height <= 1e6))
        return Error{detail::message("height is ", view.height, " m: give a height from -1e6 to 1e6.")};
    return {};
}

Result<void> draw_lines(const WindControl& control, const WindReader& reader, const DebugView& view, windrow_debug_draw draw,
                        void* user) {
    if (auto valid = check(view); !valid)
        return valid;
    const auto of_kind = [&](windrow_debug_kind kind, const DebugDraw& settings) {
        int number = 0;
        float speed = 0.0f;
        debug_draw(control, reader, settings, {.line = [&](glm::dvec3 from, glm::dvec3 to, std::uint32_t) {
                       if (kind == WINDROW_DEBUG_ARROW && number++ % k_arrow_lines == 0) // the shaft
                           speed = static_cast<float>(glm::length(to - from)) / view.seconds;
                       const windrow_debug_line line{
                           .begin = {from.x, from.y, from.z}, .end = {to.x, to.y, to.z}, .kind = kind, .speed = speed};
                       draw(user, &line);
                   }});
    };
    const DebugDraw nothing{.box = false, .motors = false, .obstacles = false};
    DebugDraw one = nothing;
    one.box = view.box;
    of_kind(WINDROW_DEBUG_BOX, one);
    one = nothing;
    one.motors = view.motors;
    of_kind(WINDROW_DEBUG_MOTOR, one);
    one = nothing;
    one.obstacles = view.obstacles;
    of_kind(WINDROW_DEBUG_OBSTACLE, one);
    if (view.arrows == 0)
        return {};
    one = nothing;
    one.arrows = true;
    one.height = static_cast<float>(view.height);
    one.spacing = std::max(control.box().size().x, control.box().size().z) / static_cast<float>(view.arrows);
    one.speed = one.spacing / view.seconds;
    of_kind(WINDROW_DEBUG_ARROW, one);
    return {};
}

} // namespace

WINDROW_EXPORT windrow_result windrow_wind_debug_lines(const windrow_wind* wind, const windrow_debug_view* view,
                                                       windrow_debug_draw draw, void* user) {
    return call({{wind, "wind"}}, [&]() -> windrow_result {
        if (draw == nullptr)
            return fail_null("draw");
        const auto lines = [&](const DebugView& wanted) { return draw_lines(*wind->control, *wind->reader, wanted, draw, user); };
        return view == nullptr ? done(lines({})) : with(view, lines);
    });
}
