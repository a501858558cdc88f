// Halves of a field, for textures: the conversion of AVX2 machines (F16C) where there is one, the text of half_text.inl elsewhere,
// with the same bits. The instruction rounds to nearest, ties to even, and keeps denormal halves; numbers beyond the largest half
// and those that are not numbers are replaced before it.
#include "fluid/cpu/kernels/half_text.inl"

#if defined(__AVX512F__) || defined(__F16C__)
inline void store_halves(std::uint16_t* p, Native numbers) {
    constexpr Native k_most = 65504.0f - Native{};
    const Native below = numbers < k_most ? numbers : k_most, bounded = below > -k_most ? below : -k_most;
    const Native known = numbers == numbers ? bounded : Native{};
#if defined(__AVX512F__)
    const __m256i halves =
        _mm512_maskz_cvtps_ph(0xffff, reinterpret_cast<__m512>(known), _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(p), halves);
#else
    const __m128i halves = _mm256_cvtps_ph(reinterpret_cast<__m256>(known), _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
    _mm_storeu_si128(reinterpret_cast<__m128i*>(p), halves);
#endif
}
#else
inline void store_halves(std::uint16_t* p, Native numbers) {
    float values[k_native_lanes];
    store_native(values, numbers);
    for (int n = 0; n < k_native_lanes; ++n)
        p[n] = half_of(values[n]);
}
#endif

void halve_vectors(const float* cells, std::size_t count, std::uint16_t* halves) {
    std::size_t n = 0;
    for (; n + k_native_cells <= count; n += k_native_cells) {
        Native numbers = load_native(cells + 4 * n);
        numbers = reinterpret_cast<Native>(reinterpret_cast<NativeBits>(numbers) & ~k_is_w);
        store_halves(halves + 4 * n, numbers);
    }
    for (std::size_t at = 4 * n; at < 4 * count; ++at)
        halves[at] = at % 4 < 3 ? half_of(cells[at]) : std::uint16_t{0};
}

void halve_axis(const float* cells, std::size_t count, int axis, std::uint16_t* halves) {
    std::size_t n = 0;
    for (; n + k_native_lanes <= count; n += k_native_lanes) {
        float values[k_native_lanes];
        for (int lane = 0; lane < k_native_lanes; ++lane)
            values[lane] = cells[4 * (n + lane) + axis];
        store_halves(halves + n, load_native(values));
    }
    for (; n < count; ++n)
        halves[n] = half_of(cells[4 * n + axis]);
}
