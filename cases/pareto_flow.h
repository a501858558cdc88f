// A flow of `windrow pareto`: where it begins, how long it lasts, and what is true at its end.
#pragma once

#include "fluid/ambient.h"
#include "fluid/box.h"
#include "fluid/motor.h"
#include "fluid/obstacle.h"

#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

namespace windrow::cases {

struct ParetoFlow {
    std::string name;     ///< the CSV's `case`
    std::string what;     ///< the flow and its truth, in a sentence
    glm::dvec3 size{1.0}; ///< [m] of the box; cells are cubes
    Boundaries boundaries{};
    glm::dvec3 mean{0.0}; ///< [m/s] mean wind; beyond open boundaries too
    std::optional<LogProfile> profile{};
    Gusts gusts{};
    double end = 1.0;            ///< [s]
    double top_speed = 1.0;      ///< [m/s] largest component, mean wind included: CFL = top_speed dt / h
    std::vector<Motor> motors{}; ///< positions from the box's low corner
    /// [m] Where the first motor is at a time [s]; empty: no motor moves.
    std::function<glm::dvec3(double t)> motion{};
    /// At rest, from the box's low corner. Errors count the cells half a coarsest cell and more from them.
    std::vector<Obstacle> obstacles{};
    std::vector<glm::ivec3> grids{};                 ///< coarse to fine
    std::function<glm::dvec3(glm::dvec3 x)> start{}; ///< empty: the ambient wind
    /// Velocity at `end`; empty: the truth is a run of the default method on the grid `reference`, at CFL 1.
    std::function<glm::dvec3(glm::dvec3 x)> exact{};
    glm::ivec3 reference{0};

    /// A profile, gusts or a motor that moves: compared by the direct solve alone.
    [[nodiscard]] bool needs_wind() const { return profile || gusts.intensity > 0.0f || motion; }
};

/// Whether a place inside the box counts for errors, and whether it is inside an obstacle.
[[nodiscard]] bool counts(const ParetoFlow& flow, glm::dvec3 x);
[[nodiscard]] bool is_solid(const ParetoFlow& flow, glm::dvec3 x);

[[nodiscard]] Box box_of(const ParetoFlow& flow, glm::ivec3 cells);
/// Steps to the end, an even number: after an odd one a first step without history shows differently.
[[nodiscard]] int steps_of(const ParetoFlow& flow, glm::ivec3 cells, double cfl);

/// All flows; with `quick` fewer, on fewer grids.
[[nodiscard]] std::vector<ParetoFlow> pareto_flows(bool quick);

} // namespace windrow::cases
