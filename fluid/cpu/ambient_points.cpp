// The ambient wind at points, by the kernels of this machine, and what a shader needs to find the same.
#include "fluid/ambient.h"
#include "fluid/cpu/point_tasks.h"
#include "fluid/window.h"

#include <algorithm>

namespace windrow {
glm::vec3 AmbientWind::velocity(glm::dvec3 position) const {
    if (uniform())
        return settings_.mean;
    glm::vec3 wind;
    velocity(std::span(&position, 1), std::span(&wind, 1));
    return wind;
}

void AmbientWind::velocity(std::span<const glm::dvec3> positions, std::span<glm::vec3> velocities) const {
    const std::size_t count = std::min(positions.size(), velocities.size());
    if (count == 0)
        return;
    cpu::AmbientTask task;
    cpu::set_ambient(task, *this);
    cpu::best_kernels().sample_ambient(task, &positions.data()->x, count, 3, &velocities.data()->x);
}

glm::vec3 AmbientWind::felt(glm::vec3 velocity, glm::dvec3 position, const Sampling& sampling) const {
    felt(std::span(&position, 1), sampling, std::span(&velocity, 1));
    return velocity;
}

void AmbientWind::felt(std::span<const glm::dvec3> positions, const Sampling& sampling, std::span<glm::vec3> velocities) const {
    const std::size_t count = std::min(positions.size(), velocities.size());
    if (count > 0)
        cpu::best_kernels().feel(cpu::felt_task(*this, sampling), &positions.data()->x, count, 3, &velocities.data()->x);
}

AmbientBlock AmbientWind::block(glm::dvec3 anchor, const Sampling& asked) const {
    const Sampling sampling = cpu::usable(asked);
    anchor = detail::usable_anchor(anchor);
    AmbientBlock block;
    block.mean = settings_.mean;
    block.gust_strength = gust_strength();
    if (settings_.profile) {
        block.roughness_length = settings_.profile->roughness_length;
        block.reference_height = settings_.profile->reference_height;
    }
    block.anchor_height = static_cast<float>(std::clamp(anchor.y - settings_.ground, k_world_range.min, k_world_range.max));
    block.felt_strength = sampling.strength;
    block.gust_texels = static_cast<float>(1.0 / texel());
    block.longest_gust = tile() ? tile()->bound() : 1.0f;
    block.gust_axes = gust_axes_;
    block.felt_limit = sampling.limit;
    const int repeats = cpu::detail_repeats(*this, sampling);
    block.detail_texels = static_cast<float>(repeats / texel());
    block.detail_amount = tile() ? sampling.detail : 0.0f;
    for (int axis = 0; axis < 3; ++axis) {
        const TilePlace gust = gusting() ? gust_place(axis, anchor[axis]) : TilePlace{};
        block.gust_texel[axis] = static_cast<float>(gust.texel);
        block.gust_fraction[axis] = gust.fraction;
        const TilePlace ripple = block.detail_amount > 0.0f ? place(axis, anchor[axis], repeats) : TilePlace{};
        block.detail_texel[axis] = static_cast<float>(ripple.texel);
        block.detail_fraction[axis] = ripple.fraction;
    }
    return block;
}

AmbientWind::TilePlace AmbientWind::place(int axis, double coordinate, int repeats) const {
    return cpu::tile_place(cpu::tile_axis(*this, axis, repeats), coordinate);
}

} // namespace windrow
