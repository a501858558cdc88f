// The step of StamStep: passes over planes for the threads. The passes themselves lie in stam_planes.inl and jacobi_plane.inl;
// psi = p / h, so that no spacing appears in the sweeps.
//
// Memory a step: 64 B a cell + 24 (divergence, gradient) + 12 a sweep.
#include "cases/reference/stam.h"

#include <cstdint>
#include <cstring>

namespace windrow::reference {
namespace {

// Cells outside that a trilinear read at a legal position touches: position -1 needs cell -1, position n needs n and n + 1.
constexpr int k_halo_low = 1;
constexpr int k_halo = 3;

std::size_t padded_floats(glm::ivec3 cells) {
    return 4 * static_cast<std::size_t>(cells.x + k_halo) * static_cast<std::size_t>(cells.y + k_halo) *
           static_cast<std::size_t>(cells.z + k_halo);
}

} // namespace

StamStep::StamStep(glm::ivec3 cells, float cell_size, int sweeps, ParallelFor parallel_for, Simd simd)
    : kernels_(kernels_for(simd)), cells_(cells), cell_size_(cell_size), sweeps_(sweeps), parallel_for_(parallel_for),
      row_stride_(4 * (static_cast<std::ptrdiff_t>(cells.x) + k_halo)), plane_stride_(row_stride_ * (cells.y + k_halo)),
      velocity_(padded_floats(cells)), advected_(velocity_.size()),
      divergence_(static_cast<std::size_t>(cells.x) * static_cast<std::size_t>(cells.y) * static_cast<std::size_t>(cells.z)),
      jacobi_(cells, simd), dense_(divergence_.size()) {}

std::ptrdiff_t StamStep::row(int j, int k) const {
    return (k + k_halo_low) * plane_stride_ + (j + k_halo_low) * row_stride_ + 4 * k_halo_low;
}

std::size_t StamStep::memory_bytes() const {
    return velocity_.bytes() + advected_.bytes() + divergence_.bytes() + jacobi_.memory_bytes();
}

// Jacobi swaps its arrays, so the task is made again for each pass that reads the pressure.
StamTask StamStep::task(float dt) {
    return {.cells = {cells_.x, cells_.y, cells_.z},
            .row_stride = row_stride_,
            .plane_stride = plane_stride_,
            .velocity = velocity_.data() + row(0, 0),
            .advected = advected_.data() + row(0, 0),
            .divergence = divergence_.data(),
            .pressure = jacobi_.row(0, 0),
            .pressure_pitch = static_cast<std::ptrdiff_t>(jacobi_.pitch()),
            .cells_per_speed = dt / cell_size_};
}

void StamStep::step(float dt) {
    if (touched_)
        parallel_for_(cells_.z, [&](int k) { pack_plane(k); });
    touched_ = false;
    const StamTask before = task(dt);
    parallel_for_(cells_.z, [&](int k) { kernels_.advect_plane(before, k); });
    parallel_for_(cells_.z, [&](int k) { kernels_.divergence_plane(before, k); });
    jacobi_.solve(divergence_, sweeps_, parallel_for_);
    const StamTask after = task(dt);
    parallel_for_(cells_.z, [&](int k) { kernels_.gradient_plane(after, k); });
}

std::span<glm::vec4> StamStep::velocity() {
    if (!touched_)
        parallel_for_(cells_.z, [&](int k) { unpack_plane(k); });
    touched_ = true;
    return dense_;
}

// Everything is ambient first; what lies inside, and below the floor, is written over it.
void StamStep::set_ambient(glm::vec3 ambient) {
    static_cast<void>(velocity());
    const float beyond[4] = {ambient.x, 0.0f, ambient.z, 0.0f};
    for (std::size_t n = 0; n < velocity_.size(); n += 4)
        std::memcpy(velocity_.data() + n, beyond, sizeof beyond);
}

void StamStep::pack_plane(int k) {
    const std::size_t row_bytes = sizeof(glm::vec4) * static_cast<std::size_t>(cells_.x);
    for (int j = 0; j < cells_.y; ++j)
        std::memcpy(velocity_.data() + row(j, k), &dense_[(static_cast<std::size_t>(k) * cells_.y + j) * cells_.x], row_bytes);
    kernels_.mirror_floor(task(0.0f), k);
}

void StamStep::unpack_plane(int k) {
    const std::size_t row_bytes = sizeof(glm::vec4) * static_cast<std::size_t>(cells_.x);
    for (int j = 0; j < cells_.y; ++j)
        std::memcpy(static_cast<void*>(&dense_[(static_cast<std::size_t>(k) * cells_.y + j) * cells_.x]),
                    velocity_.data() + row(j, k), row_bytes);
}

} // namespace windrow::reference
