// Cells as texels (fluid/textures.h).
#include "fluid/cpu/kernels/kernels.h"
#include "fluid/textures.h"

#include <bit>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace windrow {
namespace {

#include "fluid/cpu/kernels/half_text.inl"

} // namespace

std::uint16_t to_half(float value) {
    return half_of(value);
}

float from_half(std::uint16_t half) {
    const std::uint32_t sign = (half & 0x8000u) << 16;
    const std::uint32_t exponent = (half >> 10) & 0x1fu;
    const std::uint32_t fraction = half & 0x3ffu;
    if (exponent == 0)
        return std::copysign(static_cast<float>(fraction) * 0x1p-24f, std::bit_cast<float>(sign));
    if (exponent == 31)
        return std::bit_cast<float>(sign | 0x7f800000u | (fraction << 13));
    return std::bit_cast<float>(sign | ((exponent + 112u) << 23) | (fraction << 13));
}

void extract_axis(std::span<const glm::vec4> field, int axis, std::span<float> texels) {
    assert(axis >= 0 && axis < 3 && texels.size() == field.size());
    for (std::size_t n = 0; n < field.size(); ++n)
        texels[n] = field[n][axis];
}

void extract_axis(std::span<const glm::vec4> field, int axis, std::span<std::uint16_t> half_texels) {
    assert(axis >= 0 && axis < 3 && half_texels.size() == field.size());
    if (!field.empty())
        cpu::best_kernels().halve_axis(&field.data()->x, field.size(), axis, half_texels.data());
}

void pack_vectors(std::span<const glm::vec4> field, std::span<float> texels) {
    assert(texels.size() == 4 * field.size());
    for (std::size_t n = 0; n < field.size(); ++n)
        for (int axis = 0; axis < 4; ++axis)
            texels[4 * n + static_cast<std::size_t>(axis)] = axis < 3 ? field[n][axis] : 0.0f;
}

void pack_vectors(std::span<const glm::vec4> field, std::span<std::uint16_t> half_texels) {
    assert(half_texels.size() == 4 * field.size());
    if (!field.empty())
        cpu::best_kernels().halve_vectors(&field.data()->x, field.size(), half_texels.data());
}

} // namespace windrow
