#include "cli/drawing/overlay.h"

#include "cli/drawing/motor_marks.h"
#include "cli/drawing/outline.h"
#include "cli/drawing/sections.h"
#include "cli/drawing/slice.h"
#include "cli/drawing/streamlines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace windrow::cli {
namespace {

constexpr double k_label_size = 13.5;
constexpr double k_title_size = 15.0;

/// The smallest 1, 2 or 5 times a power of ten that is not below `least`.
double nice_step(double least) {
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= least * (1.0 - 1e-9))
            return factor * power;
    return 10.0 * power;
}

std::vector<double> multiples(double low, double extent, double step) {
    std::vector<double> places;
    const double slack = 1e-6 * step;
    const double first = std::ceil((low - slack) / step);
    for (int index = 0; index < 1000; ++index) {
        const double place = (first + index) * step;
        if (place > low + extent + slack)
            break;
        places.push_back(place);
    }
    return places;
}

std::string axis_title(int axis, double offset) {
    const std::string name(1, "xyz"[axis]);
    if (offset == 0.0)
        return name + " [m]";
    return name + (offset > 0.0 ? " \xe2\x88\x92 " : " + ") + fixed(std::abs(offset), 0) + " [m]";
}

/// What a side is shows in its line: a wall is thick, open air thin, a periodic boundary dashed.
Line line_of(const Boundary& side) {
    if (side.solid())
        return {.colour = k_ink, .width = 4.0};
    if (side.kind == BoundaryKind::periodic)
        return {.colour = k_ink, .width = 1.6, .dash = 7.0, .gap = 4.0};
    return {.colour = k_ink, .width = 1.0};
}

void draw_outline(Canvas& canvas, const Panel& panel, const Boundaries& boundaries) {
    const auto edge = [&](const Boundary& side, glm::dvec2 from, glm::dvec2 to, glm::dvec2 outward) {
        const Line line = line_of(side);
        const glm::dvec2 shift = outward * 0.5 * line.width;
        // Lengthened by its own width, so that the corners close.
        const glm::dvec2 along = {outward.y != 0.0 ? line.width : 0.0, outward.x != 0.0 ? line.width : 0.0};
        canvas.stroke(std::array{from + shift - along * 0.5, to + shift + along * 0.5}, line);
    };
    const Rect& r = panel.rect;
    const int right = panel.plane.right(), along = panel.plane.along_height();
    const int top_end = panel.plane.grows_upward() ? 1 : 0;
    edge(boundaries.at(right, 0), {r.x, r.y}, {r.x, r.bottom()}, {-1.0, 0.0});
    edge(boundaries.at(right, 1), {r.right(), r.y}, {r.right(), r.bottom()}, {1.0, 0.0});
    edge(boundaries.at(along, top_end), {r.x, r.y}, {r.right(), r.y}, {0.0, -1.0});
    edge(boundaries.at(along, 1 - top_end), {r.x, r.bottom()}, {r.right(), r.bottom()}, {0.0, 1.0});
}

struct PanelTicks {
    AxisTicks right, height;
};

PanelTicks ticks_of(Canvas& canvas, const Panel& panel) {
    AxisTicks right = make_ticks(panel.low.x, panel.extent.x, 46.0 / panel.scale.x);
    double widest = 0.0;
    for (const double place : right.places)
        widest = std::max(widest, canvas.width_of(fixed(place - right.offset, right.decimals), k_label_size));
    if (widest + 18.0 > right.step * panel.scale.x && right.places.size() > 1)
        right = make_ticks(panel.low.x, panel.extent.x, (widest + 18.0) / panel.scale.x);
    // One step on both axes, so that the ticks make squares, unless the box was stretched.
    const double stretch = panel.scale.y / panel.scale.x;
    const bool square = stretch > 0.98 && stretch < 1.02 && right.places.size() > 1;
    return {right, make_ticks(panel.low.y, panel.extent.y, square ? right.step : 36.0 / panel.scale.y)};
}

