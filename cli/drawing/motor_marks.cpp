#include "cli/drawing/motor_marks.h"

#include "cli/drawing/outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace windrow::cli {
namespace {

/// Of any length but 0; 0 stays 0.
glm::vec3 unit(glm::vec3 direction) {
    const float length = glm::length(direction);
    return length > 0.0f ? direction / length : glm::vec3(0.0f);
}

struct RegionOf {
    PlacedRegion operator()(const DirectionalMotor& motor) const { return {motor.region, motor.position}; }
    PlacedRegion operator()(const JetMotor& motor) const {
        return {Cone{motor.length * unit(motor.direction), motor.start_radius, motor.end_radius}, motor.position};
    }
    PlacedRegion operator()(const VortexMotor& motor) const {
        const glm::vec3 half = motor.half_length * unit(motor.axis);
        return {Cone{2.0f * half, motor.radius, motor.radius}, motor.position - glm::dvec3(half)};
    }
    PlacedRegion operator()(const auto& ball) const { return {Sphere{ball.radius}, ball.position}; }
};

std::string text_of(const std::variant<Force, Drive>& law) {
    if (const auto* drive = std::get_if<Drive>(&law))
        return brief(drive->speed) + " m/s";
    return brief(std::get<Force>(law).acceleration) + " m/s\xc2\xb2";
}

struct StrengthText {
    std::string operator()(const WakeMotor& /*its speed is its path's*/) const { return {}; }
    std::string operator()(const OmniMotor& motor) const { return brief(motor.speed) + " m/s"; }
    std::string operator()(const PressureMotor& motor) const { return brief(motor.speed) + " m/s"; }
    std::string operator()(const auto& motor) const { return text_of(motor.law); }
};

constexpr double k_size = 13.0;
constexpr double k_height = 21.0;
constexpr double k_stripe = 4.0;
constexpr double k_pad = 7.0;
constexpr double k_widest = 190.0;
constexpr double k_distance = 7.0; // between a thing and its name
constexpr std::size_t k_most = 40; // more names than this are a texture, not information

/// Places for a plate, the best first.
std::vector<Rect> candidates(const Rect& around, double width) {
    const glm::dvec2 m = around.middle();
    const double left = around.x - k_distance - width, right = around.right() + k_distance;
    const double above = around.y - k_distance - k_height, below = around.bottom() + k_distance;
    const double level = m.y - 0.5 * k_height, centred = m.x - 0.5 * width;
    std::vector<Rect> places;
    for (const glm::dvec2 corner :
         {glm::dvec2(right, level), glm::dvec2(centred, above), glm::dvec2(centred, below), glm::dvec2(left, level),
          glm::dvec2(right, above), glm::dvec2(right, below), glm::dvec2(left, above), glm::dvec2(left, below),
          // Within it: top, bottom and its four corners.
          glm::dvec2(centred, around.y + k_distance), glm::dvec2(centred, around.bottom() - k_distance - k_height),
          glm::dvec2(around.x + k_distance, around.y + k_distance),
          glm::dvec2(around.right() - k_distance - width, around.y + k_distance),
          glm::dvec2(around.x + k_distance, around.bottom() - k_distance - k_height),
          glm::dvec2(around.right() - k_distance - width, around.bottom() - k_distance - k_height),
          // Farther off.
          glm::dvec2(right + 16.0, above - 16.0), glm::dvec2(right + 16.0, below + 16.0), glm::dvec2(left - 16.0, above - 16.0),
          glm::dvec2(left - 16.0, below + 16.0)})
        places.push_back({corner.x, corner.y, width, k_height});
    return places;
}

constexpr double k_full_turn = 2.0 * std::numbers::pi;

bool finite(glm::dvec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void draw_head(Canvas& canvas, glm::dvec2 tip, glm::dvec2 way, double size, Colour colour) {
    const glm::dvec2 side(-way.y, way.x);
    const std::array corners{tip, tip - way * size + side * (0.52 * size), tip - way * size - side * (0.52 * size)};
    canvas.stroke(corners, {.colour = k_casing.faded(colour.alpha), .width = 2.4}, true);
    canvas.fill(corners, colour);
}

/// A line of points with a head at its end.
void draw_bent_arrow(Canvas& canvas, const std::vector<glm::dvec2>& points, double head, Colour colour) {
    const glm::dvec2 last = points.back() - points[points.size() - 2];
    const double length = glm::length(last);
    if (!(length > 0.0) || !std::isfinite(length))
        return;
    Line line = on_air(colour, 2.2);
    line.casing_width = 1.2;
    canvas.stroke(points, line);
    draw_head(canvas, points.back() + last * (0.7 * head / length), last / length, head, colour);
}

/// How a motor lies on the panel.
struct Sight {
    PlacedRegion placed;
    Runs runs;
    Rect whole, visible;
    glm::dvec2 middle{0.0}; ///< of the region, on the page
    bool cut = false;       ///< by the panel's plane
    Colour colour;
};

/// The place of a name for something that covers most of the panel: by its middle, not at the panel's rim.
Rect name_anchor(const Rect& visible, glm::dvec2 middle, const Rect& room) {
    if (visible.width < 0.7 * room.width || visible.height < 0.7 * room.height)
        return visible;
    return {middle.x - 20.0, middle.y - 20.0, 40.0, 40.0};
}

/// The point moved so far into the panel that a mark of a size has room.
glm::dvec2 held_within(glm::dvec2 point, const Rect& room, double size) {
    const Rect inner = room.grown(-std::min({0.5 * size + 3.0, 0.5 * room.width, 0.5 * room.height}));
    return glm::clamp(point, glm::dvec2(inner.x, inner.y), glm::dvec2(inner.right(), inner.bottom()));
}

// --- What a kind does ------------------------------------------------------------------------------------------------

/// One function a kind.
struct Sign {
    Marks& marks;
    const Sight& sight;
    double strength;

    /// An arrow in the region's middle; where that lies beyond the panel, shorter and in the middle of what is seen of it.
    void push(glm::vec3 direction, float amount) const {
        const Rect& room = marks.panel.rect;
        const double longest = std::clamp(0.8 * std::min(room.width, room.height), 24.0, marks.crowded ? 26.0 : 76.0);
        const double reach = std::max(0.5 * std::max(sight.whole.width, sight.whole.height),
                                      0.9 * std::min(sight.whole.width, sight.whole.height));
        double length = std::clamp(reach, marks.crowded ? 12.0 : 24.0, longest);
        glm::dvec2 middle = sight.middle;
        if (!room.contains(middle)) {
            length = std::min(length, 26.0);
            middle = sight.visible.middle();
        }
        middle = held_within(middle, room, length);
        draw_motor_arrow(marks.canvas, marks.panel, middle, amount < 0.0f ? -direction : direction, length, sight.colour);
        marks.kept_free.push_back({middle.x - 18.0, middle.y - 18.0, 36.0, 36.0});
    }

    static float amount_of(const std::variant<Force, Drive>& law) {
        return std::holds_alternative<Drive>(law) ? std::get<Drive>(law).speed : std::get<Force>(law).acceleration;
    }

    void operator()(const DirectionalMotor& motor) const { push(motor.direction, amount_of(motor.law)); }
    void operator()(const JetMotor& motor) const { push(motor.direction, amount_of(motor.law)); }

    void operator()(const WakeMotor& /*motor*/) const {
        const double radius = 0.5 * std::min(sight.whole.width, sight.whole.height);
        // A body small on the page still gets a disc that can be seen.
        if (radius < 5.0)
            marks.canvas.fill_circle(sight.middle, marks.crowded ? 3.5 : 5.0, sight.colour);
        marks.kept_free.push_back(sight.visible);
    }

    /// Along circles about the axis; from the side, along the half before the reader, seen a little from above.
    void operator()(const VortexMotor& motor) const {
        const double long_enough = glm::length(glm::dvec3(motor.axis));
        if (!(long_enough > 0.0) || !std::isfinite(long_enough))
            return;
        const glm::dvec3 axis = glm::dvec3(motor.axis) / long_enough * (amount_of(motor.law) < 0.0f ? -1.0 : 1.0);
        const Plane& plane = marks.panel.plane;
        const double toward_reader = plane.normal == Normal::x ? -axis.x : axis[plane.across()];
        const double scale = std::min(marks.panel.scale.x, marks.panel.scale.y);
        const double radius = std::clamp(0.55 * motor.radius * scale, 7.0, 90.0);
        const glm::dvec2 middle = held_within(sight.middle, marks.panel.rect, 20.0);
        if (std::abs(toward_reader) > 0.5) {
            // Right-handed about an axis toward the reader turns against the clock, whichever way the panel's axes grow.
            draw_turning_arrows(marks.canvas, middle, radius, toward_reader < 0.0, sight.colour);
            return;
        }
        const glm::dvec2 up = glm::normalize(marks.panel.turned(plane.in_plane(axis)));
        const glm::dvec2 way(-up.y, up.x); // the near side moves so: a quarter turn from the axis, clockwise on the page
        std::vector<glm::dvec2> arc;
        for (int index = 0; index <= 24; ++index) {
            const double angle = (index / 24.0 - 0.5) * 0.36 * k_full_turn;
            arc.push_back(middle + radius * (std::sin(angle) * way - 0.3 * std::cos(angle) * up));
        }
        draw_bent_arrow(marks.canvas, arc, std::clamp(0.5 * radius, 6.0, 12.0), sight.colour);
        marks.canvas.stroke(std::array{middle - up * radius, middle + up * radius},
                            {.colour = sight.colour, .width = 1.2, .dash = 3.0, .gap = 3.0});
    }

    void operator()(const OmniMotor& motor) const { radial(motor.speed > 0.0f); }
    void operator()(const PressureMotor& motor) const { radial((motor.speed > 0.0f) == (strength > 0.0)); }
    void radial(bool outward) const {
        const double radius = std::clamp(0.5 * std::min(sight.whole.width, sight.whole.height), 8.0, 60.0);
        draw_radial_arrows(marks.canvas, held_within(sight.middle, marks.panel.rect, 16.0), radius, outward, sight.colour);
    }
};

std::vector<glm::dvec2> outline_on(const Panel& panel, const Motor& motor, const PlacedRegion& placed) {
    if (const auto* burst = std::get_if<PressureMotor>(&motor)) {
        auto points = star(panel.to_page(burst->position), burst->radius * std::min(panel.scale.x, panel.scale.y));
        points.push_back(points.front());
        return points;
    }
    return outline_of(placed.region, placed.centre, panel);
}

} // namespace

PlacedRegion region_of(const Motor& motor) {
    return std::visit(RegionOf{}, motor);
}

std::string strength_text(const Motor& motor) {
    return std::visit(StrengthText{}, motor);
}

void draw_names(Canvas& canvas, const std::vector<Name>& names, const std::vector<Rect>& kept_free, const Rect& room) {
    std::vector<Rect> taken;
    for (const Name& name : names) {
        if (taken.size() >= k_most)
            break;
        const double widest = std::min(k_widest, room.width - 2.0 * k_pad - k_stripe);
        if (widest < 20.0)
            return;
        const std::string text = canvas.fitted(name.text.empty() ? "unnamed" : name.text, k_size, widest, true);
        const double text_width = canvas.width_of(text, k_size, true);
        std::string detail = name.detail.empty() ? std::string() : "  " + name.detail;
        double detail_width = canvas.width_of(detail, k_size - 1.0);
        if (text_width + detail_width > widest) {
            detail.clear();
            detail_width = 0.0;
        }
        const double width = text_width + detail_width + 2.0 * k_pad + k_stripe;

        Rect best;
        double best_cost = std::numeric_limits<double>::infinity();
        double order = 0.0;
        for (Rect place : candidates(name.around, width)) {
            const glm::dvec2 wanted(place.x, place.y);
            place.x = std::clamp(place.x, room.x, std::max(room.x, room.right() - place.width));
            place.y = std::clamp(place.y, room.y, std::max(room.y, room.bottom() - place.height));
            // A place costs its rank, being pushed back into the room, and whatever it covers.
            double cost = order + 2.0 * (std::abs(place.x - wanted.x) + std::abs(place.y - wanted.y));
            order += 3.0;
            for (const Rect& other : taken)
                cost += 100.0 * shared_area(place.grown(2.0), other);
            for (const Rect& free : kept_free)
                cost += 1.0 * shared_area(place, free);
            cost += 0.4 * shared_area(place, name.around);
            if (cost < best_cost) {
                best_cost = cost;
                best = place;
            }
        }
        const bool covers =
            std::any_of(taken.begin(), taken.end(), [&](const Rect& other) { return shared_area(best, other) > 0.0; });
        if (covers && !taken.empty())
            continue;
        taken.push_back(best);

        canvas.fill(best, k_plate, 3.0);
        canvas.fill(Rect{best.x, best.y, k_stripe, best.height}, name.colour);
        const double base = best.y + 0.5 * k_height + 0.36 * k_size;
        canvas.words(text, {best.x + k_stripe + k_pad, base}, {.size = k_size, .colour = hex(0xFFFFFF), .bold = true});
        canvas.words(detail, {best.x + k_stripe + k_pad + text_width, base}, {.size = k_size - 1.0, .colour = hex(0xC9D0DA)});
    }
}

Line on_air(Colour colour, double width) {
    return {.colour = colour, .width = width, .casing = k_casing.faded(colour.alpha), .casing_width = 1.4};
}

void draw_motor(Marks& marks, const NamedMotor& motor, bool named_elsewhere) {
    constexpr double k_faintest = 0.01; // of the full strength
    const double share = std::abs(motor.strength);
    if (!finite(position_of(motor.motor)) || !(share >= k_faintest))
        return;
    const Rect& room = marks.panel.rect;
    Sight sight;
    sight.placed = region_of(motor.motor);
    const std::vector<glm::dvec2> outline = outline_on(marks.panel, motor.motor, sight.placed);
    sight.whole = bounds_of({outline}, {-1e300, -1e300, 2e300, 2e300});
    const bool body = std::holds_alternative<WakeMotor>(motor.motor);
    if (shared_area(sight.whole.grown(body ? 4.0 : 0.0), room) <= 0.0)
        return; // beyond the box as this panel sees it
    sight.runs = cut(outline, room.grown(8.0));
    sight.visible = bounds_of({outline}, room);
    sight.middle = sight.whole.middle();
    sight.cut = cuts(marks.panel, sight.placed.region, sight.placed.centre);
    sight.colour = style_of(motor.motor).colour.faded(0.7 + 0.3 * std::sqrt(std::min(share, 1.0)));
    if (marks.crowded && !sight.cut) {
        marks.canvas.fill_circle(held_within(sight.middle, room, 0.0), 2.0, sight.colour.faded(0.8));
        return;
    }
    Line line = on_air(sight.colour, marks.crowded ? 1.4 : 2.0);
    if (!sight.cut) {
        line.dash = body ? 4.0 : 5.0;
        line.gap = body ? 3.0 : 4.0;
    }
    const double radius = 0.5 * std::min(sight.whole.width, sight.whole.height);
    if (body && radius >= 5.0 && radius < 2000.0)
        marks.canvas.fill(outline, sight.colour.faded(0.28));
    for (const auto& run : sight.runs)
        marks.canvas.stroke(run, line);
    std::visit(Sign{marks, sight, motor.strength}, motor.motor);
    if (named_elsewhere || marks.crowded)
        return;
    (body ? marks.bodies : marks.devices)
        .push_back({printable(motor.name), strength_text(motor.motor), style_of(motor.motor).colour,
                    name_anchor(sight.visible, held_within(sight.middle, room, 40.0), room)});
}

void draw_motor_arrow(Canvas& canvas, const Panel& panel, glm::dvec2 middle, glm::vec3 direction, double length, Colour colour) {
    const double size = glm::length(glm::dvec3(direction));
    if (!(size > 0.0) || !std::isfinite(size))
        return;
    const glm::dvec3 unit = glm::dvec3(direction) / size;
    const glm::dvec2 on_page = panel.turned(panel.plane.in_plane(unit));
    const double share = glm::length(on_page);
    const double ring = std::clamp(0.4 * length, 5.0, 9.0);
    if (share < 0.25) {
        const bool toward_reader = (unit[panel.plane.across()] > 0.0) != (panel.plane.normal == Normal::x);
        canvas.fill_circle(middle, ring, k_casing);
        canvas.stroke_circle(middle, ring, on_air(colour, 2.2));
        if (toward_reader) {
            canvas.fill_circle(middle, 0.36 * ring, colour);
        } else {
            const double arm = 0.55 * ring;
            canvas.stroke(std::array{middle - glm::dvec2(arm), middle + glm::dvec2(arm)}, {.colour = colour, .width = 2.2});
            canvas.stroke(std::array{middle + glm::dvec2(-arm, arm), middle + glm::dvec2(arm, -arm)},
                          {.colour = colour, .width = 2.2});
        }
        return;
    }
    const double long_enough = std::max(length * share, std::min(length, 24.0));
    const double head = std::min(14.0, 0.55 * long_enough), shaft = 0.36 * head;
    const glm::dvec2 way = on_page / share, side(-way.y, way.x);
    const glm::dvec2 tail = middle - way * (0.5 * long_enough), tip = middle + way * (0.5 * long_enough), neck = tip - way * head;
    const std::array shape{tail + side * (0.5 * shaft), neck + side * (0.5 * shaft), neck + side * (0.57 * head), tip,
                           neck - side * (0.57 * head), neck - side * (0.5 * shaft), tail - side * (0.5 * shaft)};
    canvas.stroke(shape, {.colour = k_casing.faded(colour.alpha), .width = 3.2}, true);
    canvas.fill(shape, colour);
}

void draw_radial_arrows(Canvas& canvas, glm::dvec2 middle, double radius, bool outward, Colour colour) {
    const double head = std::clamp(0.3 * radius, 4.5, 10.0), inner = 0.35 * radius, outer = 0.95 * radius;
    for (int index = 0; index < 8; ++index) {
        const double angle = k_full_turn * (index + 0.5) / 8.0;
        const glm::dvec2 way(std::cos(angle), std::sin(angle));
        const glm::dvec2 from = middle + way * (outward ? inner : outer), to = middle + way * (outward ? outer : inner);
        const glm::dvec2 ahead = outward ? way : -way;
        Line line = on_air(colour, 1.8);
        line.casing_width = 1.0;
        canvas.stroke(std::array{from, to - ahead * (0.8 * head)}, line);
        draw_head(canvas, to, ahead, head, colour);
    }
}

void draw_turning_arrows(Canvas& canvas, glm::dvec2 middle, double radius, bool clockwise, Colour colour) {
    const double head = std::clamp(0.5 * radius, 5.0, 12.0);
    for (int arrow = 0; arrow < 3; ++arrow) {
        std::vector<glm::dvec2> arc;
        for (int index = 0; index <= 16; ++index) {
            const double turn = arrow / 3.0 + 0.22 * index / 16.0;
            const double angle = k_full_turn * (clockwise ? turn : -turn); // the page's y runs down
            arc.push_back(middle + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
        }
        draw_bent_arrow(canvas, arc, head, colour);
    }
}

std::vector<glm::dvec2> star(glm::dvec2 middle, double radius) {
    std::vector<glm::dvec2> points;
    for (int index = 0; index < 32; ++index) {
        const double angle = k_full_turn * index / 32.0;
        points.push_back(middle + (index % 2 == 0 ? 1.0 : 0.84) * radius * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return points;
}

} // namespace windrow::cli
