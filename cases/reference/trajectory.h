// Semi-Lagrangian transport once more, in double and cell by cell, from the words of operators.h and boundaries.h alone:
//
//     x0 = x - dt u(x),  xd = x - dt/2 (u(x) + V(x0)),  V = (1 + a) u - a u_old,  result(x) = R(xd)
//     R  = ambient + g (carried - ambient) - s q
//
// Positions are cell indices (a centre is a whole number). A position stays within one cell beyond the outermost centres at an
// open boundary and within the face at a wall. Slow on purpose: every read walks through the sides by itself.
#pragma once

#include "fluid/operators.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <span>

namespace windrow::reference {

/// A cell's index brought inside the box, with what the sides do to a value on its way back out.
struct Beyond {
    glm::ivec3 inside{0};
    bool open = false; ///< beyond an open boundary: nothing inside is read
    glm::dvec3 scale{1.0};
    glm::dvec3 history_scale{1.0};
};

inline Beyond beyond(const Box& box, glm::ivec3 index) {
    Beyond result;
    for (int axis = 2; axis >= 0; --axis) {
        const int count = box.cells[axis];
        while (index[axis] < 0 || index[axis] >= count) {
            const Boundary& side = box.boundaries.at(axis, index[axis] < 0 ? 0 : 1);
            if (side.kind == BoundaryKind::open) {
                result.open = true;
                return result;
            }
            if (side.kind == BoundaryKind::periodic) {
                index[axis] += index[axis] < 0 ? count : -count;
                continue;
            }
            index[axis] = (index[axis] < 0 ? -1 : 2 * count - 1) - index[axis];
            result.scale[axis] = -result.scale[axis]; // carried air slips along every wall (boundaries.h)
            result.history_scale[axis] = -result.history_scale[axis];
        }
    }
    result.inside = index;
    return result;
}

inline glm::dvec3 legal(const Box& box, glm::dvec3 position) {
    for (int axis = 0; axis < 3; ++axis) {
        if (box.boundaries.periodic(axis))
            continue;
        const double low = box.boundaries.at(axis, 0).kind == BoundaryKind::open ? -1.0 : -0.5;
        const double high = box.cells[axis] - (box.boundaries.at(axis, 1).kind == BoundaryKind::open ? 0.0 : 0.5);
        position[axis] = std::clamp(position[axis], low, high);
    }
    return position;
}

/// Interpolates Value read(glm::ivec3 cell) at a position: the weights of nodes first..first + nodes - 1 about its lower cell.
template <class Value, class Read>
Value interpolate(Interpolation interpolation, glm::dvec3 position, Read&& read) {
    const glm::dvec3 low = glm::floor(position), t = position - low;
    const bool linear = interpolation == Interpolation::linear;
    const int first = linear ? 0 : -1, nodes = linear ? 2 : 4;
    double weights[3][4];
    for (int axis = 0; axis < 3; ++axis)
        for (int node = 0; node < nodes; ++node) {
            double w = 1.0;
            for (int other = 0; other < nodes; ++other)
                if (other != node)
                    w *= (t[axis] - (first + other)) / static_cast<double>(node - other);
            weights[axis][node] = w;
        }
    const auto weight = [&](int i, int j, int k) {
        if (interpolation != Interpolation::cubic_32)
            return weights[0][i] * weights[1][j] * weights[2][k];
        const int at[] = {i, j, k};
        double linear_part[3], added[3];
        for (int axis = 0; axis < 3; ++axis) {
            linear_part[axis] = at[axis] == 1 ? 1.0 - t[axis] : at[axis] == 2 ? t[axis] : 0.0;
            added[axis] = weights[axis][at[axis]] - linear_part[axis];
        }
        const auto& [x, y, z] = linear_part;
        return x * y * z + added[0] * y * z + x * added[1] * z + x * y * added[2];
    };
    Value sum{};
    for (int k = 0; k < nodes; ++k)
        for (int j = 0; j < nodes; ++j)
            for (int i = 0; i < nodes; ++i)
                if (const double w = weight(i, j, k); w != 0.0)
                    sum += w * read(glm::ivec3(low) + first + glm::ivec3(i, j, k));
    return sum;
}

/// Where the air that arrives at `cell` was at the start of the step.
inline glm::dvec3 departure(const Box& box, glm::dvec3 ambient, const Transport& transport, glm::ivec3 cell) {
    const bool steady = transport.velocity_old.empty();
    const double a = steady ? 0.0 : static_cast<double>(transport.extrapolation);
    const double cells_per_speed = static_cast<double>(transport.dt) / static_cast<double>(box.cell_size);
    const auto wind = [&](glm::ivec3 index) {
        const Beyond from = beyond(box, index);
        if (from.open)
            return ambient;
        const std::size_t n = box.index(from.inside.x, from.inside.y, from.inside.z);
        const glm::dvec3 now(transport.velocity[n]);
        return from.scale * (steady ? now : (1.0 + a) * now - a * glm::dvec3(transport.velocity_old[n]));
    };
    const glm::dvec3 here(transport.velocity[box.index(cell.x, cell.y, cell.z)]);
    const glm::dvec3 guess = legal(box, glm::dvec3(cell) - cells_per_speed * here);
    const glm::dvec3 there = interpolate<glm::dvec3>(Interpolation::linear, guess, wind);
    return legal(box, glm::dvec3(cell) - 0.5 * cells_per_speed * (here + there));
}

/// The velocity that arrives at `cell`.
inline glm::dvec3 arrival(const Box& box, glm::dvec3 ambient, const Transport& transport, glm::ivec3 cell) {
    const auto carried = [&](glm::ivec3 index) {
        const Beyond from = beyond(box, index);
        if (from.open)
            return ambient;
        const std::size_t n = box.index(from.inside.x, from.inside.y, from.inside.z);
        const glm::dvec3 settled =
            ambient + static_cast<double>(transport.relaxation) * (glm::dvec3(transport.carried[n]) - ambient);
        const glm::dvec3 value = from.scale * settled;
        if (transport.history.empty())
            return value;
        return value - static_cast<double>(transport.history_scale) * from.history_scale * glm::dvec3(transport.history[n]);
    };
    return interpolate<glm::dvec3>(transport.interpolation, departure(box, ambient, transport, cell), carried);
}

/// A scalar as the sides hold it: mirrored at walls, `outside` beyond open boundaries.
inline double scalar_at(const Box& box, std::span<const float> values, double outside, glm::ivec3 index) {
    const Beyond from = beyond(box, index);
    return from.open ? outside : static_cast<double>(values[box.index(from.inside.x, from.inside.y, from.inside.z)]);
}

} // namespace windrow::reference
