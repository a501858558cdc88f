// The 7-point Laplacian in double, neighbour by neighbour from the words of boundaries.h, with a conjugate gradient to invert it.
//
//     (L v)[i] = sum over the axes of v[i-1] - 2 v[i] + v[i+1]      (h = 1)
//
// Beyond a side lies        pressure      velocity along the side's normal     velocity across it
//   open                    0             ambient                              ambient
//   free_slip                p            -u                                   u
//   no_slip                  p            -u                                   2 U - u
//   periodic                 the far side's value
// Every ghost is scale * v + offset of one cell inside; the part without offsets is symmetric, so conjugate gradients apply.
#pragma once

#include "fluid/operators.h"

#include <cmath>
#include <glm/vec3.hpp>
#include <numeric>
#include <vector>

namespace windrow::reference {

using Values = std::vector<double>;

class Stencil {
  public:
    static Stencil pressure(const Box& box) {
        Stencil stencil(box);
        stencil.singular_ = true;
        for (int axis = 0; axis < 3; ++axis)
            for (int end = 0; end < 2; ++end) {
                const bool open = box.boundaries.at(axis, end).kind == BoundaryKind::open;
                stencil.ghosts_[axis][end] = {open ? 0.0 : 1.0, 0.0};
                stencil.singular_ = stencil.singular_ && !open;
            }
        return stencil;
    }

    static Stencil velocity(const Box& box, int component, glm::vec3 ambient) {
        Stencil stencil(box);
        for (int axis = 0; axis < 3; ++axis)
            for (int end = 0; end < 2; ++end) {
                const Boundary& side = box.boundaries.at(axis, end);
                Ghost& ghost = stencil.ghosts_[axis][end];
                if (side.kind == BoundaryKind::open)
                    ghost = {0.0, static_cast<double>(ambient[component])};
                else if (side.kind == BoundaryKind::no_slip)
                    ghost = {-1.0, 2.0 * static_cast<double>(side.wall_velocity[component])};
                else
                    ghost = {axis == component ? -1.0 : 1.0, 0.0};
            }
        return stencil;
    }

    /// True where a constant is in the null space of L.
    [[nodiscard]] bool singular() const { return singular_; }

    /// L v, with what moving walls and the ambient wind add, or without.
    enum class Offsets { with, without };
    [[nodiscard]] Values laplacian(const Values& v, Offsets offsets = Offsets::with) const {
        Values result(v.size());
        std::size_t n = 0;
        const std::ptrdiff_t strides[3] = {1, box_.cells.x, static_cast<std::ptrdiff_t>(box_.cells.x) * box_.cells.y};
        glm::ivec3 at;
        for (at.z = 0; at.z < box_.cells.z; ++at.z)
            for (at.y = 0; at.y < box_.cells.y; ++at.y)
                for (at.x = 0; at.x < box_.cells.x; ++at.x, ++n) {
                    double sum = 0.0;
                    for (int axis = 0; axis < 3; ++axis) {
                        const int last = box_.cells[axis] - 1;
                        for (int end = 0; end < 2; ++end) {
                            const bool edge = at[axis] == (end == 0 ? 0 : last);
                            if (!edge)
                                sum += v[n + (end == 0 ? -strides[axis] : strides[axis])];
                            else if (box_.boundaries.periodic(axis))
                                sum += v[n + (end == 0 ? last : -last) * strides[axis]];
                            else
                                sum += ghosts_[axis][end].scale * v[n] +
                                       (offsets == Offsets::with ? ghosts_[axis][end].offset : 0.0);
                            sum -= v[n];
                        }
                    }
                    result[n] = sum;
                }
        return result;
    }

    /// Solves (shift - L) v = rhs, offsets left out; in a singular box without shift the mean of rhs is dropped and v has mean 0.
    [[nodiscard]] Values solve(double shift, Values rhs, double tolerance = 1e-12) const {
        const bool drop_mean = singular_ && shift == 0.0;
        if (drop_mean)
            remove_mean(rhs);
        Values v(rhs.size(), 0.0), residual = rhs, direction = rhs;
        double squares = dot(residual, residual);
        const double enough = tolerance * tolerance * squares;
        for (std::size_t pass = 0; pass < 20 * rhs.size() + 100 && squares > enough; ++pass) {
            Values image = laplacian(direction, Offsets::without);
            for (std::size_t n = 0; n < image.size(); ++n)
                image[n] = shift * direction[n] - image[n];
            const double step = squares / dot(direction, image);
            for (std::size_t n = 0; n < v.size(); ++n) {
                v[n] += step * direction[n];
                residual[n] -= step * image[n];
            }
            const double next = dot(residual, residual);
            for (std::size_t n = 0; n < v.size(); ++n)
                direction[n] = residual[n] + next / squares * direction[n];
            squares = next;
        }
        if (drop_mean)
            remove_mean(v);
        return v;
    }

    static double dot(const Values& a, const Values& b) { return std::inner_product(a.begin(), a.end(), b.begin(), 0.0); }
    static double norm(const Values& v) { return std::sqrt(dot(v, v)); }
    static void remove_mean(Values& v) {
        const double mean = std::accumulate(v.begin(), v.end(), 0.0) / static_cast<double>(v.size());
        for (double& value : v)
            value -= mean;
    }

  private:
    explicit Stencil(const Box& box) : box_(box) {}
    struct Ghost {
        double scale = 1.0, offset = 0.0;
    };
    Box box_;
    Ghost ghosts_[3][2];
    bool singular_ = false;
};

} // namespace windrow::reference
