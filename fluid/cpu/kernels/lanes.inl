// Small vectors: Cell (four floats, one cell's velocity) and Block (sixteen floats: four cells, or k_lanes columns).
//
// Written with the compiler's vector types, so that one text serves SSE, AVX2, AVX-512 and NEON. Intrinsics are used only for
// operations that the language lacks: the fused multiply-add.

#if defined(__AVX512F__)
constexpr int k_native_lanes = 16;
#elif defined(__AVX__)
constexpr int k_native_lanes = 8;
#else
constexpr int k_native_lanes = 4;
#endif
constexpr int k_parts = k_lanes / k_native_lanes;
constexpr int k_native_cells = k_native_lanes / 4; // in a register

typedef float Cell __attribute__((vector_size(16)));
typedef float CellUnaligned __attribute__((vector_size(16), aligned(4), may_alias));
typedef std::int32_t CellInt __attribute__((vector_size(16)));
typedef float Native __attribute__((vector_size(k_native_lanes * 4)));
typedef float NativeUnaligned __attribute__((vector_size(k_native_lanes * 4), aligned(4), may_alias));

inline Cell load_cell(const float* p) {
    return *reinterpret_cast<const CellUnaligned*>(p);
}
inline void store_cell(float* p, Cell value) {
    *reinterpret_cast<CellUnaligned*>(p) = value;
}
inline Native load_native(const float* p) {
    return *reinterpret_cast<const NativeUnaligned*>(p);
}
inline void store_native(float* p, Native value) {
    *reinterpret_cast<NativeUnaligned*>(p) = value;
}
inline Cell splat(float value) {
    return Cell{value, value, value, value};
}

// A register of either width, for loops that do whole registers first and single cells at the end.
template <class V>
inline V load(const float* p);
template <>
inline Cell load<Cell>(const float* p) {
    return load_cell(p);
}
// The cell repeated.
template <class V>
inline V repeat(Cell cell);
template <>
inline Cell repeat<Cell>(Cell cell) {
    return cell;
}
#if defined(__AVX512F__)
template <>
inline Native load<Native>(const float* p) {
    return load_native(p);
}
template <>
inline Native repeat<Native>(Cell cell) {
    return reinterpret_cast<Native>(_mm512_maskz_broadcast_f32x4(0xffff, reinterpret_cast<__m128>(cell)));
}
#elif defined(__AVX__)
template <>
inline Native load<Native>(const float* p) {
    return load_native(p);
}
template <>
inline Native repeat<Native>(Cell cell) {
    return __builtin_shufflevector(cell, cell, 0, 1, 2, 3, 0, 1, 2, 3);
}
#endif

// a * b + c, fused where the level has the instruction.
inline Cell multiply_add(Cell a, Cell b, Cell c) {
#if defined(__FMA__)
    return reinterpret_cast<Cell>(
        _mm_fmadd_ps(reinterpret_cast<__m128>(a), reinterpret_cast<__m128>(b), reinterpret_cast<__m128>(c)));
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
    return reinterpret_cast<Native>(
        _mm512_fmadd_ps(reinterpret_cast<__m512>(a), reinterpret_cast<__m512>(b), reinterpret_cast<__m512>(c)));
}
#elif defined(__FMA__)
inline Native multiply_add(Native a, Native b, Native c) {
    return reinterpret_cast<Native>(
        _mm256_fmadd_ps(reinterpret_cast<__m256>(a), reinterpret_cast<__m256>(b), reinterpret_cast<__m256>(c)));
}
#endif

// a + t (b - a)
inline Cell lerp(Cell a, Cell b, float t) {
    return multiply_add(splat(t), b - a, a);
}