/// More motors than this are drawn small and without names.
constexpr std::size_t k_max_named = 24;

bool finite_point(glm::dvec3 v) {
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
    if (!finite_point(trail.now))
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

/// The names of the obstacles that the panel cuts. A name of several is no name.
void name_bodies(Marks& marks, const SlicedAir& air) {
    const auto of_that_name = [&](const std::string& name) {
        return std::count_if(air.obstacles.begin(), air.obstacles.end(),
                             [&](const NamedObstacle& obstacle) { return obstacle.name == name; });
    };
    if (air.obstacles.size() > k_max_named)
        return;
    for (const CutBody& body : bodies_at(air.obstacles, marks.panel.plane, air)) {
        const glm::dvec2 at = marks.panel.to_page(body.named->obstacle.position);
        if (body.named->name.empty() || !marks.panel.rect.contains(at) || of_that_name(body.named->name) > 1)
            continue;
        const Rect around{at.x - 8.0, at.y - 8.0, 16.0, 16.0};
        marks.devices.push_back({printable(body.named->name), "", k_obstacle, around});
    }
}

} // namespace

AxisTicks make_ticks(double low, double extent, double apart) {
    AxisTicks ticks;
    ticks.step = nice_step(apart);
    ticks.places = multiples(low, extent, ticks.step);
    // A strip thinner than a step: finer steps until one falls in, and only that one is kept.
    for (int finer = 0; finer < 12 && ticks.places.empty(); ++finer) {
        ticks.step = nice_step(0.45 * ticks.step);
        ticks.places = multiples(low, extent, ticks.step);
        if (ticks.places.size() > 1)
            ticks.places = {ticks.places[ticks.places.size() / 2]};
    }
    if (ticks.places.empty())
        ticks.places = {low};
    ticks.decimals = std::clamp(static_cast<int>(-std::floor(std::log10(ticks.step) + 1e-9)), 0, 9);
    // Far away a label would need more figures than fit: whole blocks of 1000 steps are taken off, seldom enough that a
    // sequence keeps its title for long.
    const double farthest = std::max(std::abs(low), std::abs(low + extent));
    if (farthest >= 1e4 && farthest / ticks.step >= 1e4) {
        const double block = std::max(1000.0 * ticks.step, 1.0);
        ticks.offset = std::floor((low + 0.5 * extent) / block) * block;
    }
    return ticks;
}

void draw_axes(Canvas& canvas, const Panel& panel, const Boundaries& boundaries) {
    draw_outline(canvas, panel, boundaries);
    const Rect& r = panel.rect;
    const Line tick{.colour = k_ink, .width = 1.2};
    const Line small_tick{.colour = k_dim_ink, .width = 0.8};
    const Words label{.size = k_label_size, .colour = k_ink};
    constexpr double k_out = 5.0; // beyond the thickest outline

    const auto minor = [](const AxisTicks& ticks, double low, double extent, double scale) {
        const double step = ticks.step / 5.0;
        return step * scale >= 6.0 ? multiples(low, extent, step) : std::vector<double>{};
    };

    Words centred = label;
    centred.align = Align::centre;
    const auto [right, height] = ticks_of(canvas, panel);
    for (const double place : minor(right, panel.low.x, panel.extent.x, panel.scale.x)) {
        const double x = panel.to_page({place, panel.low.y}).x;
        canvas.stroke(std::array{glm::dvec2(x, r.bottom() + k_out), glm::dvec2(x, r.bottom() + k_out + 3.0)}, small_tick);
    }
    for (const double place : right.places) {
        const double x = panel.to_page({place, panel.low.y}).x;
        canvas.stroke(std::array{glm::dvec2(x, r.bottom() + k_out), glm::dvec2(x, r.bottom() + k_out + 6.0)}, tick);
        canvas.words(fixed(place - right.offset, right.decimals), {x, r.bottom() + k_out + 20.0}, centred);
    }
    canvas.words(axis_title(panel.plane.right(), right.offset), {r.x + 0.5 * r.width, r.bottom() + k_out + 42.0},
                 {.size = k_title_size, .colour = k_ink, .align = Align::centre});

    Words flush = label;
    flush.align = Align::right;
    for (const double place : minor(height, panel.low.y, panel.extent.y, panel.scale.y)) {
        const double y = panel.to_page({panel.low.x, place}).y;
        canvas.stroke(std::array{glm::dvec2(r.x - k_out - 3.0, y), glm::dvec2(r.x - k_out, y)}, small_tick);
    }
    for (const double place : height.places) {
        const double y = panel.to_page({panel.low.x, place}).y;
        canvas.stroke(std::array{glm::dvec2(r.x - k_out - 6.0, y), glm::dvec2(r.x - k_out, y)}, tick);
        canvas.words(fixed(place - height.offset, height.decimals), {r.x - k_out - 10.0, y + 0.36 * k_label_size}, flush);
    }
    canvas.words(axis_title(panel.plane.along_height(), height.offset), {r.x - k_out - 47.0, r.y + 0.5 * r.height},
                 {.size = k_title_size, .colour = k_ink, .align = Align::centre, .upward = true});
}

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

