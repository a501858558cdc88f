#include "fluid/cpu/sources.h"

#include "fluid/box.h"
#include "fluid/numerics.h"

#include <algorithm>
#include <cmath>
#include <variant>

namespace windrow::cpu {
namespace {

using detail::MotorReach;

// The cells whose centres lie within `low`..`high` [m from the box's corner]; false if there are none.
bool cover(MotorReach& reach, glm::vec3 low, glm::vec3 high, const Window& window) {
    const float h = window.cell_size;
    for (int axis = 0; axis < 3; ++axis) {
        const auto cells = static_cast<float>(window.cells[axis]);
        reach.low[axis] = static_cast<int>(std::clamp(std::floor(low[axis] / h - 0.5f), 0.0f, cells));
        reach.high[axis] = static_cast<int>(std::clamp(std::ceil(high[axis] / h + 0.5f), 0.0f, cells));
        if (reach.low[axis] >= reach.high[axis])
            return false;
    }
    return true;
}

glm::vec3 metres(const Window& window, glm::dvec3 position) {
    return glm::vec3(window.local_rounded(position) * static_cast<double>(window.cell_size));
}

struct RegionReach {
    MotorReach& reach;
    const Window& window;

    /// Share of its strength that a widened region keeps, so that its impulse stays.
    float operator()(const Sphere& sphere) const {
        reach.shape = MotorReach::Shape::sphere;
        reach.radius = numerics::windrow_widened(sphere.radius, window.cell_size);
        const float share = sphere.radius / reach.radius;
        return share * share * share;
    }
    float operator()(const Capsule& capsule) const {
        reach.shape = MotorReach::Shape::capsule;
        reach.extent = capsule.half_axis;
        reach.radius = numerics::windrow_widened(capsule.radius, window.cell_size);
        // Volume of the weight: a ball's 32 pi R^3 / 105 and pi R^2 / 3 for each metre of axis.
        const float length = 2.0f * glm::length(capsule.half_axis);
        const auto volume = [&](float radius) { return radius * radius * (32.0f / 105.0f * radius + length / 3.0f); };
        return volume(capsule.radius) / volume(reach.radius);
    }
    float operator()(const AlignedBox& box) const {
        reach.shape = MotorReach::Shape::box;
        float share = 1.0f;
        for (int axis = 0; axis < 3; ++axis) {
            reach.extent[axis] = numerics::windrow_widened(box.half_size[axis], window.cell_size);
            share *= box.half_size[axis] / reach.extent[axis];
        }
        return share;
    }
};

bool prepare(const DirectionalMotor& motor, const Motors::Slot&, float dt, const Window& window, MotorReach& reach) {
    const float share = std::visit(RegionReach{reach, window}, motor.region);
    if (const auto* force = std::get_if<Force>(&motor.law)) {
        reach.drives = false;
        reach.push = share * force->acceleration * motor.direction;
    } else {
        const auto& drive = std::get<Drive>(motor.law);
        reach.drives = true;
        reach.push = drive.speed * motor.direction;
        reach.exponent = share * drive.rate * dt;
    }
    reach.centre = metres(window, motor.position);
    const glm::vec3 half = reach.shape == MotorReach::Shape::box ? reach.extent
                           : reach.shape == MotorReach::Shape::capsule
                               ? glm::abs(reach.extent) + reach.radius
                               : glm::vec3(reach.radius);
    return cover(reach, reach.centre - half, reach.centre + half, window);
}

bool prepare(const WakeMotor& motor, const Motors::Slot& slot, float dt, const Window& window, MotorReach& reach) {
    if (motor.position == slot.path_start)
        return false;
    reach.shape = MotorReach::Shape::path;
    reach.radius = numerics::windrow_widened(motor.radius, window.cell_size);
    reach.centre = metres(window, slot.path_start);
    reach.extent = metres(window, motor.position);
    const glm::vec3 path = reach.extent - reach.centre;
    const float length = glm::length(path);
    if (!(length > 0.0f))
        return false;
    const float thin = motor.radius / reach.radius;
    const float share = thin * thin * thin;
    if (const auto* force = std::get_if<WakeForce>(&motor.law)) {
        reach.drives = false;
        reach.push = (share * force->strength / (dt * length)) * path;
    } else {
        const auto& drive = std::get<WakeDrive>(motor.law);
        reach.drives = true;
        reach.push = (drive.entrainment / dt) * path;
        reach.exponent = share * drive.per_metre;
    }
    return cover(reach, glm::min(reach.centre, reach.extent) - reach.radius, glm::max(reach.centre, reach.extent) + reach.radius, window);
}

float weight(const MotorReach& reach, glm::vec3 p) {
    switch (reach.shape) {
    case MotorReach::Shape::sphere:
        return numerics::windrow_sphere_weight(p - reach.centre, reach.radius);
    case MotorReach::Shape::capsule:
        return numerics::windrow_capsule_weight(p - reach.centre, reach.extent, reach.radius);
    case MotorReach::Shape::box:
        return numerics::windrow_box_weight(p - reach.centre, reach.extent);
    default:
        return numerics::windrow_wake_path(p, reach.centre, reach.extent, reach.radius);
    }
}

} // namespace

ForceField::ForceField(glm::ivec3 cells)
    : cells_(cells), values_(static_cast<std::size_t>(cells.x) * cells.y * cells.z), row_holds_(static_cast<std::size_t>(cells.y) * cells.z),
      plane_largest_(static_cast<std::size_t>(cells.z)) {}

void ForceField::add_to(std::span<glm::vec4> velocity, float factor, const ParallelFor& parallel_for) const {
    if (!any_)
        return;
    parallel_for(cells_.z, [&](int k) {
        for (int j = 0; j < cells_.y; ++j) {
            const std::size_t row = static_cast<std::size_t>(k) * cells_.y + j;
            if (row_holds_[row] == 0)
                continue;
            for (std::size_t n = row * cells_.x; n < (row + 1) * cells_.x; ++n)
                velocity[n] += factor * values_[n];
        }
    });
}

int apply_motors(Motors& motors, const Window& window, float dt, std::span<glm::vec4> velocity, ForceField& forces, const ParallelFor& parallel_for) {
    int reached = 0;
    const std::span<MotorReach> list = motors.reach();
    for (const Motors::Slot& slot : motors.slots()) {
        if (!slot.used)
            continue;
        MotorReach& reach = list[reached];
        if (std::visit([&](const auto& kind) { return prepare(kind, slot, dt, window, reach); }, slot.motor))
            ++reached;
    }
    motors.finish_paths();
    const bool held_any = forces.any_;
    forces.any_ = false;
    forces.largest_ = 0.0f;
    if (reached == 0 && !held_any)
        return 0;

    const glm::ivec3 cells = window.cells;
    parallel_for(cells.z, [&](int k) {
        glm::vec4 drives[k_max_axis_cells]; // sum of E U, and of E in w
        forces.plane_largest_[k] = 0.0f;
        for (int j = 0; j < cells.y; ++j) {
            const std::size_t row = static_cast<std::size_t>(k) * cells.y + j;
            glm::vec4* const force_row = forces.values_.data() + row * cells.x;
            bool any_force = false;
            int drive_low = cells.x, drive_high = 0;
            for (int n = 0; n < reached; ++n) {
                const MotorReach& reach = list[n];
                if (k < reach.low.z || k >= reach.high.z || j < reach.low.y || j >= reach.high.y)
                    continue;
                if (!reach.drives && !any_force) {
                    std::fill(force_row, force_row + cells.x, glm::vec4(0.0f));
                    any_force = true;
                }
                if (reach.drives && drive_low > drive_high)
                    std::fill(drives, drives + cells.x, glm::vec4(0.0f));
                if (reach.drives) {
                    drive_low = std::min(drive_low, reach.low.x);
                    drive_high = std::max(drive_high, reach.high.x);
                }
                for (int i = reach.low.x; i < reach.high.x; ++i) {
                    const glm::vec3 centre = window.cell_size * (glm::vec3(i, j, k) + 0.5f);
                    const float w = weight(reach, centre);
                    if (w == 0.0f)
                        continue;
                    if (reach.drives) {
                        const float exponent = w * reach.exponent;
                        drives[i] += glm::vec4(exponent * reach.push, exponent);
                    } else {
                        force_row[i] += glm::vec4(w * reach.push, 0.0f);
                    }
                }
            }
            forces.row_holds_[row] = any_force ? 1 : 0;
            if (any_force)
                for (int i = 0; i < cells.x; ++i)
                    for (int axis = 0; axis < 3; ++axis)
                        forces.plane_largest_[k] = std::max(forces.plane_largest_[k], std::abs(force_row[i][axis]));
            for (int i = drive_low; i < drive_high; ++i) {
                const float exponent = drives[i].w;
                if (exponent > 0.0f) {
                    glm::vec4& u = velocity[row * cells.x + i];
                    u = glm::vec4(numerics::windrow_drive(glm::vec3(u), glm::vec3(drives[i]) / exponent, exponent), 0.0f);
                }
            }
        }
    });
    for (int k = 0; k < cells.z; ++k)
        forces.largest_ = std::max(forces.largest_, forces.plane_largest_[k]);
    for (std::size_t row = 0; row < forces.row_holds_.size() && !forces.any_; ++row)
        forces.any_ = forces.row_holds_[row] != 0;
    return reached;
}

} // namespace windrow::cpu
