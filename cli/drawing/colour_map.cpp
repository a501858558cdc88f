#include "cli/drawing/colour_map.h"

#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/trigonometric.hpp>
#include <span>

namespace windrow::cli {
namespace {

/// One anchor of a map: lightness, colourfulness and hue of OKLab in polar form.
struct Anchor {
    double lightness, chroma, hue_deg;
};

// Equal steps of lightness; chroma stays inside sRGB all the way, so that no channel is cut and no band appears.
constexpr std::array k_speed_anchors{
    Anchor{0.170, 0.050, 272.0}, // ink
    Anchor{0.329, 0.110, 266.0}, // blue
    Anchor{0.488, 0.108, 243.0}, // sea blue
    Anchor{0.647, 0.109, 190.0}, // teal
    Anchor{0.806, 0.140, 145.0}, // leaf
    Anchor{0.965, 0.105, 108.0}, // straw
};

constexpr std::array k_signed_anchors{
    Anchor{0.300, 0.095, 262.0}, // deep blue
    Anchor{0.520, 0.120, 250.0}, // blue
    Anchor{0.740, 0.085, 240.0}, // sky
    Anchor{0.960, 0.006, 90.0},  // paper
    Anchor{0.740, 0.110, 60.0},  // sand
    Anchor{0.520, 0.125, 45.0},  // rust
    Anchor{0.300, 0.085, 32.0},  // deep rust
};

glm::dvec3 lab_of(const Anchor& anchor) {
    const double hue = glm::radians(anchor.hue_deg);
    return {anchor.lightness, anchor.chroma * std::cos(hue), anchor.chroma * std::sin(hue)};
}

glm::dvec3 to_linear_rgb(glm::dvec3 lab) {
    const double l = std::pow(lab.x + 0.3963377774 * lab.y + 0.2158037573 * lab.z, 3.0);
    const double m = std::pow(lab.x - 0.1055613458 * lab.y - 0.0638541728 * lab.z, 3.0);
    const double s = std::pow(lab.x - 0.0894841775 * lab.y - 1.2914855480 * lab.z, 3.0);
    return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s, //
            -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s, -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

std::uint8_t encode(double linear) {
    const double held = glm::clamp(linear, 0.0, 1.0);
    const double coded = held <= 0.0031308 ? 12.92 * held : 1.055 * std::pow(held, 1.0 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(coded * 255.0));
}

double decode(std::uint8_t coded) {
    const double value = coded / 255.0;
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

/// The anchors joined in OKLab by a Catmull-Rom curve: no kink at an anchor, which the eye would read as an edge in the air.
glm::dvec3 lab_at(std::span<const Anchor> anchors, double share) {
    const int last = static_cast<int>(anchors.size()) - 1;
    const double place = glm::clamp(share, 0.0, 1.0) * last;
    const int from = glm::clamp(static_cast<int>(place), 0, last - 1);
    const double t = place - from;
    const auto anchor = [&](int index) {
        if (index < 0)
            return 2.0 * lab_of(anchors[0]) - lab_of(anchors[1]);
        if (index > last)
            return 2.0 * lab_of(anchors[last]) - lab_of(anchors[last - 1]);
        return lab_of(anchors[index]);
    };
    const glm::dvec3 a = anchor(from - 1), b = anchor(from), c = anchor(from + 1), d = anchor(from + 2);
    return b + 0.5 * t * (c - a + t * (2.0 * a - 5.0 * b + 4.0 * c - d + t * (3.0 * (b - c) + d - a)));
}

/// Fine enough that the nearest entry is the exact colour.
constexpr int k_entries = 2048;
using Table = std::array<Rgb8, k_entries>;

Table make_table(std::span<const Anchor> anchors) {
    Table table;
    for (int entry = 0; entry < k_entries; ++entry) {
        const glm::dvec3 rgb = to_linear_rgb(lab_at(anchors, entry / (k_entries - 1.0)));
        table[entry] = {encode(rgb.x), encode(rgb.y), encode(rgb.z)};
    }
    return table;
}

Rgb8 look_up(const Table& table, float share) {
    if (!(share > 0.0f)) // NaN too, but callers draw that in k_broken_colour
        return table.front();
    if (share >= 1.0f)
        return table.back();
    return table[static_cast<std::size_t>(share * (k_entries - 1) + 0.5f)];
}

} // namespace

Rgb8 speed_colour(float share) {
    static const Table table = make_table(k_speed_anchors);
    return look_up(table, share);
}

Rgb8 signed_colour(float share) {
    static const Table table = make_table(k_signed_anchors);
    return look_up(table, 0.5f * share + 0.5f);
}

glm::dvec3 to_oklab(Rgb8 colour) {
    const double r = decode(colour[0]), g = decode(colour[1]), b = decode(colour[2]);
    const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s, //
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s, 0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

} // namespace windrow::cli
