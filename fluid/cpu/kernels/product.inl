// Small dense products for the fast diagonalisation: a tile of C stays in registers while the depth runs.

#if defined(__AVX512F__)
constexpr int k_tile_rows = 8; // hides the latency of the sums, and divides the usual sizes
#elif defined(__AVX__)
constexpr int k_tile_rows = 6;
#else
constexpr int k_tile_rows = 3;
#endif

template <int Rows>
inline void multiply_tile(const float* a, std::ptrdiff_t a_stride, const float* b, std::ptrdiff_t b_stride, float* c,
                          std::ptrdiff_t c_stride, int depth) {
    Native sums[Rows][k_parts] = {};
    for (int d = 0; d < depth; ++d) {
        const Block values = load_block(b + d * b_stride);
        for (int r = 0; r < Rows; ++r) {
            const Native factor = a[r * a_stride + d] - Native{};
            for (int n = 0; n < k_parts; ++n)
                sums[r][n] = multiply_add(factor, values.part[n], sums[r][n]);
        }
    }
#pragma GCC unroll 8 // a loop would index the sums, and so put them in memory
    for (int r = 0; r < Rows; ++r)
        for (int n = 0; n < k_parts; ++n)
            store_native(c + r * c_stride + n * k_native_lanes, sums[r][n]);
}

void multiply(const Product& p) {
    for (int column = 0; column < p.columns; column += k_lanes) {
        int row = 0;
        for (; row + k_tile_rows <= p.rows; row += k_tile_rows)
            multiply_tile<k_tile_rows>(p.a + row * p.a_stride, p.a_stride, p.b + column, p.b_stride,
                                       p.c + row * p.c_stride + column, p.c_stride, p.depth);
        if constexpr (k_tile_rows > 4)
            for (; row + 4 <= p.rows; row += 4)
                multiply_tile<4>(p.a + row * p.a_stride, p.a_stride, p.b + column, p.b_stride, p.c + row * p.c_stride + column,
                                 p.c_stride, p.depth);
        for (; row < p.rows; ++row)
            multiply_tile<1>(p.a + row * p.a_stride, p.a_stride, p.b + column, p.b_stride, p.c + row * p.c_stride + column,
                             p.c_stride, p.depth);
    }
}
