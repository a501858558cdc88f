// Thomas elimination with stored pivots, k_lanes systems at a time; periodic systems by Sherman and Morrison.
// Unrolled over two modes, since each recurrence depends on its own last row.

template <int Modes>
inline void eliminate(float* data, std::ptrdiff_t stride, const float* pivots, int rows) {
    const std::ptrdiff_t pivot_stride = static_cast<std::ptrdiff_t>(rows) * k_lanes;
    Block carry[Modes];
    for (int m = 0; m < Modes; ++m)
        carry[m] = Block{};
    for (int j = 0; j < rows; ++j)
        for (int m = 0; m < Modes; ++m) {
            float* const at = data + m * stride + j * k_lanes;
            carry[m] = (load_block(at) - carry[m]) * load_block(pivots + m * pivot_stride + j * k_lanes);
            store_block(at, carry[m]);
        }
    for (int j = rows - 2; j >= 0; --j)
        for (int m = 0; m < Modes; ++m) {
            float* const at = data + m * stride + j * k_lanes;
            carry[m] = subtract_product(load_block(pivots + m * pivot_stride + j * k_lanes), carry[m], load_block(at));
            store_block(at, carry[m]);
        }
}

void tridiagonal(const TridiagonalTask& task) {
    const std::ptrdiff_t mode_stride = static_cast<std::ptrdiff_t>(task.rows) * k_lanes;
    int m = 0;
    for (; m + 2 <= task.modes; m += 2)
        eliminate<2>(task.data + m * task.stride, task.stride, task.pivots + m * mode_stride, task.rows);
    for (; m < task.modes; ++m)
        eliminate<1>(task.data + m * task.stride, task.stride, task.pivots + m * mode_stride, task.rows);
    if (task.cyclic == nullptr)
        return;
    for (m = 0; m < task.modes; ++m) {
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
