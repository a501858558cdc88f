// Even-odd split of an axis with like ends. Its modes are even or odd about the middle, so that a product with them needs only
// sums or differences of mirrored values, half as many of each. With unlike ends there are no pairs and the split is a copy.

// Lines of k_lanes floats, `stride` apart, to a dense block: sums, the unpaired line, differences.
void fold_lines(const Fold& fold, const float* lines, std::ptrdiff_t stride, float* folded) {
    const int even = fold.count - fold.pairs;
    const float* const last = lines + (fold.count - 1) * stride;
    for (int n = 0; n < fold.pairs; ++n) {
        const Block a = load_block(lines + n * stride), b = load_block(last - n * stride);
        store_block(folded + n * k_lanes, a + b);
        store_block(folded + (even + n) * k_lanes, a - b);
    }
    for (int n = fold.pairs; n < even; ++n)
        store_block(folded + n * k_lanes, load_block(lines + n * stride));
}

void unfold_lines(const Fold& fold, const float* folded, float* lines, std::ptrdiff_t stride) {
    const int even = fold.count - fold.pairs;
    float* const last = lines + (fold.count - 1) * stride;
    for (int n = 0; n < fold.pairs; ++n) {
        const Block a = load_block(folded + n * k_lanes), b = load_block(folded + (even + n) * k_lanes);
        store_block(lines + n * stride, a + b);
        store_block(last - n * stride, a - b);
    }
    for (int n = fold.pairs; n < even; ++n)
        store_block(lines + n * stride, load_block(folded + n * k_lanes));
}

// The same along a row; differences start at `odd_offset`.
void fold_row(const Fold& fold, const float* row, int odd_offset, float* folded) {
    const float* const last = row + fold.count - 1;
    float* const odd = folded + odd_offset;
    for (int n = 0; n < fold.pairs; ++n) {
        const float a = row[n], b = last[-n];
        folded[n] = a + b;
        odd[n] = a - b;
    }
    for (int n = fold.pairs; n < fold.count - fold.pairs; ++n)
        folded[n] = row[n];
}

void unfold_row(const Fold& fold, const float* folded, int odd_offset, float* row) {
    float* const last = row + fold.count - 1;
    const float* const odd = folded + odd_offset;
    for (int n = 0; n < fold.pairs; ++n) {
        const float a = folded[n], b = odd[n];
        row[n] = a + b;
        last[-n] = a - b;
    }
    for (int n = fold.pairs; n < fold.count - fold.pairs; ++n)
        row[n] = folded[n];
}
