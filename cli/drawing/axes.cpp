#include "cli/drawing/axes.h"

#include "cli/drawing/palette.h"
#include "cli/drawing/text.h"

#include <algorithm>
#include <array>
#include <cmath>

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

/// What a side is shows in its line: a wall is thick, open air thin, a periodic side dashed.
Line line_of(const Side& side) {
    if (side.solid())
        return {.colour = k_ink, .width = 4.0};
    if (side.kind == SideKind::periodic)
        return {.colour = k_ink, .width = 1.6, .dash = 7.0, .gap = 4.0};
    return {.colour = k_ink, .width = 1.0};
}

void draw_outline(Canvas& canvas, const Panel& panel, const Sides& sides) {
    const auto edge = [&](const Side& side, glm::dvec2 from, glm::dvec2 to, glm::dvec2 outward) {
        const Line line = line_of(side);
        const glm::dvec2 shift = outward * 0.5 * line.width;
        // Lengthened by its own width, so that the corners close.
        const glm::dvec2 along = {outward.y != 0.0 ? line.width : 0.0, outward.x != 0.0 ? line.width : 0.0};
        canvas.stroke(std::array{from + shift - along * 0.5, to + shift + along * 0.5}, line);
    };
    const Rect& r = panel.rect;
    const int right = panel.plane.right(), along = panel.plane.along_height();
    const int top_end = panel.plane.grows_upward() ? 1 : 0;
    edge(sides.at(right, 0), {r.x, r.y}, {r.x, r.bottom()}, {-1.0, 0.0});
    edge(sides.at(right, 1), {r.right(), r.y}, {r.right(), r.bottom()}, {1.0, 0.0});
    edge(sides.at(along, top_end), {r.x, r.y}, {r.right(), r.y}, {0.0, -1.0});
    edge(sides.at(along, 1 - top_end), {r.x, r.bottom()}, {r.right(), r.bottom()}, {0.0, 1.0});
}

struct PanelTicks {
    Ticks right, height;
};

PanelTicks ticks_of(Canvas& canvas, const Panel& panel) {
    Ticks right = make_ticks(panel.low.x, panel.extent.x, 46.0 / panel.scale.x);
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

} // namespace

Ticks make_ticks(double low, double extent, double apart) {
    Ticks ticks;
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

void draw_axes(Canvas& canvas, const Panel& panel, const Sides& sides) {
    draw_outline(canvas, panel, sides);
    const Rect& r = panel.rect;
    const Line tick{.colour = k_ink, .width = 1.2};
    const Line small_tick{.colour = k_dim_ink, .width = 0.8};
    const Words label{.size = k_label_size, .colour = k_ink};
    constexpr double k_out = 5.0; // beyond the thickest outline

    const auto minor = [](const Ticks& ticks, double low, double extent, double scale) {
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

} // namespace windrow::cli
