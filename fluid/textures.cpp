#include "fluid/textures.h"

#include <bit>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace windrow {
namespace {

constexpr std::uint32_t k_largest_half = 0x7bff; // 65504

} // namespace

// Rounds to nearest, ties to even, by integer arithmetic: the bits kept by the half, plus the carry of the dropped bits.
std::uint16_t to_half(float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    const std::uint32_t sign = (bits >> 16) & 0x8000u;
    const std::uint32_t magnitude = bits & 0x7fffffffu;
    if (magnitude > 0x7f800000u)
        return 0; // NaN
    if (magnitude < 0x38800000u) {
        // Below 2^-14 a half counts multiples of 2^-24. Adding 1/2 makes the float adder round to these.
        const float counted = std::bit_cast<float>(magnitude) + 0.5f;
        return static_cast<std::uint16_t>(sign | (std::bit_cast<std::uint32_t>(counted) - 0x3f000000u));
    }
    const std::uint32_t rounded = (magnitude - 0x38000000u + 0xfffu + ((magnitude >> 13) & 1u)) >> 13;
    return static_cast<std::uint16_t>(sign | (rounded < k_largest_half ? rounded : k_largest_half));
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
    for (std::size_t n = 0; n < field.size(); ++n)
        half_texels[n] = to_half(field[n][axis]);
}

} // namespace windrow
