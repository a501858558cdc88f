// The same scene elsewhere: its bodies, motors, plants and boundaries mirrored, turned or moved; and a shape in another size.
#pragma once

#include "tests/scenario_parts.h"

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <variant>

namespace windrow::test {

/// A shape of the table, which is some cells wide, `factor` times as large.
[[nodiscard]] inline Shape resized(Shape shape, float factor) {
    if (auto* const ball = std::get_if<Sphere>(&shape))
        ball->radius *= factor;
    if (auto* const block = std::get_if<Block>(&shape))
        block->half_size *= factor;
    if (auto* const rod = std::get_if<Capsule>(&shape)) {
        rod->half_axis *= factor;
        rod->radius *= factor;
    }
    if (auto* const drum = std::get_if<Cylinder>(&shape)) {
        drum->radius *= factor;
        drum->half_length *= factor;
    }
    if (auto* const plate = std::get_if<Plate>(&shape))
        plate->half_size *= factor;
    if (auto* const mesh = std::get_if<MeshShape>(&shape))
        mesh->scale = factor;
    if (auto* const voxels = std::get_if<VoxelShape>(&shape))
        voxels->cell_size *= factor;
    return shape;
}

/// Where a scene is played: as it is, mirrored in x or z, turned about y by quarters, or moved a little.
class Frame {
  public:
    [[nodiscard]] static Frame mirrored(int axis) {
        Frame frame;
        frame.to_[axis][axis] = -1.0;
        return frame;
    }
    [[nodiscard]] static Frame turned(int quarters) {
        Frame frame;
        for (int n = 0; n < quarters; ++n)
            frame.to_ = glm::dmat3({0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}, {1.0, 0.0, 0.0}) * frame.to_;
        return frame;
    }
    [[nodiscard]] static Frame moved(glm::dvec3 by) {
        Frame frame;
        frame.by_ = by;
        return frame;
    }
    [[nodiscard]] bool is_mirror() const { return glm::determinant(to_) < 0.0; }
    [[nodiscard]] glm::dvec3 place(glm::dvec3 at) const { return to_ * at + by_; }
    [[nodiscard]] glm::vec3 way(glm::vec3 along) const { return glm::vec3(to_ * glm::dvec3(along)); }
    [[nodiscard]] glm::ivec3 cells(glm::ivec3 count) const { return glm::ivec3(glm::round(glm::abs(to_ * glm::dvec3(count)))); }
    /// A body is mirrored in its own x too, so that it turns and is not turned inside out.
    [[nodiscard]] glm::quat orientation(glm::quat of) const {
        glm::dmat3 own(1.0);
        own[0][0] = glm::determinant(to_);
        return glm::normalize(glm::quat_cast(glm::mat3(to_ * glm::mat3_cast(glm::dquat(of)) * own)));
    }
    [[nodiscard]] Obstacle obstacle(Obstacle body) const {
        body.position = place(body.position);
        body.orientation = orientation(body.orientation);
        if (auto* const rod = std::get_if<Capsule>(&body.shape); rod != nullptr && is_mirror())
            rod->half_axis.x = -rod->half_axis.x;
        return body;
    }
    /// Turbulence is left out: its eddies are where they are in the world.
    [[nodiscard]] Motor motor(Motor motor) const {
        std::visit(
            [&](auto& kind) {
                kind.position = place(kind.position);
                if constexpr (requires { kind.turbulence; })
                    kind.turbulence.intensity = 0.0f;
                if constexpr (requires { kind.direction; })
                    kind.direction = way(kind.direction);
                if constexpr (requires { kind.axis; })
                    kind.axis = static_cast<float>(glm::determinant(to_)) * way(kind.axis);
            },
            motor);
        return motor;
    }
    [[nodiscard]] DragDeposit deposit(DragDeposit plant) const {
        if (auto* const one = std::get_if<PlantDrag>(&plant))
            one->position = place(one->position);
        if (auto* const belt = std::get_if<BeltDrag>(&plant)) {
            belt->start = place(belt->start);
            belt->end = place(belt->end);
        }
        return plant;
    }
    [[nodiscard]] Boundaries boundaries(const Boundaries& of) const {
        Boundaries to;
        Boundary* const ends[] = {&to.x_low, &to.x_high, &to.y_low, &to.y_high, &to.z_low, &to.z_high};
        for (int axis = 0; axis < 3; ++axis)
            for (const int end : {0, 1}) {
                glm::vec3 out(0.0f);
                out[axis] = end == 0 ? -1.0f : 1.0f;
                out = way(out);
                for (int there = 0; there < 3; ++there)
                    if (std::abs(out[there]) > 0.5f)
                        *ends[2 * there + (out[there] > 0.0f ? 1 : 0)] = of.at(axis, end);
            }
        return to;
    }

  private:
    glm::dmat3 to_{1.0};
    glm::dvec3 by_{0.0}; ///< [m]
};

} // namespace windrow::test
