#include "cases/reference/voxel_step.h"

#include <algorithm>
#include <glm/common.hpp>

namespace windrow::reference {

VoxelStep::VoxelStep(glm::ivec3 cells, float cell_size, int sweeps, glm::vec3 ambient,
                     const std::function<bool(glm::ivec3)>& is_solid, ParallelFor parallel_for)
    : cells_(cells), cell_size_(cell_size), sweeps_(sweeps), ambient_(ambient.x, 0.0f, ambient.z), parallel_for_(parallel_for) {
    const auto count = static_cast<std::size_t>(cells.x) * static_cast<std::size_t>(cells.y) * static_cast<std::size_t>(cells.z);
    solid_.resize(count);
    for (int k = 0; k < cells.z; ++k)
        for (int j = 0; j < cells.y; ++j)
            for (int i = 0; i < cells.x; ++i)
                solid_[index({i, j, k})] = is_solid({i, j, k}) ? 1 : 0;
    velocity_.assign(count, glm::vec4(0.0f));
    advected_ = velocity_;
    divergence_.assign(count, 0.0f);
    pressure_ = next_pressure_ = divergence_;
}

// The ambient wind beyond the open boundaries, the mirrored cell below the floor.
glm::vec3 VoxelStep::at(glm::ivec3 cell) const {
    if (cell.x < 0 || cell.z < 0 || cell.x >= cells_.x || cell.y >= cells_.y || cell.z >= cells_.z)
        return ambient_;
    if (cell.y < 0)
        return glm::vec3(1.0f, -1.0f, 1.0f) * glm::vec3(velocity_[index({cell.x, -1 - cell.y, cell.z})]);
    return glm::vec3(velocity_[index(cell)]);
}

glm::vec3 VoxelStep::sample(glm::vec3 cell) const {
    const glm::vec3 place = glm::clamp(cell, glm::vec3(-1.0f, -0.5f, -1.0f), glm::vec3(cells_));
    const glm::ivec3 low(glm::floor(place));
    const glm::vec3 part = place - glm::vec3(low);
    glm::vec3 sum(0.0f);
    for (int n = 0; n < 8; ++n) {
        const glm::ivec3 corner(n & 1, n >> 1 & 1, n >> 2);
        const glm::vec3 weights = glm::mix(1.0f - part, part, glm::vec3(corner));
        sum += weights.x * weights.y * weights.z * at(low + corner);
    }
    return sum;
}

template <class Visit>
void VoxelStep::for_each_air(const Visit& visit) const {
    parallel_for_(cells_.z, [&](int k) {
        for (int j = 0; j < cells_.y; ++j)
            for (int i = 0; i < cells_.x; ++i)
                if (const glm::ivec3 cell(i, j, k); solid_[index(cell)] == 0)
                    visit(index(cell), cell);
    });
}

void VoxelStep::set_velocity(std::span<const glm::vec4> velocity) {
    for (std::size_t n = 0; n < velocity_.size(); ++n)
        velocity_[n] = solid_[n] != 0 ? glm::vec4(0.0f) : velocity[n];
}

// Of a neighbour: the cell's own beside a solid and over the floor, 0 beyond an open boundary.
float VoxelStep::pressure_beside(glm::ivec3 cell, int axis, int side) const {
    const float own = pressure_[index(cell)];
    cell[axis] += side;
    if (cell.y < 0)
        return own;
    if (cell[axis] < 0 || cell[axis] >= cells_[axis])
        return 0.0f;
    return solid_[index(cell)] != 0 ? own : pressure_[index(cell)];
}

void VoxelStep::step(float dt) {
    std::fill(advected_.begin(), advected_.end(), glm::vec4(0.0f));
    for_each_air([&](std::size_t n, glm::ivec3 cell) {
        advected_[n] = glm::vec4(sample(glm::vec3(cell) - dt / cell_size_ * glm::vec3(velocity_[n])), 0.0f);
    });
    // The divergence reads the cell itself beyond an open boundary, its mirror below the floor, and 0 in solids.
    for_each_air([&](std::size_t n, glm::ivec3 cell) {
        float sum = 0.0f;
        for (int axis = 0; axis < 3; ++axis)
            for (const int side : {-1, 1}) {
                glm::ivec3 other = cell;
                other[axis] = std::clamp(cell[axis] + side, 0, cells_[axis] - 1);
                const float sign = cell[axis] + side < 0 && axis == 1 ? -1.0f : 1.0f;
                sum += static_cast<float>(side) * sign * advected_[index(other)][axis];
            }
        divergence_[n] = 0.5f * sum;
    });
    std::fill(pressure_.begin(), pressure_.end(), 0.0f);
    for (int sweep = 0; sweep < sweeps_; ++sweep) {
        for_each_air([&](std::size_t n, glm::ivec3 cell) {
            float sum = -divergence_[n];
            for (int axis = 0; axis < 3; ++axis)
                sum += pressure_beside(cell, axis, -1) + pressure_beside(cell, axis, 1);
            next_pressure_[n] = sum / 6.0f;
        });
        pressure_.swap(next_pressure_);
    }
    for_each_air([&](std::size_t n, glm::ivec3 cell) {
        for (int axis = 0; axis < 3; ++axis) {
            bool beside_solid = false;
            for (const int side : {-1, 1}) {
                glm::ivec3 other = cell;
                other[axis] += side;
                beside_solid = beside_solid || (other[axis] >= 0 && other[axis] < cells_[axis] && solid_[index(other)] != 0);
            }
            velocity_[n][axis] =
                beside_solid ? 0.0f
                             : advected_[n][axis] - 0.5f * (pressure_beside(cell, axis, 1) - pressure_beside(cell, axis, -1));
        }
    });
}

} // namespace windrow::reference