// Two adjacent cells.
#if defined(__AVX__)
typedef float Pair __attribute__((vector_size(32)));
typedef float PairUnaligned __attribute__((vector_size(32), aligned(4), may_alias));
inline Pair load_pair(const float* p) {
    return *reinterpret_cast<const PairUnaligned*>(p);
}
// a * weight + c
inline Pair multiply_add(Pair a, float weight, Pair c) {
    return reinterpret_cast<Pair>(
        _mm256_fmadd_ps(reinterpret_cast<__m256>(a), _mm256_set1_ps(weight), reinterpret_cast<__m256>(c)));
}
#else
struct Pair {
    Cell low, high;
};
inline Pair load_pair(const float* p) {
    return {load_cell(p), load_cell(p + 4)};
}
inline Pair operator-(Pair a, Pair b) {
    return {a.low - b.low, a.high - b.high};
}
inline Pair multiply_add(Pair a, float weight, Pair c) {
    return {multiply_add(a.low, splat(weight), c.low), multiply_add(a.high, splat(weight), c.high)};
}
#endif
inline Pair lerp(Pair a, Pair b, float t) {
    return multiply_add(b - a, t, a);
}

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
// The two cells in its middle.
inline Pair middle(const Block& block) {
#if defined(__AVX512F__)
    return __builtin_shufflevector(block.part[0], block.part[0], 4, 5, 6, 7, 8, 9, 10, 11);
#elif defined(__AVX__)
    return __builtin_shufflevector(block.part[0], block.part[1], 4, 5, 6, 7, 8, 9, 10, 11);
#else
    return {block.part[1], block.part[2]};
#endif
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
inline Block lerp(const Block& a, const Block& b, float t) {
    return multiply_add(b - a, t, a);
}
// c - a * b, lane by lane
inline Block subtract_product(const Block& a, const Block& b, Block c) {
    for (int n = 0; n < k_parts; ++n)
        c.part[n] = multiply_add(-a.part[n], b.part[n], c.part[n]);
    return c;
}

// The four cells of each of some blocks: the first cells of all blocks, then the second, and so on. By shuffles, since a pointer
// into a block would force it into memory.
struct Nodes {
    Native before, here, after, beyond;
};
inline Nodes transpose(const Block (&blocks)[k_native_cells]) {
#if defined(__AVX512F__)
    const Native a = blocks[0].part[0], b = blocks[1].part[0], c = blocks[2].part[0], d = blocks[3].part[0];
    const Native ab_low = __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7, 16, 17, 18, 19, 20, 21, 22, 23);
    const Native cd_low = __builtin_shufflevector(c, d, 0, 1, 2, 3, 4, 5, 6, 7, 16, 17, 18, 19, 20, 21, 22, 23);
    const Native ab_high = __builtin_shufflevector(a, b, 8, 9, 10, 11, 12, 13, 14, 15, 24, 25, 26, 27, 28, 29, 30, 31);
    const Native cd_high = __builtin_shufflevector(c, d, 8, 9, 10, 11, 12, 13, 14, 15, 24, 25, 26, 27, 28, 29, 30, 31);
    return {__builtin_shufflevector(ab_low, cd_low, 0, 1, 2, 3, 8, 9, 10, 11, 16, 17, 18, 19, 24, 25, 26, 27),
            __builtin_shufflevector(ab_low, cd_low, 4, 5, 6, 7, 12, 13, 14, 15, 20, 21, 22, 23, 28, 29, 30, 31),
            __builtin_shufflevector(ab_high, cd_high, 0, 1, 2, 3, 8, 9, 10, 11, 16, 17, 18, 19, 24, 25, 26, 27),
            __builtin_shufflevector(ab_high, cd_high, 4, 5, 6, 7, 12, 13, 14, 15, 20, 21, 22, 23, 28, 29, 30, 31)};
#elif defined(__AVX__)
    const Native a_low = blocks[0].part[0], a_high = blocks[0].part[1], b_low = blocks[1].part[0], b_high = blocks[1].part[1];
    return {__builtin_shufflevector(a_low, b_low, 0, 1, 2, 3, 8, 9, 10, 11),
            __builtin_shufflevector(a_low, b_low, 4, 5, 6, 7, 12, 13, 14, 15),
            __builtin_shufflevector(a_high, b_high, 0, 1, 2, 3, 8, 9, 10, 11),
            __builtin_shufflevector(a_high, b_high, 4, 5, 6, 7, 12, 13, 14, 15)};
#else
    return {blocks[0].part[0], blocks[0].part[1], blocks[0].part[2], blocks[0].part[3]};
#endif
}

