// Small vectors: Cell (four floats, one cell's velocity) and Block (sixteen floats: four cells, or k_lanes columns).
//
// Written with the compiler's vector types, so one text serves SSE, AVX2, AVX-512 and NEON; intrinsics only where the
// language has no word: the fused multiply-add.

#if defined(__AVX512F__)
constexpr int k_native_lanes = 16;
#elif defined(__AVX__)
constexpr int k_native_lanes = 8;
#else
constexpr int k_native_lanes = 4;
#endif
constexpr int k_parts = k_lanes / k_native_lanes;

typedef float Cell __attribute__((vector_size(16)));
typedef float CellUnaligned __attribute__((vector_size(16), aligned(4), may_alias));
typedef std::int32_t CellInt __attribute__((vector_size(16)));
typedef float Native __attribute__((vector_size(k_native_lanes * 4)));
typedef float NativeUnaligned __attribute__((vector_size(k_native_lanes * 4), aligned(4), may_alias));

inline Cell load_cell(const float* p) { return *reinterpret_cast<const CellUnaligned*>(p); }
inline void store_cell(float* p, Cell value) { *reinterpret_cast<CellUnaligned*>(p) = value; }
inline Native load_native(const float* p) { return *reinterpret_cast<const NativeUnaligned*>(p); }
inline void store_native(float* p, Native value) { *reinterpret_cast<NativeUnaligned*>(p) = value; }
inline Cell splat(float value) { return Cell{value, value, value, value}; }

// a * b + c, fused where the level has the instruction.
inline Cell multiply_add(Cell a, Cell b, Cell c) {
#if defined(__FMA__)
    return reinterpret_cast<Cell>(_mm_fmadd_ps(reinterpret_cast<__m128>(a), reinterpret_cast<__m128>(b), reinterpret_cast<__m128>(c)));
#else
    return a * b + c;
#endif
}
inline float multiply_add(float a, float b, float c) {
#if defined(__FMA__)
    return __builtin_fmaf(a, b, c);
#else
    return a * b + c;
#endif
}
#if defined(__AVX512F__)
inline Native multiply_add(Native a, Native b, Native c) {
    return reinterpret_cast<Native>(_mm512_fmadd_ps(reinterpret_cast<__m512>(a), reinterpret_cast<__m512>(b), reinterpret_cast<__m512>(c)));
}
#elif defined(__FMA__)
inline Native multiply_add(Native a, Native b, Native c) {
    return reinterpret_cast<Native>(_mm256_fmadd_ps(reinterpret_cast<__m256>(a), reinterpret_cast<__m256>(b), reinterpret_cast<__m256>(c)));
}
#endif

struct Block {
    Native part[k_parts];
};
inline Block load_block(const float* p) {
    Block block;
    for (int n = 0; n < k_parts; ++n)
        block.part[n] = load_native(p + n * k_native_lanes);
    return block;
}
inline void store_block(float* p, const Block& block) {
    for (int n = 0; n < k_parts; ++n)
        store_native(p + n * k_native_lanes, block.part[n]);
}
inline Block operator+(Block a, const Block& b) {
    for (int n = 0; n < k_parts; ++n)
        a.part[n] += b.part[n];
    return a;
}
inline Block operator-(Block a, const Block& b) {
    for (int n = 0; n < k_parts; ++n)
        a.part[n] -= b.part[n];
    return a;
}
inline Block operator*(Block a, const Block& b) {
    for (int n = 0; n < k_parts; ++n)
        a.part[n] *= b.part[n];
    return a;
}
// a * weight + c
inline Block multiply_add(const Block& a, float weight, Block c) {
    for (int n = 0; n < k_parts; ++n)
        c.part[n] = multiply_add(a.part[n], weight - Native{}, c.part[n]);
    return c;
}
// c - a * b, lane by lane
inline Block subtract_product(const Block& a, const Block& b, Block c) {
    for (int n = 0; n < k_parts; ++n)
        c.part[n] = multiply_add(-a.part[n], b.part[n], c.part[n]);
    return c;
}

// Cell n of a block: by shuffles, since a pointer into the block would send it through memory.
template <int N>
inline Cell cell_of(const Block& block) {
#if defined(__AVX512F__)
    return __builtin_shufflevector(block.part[0], block.part[0], 4 * N, 4 * N + 1, 4 * N + 2, 4 * N + 3);
#elif defined(__AVX__)
    constexpr int k_first = 4 * (N % 2);
    return __builtin_shufflevector(block.part[N / 2], block.part[N / 2], k_first, k_first + 1, k_first + 2, k_first + 3);
#else
    return block.part[N];
#endif
}
