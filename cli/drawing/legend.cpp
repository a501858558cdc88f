#include "cli/drawing/legend.h"

#include "cli/drawing/axes.h"
#include "cli/drawing/colour_bar.h"
#include "cli/drawing/colour_map.h"
#include "cli/drawing/motor_marks.h"
#include "cli/drawing/motor_style.h"
#include "cli/drawing/overlay.h"
#include "cli/drawing/palette.h"
#include "cli/drawing/text.h"
#include "cli/drawing/world_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

namespace windrow::cli {
namespace {

constexpr double k_row_height = 204.0;
constexpr double k_row_gap = 14.0;
constexpr double k_block_gap = 18.0;
constexpr std::array k_block_widths{130.0, 132.0, 178.0, 116.0}; // ambient, sizes, signs, map

struct Places {
    Rect bar;
    std::vector<Rect> blocks;

    [[nodiscard]] double bottom() const { return std::max(bar.bottom(), blocks.back().bottom()); }
};

/// The colour bar with the blocks below it in rows, or beside it where there is width for both. The last block of a row takes
/// what is left of it.
Places places_in(const Rect& legend) {
    double all_blocks = -k_block_gap;
    for (const double block : k_block_widths)
        all_blocks += block + k_block_gap;
    const bool beside = legend.width >= 2.0 * all_blocks;
    const double bar_width = beside ? 0.5 * (legend.width - 2.0 * k_block_gap) : legend.width;
    Places places{{legend.x, legend.y, bar_width, k_colour_bar_height}, {}};

    const double left = beside ? legend.x + bar_width + 2.0 * k_block_gap : legend.x;
    double x = left, y = beside ? legend.y : legend.y + k_colour_bar_height + k_row_gap;
    const auto end_row = [&] { places.blocks.back().width = legend.right() - places.blocks.back().x; };
    for (const double block : k_block_widths) {
        if (x > left && x + block > legend.right() + 0.5) {
            end_row();
            x = left;
            y += k_row_height + k_row_gap;
        }
        places.blocks.push_back({x, y, block, k_row_height});
        x += block + k_block_gap;
    }
    end_row();
    return places;
}

void draw_heading(Canvas& canvas, const Rect& place, std::string_view text) {
    canvas.stroke(std::array{glm::dvec2(place.x, place.y), glm::dvec2(place.right(), place.y)},
                  {.colour = k_hairline, .width = 1.0});
    canvas.words(text, {place.x, place.y + 19.0}, {.size = 13.5, .colour = k_ink, .bold = true});
}

void draw_ambient(Canvas& canvas, const Rect& place, const LegendInput& input) {
    draw_heading(canvas, place, "ambient wind");
    const glm::dvec3 ambient(input.air.ambient);
    constexpr double k_radius = 42.0;
    const glm::dvec2 middle(place.x + 0.5 * std::min(place.width, 138.0) - 6.0, place.y + 78.0);
    canvas.fill_circle(middle, k_radius, to_colour(speed_colour(static_cast<float>(glm::length(ambient)) / input.scale)));
    canvas.stroke_circle(middle, k_radius, {.colour = k_ink, .width = 1.0});
    for (int quarter = 0; quarter < 4; ++quarter) {
        const glm::dvec2 way(quarter == 0 ? 1.0 : quarter == 1 ? -1.0 : 0.0, quarter == 2 ? 1.0 : quarter == 3 ? -1.0 : 0.0);
        canvas.stroke(std::array{middle + way * k_radius, middle + way * (k_radius + 5.0)}, {.colour = k_ink, .width = 1.2});
    }
    canvas.words("x", middle + glm::dvec2(k_radius + 9.0, 4.5), {.size = 13.0, .colour = k_ink});
    canvas.words("z", middle + glm::dvec2(0.0, k_radius + 17.0), {.size = 13.0, .colour = k_ink, .align = Align::centre});

    const glm::dvec2 level(ambient.x, ambient.z);
    const double speed = glm::length(level);
    const Rgb8 air = speed_colour(static_cast<float>(glm::length(ambient)) / input.scale);
    // Not to the scale of the arrows on the slices: there a breeze would be a stub.
    if (speed > 0.0)
        draw_wind_arrow(canvas, middle, level / speed, 2.0 * k_radius * std::clamp(0.35 + 0.5 * speed / input.scale, 0.35, 0.85),
                        air);
    else
        draw_wind_arrow(canvas, middle, {}, 0.0, air);
    std::string text = glm::length(ambient) > 0.0 ? brief(glm::length(ambient)) + " m/s" : std::string("calm");
    if (std::abs(ambient.y) > 1e-3)
        text += std::string(ambient.y > 0.0 ? ", up " : ", down ") + brief(std::abs(ambient.y));
    canvas.words(text, {middle.x, place.y + 160.0}, {.size = 14.0, .colour = k_ink, .align = Align::centre});
    double base = place.y + 180.0;
    const auto note = [&](const std::string& words) {
        canvas.words(canvas.fitted(words, 13.0, place.width), {middle.x, base},
                     {.size = 13.0, .colour = k_dim_ink, .align = Align::centre});
        base += 18.0;
    };
    if (input.air.profile_height > 0.0f)
        note(brief(input.air.profile_height) + " m above ground");
    if (input.air.gust_intensity > 0.0f)
        note("gusts of " + brief(100.0 * static_cast<double>(input.air.gust_intensity)) + " %");
}

/// A length of 1, 2 or 5 times a power of ten that is at most `most`.
double round_length(double most) {
    const double power = std::pow(10.0, std::floor(std::log10(most)));
    for (const double factor : {5.0, 2.0})
        if (factor * power <= most)
            return factor * power;
    return power;
}

void draw_sizes(Canvas& canvas, const Rect& place, const LegendInput& input) {
    draw_heading(canvas, place, "sizes");
    const double scale = input.layout.level.scale.x;
    const double metres = round_length(std::min(140.0, place.width) / scale);
    const double bar = metres * scale, y = place.y + 42.0;
    // Half black, half open, as on a map.
    canvas.fill(Rect{place.x, y, bar, 7.0}, k_ink);
    canvas.fill(Rect{place.x + 0.5 * bar, y + 1.2, 0.5 * bar - 1.2, 4.6}, k_paper);
    canvas.words(brief(metres) + " m", {place.x, y + 23.0}, {.size = 13.5, .colour = k_ink});

    const double cell = input.air.box.cell_size * scale;
    const double shown = std::min(cell, 30.0);
    if (cell >= 2.0 && cell <= 30.0)
        canvas.stroke(Rect{place.x + 0.5, place.y + 84.0 - 0.5 * shown, shown, shown}, {.colour = k_ink, .width = 1.0});
    canvas.words("cell " + brief(input.air.box.cell_size, 4) + " m",
                 {place.x + (cell >= 2.0 && cell <= 30.0 ? shown + 9.0 : 0.0), place.y + 89.0}, {.size = 13.5, .colour = k_ink});

    const double page_scale = std::min(input.layout.level.scale.x, input.layout.level.scale.y);
    const double spacing = arrow_spacing(input.air.box.cell_size, k_arrow_spacing / page_scale) * page_scale;
    const double reach = k_arrow_reach * std::min(spacing, 2.0 * k_arrow_spacing);
    const double row = place.y + 116.0;
    canvas.fill(Rect{place.x, row, reach + 14.0, 44.0}, to_colour(speed_colour(0.35f)), 3.0);
    for (const double share : {1.0, 0.5}) {
        const double height = row + (share == 1.0 ? 13.0 : 31.0);
        draw_wind_arrow(canvas, {place.x + 7.0 + 0.5 * reach * share, height}, {1.0, 0.0}, reach * share, speed_colour(0.35f));
        canvas.words(brief(input.scale * share) + " m/s", {place.x + reach + 22.0, height + 4.8},
                     {.size = 13.0, .colour = k_ink});
    }
}

/// A small picture of each kind, as it looks on a slice.
void draw_kind(Canvas& canvas, const Rect& sample, std::size_t kind) {
    const Colour colour = k_motor_styles[kind].colour;
    const glm::dvec2 m = sample.middle();
    const Line line = on_air(colour, 1.6);
    const auto arrow = [&](double from, double to) {
        canvas.stroke(std::array{glm::dvec2(m.x + from, m.y), glm::dvec2(m.x + to - 4.0, m.y)}, {.colour = colour, .width = 2.2});
        canvas.fill(
            std::array{glm::dvec2(m.x + to, m.y), glm::dvec2(m.x + to - 6.0, m.y - 4.0), glm::dvec2(m.x + to - 6.0, m.y + 4.0)},
            colour);
    };
    switch (kind) {
    case 0:
        canvas.stroke(Rect{m.x - 13.0, m.y - 7.0, 26.0, 14.0}, line, 7.0);
        arrow(-8.0, 9.0);
        break;
    case 1:
        canvas.fill_circle(m, 6.5, colour.faded(0.28));
        canvas.stroke_circle(m, 6.5, line);
        break;
    case 2:
        canvas.stroke(std::array{m + glm::dvec2(-13, -3), m + glm::dvec2(13, -8), m + glm::dvec2(13, 8), m + glm::dvec2(-13, 3)},
                      line, true);
        arrow(-9.0, 10.0);
        break;
    case 3:
        draw_turning_arrows(canvas, m, 5.5, false, colour);
        break;
    case 4:
        draw_radial_arrows(canvas, m, 9.0, true, colour);
        break;
    default:
        canvas.stroke(star(m, 8.0), line, true);
        break;
    }
}

void draw_signs(Canvas& canvas, const Rect& place, const LegendInput& input) {
    draw_heading(canvas, place, "signs");
    double y = place.y + 41.0;
    const auto row = [&](const std::string& text, const std::string& more, auto&& draw) {
        if (y > place.bottom())
            return;
        const Rect sample{place.x, y - 10.0, 36.0, 20.0};
        canvas.fill(sample, to_colour(speed_colour(0.3f)), 3.0);
        canvas.clip(sample);
        draw(sample);
        canvas.unclip();
        const double left = place.x + 44.0;
        const std::string fitted = canvas.fitted(text, 13.0, place.right() - left);
        canvas.words(fitted, {left, y + 4.8}, {.size = 13.0, .colour = k_ink});
        const double end = left + canvas.width_of(fitted, 13.0);
        if (end + canvas.width_of(more, 12.0) <= place.right())
            canvas.words(more, {end, y + 4.8}, {.size = 12.0, .colour = k_dim_ink});
        y += 20.5;
    };
    const auto line_of = [](Colour colour, double dash) {
        return Line{.colour = colour, .width = 2.0, .dash = dash, .gap = 4.0, .casing = k_casing, .casing_width = 1.2};
    };
    if (input.broken_air) // first: nothing else counts then
        row("air is no number", "", [&](const Rect& s) { canvas.fill(s, to_colour(k_broken_colour), 3.0); });
    if (std::any_of(input.trails.begin(), input.trails.end(), [](const Trail& trail) { return trail.followed; }))
        row("the box follows it", "", [&](const Rect& s) { draw_player(canvas, s.middle()); });
    if (!input.trails.empty())
        row("path: past, to come", "", [&](const Rect& s) {
            const double mid = s.middle().y;
            canvas.stroke(std::array{glm::dvec2(s.x + 3.0, mid), glm::dvec2(s.middle().x - 1.0, mid)}, line_of(k_player, 0.0));
            canvas.stroke(std::array{glm::dvec2(s.middle().x + 2.0, mid), glm::dvec2(s.right() - 2.0, mid)},
                          line_of(k_player, 4.0));
        });
    MotorCounts acting{};
    for (const NamedMotor& motor : input.motors)
        ++acting[motor.motor.index()];
    bool any = false;
    for (std::size_t kind = 0; kind < acting.size(); ++kind) {
        const int all = std::max(acting[kind], input.motors_of_scene[kind]);
        if (all == 0)
            continue;
        any = true;
        // Many of a kind are one row: how many act now, of how many in the scene.
        row(k_motor_styles[kind].name, all > 1 ? "  " + std::to_string(acting[kind]) + "/" + std::to_string(all) : "",
            [&](const Rect& s) { draw_kind(canvas, s, kind); });
    }
    if (any)
        row("dashed: off the slice", "",
            [&](const Rect& s) { canvas.stroke(s.grown(-4.5), line_of(k_motor_styles[0].colour, 5.0), 4.0); });
    if (input.trails.empty() && !any)
        canvas.words("no motors, no paths", {place.x, y + 4.8}, {.size = 13.0, .colour = k_dim_ink});
}

} // namespace

double legend_height(double width) {
    return places_in({0.0, 0.0, width, 0.0}).bottom();
}

void draw_legend(Canvas& canvas, const LegendInput& input) {
    const Places places = places_in(input.layout.legend);
    draw_colour_bar(canvas, places.bar, input.scale, input.largest);
    draw_ambient(canvas, places.blocks[0], input);
    draw_sizes(canvas, places.blocks[1], input);
    draw_signs(canvas, places.blocks[2], input);
    draw_heading(canvas, places.blocks[3], "where the box is");
    const Rect& block = places.blocks[3];
    draw_world_map(canvas, {block.x, block.y + 30.0, block.width, 142.0}, input.air, input.trails, input.motors);
}

} // namespace windrow::cli
