// One float as a half (to_half of fluid/textures.h, which includes this text too): rounded to nearest, ties to even, by integer
// arithmetic: the bits kept by the half, plus the carry of the dropped bits.
inline std::uint16_t half_of(float value) {
    constexpr std::uint32_t k_largest_half = 0x7bff; // 65504
    const auto bits = __builtin_bit_cast(std::uint32_t, value);
    const std::uint32_t sign = (bits >> 16) & 0x8000u;
    const std::uint32_t magnitude = bits & 0x7fffffffu;
    // Below 2^-14 a half counts multiples of 2^-24. Adding 1/2 makes the float adder round to these.
    const float counted = __builtin_bit_cast(float, magnitude < 0x38800000u ? magnitude : 0u) + 0.5f;
    const std::uint32_t small = __builtin_bit_cast(std::uint32_t, counted) - 0x3f000000u;
    const std::uint32_t rounded = (magnitude - 0x38000000u + 0xfffu + ((magnitude >> 13) & 1u)) >> 13;
    const std::uint32_t large = rounded < k_largest_half ? rounded : k_largest_half;
    const std::uint32_t half = sign | (magnitude < 0x38800000u ? small : large);
    return static_cast<std::uint16_t>(magnitude > 0x7f800000u ? 0u : half); // NaN
}
