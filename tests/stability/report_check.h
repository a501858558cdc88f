// Whether a step reports what it did: Diagnostics against the cells.
#pragma once

#include "fluid/wind.h"
#include "tests/winds.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>
#include <string>

namespace windrow::test {

/// What the test knows of the step.
struct StepTaken {
    double dt = 0.0;         ///< [s]
    std::int64_t broken = 0; ///< cells that held no number before it
    bool was_asleep = false;
    bool moved = false; ///< the box may have moved in it, and left broken cells behind
};

/// Cells of which a component is NaN or infinite.
[[nodiscard]] inline std::int64_t nonfinite_cells(std::span<const glm::vec4> field) {
    return std::count_if(field.begin(), field.end(), [](const glm::vec4& u) {
        return !(std::isfinite(u.x) && std::isfinite(u.y) && std::isfinite(u.z) && std::isfinite(u.w));
    });
}

/// The first thing in which report and cells disagree; empty where there is none.
[[nodiscard]] inline std::string disagreement(const Wind& wind, const Diagnostics& report, const StepTaken& step) {
    std::ostringstream text;
    const auto differs = [&](const char* what, auto reported, auto found) {
        text << what << " is reported as " << reported << ", but is " << found;
        return text.str();
    };
    const Config& config = wind.config();
    const double h = config.cell_size;
    if (!report.stepped)
        return differs("stepped", false, true);
    const std::span<const glm::vec4> field = wind.field();
    float largest = 0.0f;
    for (const glm::vec4& u : field) {
        largest = std::max({largest, std::abs(u.x), std::abs(u.y), std::abs(u.z)});
        if (u.w != 0.0f)
            return differs("the fourth component", 0.0f, u.w);
    }
    // Air that sleeps in gusts: they blow on, its figures are those of the step that fell asleep.
    const bool blows_on = step.was_asleep && report.asleep && wind.view().ambient().gusting();
    if (!blows_on && report.max_speed != largest)
        return differs("max_speed", report.max_speed, largest);
    // Runs of 1024 floats are summed in float, to 256 a lane, each sum off by half a rounding at most; squares too small for a
    // float are off by half of its smallest number.
    const double energy = energy_of(field) * h * h * h;
    const double smallest = 1.5 * static_cast<double>(field.size()) * std::numeric_limits<float>::denorm_min() * h * h * h;
    if (!blows_on && !(std::abs(report.energy - energy) <= 256.0 * 6e-8 * energy + smallest))
        return differs("energy", report.energy, energy);
    if (!(report.divergence_rms >= 0.0 && std::isfinite(report.divergence_rms)))
        return differs("divergence_rms", report.divergence_rms, "a size");
    if (report.repaired_cells > step.broken || (!step.moved && report.repaired_cells < step.broken))
        return differs("repaired_cells", report.repaired_cells, step.broken);
    if (step.was_asleep && report.asleep)
        return {}; // it did nothing, and tells what it found when it fell asleep

    if (!(report.cfl >= 0.0f && std::isfinite(report.cfl)))
        return differs("cfl", report.cfl, "a number of cells");
    const float wanted = config.stages.advection ? std::max(1.0f, std::ceil(report.cfl / config.max_cfl)) : 1.0f;
    // While bodies move, the number is known before the step.
    const auto bodies = wind.obstacles().in_reach();
    const bool foreseen = std::any_of(bodies.begin(), bodies.end(), [](const auto& body) { return body.moves(); });
    const bool capped = wanted > static_cast<float>(config.max_substeps) && (!foreseen || report.substeps == config.max_substeps);
    if (report.substeps_capped != capped)
        return differs("substeps_capped", report.substeps_capped, capped);
    if (report.substeps < 1 || report.substeps > config.max_substeps)
        return differs("substeps", report.substeps, "outside of its range");
    if (const int substeps = capped ? config.max_substeps : static_cast<int>(wanted); !foreseen && report.substeps != substeps)
        return differs("substeps", report.substeps, substeps);
    const double fastest = static_cast<double>(config.max_cfl) * config.max_substeps * h / step.dt;
    if (config.stages.advection && largest > 1.0001 * fastest)
        return differs("max_speed", report.max_speed, fastest);
    if (report.limited_cells != 0 && !capped && largest < 0.999 * fastest)
        return differs("limited_cells", report.limited_cells, "none: nothing is as fast as the limit");
    const DiffusionMethod method =
        config.stages.diffusion
            ? diffusion_method(config.viscosity, static_cast<float>(step.dt) / static_cast<float>(report.substeps),
                               config.cell_size)
            : DiffusionMethod::none;
    // What short steps owe is paid by one of them, in one pass.
    const bool pays = method == DiffusionMethod::none && report.diffusion == DiffusionMethod::one_pass &&
                      config.stages.diffusion &&
                      diffusion_method(config.viscosity, 1.0f, config.cell_size) != DiffusionMethod::none;
    if (report.diffusion != method && !pays)
        return differs("diffusion", static_cast<int>(report.diffusion), static_cast<int>(method));
    const double stages = sum_of_stages(report.times_ms);
    if (!(stages <= report.times_ms.total * (1.0 + 1e-9)))
        return differs("the time of all stages", stages, report.times_ms.total);
    return {};
}

} // namespace windrow::test
