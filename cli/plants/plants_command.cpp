// What docs/plants.md and docs/plants_motion.md show. Each curve is computed by the library's own calls.
#include "cli/plants/plants_command.h"

#include "cli/flags.h"
#include "cli/output_file.h"
#include "cli/table.h"
#include "coupling/blade.h"
#include "coupling/plant_classes.h"
#include "coupling/shell.h"
#include "fluid/ambient.h"
#include "scene/number_text.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>

namespace windrow::cli {
namespace {

constexpr double k_degrees = 180.0 / 3.14159265358979323846;

struct NamedPlant {
    const char* name;
    Drag drag;
    double height; // [m] where it meets the wind of the table
};

std::array<NamedPlant, 8> plants() {
    return {{{"grass", grass(), 0.2},
             {"reed", reed(), 1.5},
             {"wheat", wheat(), 0.6},
             {"leaf", leaf(), 5.0},
             {"twig", twig(), 5.0},
             {"branch", branch(), 6.0},
             {"small trunk", small_trunk(), 6.0},
             {"large trunk", large_trunk(), 14.0}}};
}

double lean_of(const NamedPlant& plant, double wind) {
    return static_cast<double>(bend_angle(plant.drag, static_cast<float>(wind))) * k_degrees;
}

/// Lean of the tip [degrees] against the wind at the plant [m/s], eight classes.
void add_bends(std::vector<PlotCurve>& curves) {
    for (const NamedPlant& plant : plants()) {
        PlotCurve& curve = curves.emplace_back(PlotCurve{"bend", "", plant.name, {}});
        for (int i = 0; i <= 300; ++i)
            curve.points.emplace_back(0.1 * i, lean_of(plant, 0.1 * i));
    }
}

/// Middle line of a blade [m] at six wind speeds: the bend, which keeps its length, and the translate form beside it.
void add_blades(std::vector<PlotCurve>& curves) {
    // A blade that is what its class says: no chance, no bend of its own.
    const Blades grass =
        *Blades::create({.length_spread = 0.0f, .stiffness_spread = 0.0f, .rest_bend = 0.0f, .rest_bend_spread = 0.0f});
    for (const float speed : {0.5f, 1.0f, 2.0f, 4.0f, 8.0f, 16.0f}) {
        const glm::vec3 load = grass.load({0, 0}, {speed, 0.0f, 0.0f});
        const auto at = [&](double h) { return glm::dvec2(grass.vertex({0, 0}, load, static_cast<float>(h), 0.0f).position); };
        const std::string name = scene::figure(static_cast<double>(speed));
        PlotCurve bent{"blades", "bent", name, {}}, translated{"blades", "translated", name, {}};
        for (int i = 0; i <= 60; ++i) {
            const double h = i / 60.0;
            bent.points.push_back(at(h));
            translated.points.emplace_back(at(1.0).x * h * h, 0.3 * h);
        }
        curves.push_back(std::move(bent));
        curves.push_back(std::move(translated));
    }
}

// The hill that shells grow on, and its normal. [m]
glm::dvec2 hill(double x) {
    return {x, 0.25 * std::exp(-std::pow(x / 0.3, 2.0))};
}
glm::dvec2 hill_normal(double x) {
    const double slope = -2.0 * x / 0.09 * hill(x).y;
    return glm::normalize(glm::dvec2(-slope, 1.0));
}

/// Shells over a hill [m] in a wind and under droop: the stem form and the translate form.
void add_shells(std::vector<PlotCurve>& curves) {
    constexpr int k_shells = 9;
    const Shells fur = *Shells::create({.shells = k_shells,
                                        .length = 0.1f,
                                        .push = 0.012f,
                                        .push_exponent = 2.0f,
                                        .droop = 0.04f,
                                        .sag = 0.5f,
                                        .strand = {.length = 0.1f, .width = 4e-4f, .rigidity = 2e-6f, .drag_coefficient = 1.5f}});
    const glm::vec3 wind{7.0f, 0.0f, 0.0f};
    for (const bool stems : {true, false}) {
        const char* const panel = stems ? "stems" : "translated";
        const auto moved = [&](double x, int shell) {
            const glm::vec3 p(hill(x), 0.0f), n(hill_normal(x), 0.0f);
            const float h = fur.height(shell);
            return glm::dvec2(stems ? fur.bent(p, n, h, 1.0f, fur.load(n, 1.0f, wind)) : fur.translated(p, n, h, 1.0f, wind));
        };
        for (int shell = 0; shell < k_shells; ++shell) {
            PlotCurve& layer = curves.emplace_back(PlotCurve{"shells", panel, "shell " + std::to_string(shell), {}});
            for (int i = 0; i <= 160; ++i)
                layer.points.push_back(moved(-0.4 + 0.005 * i, shell));
        }
        for (int i = 0; i <= 16; ++i) {
            PlotCurve& strand = curves.emplace_back(PlotCurve{"shells", panel, "strand " + std::to_string(i), {}});
            for (int shell = 0; shell < k_shells; ++shell)
                strand.points.push_back(moved(-0.4 + 0.05 * i, shell));
        }
    }
}

std::vector<PlotCurve> plant_curves() {
    std::vector<PlotCurve> curves;
    add_bends(curves);
    add_blades(curves);
    add_shells(curves);
    constexpr std::array k_rates{1000, 144, 60, 30, 15}; // [Hz]
    constexpr std::array k_shells{20, 200};
    for (auto& motion :
         {spring_response_curves(springs::wheat, k_rates, 2.0), cascade_curves({}, k_shells, 12.0)}) // the slowest: 9 s
        curves.insert(curves.end(), motion.begin(), motion.end());
    return curves;
}

/// The lean of each class in the middle of Beaufort's forces 1 to 10.
std::string beaufort_table() {
    constexpr std::array k_winds{0.9, 2.4, 4.4, 6.7, 9.3, 12.3, 15.5, 18.9, 22.6, 26.4}; // [m/s]
    std::string table = "Lean of the tip [degrees] in a steady wind; the scale's winds blow at 10 m over short grass.\n\n"
                        "Beaufort force    ";
    for (std::size_t n = 0; n < k_winds.size(); ++n)
        table += right(std::to_string(n + 1), 7);
    table += "\nwind at 10 m [m/s]";
    for (const double wind : k_winds)
        table += right(to_fixed(wind, 1), 7);
    for (const NamedPlant& plant : plants()) {
        const std::string name = plant.name;
        table += "\n" + name + std::string(11 - name.size(), ' ') + right(to_fixed(plant.height, 1), 5) + " m";
        for (const double wind : k_winds) {
            const auto air = AmbientWind::create({.mean = {static_cast<float>(wind), 0.0f, 0.0f}, .profile = LogProfile{}});
            table += right(to_fixed(lean_of(plant, air->velocity({0.0, plant.height, 0.0}).x), 1), 7);
        }
    }
    return table + "\n";
}

} // namespace

void add_plants(CLI::App& app, std::function<int()>& chosen, const Console& console) {
    CLI::App* const plants =
        app.add_subcommand("plants", "Print how far plants bend at each wind speed and how they move; tables and curves");
    const auto out = std::make_shared<std::optional<std::filesystem::path>>();
    Flags(*plants).folder("--out", *out, "Folder for plants.csv, which ./dev plots draws; default out/plants");
    plants->callback([out, &chosen, &console] {
        const std::filesystem::path folder = out->value_or(std::filesystem::path("out") / "plants");
        chosen = [folder, &console] { return run_plants(folder, console); };
    });
}

int run_plants(const std::filesystem::path& out, const Console& console) {
    OutputFolder folder;
    if (const Fault fault = folder.open(out))
        return complain_of(fault, console);
    OutputFile file(out / "plants.csv");
    file.write(plot_csv(plant_curves()));
    if (const Fault fault = file.publish())
        return complain_of(fault, console);
    console.out << beaufort_table() << "\nIn " << out.string() << ": plants.csv; ./dev plots " << out.string() << " draws it.\n";
    return k_exit_well;
}

} // namespace windrow::cli
