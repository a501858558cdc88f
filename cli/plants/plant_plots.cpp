#include "cli/plants/plant_plots.h"

#include "cli/drawing/palette.h"
#include "cli/plants/chart.h"
#include "coupling/blade.h"
#include "coupling/plant_classes.h"
#include "coupling/shell.h"
#include "fluid/ambient.h"
#include "scene/number_text.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>

namespace windrow::cli {
namespace {

constexpr double k_degrees = 180.0 / 3.14159265358979323846;

struct NamedPlant {
    const char* name;
    Drag drag;
    double height; // [m] where it meets the wind of the table
    double label;  // [degrees] its name moved in the plot, so that names do not meet
};

std::array<NamedPlant, 8> plants() {
    return {{{"grass", grass(), 0.2, 0.0},
             {"reed", reed(), 1.5, 0.0},
             {"wheat", wheat(), 0.6, 1.5},
             {"leaf", leaf(), 5.0, -1.5},
             {"twig", twig(), 5.0, 0.0},
             {"branch", branch(), 6.0, 0.0},
             {"small trunk", small_trunk(), 6.0, 0.0},
             {"large trunk", large_trunk(), 14.0, 0.0}}};
}

// A blade that is what its class says: no chance, no bend of its own.
Blades plain_blades() {
    return *Blades::create({.length_spread = 0.0f, .stiffness_spread = 0.0f, .own_bend = 0.0f, .own_bend_spread = 0.0f});
}

// The hill that shells grow on in the plot, and its normal. [m]
glm::dvec2 hill(double x) {
    return {x, 0.25 * std::exp(-std::pow(x / 0.3, 2.0))};
}
glm::dvec2 hill_normal(double x) {
    const double slope = -2.0 * x / 0.09 * hill(x).y;
    return glm::normalize(glm::dvec2(-slope, 1.0));
}

} // namespace

Plot bend_plot() {
    Plot plot{.width = 1000.0, .height = 640.0, .paper = k_paper, .title = "Bend against wind speed"};
    Chart chart(plot, {90.0, 60.0, 770.0, 500.0}, {"wind at the plant [m/s]", 0.0, 30.0, 5.0},
                {"lean of the tip [degrees]", 0.0, 90.0, 15.0});
    chart.add_axes("How far plants lean in a steady wind");
    std::size_t n = 0;
    for (const NamedPlant& plant : plants()) {
        std::vector<glm::dvec2> values;
        for (int i = 0; i <= 300; ++i) {
            const double speed = 0.1 * i;
            values.emplace_back(speed, static_cast<double>(bend_angle(plant.drag, static_cast<float>(speed))) * k_degrees);
        }
        const Colour colour = series_colour(n++);
        chart.add_line(values, {.colour = colour, .width = 2.2});
        chart.add_label(plant.name, values.back() + glm::dvec2(0.0, plant.label), colour);
    }
    return plot;
}

Plot blade_plot() {
    Plot plot{.width = 1120.0, .height = 520.0, .paper = k_paper, .title = "A blade at six wind speeds"};
    const Blades grass = plain_blades();
    constexpr std::array k_speeds{0.5f, 1.0f, 2.0f, 4.0f, 8.0f, 16.0f};
    Chart bent(plot, {90.0, 60.0, 440.0, 374.0}, {"downwind [m]", 0.0, 0.4, 0.1}, {"height [m]", 0.0, 0.34, 0.1});
    bent.add_axes("Bent: its length stays");
    Chart shifted(plot, {640.0, 60.0, 440.0, 374.0}, {"downwind [m]", 0.0, 0.4, 0.1}, {"height [m]", 0.0, 0.34, 0.1});
    shifted.add_axes("Translated by the same tip's way: it stretches");
    for (std::size_t n = 0; n < k_speeds.size(); ++n) {
        const glm::vec3 load = grass.load({0, 0}, {k_speeds[n], 0.0f, 0.0f});
        const auto at = [&](double h) {
            const glm::vec3 p = grass.vertex({0, 0}, load, static_cast<float>(h), 0.0f).position;
            return glm::dvec2(p.x, p.y);
        };
        std::vector<glm::dvec2> bend, shift;
        for (int i = 0; i <= 60; ++i) {
            const double h = i / 60.0;
            bend.push_back(at(h));
            shift.emplace_back(at(1.0).x * h * h, 0.3 * h);
        }
        const Colour colour = series_colour(n);
        bent.add_line(bend, {.colour = colour, .width = 2.4});
        shifted.add_line(shift, {.colour = colour, .width = 2.4});
        bent.add_label(scene::figure(static_cast<double>(k_speeds[n])) + (n == 0 ? " m/s" : ""), bend.back(), colour);
    }
    return plot;
}

Plot shell_plot() {
    Plot plot{.width = 1120.0, .height = 370.0, .paper = k_paper, .title = "Shells over a hill"};
    constexpr int k_shells = 9;
    const Shells fur = *Shells::create({.shells = k_shells,
                                        .length = 0.1f,
                                        .push = 0.012f,
                                        .push_exponent = 2.0f,
                                        .droop = 0.04f,
                                        .sag = 0.5f,
                                        .strand = {.length = 0.1f, .width = 4e-4f, .rigidity = 2e-6f, .drag_coefficient = 1.5f}});
    const glm::vec3 wind{7.0f, 0.0f, 0.0f};
    const char* const titles[] = {"Stems: bent by 7 m/s and by their weight", "Push h^2 and droop, inward parts removed"};
    for (int kind = 0; kind < 2; ++kind) {
        Chart chart(plot, {kind == 0 ? 90.0 : 640.0, 60.0, 440.0, 220.0}, {"downwind [m]", -0.5, 0.6, 0.25},
                    {"height [m]", 0.0, 0.55, 0.1});
        chart.add_axes(titles[kind]);
        const auto moved = [&](double x, int shell) {
            const glm::vec3 p(hill(x), 0.0f), n(hill_normal(x), 0.0f);
            const float h = fur.height(shell);
            const glm::vec3 q =
                kind == 0 ? fur.bent(p, n, h, 1.0f, fur.load(n, 1.0f, wind)) : fur.translated(p, n, h, 1.0f, wind);
            return glm::dvec2(q.x, q.y);
        };
        for (int shell = 0; shell < k_shells; ++shell) {
            std::vector<glm::dvec2> layer;
            for (int i = 0; i <= 160; ++i)
                layer.push_back(moved(-0.4 + 0.005 * i, shell));
            chart.add_line(layer, {.colour = shell == 0 ? k_ink : series_colour(2).faded(0.75), .width = shell == 0 ? 2.6 : 1.2});
        }
        for (int i = 0; i <= 16; ++i) {
            std::vector<glm::dvec2> strand;
            for (int shell = 0; shell < k_shells; ++shell)
                strand.push_back(moved(-0.4 + 0.05 * i, shell));
            chart.add_line(strand, {.colour = series_colour(1), .width = 1.6});
        }
    }
    return plot;
}

std::string beaufort_table() {
    // Middles of the scale's classes. [m/s]
    constexpr std::array k_winds{0.9, 2.4, 4.4, 6.7, 9.3, 12.3, 15.5, 18.9, 22.6, 26.4};
    const auto air = [](double wind) {
        return *AmbientWind::create({.mean = {static_cast<float>(wind), 0.0f, 0.0f}, .profile = LogProfile{}});
    };
    char text[128];
    std::string table = "Lean of the tip [degrees] in a steady wind; the scale's winds blow at 10 m over short grass.\n\n";
    table += "Beaufort force    ";
    for (std::size_t n = 0; n < k_winds.size(); ++n) {
        std::snprintf(text, sizeof text, " %6zu", n + 1);
        table += text;
    }
    table += "\nwind at 10 m [m/s]";
    for (std::size_t n = 0; n < k_winds.size(); ++n) {
        std::snprintf(text, sizeof text, " %6.1f", k_winds[n]);
        table += text;
    }
    for (const NamedPlant& plant : plants()) {
        std::snprintf(text, sizeof text, "\n%-11s %4.1f m", plant.name, plant.height);
        table += text;
        for (const double wind : k_winds) {
            const glm::vec3 there = air(wind).velocity({0.0, plant.height, 0.0});
            std::snprintf(text, sizeof text, " %6.1f", static_cast<double>(bend_angle(plant.drag, there.x)) * k_degrees);
            table += text;
        }
    }
    return table + "\n";
}

} // namespace windrow::cli
