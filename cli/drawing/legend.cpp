// The legend: what the frame's colours, arrows and marks mean, and where in the world the box is.
#include "cli/drawing/frame.h"
#include "cli/drawing/motor_marks.h"
#include "cli/drawing/outline.h"
#include "cli/drawing/overlay.h"
#include "cli/drawing/slice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace windrow::cli {
namespace {

inline constexpr double k_colour_bar_height = 118.0;

/// A force of the Beaufort scale: the speed where it begins and what it does on land, in two lines.
struct BeaufortForce {
    double from; ///< [m/s]
    std::string_view first, second;
};

// Limits as the World Meteorological Organization gives them, rounded to what 10-minute means are quoted in.
constexpr std::array<BeaufortForce, 13> k_beaufort{{
    {0.0, "calm", ""},
    {0.3, "smoke", "drifts"},
    {1.6, "leaves", "rustle"},
    {3.4, "twigs", "move"},
    {5.5, "branches", "move"},
    {8.0, "small trees", "sway"},
    {10.8, "large", "branches"},
    {13.9, "whole trees", "move"},
    {17.2, "twigs", "break"},
    {20.8, "branches", "break"},
    {24.5, "trees", "uprooted"},
    {28.5, "wide", "damage"},
    {32.7, "hurricane", ""},
}};

constexpr double k_bar_height = 18.0;

void draw_colour_bar(Canvas& canvas, const Rect& place, float scale, float largest) {
    constexpr std::string_view k_heading = "wind speed [m/s]", k_forces = "  over Beaufort force";
    canvas.words(k_heading, {place.x, place.y + 13.0}, {.size = 15.0, .colour = k_ink, .bold = true});
    const double heading = canvas.width_of(k_heading, 15.0, true), forces = canvas.width_of(k_forces, 13.0);
    // The longest words that there is room for.
    const std::string figure = brief(largest);
    const std::string most = "largest shown " + figure, beyond = most + ", beyond the scale";
    const double room = place.width - heading - 24.0;
    const auto fits = [&](std::string_view text) { return canvas.width_of(text, 13.0) <= room; };
    const std::string& shown = largest > scale && fits(beyond) ? beyond : fits(most) ? most : figure;
    canvas.words(shown, {place.right(), place.y + 13.0}, {.size = 13.0, .colour = k_dim_ink, .align = Align::right});
    if (forces + canvas.width_of(shown, 13.0) <= room)
        canvas.words(k_forces, {place.x + heading, place.y + 13.0}, {.size = 13.0, .colour = k_dim_ink});

    // The bar ends in a point: faster air has the last colour too.
    constexpr double k_point = 14.0;
    const Rect bar{place.x, place.y + 30.0, place.width - k_point, k_bar_height};
    const int width_px = std::max(2, static_cast<int>(std::lround(bar.width * canvas.unit())));
    const int height_px = std::max(1, static_cast<int>(std::lround(bar.height * canvas.unit())));
    Image ramp(width_px, height_px);
    for (int column = 0; column < width_px; ++column) {
        const Rgb8 colour = speed_colour((static_cast<float>(column) + 0.5f) / static_cast<float>(width_px));
        for (int row = 0; row < height_px; ++row)
            ramp.set(column, row, colour);
    }
    const Rect snapped{canvas.snapped(bar.x), canvas.snapped(bar.y), width_px / canvas.unit(), height_px / canvas.unit()};
    const std::array point{glm::dvec2(snapped.right(), snapped.y), glm::dvec2(place.right(), snapped.middle().y),
                           glm::dvec2(snapped.right(), snapped.bottom())};
    canvas.fill(point, to_colour(speed_colour(1.0f)));
    canvas.image(ramp, {snapped.x, snapped.y});
    const std::array outline{glm::dvec2(snapped.x, snapped.y), point[0], point[1], point[2],
                             glm::dvec2(snapped.x, snapped.bottom())};
    canvas.stroke(outline, {.colour = k_ink, .width = 1.0}, true);

    const auto x_of = [&](double speed) { return snapped.x + snapped.width * std::clamp(speed / scale, 0.0, 1.0); };
    if (largest > 0.0f && std::isfinite(largest)) {
        const double x = largest > scale ? place.right() - 4.0 : x_of(largest);
        const double y = snapped.y - 2.0;
        canvas.fill(std::array{glm::dvec2(x, y), glm::dvec2(x - 5.0, y - 8.0), glm::dvec2(x + 5.0, y - 8.0)}, k_ink);
    }

    AxisTicks ticks = make_ticks(0.0, scale, 46.0 * scale / snapped.width);
    const auto label = [&](double tick) { return scale >= 1e-4f && scale < 1e6f ? fixed(tick, ticks.decimals) : brief(tick); };
    const double widest = canvas.width_of(label(ticks.places.back()), 13.5) + 20.0;
    if (widest > 46.0)
        ticks = make_ticks(0.0, scale, widest * scale / snapped.width);
    for (const double tick : ticks.places) {
        canvas.stroke(std::array{glm::dvec2(x_of(tick), snapped.bottom()), glm::dvec2(x_of(tick), snapped.bottom() + 5.0)},
                      {.colour = k_ink, .width = 1.2});
        canvas.words(label(tick), {x_of(tick), snapped.bottom() + 18.0}, {.size = 13.5, .colour = k_ink, .align = Align::centre});
    }

    // Forces as a row of brackets, with as many words as each has room for.
    const double top = snapped.bottom() + 29.0;
    const Words words{.size = 12.0, .colour = k_dim_ink, .align = Align::centre};
    for (std::size_t force = 0; force < k_beaufort.size(); ++force) {
        const double from = k_beaufort[force].from;
        const double to = force + 1 < k_beaufort.size() ? k_beaufort[force + 1].from : 1e9;
        if (from >= scale)
            break;
        const double left = x_of(from) + 1.5, right = x_of(to) - 1.5;
        if (right - left < 3.0)
            continue;
        canvas.stroke(
            std::array{glm::dvec2(left, top + 4.0), glm::dvec2(left, top), glm::dvec2(right, top), glm::dvec2(right, top + 4.0)},
            {.colour = k_dim_ink, .width = 0.9});
        const double middle = 0.5 * (left + right), bracket = right - left + 2.0;
        const std::string number = std::to_string(force);
        const std::string numbered = number + "  " + std::string(k_beaufort[force].first);
        if (canvas.width_of(numbered, words.size) <= bracket &&
            canvas.width_of(k_beaufort[force].second, words.size) <= bracket) {
            canvas.words(numbered, {middle, top + 17.0}, words);
            canvas.words(k_beaufort[force].second, {middle, top + 31.0}, words);
        } else if (canvas.width_of(number, words.size) <= bracket) {
            canvas.words(number, {middle, top + 17.0}, words);
        }
    }
}

void draw_world_map(Canvas& canvas, const Rect& place, const SlicedAir& air, std::span<const Trail> trails,
                    std::span<const NamedMotor> motors) {
    const glm::dvec2 corner(air.origin.x, air.origin.z), extent(air.extent().x, air.extent().z);
    glm::dvec2 low = corner, high = corner + extent;
    for (const Trail& trail : trails) {
        // Half a box, and a cell for the rounding to whole cells.
        const glm::dvec2 around = trail.followed ? 0.5 * extent + static_cast<double>(air.box.cell_size) : glm::dvec2(0.0);
        for (const glm::dvec3& point : trail.points) {
            const glm::dvec2 at(point.x, point.z);
            if (!std::isfinite(at.x) || !std::isfinite(at.y))
                continue;
            low = glm::min(low, at - around);
            high = glm::max(high, at + around);
        }
    }
    const glm::dvec2 middle = 0.5 * (low + high), size = high - low;
    const double scale = std::min(place.width / size.x, place.height / size.y);
    const glm::dvec2 centre(place.x + 0.5 * size.x * scale, place.y + 0.5 * size.y * scale);
    const auto to_page = [&](glm::dvec2 world) { return centre + (world - middle) * scale; };

    const Rect land{centre.x - 0.5 * size.x * scale, centre.y - 0.5 * size.y * scale, size.x * scale, size.y * scale};
    canvas.fill(land, hex(0xEFEEE8));
    canvas.clip(land);
    for (const Trail& trail : trails) {
        std::vector<glm::dvec2> points;
        for (const glm::dvec3& point : trail.points) {
            const glm::dvec2 at = to_page({point.x, point.z});
            if (points.empty() || !(std::abs(at.x - points.back().x) + std::abs(at.y - points.back().y) < 0.5))
                points.push_back(at);
        }
        for (const auto& run : cut(points, land))
            canvas.stroke(run, {.colour = trail.followed ? k_ink : k_body, .width = trail.followed ? 1.4 : 1.1});
    }
    const glm::dvec2 from = to_page(corner), to = to_page(corner + extent);
    canvas.unclip();
    const Rect box{from.x, from.y, to.x - from.x, to.y - from.y};
    canvas.fill(box, hex(0x2B5C9E, 0.16));
    canvas.stroke(box, {.colour = hex(0x2B5C9E), .width = 1.6});
    const double dot = motors.size() > 40 ? 1.6 : 2.6;
    for (const NamedMotor& motor : motors) {
        const glm::dvec3 position = position_of(motor.motor);
        const glm::dvec2 at = to_page({position.x, position.z});
        if (land.contains(at))
            canvas.fill_circle(at, dot, style_of(motor.motor).colour);
    }
    for (const Trail& trail : trails) {
        const glm::dvec2 at = to_page({trail.now.x, trail.now.z});
        if (!land.contains(at))
            continue;
        canvas.fill_circle(at, 3.6, k_paper);
        canvas.fill_circle(at, 2.6, trail.followed ? k_ink : k_body);
    }
    canvas.stroke(land, {.colour = k_hairline, .width = 1.0});
}

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
    if (input.flow == scene::FlowMarks::streamlines) {
        const Rect sample{place.x, row, 62.0, 22.0};
        canvas.fill(sample, to_colour(speed_colour(0.35f)), 3.0);
        std::vector<glm::dvec2> points;
        for (int n = 0; n <= 24; ++n)
            points.push_back({sample.x + 6.0 + 2.0 * n, sample.middle().y + 4.0 * std::sin(0.25 * n)});
        draw_streamline(canvas, points, [](glm::dvec2) { return speed_colour(0.35f); });
        canvas.words("streamline", {place.x, row + 40.0}, {.size = 13.0, .colour = k_ink});
        return;
    }
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
    if (const std::size_t count = input.air.obstacles.size(); count > 0)
        row("obstacle", count > 1 ? "  " + std::to_string(count) : "", [&](const Rect& s) {
            canvas.fill(s.grown(-4.0), k_obstacle);
            canvas.stroke(s.grown(-4.0), {.colour = k_ink, .width = 1.4});
        });
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
    if (input.trails.empty() && !any && input.air.obstacles.empty())
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
