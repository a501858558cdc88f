// Boxes, fields and exact flows that the analytic tests share.
//
// Positions are metres from the box's low corner, in double; a field samples a flow at cell centres, box.h's layout.
#pragma once

#include "fluid/pieces.h"
#include "fluid/wind.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>
#include <random>
#include <span>
#include <vector>

namespace windrow::flows {

inline constexpr double k_pi = std::numbers::pi;
using Field = std::vector<glm::vec4>;

// --- Boxes -----------------------------------------------------------------------------------------------------------

/// Workspace of a box that is known to be legal.
inline Workspace workspace(const Box& box, glm::vec3 ambient = glm::vec3(0.0f)) {
    return *Workspace::create({.box = box, .ambient = ambient, .parallel_for = {}});
}

inline Box periodic_box(glm::ivec3 cells, double cell_size = 1.0) {
    return {.cells = cells, .cell_size = static_cast<float>(cell_size), .sides = Sides::all(SideKind::periodic)};
}

/// One side of a Sides, to write to.
inline Side& side_of(Sides& sides, int axis, int end) {
    Side* const ordered[6] = {&sides.x_low, &sides.x_high, &sides.y_low, &sides.y_high, &sides.z_low, &sides.z_high};
    return *ordered[2 * axis + end];
}

inline Sides axis_sides(const SideKind (&kinds)[3][2]) {
    Sides sides;
    for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end)
            side_of(sides, axis, end).kind = kinds[axis][end];
    return sides;
}

/// Visits every cell with its place in the layout and its centre from the low corner.
template <class Visit>
void for_each_cell(const Box& box, Visit&& visit) {
    std::size_t n = 0;
    for (int k = 0; k < box.cells.z; ++k)
        for (int j = 0; j < box.cells.y; ++j)
            for (int i = 0; i < box.cells.x; ++i, ++n)
                visit(n, static_cast<double>(box.cell_size) * glm::dvec3(i + 0.5, j + 0.5, k + 0.5));
}

/// Samples glm::dvec3 flow(glm::dvec3 x).
template <class Flow>
Field sample(const Box& box, Flow&& flow) {
    Field field(box.cell_count());
    for_each_cell(box, [&](std::size_t n, glm::dvec3 x) { field[n] = glm::vec4(glm::vec3(flow(x)), 0.0f); });
    return field;
}

/// Samples double value(glm::dvec3 x).
template <class Value>
std::vector<float> sample_scalar(const Box& box, Value&& value) {
    std::vector<float> field(box.cell_count());
    for_each_cell(box, [&](std::size_t n, glm::dvec3 x) { field[n] = static_cast<float>(value(x)); });
    return field;
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

/// |u - flow|_2 / |flow - mean|_2 over the cell centres.
template <class Flow>
double relative_error(const Box& box, std::span<const glm::vec4> u, Flow&& flow, glm::dvec3 mean = glm::dvec3(0.0)) {
    double error = 0.0, size = 0.0;
    for_each_cell(box, [&](std::size_t n, glm::dvec3 x) {
        const glm::dvec3 exact = flow(x);
        const glm::dvec3 off = glm::dvec3(u[n]) - exact;
        error += glm::dot(off, off);
        size += glm::dot(exact - mean, exact - mean);
    });
    return std::sqrt(error / size);
}

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

// --- Exact flows -----------------------------------------------------------------------------------------------------

/// Taylor and Green's vortices in two dimensions, carried by a mean wind: an exact solution of Navier and Stokes' equations.
struct TaylorGreen2D {
    glm::dvec2 mean{0.0};
    double viscosity = 0.0;

    glm::dvec3 operator()(glm::dvec3 p, double t) const {
        const double fade = std::exp(-2.0 * viscosity * t), x = p.x - mean.x * t, y = p.y - mean.y * t;
        return {mean.x + fade * std::sin(x) * std::cos(y), mean.y - fade * std::cos(x) * std::sin(y), 0.0};
    }
};

/// Arnold, Beltrami and Childress' flow: its own curl, so it only fades, as exp(-nu t).
struct ArnoldBeltramiChildress {
    double a = 1.0, b = 0.8, c = 0.6;
    double viscosity = 0.0;

    glm::dvec3 operator()(glm::dvec3 p, double t) const {
        const double fade = std::exp(-viscosity * t);
        return fade * glm::dvec3(a * std::sin(p.z) + c * std::cos(p.y), b * std::sin(p.x) + a * std::cos(p.z),
                                 c * std::sin(p.y) + b * std::cos(p.x));
    }
};

/// A Wind of `box` that starts from `start`, for the raw step: no settling, no sub-steps. The box's low corner is the origin.
inline Wind raw_wind(const Box& box, double viscosity, Scheme scheme, Interpolation interpolation) {
    Config config{.cells = box.cells, .cell_size = box.cell_size, .sides = box.sides};
    config.centre = 0.5 * static_cast<double>(box.cell_size) * glm::dvec3(box.cells);
    config.viscosity = static_cast<float>(viscosity);
    config.settling_time = 0.0f;
    config.scheme = scheme;
    config.interpolation = interpolation;
    config.max_cfl = 1e5f;
    return *Wind::create(config);
}

} // namespace windrow::flows