namespace {

constexpr double k_head_distance = 96.0; // between heads along a streamline

/// The slice's colour at a place of the page.
Rgb8 colour_at(const Panel& panel, const Image& slice, glm::dvec2 place) {
    const glm::dvec2 share = (place - glm::dvec2(panel.rect.x, panel.rect.y)) / glm::dvec2(panel.rect.width, panel.rect.height);
    return slice.at(std::clamp(static_cast<int>(share.x * slice.width), 0, slice.width - 1),
                    std::clamp(static_cast<int>(share.y * slice.height), 0, slice.height - 1));
}

void draw_arrows(Canvas& canvas, const Panel& panel, const SlicedAir& air, std::span<const CutBody> bodies, const Image& slice,
                 float scale) {
    const double page_scale = std::min(panel.scale.x, panel.scale.y);
    const double spacing = arrow_spacing(air.box.cell_size, k_arrow_spacing / page_scale);
    const double reach = k_arrow_reach * std::min(spacing * page_scale, 2.0 * k_arrow_spacing);
    for (const WindArrow& arrow : slice_arrows(air, panel.plane, spacing, scale)) {
        if (inside_body(bodies, panel.plane.to_world(arrow.middle)))
            continue;
        const glm::dvec2 middle = panel.to_page(arrow.middle);
        draw_wind_arrow(canvas, middle, panel.turned(arrow.direction), arrow.share * reach, colour_at(panel, slice, middle));
    }
}

void draw_streamlines(Canvas& canvas, const Panel& panel, const SlicedAir& air, std::span<const CutBody> bodies,
                      const Image& slice, float scale) {
    const double spacing = k_streamline_spacing / std::min(panel.scale.x, panel.scale.y);
    constexpr double k_calm = 0.005; // of the scale
    for (const Streamline& line : streamlines(air, panel.plane, bodies, spacing, k_calm * static_cast<double>(scale))) {
        std::vector<glm::dvec2> points;
        for (const glm::dvec2 point : line)
            points.push_back(panel.to_page(point));
        draw_streamline(canvas, points, [&](glm::dvec2 place) { return colour_at(panel, slice, place); });
    }
}

} // namespace

