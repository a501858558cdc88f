#include "cli/drawing/overlay.h"

#include "cli/drawing/colour_map.h"
#include "cli/drawing/motor_marks.h"
#include "cli/drawing/outline.h"
#include "cli/drawing/palette.h"
#include "cli/drawing/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace windrow::cli {
namespace {

/// More motors than this are drawn small and without names.
constexpr std::size_t k_most_named = 24;

bool finite(glm::dvec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
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

void draw_trail(Marks& marks, const Trail& trail) {
    const Rect room = marks.panel.rect.grown(12.0);
    const PathParts parts = split_path(trail.points, trail.now, marks.panel);
    const Colour colour = trail.followed ? k_player : k_body;
    Line line = on_air(colour, 2.2);
    for (const auto& run : cut(parts.past, room))
        marks.canvas.stroke(run, line);
    line = on_air(colour.faded(0.9), 1.8);
    line.dash = 7.0;
    line.gap = 6.0;
    for (const auto& run : cut(parts.future, room))
        marks.canvas.stroke(run, line);
}

void draw_trail_head(Marks& marks, const Trail& trail, bool named_elsewhere) {
    if (!finite(trail.now))
        return;
    const glm::dvec2 at = marks.panel.to_page(trail.now);
    if (!marks.panel.rect.contains(at))
        return;
    const Rect around{at.x - 12.0, at.y - 12.0, 24.0, 24.0};
    if (trail.followed) {
        draw_player(marks.canvas, at);
        marks.kept_free.push_back(around);
        marks.bodies.insert(marks.bodies.begin(), {trail.name, "", k_player, around}); // the first name always finds a place
    } else if (!named_elsewhere) {
        marks.canvas.fill_circle(at, 6.5, k_casing);
        marks.canvas.fill_circle(at, 5.0, k_body);
        marks.kept_free.push_back(around);
        marks.bodies.push_back({trail.name, "", k_body, around});
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

void draw_player(Canvas& canvas, glm::dvec2 at) {
    canvas.stroke_circle(at, 8.5, {.colour = k_player, .width = 2.6, .casing = k_casing, .casing_width = 1.8});
    for (const glm::dvec2 way : {glm::dvec2(1, 0), glm::dvec2(-1, 0), glm::dvec2(0, 1), glm::dvec2(0, -1)})
        canvas.stroke(std::array{at + way * 9.5, at + way * 14.5},
                      {.colour = k_player, .width = 2.6, .casing = k_casing, .casing_width = 1.8});
    canvas.fill_circle(at, 3.8, k_casing);
    canvas.fill_circle(at, 2.6, k_player);
}

void draw_things(Canvas& canvas, const Panel& panel, std::span<const Trail> trails, std::span<const NamedMotor> motors) {
    Marks marks{
        .canvas = canvas, .panel = panel, .crowded = motors.size() > k_most_named, .bodies = {}, .devices = {}, .kept_free = {}};
    canvas.clip(panel.rect);
    for (const Trail& trail : trails)
        draw_trail(marks, trail);
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
    // Bodies last: they are small.
    for (const bool bodies : {false, true})
        for (const NamedMotor& motor : motors)
            if (std::holds_alternative<WakeMotor>(motor.motor) == bodies)
                draw_motor(marks, motor, bodies && is_followed(motor));
    canvas.unclip();
    // A mark may stand out of the panel: the player's feet are on the floor.
    for (const Trail& trail : trails)
        draw_trail_head(marks, {printable(trail.name), {}, trail.now, trail.followed}, marks.crowded || has_body(trail));
    std::vector<Name> names = std::move(marks.bodies);
    names.insert(names.end(), marks.devices.begin(), marks.devices.end());
    draw_names(canvas, names, marks.kept_free, panel.rect.grown(-5.0));
}

} // namespace windrow::cli