// The same for pairs of cells.
struct Ends {
    Native here, after;
};
inline Ends transpose(const Pair (&pairs)[k_native_cells]) {
#if defined(__AVX512F__)
    const Native ab = __builtin_shufflevector(pairs[0], pairs[1], 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    const Native cd = __builtin_shufflevector(pairs[2], pairs[3], 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    return {__builtin_shufflevector(ab, cd, 0, 1, 2, 3, 8, 9, 10, 11, 16, 17, 18, 19, 24, 25, 26, 27),
            __builtin_shufflevector(ab, cd, 4, 5, 6, 7, 12, 13, 14, 15, 20, 21, 22, 23, 28, 29, 30, 31)};
#elif defined(__AVX__)
    return {__builtin_shufflevector(pairs[0], pairs[1], 0, 1, 2, 3, 8, 9, 10, 11),
            __builtin_shufflevector(pairs[0], pairs[1], 4, 5, 6, 7, 12, 13, 14, 15)};
#else
    return {pairs[0].low, pairs[0].high};
#endif
}

// One float a cell, each four times.
inline Native spread(const float* p) {
#if defined(__AVX512F__)
    // Widened by hand: the compiler would use memory.
    const __m512i lanes = _mm512_set_epi32(3, 3, 3, 3, 2, 2, 2, 2, 1, 1, 1, 1, 0, 0, 0, 0);
    return reinterpret_cast<Native>(_mm512_maskz_permutexvar_ps(0xffff, lanes, _mm512_castps128_ps512(_mm_loadu_ps(p))));
#elif defined(__AVX__)
    return Native{p[0], p[0], p[0], p[0], p[1], p[1], p[1], p[1]};
#else
    return splat(*p);
#endif
}

// Transposition between cells and components: four registers of cells against one register per component. Done within the
// quarters of registers, where shuffles are cheap. `deal` interleaves a row of floats in the required order, `undeal` inverts it.
#if defined(__AVX512F__)
inline Native join_low(Native a, Native b) {
    return __builtin_shufflevector(a, b, 0, 16, 1, 17, 4, 20, 5, 21, 8, 24, 9, 25, 12, 28, 13, 29);
}
inline Native join_high(Native a, Native b) {
    return __builtin_shufflevector(a, b, 2, 18, 3, 19, 6, 22, 7, 23, 10, 26, 11, 27, 14, 30, 15, 31);
}
inline Native pairs_low(Native a, Native b) {
    return __builtin_shufflevector(a, b, 0, 1, 16, 17, 4, 5, 20, 21, 8, 9, 24, 25, 12, 13, 28, 29);
}
inline Native pairs_high(Native a, Native b) {
    return __builtin_shufflevector(a, b, 2, 3, 18, 19, 6, 7, 22, 23, 10, 11, 26, 27, 14, 15, 30, 31);
}
inline Native deal(Native a) {
    return __builtin_shufflevector(a, a, 0, 4, 8, 12, 1, 5, 9, 13, 2, 6, 10, 14, 3, 7, 11, 15);
}
inline Native undeal(Native a) {
    return __builtin_shufflevector(a, a, 0, 4, 8, 12, 1, 5, 9, 13, 2, 6, 10, 14, 3, 7, 11, 15);
}
#elif defined(__AVX__)
inline Native join_low(Native a, Native b) {
    return __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13);
}
inline Native join_high(Native a, Native b) {
    return __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15);
}
inline Native pairs_low(Native a, Native b) {
    return __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13);
}
inline Native pairs_high(Native a, Native b) {
    return __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15);
}
inline Native deal(Native a) {
    return __builtin_shufflevector(a, a, 0, 2, 4, 6, 1, 3, 5, 7);
}
inline Native undeal(Native a) {
    return __builtin_shufflevector(a, a, 0, 4, 1, 5, 2, 6, 3, 7);
}
#else
inline Native join_low(Native a, Native b) {
    return __builtin_shufflevector(a, b, 0, 4, 1, 5);
}
inline Native join_high(Native a, Native b) {
    return __builtin_shufflevector(a, b, 2, 6, 3, 7);
}
inline Native pairs_low(Native a, Native b) {
    return __builtin_shufflevector(a, b, 0, 1, 4, 5);
}
inline Native pairs_high(Native a, Native b) {
    return __builtin_shufflevector(a, b, 2, 3, 6, 7);
}
inline Native deal(Native a) {
    return a;
}
inline Native undeal(Native a) {
    return a;
}
#endif

