// Transform of cell values to modes of the axes x and z, or back: products with the axes' eigenvectors, a tile of a plane of
// constant y at a time in shared memory. Where a tile holds a whole plane, both axes in one pass; else each in a pass of its own.
//
//   forward   hat[m] = sum_c E[m][c] value[c]        back   value[c] = sum_m E[m][c] hat[m]
//
// Where both ends of an axis are alike, its vectors are even or odd about the middle (fluid/grid/basis.h). Pairs of cells c and
// n - 1 - c are then replaced by their sum and difference, and the products take half as many terms.
//
// Modes are stored as [y][mode of z][mode of x], so that neighbouring columns are contiguous for the next pass.
// Before this text: float load(ivec3 cell) and void store(ivec3 cell, float value), `cell` in cells or modes.

layout(constant_id = 3) const int k_tile_x = 32; // cells of a tile: whole axes where they are transformed
layout(constant_id = 4) const int k_tile_z = 32;
layout(constant_id = 5) const bool k_along_x = true;
layout(constant_id = 6) const bool k_along_z = true;
const int k_group = int(gl_WorkGroupSize.x);
// An invocation computes k_rows products along z in each of k_blocks columns of x, `k_width` columns apart.
const int k_blocks = (k_tile_x + k_group - 1) / k_group;
const int k_width = (k_tile_x + k_blocks - 1) / k_blocks;
const int k_step = k_group / k_width;
const int k_rows = (k_tile_z + k_step - 1) / k_step;

// Sizes of arrays are literal: some compilers of Metal take no others. passes.cpp chooses tiles that fit.
shared float tile[WINDROW_TILE_FLOATS];
float held[WINDROW_TILE_HELD];

// [input][output] of an axis; where they begin is in the push.
float eigenvector(int table, int from, int to, int count) { return tables[table + from * count + to]; }

void store_held() {
    barrier();
    const int t = int(gl_LocalInvocationIndex), lane = t % k_width, first = t / k_width;
    for (int block = 0; block < k_blocks; ++block)
        for (int row = 0; row < k_rows; ++row) {
            const int x = lane + block * k_width, z = first + row * k_step;
            if (first < k_step && x < k_tile_x && z < k_tile_z)
                tile[x + z * k_tile_x] = held[block * k_rows + row];
        }
    barrier();
}

void transform_x() {
    const int t = int(gl_LocalInvocationIndex), lane = t % k_width, first = t / k_width, even = push.x_even;
    for (int block = 0; block < k_blocks; ++block) {
        const int to = min(lane + block * k_width, k_tile_x - 1);
        const bool odd = to >= even;
        const int begin = !odd ? 0 : push.forward != 0 ? k_tile_x - 1 : even;
        const int step = odd && push.forward != 0 ? -1 : 1, terms = odd ? k_tile_x - even : even;
        for (int row = 0; row < k_rows; ++row)
            held[block * k_rows + row] = 0.0f;
        for (int from = 0; from < terms; ++from) {
            const float factor = eigenvector(push.x_vectors, from, to, k_tile_x);
            for (int row = 0; row < k_rows; ++row)
                held[block * k_rows + row] +=
                    factor * tile[min(first + row * k_step, k_tile_z - 1) * k_tile_x + begin + step * from];
        }
    }
    store_held();
}

void transform_z() {
    const int t = int(gl_LocalInvocationIndex), lane = t % k_width, first = t / k_width, even = push.z_even;
    for (int block = 0; block < k_blocks; ++block) {
        const int x = min(lane + block * k_width, k_tile_x - 1);
        for (int row = 0; row < k_rows; ++row)
            held[block * k_rows + row] = 0.0f;
        for (int from = 0; from < even; ++from) {
            const int of_odd = push.forward != 0 ? k_tile_z - 1 - from : min(even + from, k_tile_z - 1);
            const float for_even = tile[x + from * k_tile_x], for_odd = tile[x + of_odd * k_tile_x];
            for (int row = 0; row < k_rows; ++row) {
                const int to = min(first + row * k_step, k_tile_z - 1);
                held[block * k_rows + row] += eigenvector(push.z_vectors, from, to, k_tile_z) * (to < even ? for_even : for_odd);
            }
        }
    }
    store_held();
}

// a, b -> a + b, a - b of the cells of each pair: the even and the odd part from cells, or cells from these.
void fold(int a, int b) {
    const float sum = tile[a] + tile[b], difference = tile[a] - tile[b];
    tile[a] = sum;
    tile[b] = difference;
}

void fold_x() {
    const int pairs = k_tile_x - push.x_even;
    for (int n = int(gl_LocalInvocationIndex); n < pairs * k_tile_z; n += k_group) {
        const int line = (n / pairs) * k_tile_x;
        fold(line + n % pairs, line + k_tile_x - 1 - n % pairs);
    }
    barrier();
}

void fold_z() {
    const int pairs = k_tile_z - push.z_even;
    for (int n = int(gl_LocalInvocationIndex); n < pairs * k_tile_x; n += k_group)
        fold(n, n % k_tile_x + (k_tile_z - 1 - n / k_tile_x) * k_tile_x);
    barrier();
}

void main() {
    const int t = int(gl_LocalInvocationIndex), count = k_tile_x * k_tile_z;
    const bool forward = push.forward != 0;
    const ivec3 first = ivec3(k_along_x ? 0 : int(gl_WorkGroupID.x) * k_tile_x, int(gl_WorkGroupID.y),
                              k_along_z ? 0 : int(gl_WorkGroupID.x) * k_tile_z);
    for (int at = t; at < count; at += k_group) {
        const ivec3 cell = first + ivec3(at % k_tile_x, 0, at / k_tile_x);
        tile[at] = inside(cell, tick.cells) ? load(cell) : 0.0f;
    }
    barrier();
    if (k_along_x) {
        if (forward)
            fold_x();
        transform_x();
        if (!forward)
            fold_x();
    }
    if (k_along_z) {
        if (forward)
            fold_z();
        transform_z();
        if (!forward)
            fold_z();
    }
    for (int at = t; at < count; at += k_group) {
        const ivec3 cell = first + ivec3(at % k_tile_x, 0, at / k_tile_x);
        if (inside(cell, tick.cells))
            store(cell, tile[at]);
    }
}