void draw_streamline(Canvas& canvas, std::span<const glm::dvec2> points, const std::function<Rgb8(glm::dvec2)>& air) {
    const auto light = [&](glm::dvec2 place) { return to_oklab(air(place)).x > 0.66; };
    const auto colour = [](bool light_air) { return light_air ? hex(0x0D1B2A, 0.80) : hex(0xFFFFFF, 0.86); };
    const auto casing = [](bool light_air) { return light_air ? hex(0xFFFFFF, 0.14) : hex(0x05090F, 0.26); };
    double way = 0.0, next_head = 0.4 * k_head_distance;
    for (std::size_t first = 0; first + 1 < points.size();) { // runs over air that is light, or is not
        const bool over_light = light(points[first]);
        std::size_t last = first + 1;
        while (last + 1 < points.size() && light(points[last]) == over_light)
            ++last;
        canvas.stroke(points.subspan(first, last - first + 1),
                      {.colour = colour(over_light), .width = 1.35, .casing = casing(over_light), .casing_width = 0.9});
        for (std::size_t n = first + 1; n <= last; ++n) {
            const glm::dvec2 step = points[n] - points[n - 1];
            way += glm::length(step);
            if (way < next_head || !(glm::length(step) > 0.0))
                continue;
            const glm::dvec2 along = glm::normalize(step), across(-along.y, along.x), tip = points[n] + 4.0 * along;
            canvas.fill(std::array{tip, tip - 8.5 * along + 3.6 * across, tip - 6.5 * along, tip - 8.5 * along - 3.6 * across},
                        colour(over_light).faded(1.12));
            next_head += k_head_distance;
        }
        first = last;
    }
}

void draw_flow(Canvas& canvas, const Panel& panel, const SlicedAir& air, const Image& slice, float scale,
               scene::FlowMarks marks) {
    const std::vector<CutBody> bodies = bodies_at(air.obstacles, panel.plane, air);
    canvas.clip(panel.rect);
    if (marks == scene::FlowMarks::streamlines)
        draw_streamlines(canvas, panel, air, bodies, slice, scale);
    else
        draw_arrows(canvas, panel, air, bodies, slice, scale);
    for (const CutBody& body : bodies)
        if (const auto ends = cut_of(body, panel.plane))
            canvas.stroke(std::array{panel.to_page(ends->first), panel.to_page(ends->second)},
                          {.colour = k_ink, .width = 3.2, .casing = hex(0xFFFFFF, 0.75), .casing_width = 1.2});
    canvas.unclip();
}

void draw_player(Canvas& canvas, glm::dvec2 at) {
    canvas.stroke_circle(at, 8.5, {.colour = k_player, .width = 2.6, .casing = k_casing, .casing_width = 1.8});
    for (const glm::dvec2 way : {glm::dvec2(1, 0), glm::dvec2(-1, 0), glm::dvec2(0, 1), glm::dvec2(0, -1)})
        canvas.stroke(std::array{at + way * 9.5, at + way * 14.5},
                      {.colour = k_player, .width = 2.6, .casing = k_casing, .casing_width = 1.8});
    canvas.fill_circle(at, 3.8, k_casing);
    canvas.fill_circle(at, 2.6, k_player);
}

void draw_things(Canvas& canvas, const Panel& panel, const SlicedAir& air, std::span<const Trail> trails,
                 std::span<const NamedMotor> motors) {
    Marks marks{
        .canvas = canvas, .panel = panel, .crowded = motors.size() > k_max_named, .bodies = {}, .devices = {}, .kept_free = {}};
    canvas.clip(panel.rect);
    for (const Trail& trail : trails)
        draw_trail(marks, trail);
    // A body and its path have one name: the player's stands at his mark, any other's at the body.
    const auto has_body = [&](const Trail& trail) {
        return std::any_of(motors.begin(), motors.end(),
                           [&](const NamedMotor& motor) {
                               return motor.name == trail.name && std::holds_alternative<WakeMotor>(motor.motor);
                           }) ||
               std::any_of(air.obstacles.begin(), air.obstacles.end(),
                           [&](const NamedObstacle& obstacle) { return obstacle.name == trail.name; });
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
    name_bodies(marks, air);
    canvas.unclip();
    // A mark may stand out of the panel: the player's feet are on the floor.
    for (const Trail& trail : trails)
        draw_trail_head(marks, {printable(trail.name), {}, trail.now, trail.followed}, marks.crowded || has_body(trail));
    std::vector<Name> names = std::move(marks.bodies);
    names.insert(names.end(), marks.devices.begin(), marks.devices.end());
    draw_names(canvas, names, marks.kept_free, panel.rect.grown(-5.0));
}

} // namespace windrow::cli