// Which lanes hold the x, the y and the fourth float of cells.
typedef std::int32_t NativeBits __attribute__((vector_size(k_native_lanes * 4)));
#if defined(__AVX512F__)
constexpr NativeBits k_is_x = {-1, 0, 0, 0, -1, 0, 0, 0, -1, 0, 0, 0, -1, 0, 0, 0};
constexpr NativeBits k_is_y = {0, -1, 0, 0, 0, -1, 0, 0, 0, -1, 0, 0, 0, -1, 0, 0};
constexpr NativeBits k_is_w = {0, 0, 0, -1, 0, 0, 0, -1, 0, 0, 0, -1, 0, 0, 0, -1};
#elif defined(__AVX__)
constexpr NativeBits k_is_x = {-1, 0, 0, 0, -1, 0, 0, 0};
constexpr NativeBits k_is_y = {0, -1, 0, 0, 0, -1, 0, 0};
constexpr NativeBits k_is_w = {0, 0, 0, -1, 0, 0, 0, -1};
#else
constexpr NativeBits k_is_x = {-1, 0, 0, 0};
constexpr NativeBits k_is_y = {0, -1, 0, 0};
constexpr NativeBits k_is_w = {0, 0, 0, -1};
#endif

struct CellRegisters {
    Native part[4];
};
struct Components {
    Native x, y, z;
};
// In the order of `deal`, the fourth floats too.
struct DealtCells {
    Native x, y, z, w;
};
inline CellRegisters cells_of_dealt(const DealtCells& u) {
    const Native xy_low = join_low(u.x, u.y), xy_high = join_high(u.x, u.y);
    const Native zw_low = join_low(u.z, u.w), zw_high = join_high(u.z, u.w);
    return {{pairs_low(xy_low, zw_low), pairs_high(xy_low, zw_low), pairs_low(xy_high, zw_high), pairs_high(xy_high, zw_high)}};
}
inline CellRegisters cells_of(const Components& u) {
    return cells_of_dealt({deal(u.x), deal(u.y), deal(u.z), Native{}});
}
inline DealtCells dealt_cells(const CellRegisters& cells) {
    const Native* const c = cells.part;
    const Native xy_low = join_low(c[0], c[1]), xy_high = join_low(c[2], c[3]);
    const Native zw_low = join_high(c[0], c[1]), zw_high = join_high(c[2], c[3]);
    return {pairs_low(xy_low, xy_high), pairs_high(xy_low, xy_high), pairs_low(zw_low, zw_high), pairs_high(zw_low, zw_high)};
}
inline Components dealt_components_of(const CellRegisters& cells) {
    const DealtCells dealt = dealt_cells(cells);
    return {dealt.x, dealt.y, dealt.z};
}

// Of a value that an int holds.
inline float floor_small(float value) {
    const auto whole = static_cast<float>(static_cast<std::int32_t>(value));
    return whole > value ? whole - 1.0f : whole;
}
