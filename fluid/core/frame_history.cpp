#include "fluid/core/frame_history.h"

#include <glm/common.hpp>

namespace windrow {
namespace {

// No gusts, the same mean wind and the same ground: both winds depend on height alone.
bool same_at_all_times(const AmbientWind& a, const AmbientWind& b) {
    return !a.gusting() && !b.gusting() && a.mean() == b.mean() && a.ground() == b.ground();
}

} // namespace

void FrameHistory::keep(const AirNow& now) {
    before_still = now.asleep;
    point_before = now.point;
    gust_phase_before = now.ambient.phase();
}

FrameBlend FrameHistory::show(const AirNow& now, double factor) {
    std::swap(shown, shown_before);
    FrameBlend blend{.factor = static_cast<float>(std::min(1.0, factor)), .still = now.asleep && before_still};
    blend.unchanged = blend.still && shown.still && same_at_all_times(shown.ambient, now.ambient) &&
                      (now.ambient.uniform() || shown.window.origin_cells.y == now.window.origin_cells.y);
    const auto between = static_cast<double>(blend.factor);
    shown = {now.window, glm::mix(point_before, now.point, between), now.ambient, blend.still};
    shown.ambient.set_phase(AmbientWind::between(gust_phase_before, now.ambient.phase(), between, now.ambient.period()));
    return blend;
}

} // namespace windrow
