// Thomas elimination with stored pivots, k_lanes systems at a time; periodic systems by Sherman and Morrison.
// Unrolled over two modes, since each recurrence depends on its own last row.

template <int Modes, bool Scaled>
inline void eliminate(float* data, std::ptrdiff_t stride, const float* pivots, int rows, const float* scale_in,
                      const float* scale_out) {
    const std::ptrdiff_t pivot_stride = static_cast<std::ptrdiff_t>(rows) * k_lanes;
    Block carry[Modes];
    for (int m = 0; m < Modes; ++m)
        carry[m] = Block{};
    for (int j = 0; j < rows; ++j)
        for (int m = 0; m < Modes; ++m) {
            float* const at = data + m * stride + j * k_lanes;
            Block d = load_block(at);
            if constexpr (Scaled)
                d = multiply_add(d, scale_in[j], Block{});
            carry[m] = (d - carry[m]) * load_block(pivots + m * pivot_stride + j * k_lanes);
            store_block(at, carry[m]);
        }
    for (int j = rows - 2; j >= 0; --j)
        for (int m = 0; m < Modes; ++m) {
            float* const at = data + m * stride + j * k_lanes;
            carry[m] = subtract_product(load_block(pivots + m * pivot_stride + j * k_lanes), carry[m], load_block(at));
            if constexpr (Scaled)
                store_block(at, multiply_add(carry[m], scale_out[j], Block{}));
            else
                store_block(at, carry[m]);
        }
    if constexpr (Scaled)
        for (int m = 0; m < Modes; ++m) {
            float* const at = data + m * stride + (rows - 1) * k_lanes;
            store_block(at, multiply_add(load_block(at), scale_out[rows - 1], Block{}));
        }
}

template <bool Scaled>
inline void eliminate_all(const TridiagonalTask& task) {
    const std::ptrdiff_t mode_stride = static_cast<std::ptrdiff_t>(task.rows) * k_lanes;
    int m = 0;
    for (; m + 2 <= task.modes; m += 2)
        eliminate<2, Scaled>(task.data + m * task.stride, task.stride, task.pivots + m * mode_stride, task.rows, task.scale_in,
                             task.scale_out);
    for (; m < task.modes; ++m)
        eliminate<1, Scaled>(task.data + m * task.stride, task.stride, task.pivots + m * mode_stride, task.rows, task.scale_in,
                             task.scale_out);
}

void tridiagonal(const TridiagonalTask& task) {
    const std::ptrdiff_t mode_stride = static_cast<std::ptrdiff_t>(task.rows) * k_lanes;
    if (task.scale_in != nullptr)
        eliminate_all<true>(task);
    else
        eliminate_all<false>(task);
    if (task.cyclic == nullptr)
        return;
    for (int m = 0; m < task.modes; ++m) {
        float* const data = task.data + m * task.stride;
        const float* const vector = task.cyclic + m * mode_stride;
        const float* const factors = task.cyclic_factors + 2 * m * k_lanes;
        const Block share =
            load_block(factors) * load_block(data) + load_block(factors + k_lanes) * load_block(data + (task.rows - 1) * k_lanes);
        for (int j = 0; j < task.rows; ++j)
            store_block(data + j * k_lanes,
                        subtract_product(share, load_block(vector + j * k_lanes), load_block(data + j * k_lanes)));
    }
}
