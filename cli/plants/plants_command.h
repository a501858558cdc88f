// `windrow plants`: how plants bend and move, as a table and as curves.
#pragma once

#include "cli/console.h"
#include "cli/table.h"
#include "coupling/cascade.h"
#include "coupling/spring.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace windrow::cli {

/// Adds the command; where it is chosen, `chosen` runs it.
void add_plants(CLI::App& app, std::function<int()>& chosen, const Console& console);

/// Prints the table of bends and writes plants.csv into a folder (plot_csv.h). Returns the exit code.
[[nodiscard]] int run_plants(const std::filesystem::path& out, const Console& console);

// Curves of motion: x [s] time, y [1] the share of the way that is done.

/// A spring at rest whose target jumps from 0 to 1 at time 0, for `seconds`, at each frame rate [Hz]. Empty for a spring that
/// `validate` rejects.
[[nodiscard]] inline std::vector<PlotCurve> spring_response_curves(const SpringClass& spring, std::span<const int> rates,
                                                                   double seconds) {
    std::vector<PlotCurve> curves;
    for (const int rate : rates) {
        const auto step = spring_step(spring, 1.0 / rate);
        if (!step)
            return {};
        PlotCurve curve{"spring", "", std::to_string(rate) + " Hz", {{0.0, 0.0}}};
        double place = 0.0, velocity = 0.0;
        const double target = 1.0;
        for (int frame = 1; frame <= static_cast<int>(seconds * rate); ++frame) {
            (void)advance_springs<double>(
                *step, {std::span(&place, 1), std::span(&velocity, 1), std::span(&target, 1), std::span(&target, 1)});
            curve.points.push_back({static_cast<double>(frame) / rate, place});
        }
        curves.push_back(std::move(curve));
    }
    return curves;
}

/// The tip of a fur whose body jumps from 0 to 1 at time 0, at 60 Hz, for each number of shells of 2 or more: on the stages of
/// `config`, and as fur is usually moved (Bloodelic's stylised fur), each shell going 0.3 of the way to the one inside it in each
/// frame.
[[nodiscard]] inline std::vector<PlotCurve> cascade_curves(const CascadeConfig& config, std::span<const int> shells,
                                                           double seconds) {
    constexpr int k_rate = 60;
    const int frames = static_cast<int>(seconds * k_rate);
    std::vector<PlotCurve> curves;
    for (const int count : shells) {
        auto cascade = Cascade::create(config, {});
        if (!cascade)
            return {};
        const Pose there{.position = {1.0, 0.0, 0.0}};
        if (!cascade->advance(0.0, there))
            return {};
        PlotCurve ours{"cascade", "", std::to_string(count) + " shells", {{0.0, 0.0}}};
        PlotCurve theirs{"cascade", "", std::to_string(count) + " shells, lerp per frame", {{0.0, 0.0}}};
        std::vector<double> lerped(static_cast<std::size_t>(std::max(count, 2)), 0.0);
        lerped[0] = 1.0; // glued to the body
        for (int frame = 1; frame <= frames; ++frame) {
            (void)cascade->advance(1.0 / k_rate, there);
            for (std::size_t i = 1; i < lerped.size(); ++i)
                lerped[i] += 0.3 * (lerped[i - 1] - lerped[i]);
            const double time = static_cast<double>(frame) / k_rate;
            const double tip_height = static_cast<double>(count - 1) / (std::max(count, 2) - 1); // of shell i: i / (count - 1)
            ours.points.push_back({time, cascade->at(tip_height).position.x});
            theirs.points.push_back({time, lerped.back()});
        }
        curves.push_back(std::move(ours));
        curves.push_back(std::move(theirs));
    }
    return curves;
}

} // namespace windrow::cli
