#include "cli/drawing/colour_bar.h"

#include "cli/drawing/axes.h"
#include "cli/drawing/colour_map.h"
#include "cli/drawing/palette.h"
#include "cli/drawing/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

namespace windrow::cli {
namespace {

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

} // namespace

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
    const std::array rim{glm::dvec2(snapped.x, snapped.y), point[0], point[1], point[2], glm::dvec2(snapped.x, snapped.bottom())};
    canvas.stroke(rim, {.colour = k_ink, .width = 1.0}, true);

    const auto x_of = [&](double speed) { return snapped.x + snapped.width * std::clamp(speed / scale, 0.0, 1.0); };
    if (largest > 0.0f && std::isfinite(largest)) {
        const double x = largest > scale ? place.right() - 4.0 : x_of(largest);
        const double y = snapped.y - 2.0;
        canvas.fill(std::array{glm::dvec2(x, y), glm::dvec2(x - 5.0, y - 8.0), glm::dvec2(x + 5.0, y - 8.0)}, k_ink);
    }

    Ticks ticks = make_ticks(0.0, scale, 46.0 * scale / snapped.width);
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

} // namespace windrow::cli
