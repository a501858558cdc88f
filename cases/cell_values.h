// Flows sampled at cell centres, and how far a field is off one.
//
// Positions are metres from the box's low corner, in double; fields are laid out as box.h says.
#pragma once

#include "cases/verify_case.h"
#include "fluid/operators.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace windrow::cases {

inline constexpr double k_pi = std::numbers::pi;
using CellVelocities = std::vector<glm::vec4>;
using CellScalars = std::vector<float>;

/// The workspace of a box that is known to be legal.
inline Workspace workspace_of(const Box& box, const VerifySetting& setting) {
    return *Workspace::create({.box = box, .simd = setting.simd, .parallel_for = setting.parallel_for});
}

/// One side of a Boundaries, to write to.
inline Boundary& side_of(Boundaries& boundaries, int axis, int end) {
    Boundary* const ordered[6] = {&boundaries.x_low,  &boundaries.x_high, &boundaries.y_low,
                                  &boundaries.y_high, &boundaries.z_low,  &boundaries.z_high};
    return *ordered[2 * axis + end];
}

/// One pair of kinds an axis, low and high.
using Ends = std::pair<BoundaryKind, BoundaryKind>;
inline Boundaries sides_of(Ends x, Ends y, Ends z) {
    Boundaries boundaries;
    for (int axis = 0; const Ends& ends : {x, y, z}) {
        side_of(boundaries, axis, 0).kind = ends.first;
        side_of(boundaries, axis++, 1).kind = ends.second;
    }
    return boundaries;
}

inline Box periodic_box(glm::ivec3 cells, double cell_size = 1.0) {
    return {.cells = cells, .cell_size = static_cast<float>(cell_size), .boundaries = Boundaries::all(BoundaryKind::periodic)};
}

/// Calls visit(place in the layout, centre) for each cell.
template <class Visit>
void visit_cells(const Box& box, Visit&& visit) {
    std::size_t n = 0;
    for (int k = 0; k < box.cells.z; ++k)
        for (int j = 0; j < box.cells.y; ++j)
            for (int i = 0; i < box.cells.x; ++i, ++n)
                visit(n, static_cast<double>(box.cell_size) * glm::dvec3(i + 0.5, j + 0.5, k + 0.5));
}

/// Samples glm::dvec3 flow(glm::dvec3 x).
template <class Flow>
CellVelocities velocities_of(const Box& box, Flow&& flow) {
    CellVelocities field(box.cell_count());
    visit_cells(box, [&](std::size_t n, glm::dvec3 x) { field[n] = glm::vec4(glm::vec3(flow(x)), 0.0f); });
    return field;
}

/// Samples double value(glm::dvec3 x).
template <class Value>
CellScalars scalars_of(const Box& box, Value&& value) {
    CellScalars field(box.cell_count());
    visit_cells(box, [&](std::size_t n, glm::dvec3 x) { field[n] = static_cast<float>(value(x)); });
    return field;
}

/// |u - flow|_2 / |flow - mean|_2
template <class Flow>
double velocity_error(const Box& box, std::span<const glm::vec4> u, Flow&& flow, glm::dvec3 mean = glm::dvec3(0.0)) {
    double error = 0.0, size = 0.0;
    visit_cells(box, [&](std::size_t n, glm::dvec3 x) {
        const glm::dvec3 exact = flow(x), off = glm::dvec3(u[n]) - exact;
        error += glm::dot(off, off);
        size += glm::dot(exact - mean, exact - mean);
    });
    return std::sqrt(error / size);
}

/// |a - b|_2 / |b - mean|_2 of velocities at the same cells.
template <class Velocities, class Truth>
double relative_error(const Velocities& a, const Truth& b, glm::dvec3 mean = glm::dvec3(0.0)) {
    double error = 0.0, size = 0.0;
    for (std::size_t n = 0; n < b.size(); ++n) {
        const glm::dvec3 exact(b[n]), off = glm::dvec3(a[n]) - exact;
        error += glm::dot(off, off);
        size += glm::dot(exact - mean, exact - mean);
    }
    return std::sqrt(error / size);
}

/// Mean of speed(out) over `count` directions that are spread evenly (Fibonacci).
template <class Speed>
double mean_over_directions(int count, Speed&& speed) {
    double sum = 0.0;
    for (int n = 0; n < count; ++n) {
        const double y = 1.0 - 2.0 * (n + 0.5) / count, across = std::sqrt(1.0 - y * y), turn = n * k_pi * (3.0 - std::sqrt(5.0));
        sum += speed(glm::dvec3(across * std::cos(turn), y, across * std::sin(turn)));
    }
    return sum / count;
}

/// |s - value|_2 / |value|_2
template <class Value>
double scalar_error(const Box& box, std::span<const float> s, Value&& value) {
    double error = 0.0, size = 0.0;
    visit_cells(box, [&](std::size_t n, glm::dvec3 x) {
        const double exact = value(x), off = s[n] - exact;
        error += off * off;
        size += exact * exact;
    });
    return std::sqrt(error / size);
}

/// The larger of two errors; a NaN is larger than any.
inline double worse(double a, double b) {
    return std::isnan(a) || a > b ? a : b;
}

/// A bound that falls as the size grows, from one known at `at`.
inline double falling_bound(double bound, int at, double order, int size) {
    return bound * std::pow(static_cast<double>(at) / size, order);
}

} // namespace windrow::cases
