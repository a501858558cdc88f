// Boxes and fields that the analytic tests share, beside those of the cases.
//
// Positions are metres from the box's low corner, in double; a field samples a flow at cell centres, box.h's layout.
#pragma once

#include "cases/cell_values.h"
#include "cases/flows.h"
#include "cases/whole_step.h"
#include "fluid/pieces.h"
#include "fluid/wind.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <random>
#include <span>
#include <vector>

namespace windrow::flows {

using cases::ArnoldBeltramiChildress;
using cases::k_pi;
using cases::periodic_box;
using cases::scalars_of;
using cases::side_of;
using cases::sides_of;
using cases::TaylorGreen2D;
using cases::velocities_of;
using cases::velocity_error;
using cases::visit_cells;
using Field = cases::CellVelocities;

/// Workspace of a box that is known to be legal.
inline Workspace workspace(const Box& box, glm::vec3 ambient = glm::vec3(0.0f)) {
    return *Workspace::create({.box = box, .ambient = ambient, .parallel_for = {}});
}

/// A Wind of `box` for the raw step: no settling, no sub-steps. The box's low corner is the origin.
inline Wind raw_wind(const Box& box, double viscosity, Scheme scheme, Interpolation interpolation) {
    Config config = cases::raw_config(box, viscosity, {});
    config.scheme = scheme;
    config.interpolation = interpolation;
    return *Wind::create(config);
}

// --- Random fields: the same numbers with any standard library ----------------------------------------------------------

class Random {
  public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}
    /// [low, high)
    double uniform(double low = -1.0, double high = 1.0) {
        return low + (high - low) * (static_cast<double>(engine_()) / 4294967296.0);
    }
    int below(int count) { return static_cast<int>(engine_() % static_cast<std::uint32_t>(count)); }
    glm::dvec3 vector(double size = 1.0) {
        glm::dvec3 result;
        for (int axis = 0; axis < 3; ++axis)
            result[axis] = uniform(-size, size);
        return result;
    }
    /// Any mix of kinds, a quarter of the axes periodic.
    Sides sides() {
        Sides result;
        for (int axis = 0; axis < 3; ++axis) {
            const bool periodic = below(4) == 0;
            for (int end = 0; end < 2; ++end)
                side_of(result, axis, end).kind = periodic ? SideKind::periodic : static_cast<SideKind>(below(3));
        }
        return result;
    }
    Field field(const Box& box, double size = 1.0) {
        Field result(box.cell_count());
        for (glm::vec4& u : result)
            u = glm::vec4(glm::vec3(vector(size)), 0.0f);
        return result;
    }

  private:
    std::mt19937 engine_;
};

// --- Norms -----------------------------------------------------------------------------------------------------------

inline double rms(std::span<const glm::vec4> u) {
    double squares = 0.0;
    for (const glm::vec4& v : u)
        squares += glm::dot(glm::dvec3(v), glm::dvec3(v));
    return std::sqrt(squares / static_cast<double>(u.size()));
}

inline double rms(std::span<const float> values) {
    double squares = 0.0;
    for (const float v : values)
        squares += static_cast<double>(v) * v;
    return std::sqrt(squares / static_cast<double>(values.size()));
}

/// Largest difference of any component.
inline double largest_difference(std::span<const glm::vec4> a, std::span<const glm::vec4> b) {
    double largest = 0.0;
    for (std::size_t n = 0; n < a.size(); ++n)
        for (int axis = 0; axis < 3; ++axis)
            largest = std::max(largest, std::abs(static_cast<double>(a[n][axis]) - b[n][axis]));
    return largest;
}

} // namespace windrow::flows
