#include "cli/drawing/overlay.h"

#include "cli/drawing/colour_map.h"
#include "cli/drawing/names.h"
#include "cli/drawing/outline.h"
#include "cli/drawing/palette.h"
#include "cli/drawing/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace windrow::cli {
namespace {

bool finite(glm::dvec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

Line on_air(Colour colour, double width) {
    return {.colour = colour, .width = width, .casing = k_casing, .casing_width = 1.4};
}

/// A slender arrow as a shape of seven corners.
std::array<glm::dvec2, 7> arrow_shape(glm::dvec2 tail, glm::dvec2 direction, double length, double shaft, double head,
                                      double head_width) {
    const glm::dvec2 across(-direction.y, direction.x);
    const glm::dvec2 neck = tail + direction * (length - head);
    return {tail + across * (0.5 * shaft), neck + across * (0.5 * shaft),      neck + across * (0.5 * head_width),
            tail + direction * length,     neck - across * (0.5 * head_width), neck - across * (0.5 * shaft),
            tail - across * (0.5 * shaft)};
}

std::string law_of(const DirectionalMotor& motor) {
    if (const auto* drive = std::get_if<Drive>(&motor.law))
        return brief(drive->speed) + " m/s";
    return brief(std::get<Force>(motor.law).acceleration) + " m/s\xc2\xb2";
}

/// The place of a name for something that covers most of the panel: by its middle, not at the panel's rim.
Rect name_anchor(const Rect& visible, glm::dvec2 middle, const Rect& room) {
    if (visible.width < 0.7 * room.width || visible.height < 0.7 * room.height)
        return visible;
    return {middle.x - 20.0, middle.y - 20.0, 40.0, 40.0};
}

/// What is drawn on one panel, and what is still to be named there.
struct Overlay {
    Canvas& canvas;
    const Panel& panel;
    std::vector<Name> bodies, devices; ///< bodies are named first: they move, and a reader looks for them
    std::vector<Rect> kept_free;
};

void draw_directional(Overlay& overlay, const std::string& name, const DirectionalMotor& motor) {
    const Rect& room = overlay.panel.rect;
    const std::vector<glm::dvec2> outline = outline_of(motor.region, motor.position, overlay.panel);
    const Runs runs = cut(outline, room.grown(8.0));
    const Rect whole = bounds_of({outline}, {-1e300, -1e300, 2e300, 2e300});
    if (shared_area(whole, room) <= 0.0)
        return; // beyond the box as this panel sees it
    // Solid where the plane cuts the region; dashed where it lies before or behind.
    const bool cut_by_plane = cuts(overlay.panel, motor.region, motor.position);
    Line line = on_air(k_motor, 2.0);
    if (!cut_by_plane) {
        line.dash = 5.0;
        line.gap = 4.0;
    }
    for (const auto& run : runs)
        overlay.canvas.stroke(run, line);

    // In its region's middle; where that lies beyond the panel, shorter and in the middle of what is seen of the region.
    const Rect visible = bounds_of({outline}, room);
    glm::dvec2 middle = overlay.panel.to_page(motor.position);
    const double longest = std::clamp(0.8 * std::min(room.width, room.height), 24.0, 76.0);
    double length = std::clamp(0.55 * std::min(whole.width, whole.height), 24.0, longest);
    if (!room.contains(middle)) {
        length = 26.0;
        middle = visible.middle();
    }
    const double inset = std::min({0.5 * length + 3.0, 0.5 * room.width, 0.5 * room.height});
    const Rect inner = room.grown(-inset);
    middle = glm::clamp(middle, glm::dvec2(inner.x, inner.y), glm::dvec2(inner.right(), inner.bottom()));
    draw_motor_arrow(overlay.canvas, overlay.panel, middle, motor.direction, length);
    overlay.kept_free.push_back({middle.x - 18.0, middle.y - 18.0, 36.0, 36.0});
    overlay.devices.push_back({name, law_of(motor), k_motor, name_anchor(visible, middle, room)});
}

void draw_wake(Overlay& overlay, const std::string& name, const WakeMotor& motor, bool named_elsewhere) {
    const Rect& room = overlay.panel.rect;
    const std::vector<glm::dvec2> outline = outline_of(Sphere{motor.radius}, motor.position, overlay.panel);
    const Rect whole = bounds_of({outline}, {-1e300, -1e300, 2e300, 2e300});
    if (shared_area(whole.grown(4.0), room) <= 0.0)
        return;
    const glm::dvec2 middle = overlay.panel.to_page(motor.position);
    // A body small on the page still gets a disc that can be seen.
    const double radius = 0.5 * std::min(whole.width, whole.height);
    if (radius < 5.0)
        overlay.canvas.fill_circle(middle, 5.0, k_wake);
    Line line = on_air(k_wake, 2.0);
    if (!cuts(overlay.panel, Sphere{motor.radius}, motor.position)) {
        line.dash = 4.0;
        line.gap = 3.0;
    }
    if (radius >= 5.0 && radius < 2000.0)
        overlay.canvas.fill(outline, k_wake.faded(0.28));
    for (const auto& run : cut(outline, room.grown(8.0)))
        overlay.canvas.stroke(run, line);
    const Rect visible = bounds_of({outline}, room);
    overlay.kept_free.push_back(visible);
    if (!named_elsewhere)
        overlay.bodies.push_back({name, "", k_wake, name_anchor(visible, middle, room)});
}

void draw_trail(Overlay& overlay, const Trail& trail) {
    const Rect room = overlay.panel.rect.grown(12.0);
    const PathParts parts = split_path(trail.points, trail.now, overlay.panel);
    const Colour colour = trail.followed ? k_player : k_wake;
    Line line = on_air(colour, 2.2);
    for (const auto& run : cut(parts.past, room))
        overlay.canvas.stroke(run, line);
    line = on_air(colour.faded(0.9), 1.8);
    line.dash = 7.0;
    line.gap = 6.0;
    for (const auto& run : cut(parts.future, room))
        overlay.canvas.stroke(run, line);
}

void draw_trail_head(Overlay& overlay, const Trail& trail, bool named_elsewhere) {
    if (!finite(trail.now))
        return;
    const glm::dvec2 at = overlay.panel.to_page(trail.now);
    if (!overlay.panel.rect.contains(at))
        return;
    const Rect around{at.x - 12.0, at.y - 12.0, 24.0, 24.0};
    if (trail.followed) {
        draw_player(overlay.canvas, at);
        overlay.kept_free.push_back(around);
        overlay.bodies.insert(overlay.bodies.begin(), {trail.name, "", k_player, around}); // the first name always finds a place
    } else if (!named_elsewhere) {
        overlay.canvas.fill_circle(at, 6.5, k_casing);
        overlay.canvas.fill_circle(at, 5.0, k_wake);
        overlay.kept_free.push_back(around);
        overlay.bodies.push_back({trail.name, "", k_wake, around});
    }
}

} // namespace

void draw_wind_arrow(Canvas& canvas, glm::dvec2 middle, glm::dvec2 direction, double length, Rgb8 air) {
    const bool light_air = to_oklab(air).x > 0.66;
    const Colour colour = light_air ? hex(0x0D1B2A, 0.92) : hex(0xFFFFFF, 0.94);
    const Colour halo = light_air ? hex(0xFFFFFF, 0.22) : hex(0x05090F, 0.38);
    if (length < 2.5) {
        canvas.fill_circle(middle, 1.9, halo);
        canvas.fill_circle(middle, 1.2, colour);
        return;
    }
    const double head = std::clamp(0.4 * length, 3.6, 10.0);
    const auto shape = arrow_shape(middle - direction * (0.5 * length), direction, length, std::clamp(0.06 * length, 1.4, 2.1),
                                   head, 0.85 * head);
    canvas.stroke(shape, {.colour = halo, .width = 1.8}, true);
    canvas.fill(shape, colour);
}

void draw_arrows(Canvas& canvas, const Panel& panel, const Air& air, const Image& slice, float scale) {
    const double page_scale = std::min(panel.scale.x, panel.scale.y);
    const double spacing = arrow_spacing(air.box.cell_size, k_arrow_spacing / page_scale);
    const double reach = k_arrow_reach * std::min(spacing * page_scale, 2.0 * k_arrow_spacing);
    for (const WindArrow& arrow : slice_arrows(air, panel.plane, spacing, scale)) {
        const glm::dvec2 middle = panel.to_page(arrow.middle);
        const glm::dvec2 share =
            (middle - glm::dvec2(panel.rect.x, panel.rect.y)) / glm::dvec2(panel.rect.width, panel.rect.height);
        const int column = std::clamp(static_cast<int>(share.x * slice.width), 0, slice.width - 1);
        const int row = std::clamp(static_cast<int>(share.y * slice.height), 0, slice.height - 1);
        draw_wind_arrow(canvas, middle, panel.turned(arrow.direction), arrow.share * reach, slice.at(column, row));
    }
}

void draw_motor_arrow(Canvas& canvas, const Panel& panel, glm::dvec2 middle, glm::vec3 direction, double length) {
    const double size = glm::length(glm::dvec3(direction));
    if (!(size > 0.0) || !std::isfinite(size))
        return;
    const glm::dvec3 unit = glm::dvec3(direction) / size;
    const glm::dvec2 on_page = panel.turned(panel.plane.in_plane(unit));
    const double share = glm::length(on_page);
    if (share < 0.25) {
        const bool toward_reader = (unit[panel.plane.across()] > 0.0) != (panel.plane.normal == Normal::x);
        canvas.fill_circle(middle, 9.0, k_casing);
        canvas.stroke_circle(middle, 9.0, on_air(k_motor, 2.2));
        if (toward_reader) {
            canvas.fill_circle(middle, 3.2, k_motor);
        } else {
            constexpr double k_arm = 5.0;
            canvas.stroke(std::array{middle - glm::dvec2(k_arm), middle + glm::dvec2(k_arm)}, {.colour = k_motor, .width = 2.2});
            canvas.stroke(std::array{middle + glm::dvec2(-k_arm, k_arm), middle + glm::dvec2(k_arm, -k_arm)},
                          {.colour = k_motor, .width = 2.2});
        }
        return;
    }
    const double long_enough = std::max(length * share, 24.0);
    const glm::dvec2 way = on_page / share;
    const auto shape = arrow_shape(middle - way * (0.5 * long_enough), way, long_enough, 5.0, 14.0, 16.0);
    canvas.stroke(shape, {.colour = k_casing, .width = 3.2}, true);
    canvas.fill(shape, k_motor);
}

void draw_player(Canvas& canvas, glm::dvec2 at) {
    canvas.stroke_circle(at, 8.5, {.colour = k_player, .width = 2.6, .casing = k_casing, .casing_width = 1.8});
    for (const glm::dvec2 way : {glm::dvec2(1, 0), glm::dvec2(-1, 0), glm::dvec2(0, 1), glm::dvec2(0, -1)})
        canvas.stroke(std::array{at + way * 9.5, at + way * 14.5},
                      {.colour = k_player, .width = 2.6, .casing = k_casing, .casing_width = 1.8});
    canvas.fill_circle(at, 3.8, k_casing);
    canvas.fill_circle(at, 2.6, k_player);
}

void draw_things(Canvas& canvas, const Panel& panel, std::span<const Trail> trails, std::span<const NamedMotor> motors) {
    Overlay overlay{canvas, panel, {}, {}, {}};
    canvas.clip(panel.rect);
    for (const Trail& trail : trails)
        draw_trail(overlay, trail);
    for (const NamedMotor& motor : motors)
        if (const auto* directional = std::get_if<DirectionalMotor>(&motor.motor);
            directional != nullptr && finite(directional->position))
            draw_directional(overlay, printable(motor.name), *directional);
    // A body and its path have one name: the player's stands at his mark, any other's at the body.
    const auto has_body = [&](const Trail& trail) {
        return std::any_of(motors.begin(), motors.end(), [&](const NamedMotor& motor) {
            return motor.name == trail.name && std::holds_alternative<WakeMotor>(motor.motor);
        });
    };
    const auto is_followed = [&](const NamedMotor& motor) {
        return std::any_of(trails.begin(), trails.end(),
                           [&](const Trail& trail) { return trail.followed && trail.name == motor.name; });
    };
    for (const NamedMotor& motor : motors)
        if (const auto* wake = std::get_if<WakeMotor>(&motor.motor); wake != nullptr && finite(wake->position))
            draw_wake(overlay, printable(motor.name), *wake, is_followed(motor));
    canvas.unclip();
    // A mark may stand out of the panel: the player's feet are on the floor.
    for (const Trail& trail : trails)
        draw_trail_head(overlay, {printable(trail.name), {}, trail.now, trail.followed}, has_body(trail));
    std::vector<Name> names = std::move(overlay.bodies);
    names.insert(names.end(), overlay.devices.begin(), overlay.devices.end());
    draw_names(canvas, names, overlay.kept_free, panel.rect.grown(-5.0));
}

} // namespace windrow::cli
