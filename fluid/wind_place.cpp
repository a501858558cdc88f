// Where the box lies, and what blows around it.
//
// A shift moves the air that stays inside to the bit; cells that it exposes hold the ambient wind, with no past. Around the box
// blows the mean wind, the same everywhere or by its profile, and gusts.
#include "fluid/wind_host.h"

#include <cmath>

namespace windrow {
namespace {

// Gusts have no component along an axis that a wall closes; the ground alone is their mirror, which they already respect.
glm::vec3 gust_axes(const Sides& sides) {
    return {sides.has_solid(0) ? 0.0f : 1.0f, sides.y_high.solid() ? 0.0f : 1.0f, sides.has_solid(2) ? 0.0f : 1.0f};
}

} // namespace

// --- The wind around the box ---------------------------------------------------------------------------------------------

void WindHost::renew_ambient() {
    ambient.set_gust_axes(gust_axes(config.sides));
    (void)ambient.set_mean(mean_wind());
    (void)ambient.set_ground(config.sides.y_low.solid() ? window.origin().y : 0.0);
    around_changed();
}

void WindHost::fill_with_ambient() {
    fill_cells();
    sources_of_air = 0;
    calm = true;
}

void WindHost::take_ambient_out() {
    if (!calm)
        add_ambient_to_cells(-1.0f);
}

void WindHost::put_ambient_in() {
    renew_ambient();
    if (calm) {
        fill_with_ambient();
        if (frames)
            fill_before();
    } else {
        add_ambient_to_cells(1.0f);
    }
    asleep = false;
}

void WindHost::change_ambient(glm::vec3 wind) {
    if (config.gusts.intensity > 0.0f) { // gusts are as strong as the mean wind: all of it changes
        take_ambient_out();
        config.ambient = wind;
        put_ambient_in();
        return;
    }
    const glm::vec3 before = mean_wind();
    config.ambient = wind;
    renew_ambient();
    asleep = false;
    add_change_to_cells(mean_wind() - before, calm);
    if (calm) // still ambient, and to the bit
        fill_with_ambient();
}

// --- Where the box lies -----------------------------------------------------------------------------------------------------

Rim WindHost::rim(glm::dvec3 point) const {
    Rim rim{.point = point, .reach = glm::vec3(0.0f), .width = config.rim};
    const float inset = frames ? 2.0f : 1.0f; // between ticks, the point is up to a tick behind the box
    for (int axis = 0; axis < 3; ++axis) {
        const float reach = 0.5f * static_cast<float>(window.cells[axis]) - inset;
        if (config.rim > 0.0f && follow_axes[axis] && reach >= config.rim + 1.0f)
            rim.reach[axis] = reach;
    }
    return rim;
}

void WindHost::follow_now(glm::dvec3 point) {
    CellIndex origin = window.centred_on(point);
    for (int axis = 0; axis < 3; ++axis)
        if (!follow_axes[axis])
            origin[axis] = window.origin_cells[axis];
    follow_point = point;
    shift_to(origin);
}

void WindHost::shift_to(CellIndex origin_cells) {
    const CellIndex shift = origin_cells - window.origin_cells;
    if (shift == CellIndex(0))
        return;
    if (shift.y != 0 && asleep && !ambient.uniform())
        asleep = false; // at another height, another wind to report
    // Gusts stand on the ground: where it moves, so do they, and what the air holds of them with it.
    const bool gusts_move = shift.y != 0 && config.sides.y_low.solid() && config.gusts.intensity > 0.0f && !calm;
    if (gusts_move)
        add_ambient_to_cells(-1.0f);
    window.origin_cells = origin_cells;
    renew_ambient();
    const bool beyond =
        std::abs(shift.x) >= window.cells.x || std::abs(shift.y) >= window.cells.y || std::abs(shift.z) >= window.cells.z;
    if (beyond || calm) {
        if (beyond || !ambient.uniform())
            fill_with_ambient();
        if (frames && !(frames->before_still && ambient.uniform()))
            fill_before();
        return;
    }
    shift_cells(shift, !gusts_move);
    if (gusts_move)
        add_ambient_to_cells(1.0f);
}

} // namespace windrow
