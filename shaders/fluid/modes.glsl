// Transform of cell values to modes of the axes x and z, or back: products with the axes' eigenvectors, a tile of a plane of
// constant y at a time in shared memory. Where a whole plane fits, both axes in one pass; else each in a pass of its own.
//
//   forward   hat[m] = sum_c E[m][c] value[c]        back   value[c] = sum_m E[m][c] hat[m]
//
// Modes are stored as [y][mode of z][mode of x], so that neighbouring columns are contiguous for the next pass.
// Before this text: float load(ivec3 cell) and void store(ivec3 cell, float value), `cell` in cells or modes.

layout(constant_id = 3) const int k_tile_x = 32; // cells of a tile: whole axes where they are transformed
layout(constant_id = 4) const int k_tile_z = 32;
layout(constant_id = 5) const bool k_along_x = true;
layout(constant_id = 6) const bool k_along_z = true;
const int k_tile = k_tile_x * k_tile_z;
const int k_group = int(gl_WorkGroupSize.x);
const int k_held = (k_tile + k_group - 1) / k_group;

shared float tile[k_tile];

// [input][output] of x and of z; where they begin is in the push.
float eigenvector(int table, int from, int to, int count) { return tables[table + from * count + to]; }

void transform_x() {
    float held[k_held];
    const int t = int(gl_LocalInvocationIndex);
    for (int n = 0; n < k_held; ++n) {
        const int at = t + n * k_group;
        held[n] = 0.0f;
        if (at < k_tile) {
            const int to = at % k_tile_x, row = at - to;
            float sum = 0.0f;
            for (int from = 0; from < k_tile_x; ++from)
                sum += eigenvector(push.x_vectors, from, to, k_tile_x) * tile[row + from];
            held[n] = sum;
        }
    }
    barrier();
    for (int n = 0; n < k_held; ++n)
        if (t + n * k_group < k_tile)
            tile[t + n * k_group] = held[n];
    barrier();
}

void transform_z() {
    float held[k_held];
    const int t = int(gl_LocalInvocationIndex);
    for (int n = 0; n < k_held; ++n) {
        const int at = t + n * k_group;
        held[n] = 0.0f;
        if (at < k_tile) {
            const int column = at % k_tile_x, to = at / k_tile_x;
            float sum = 0.0f;
            for (int from = 0; from < k_tile_z; ++from)
                sum += eigenvector(push.z_vectors, from, to, k_tile_z) * tile[column + from * k_tile_x];
            held[n] = sum;
        }
    }
    barrier();
    for (int n = 0; n < k_held; ++n)
        if (t + n * k_group < k_tile)
            tile[t + n * k_group] = held[n];
    barrier();
}

void main() {
    const int t = int(gl_LocalInvocationIndex);
    const ivec3 first = ivec3(k_along_x ? 0 : int(gl_WorkGroupID.x) * k_tile_x, int(gl_WorkGroupID.y),
                              k_along_z ? 0 : int(gl_WorkGroupID.x) * k_tile_z);
    for (int at = t; at < k_tile; at += k_group) {
        const ivec3 cell = first + ivec3(at % k_tile_x, 0, at / k_tile_x);
        tile[at] = inside(cell, tick.cells) ? load(cell) : 0.0f;
    }
    barrier();
    if (k_along_x)
        transform_x();
    if (k_along_z)
        transform_z();
    for (int at = t; at < k_tile; at += k_group) {
        const ivec3 cell = first + ivec3(at % k_tile_x, 0, at / k_tile_x);
        if (inside(cell, tick.cells))
            store(cell, tile[at]);
    }
}
