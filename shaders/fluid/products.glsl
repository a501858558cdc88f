// Products of lines of values with the eigenvectors of an axis whose ends are alike, of a multiple of 8 cells (modes.glsl has the
// sums and differences of mirrored cells that they begin with). Lines are in shared memory in fours; an invocation computes four
// neighbouring outputs of `k_each` lines, so that an eigenvector that is loaded serves all of these.
//
// Before this text: Tables as vec4 `tables`.
layout(constant_id = 3) const int k_outputs = 32; // of a line
layout(constant_id = 4) const int k_lines = 8;    // of a group
layout(constant_id = 5) const int k_each = 1;     // of an invocation, 4 at most
const int k_group = int(gl_WorkGroupSize.x);
const int k_fours = k_outputs / 4; // of a line

// No larger than it must be, so that more groups run on a multiprocessor at a time; the most where a compiler of Metal takes the
// default. passes.cpp chooses lines that fit.
layout(constant_id = 6) const int k_part = WINDROW_TILE_FLOATS / 4; // k_lines k_fours
shared vec4 part[k_part];                                           // [line][four]
vec4 held[4];

int own_four() { return int(gl_LocalInvocationIndex) % k_fours; }
int own_line(int n) { return int(gl_LocalInvocationIndex) / k_fours * k_each + n; }

// `table`: where the axis' table [input][output] begins, in fours as all that follows. `width`: of its rows. `first`: output there of
// the first one here. `terms`: of an output. Outputs behind as many of a line are of its odd part, which is behind the even one.
void multiply(int table, int width, int first, int terms) {
    const int four = own_four(), from = four < terms ? 0 : terms;
    for (int n = 0; n < k_each; ++n)
        held[n] = vec4(0.0f);
    for (int term = 0; term < terms; ++term) {
        const int at = table + 4 * term * width + first + four;
        const vec4 a = tables[at], b = tables[at + width], c = tables[at + 2 * width], d = tables[at + 3 * width];
        for (int n = 0; n < k_each; ++n) {
            const vec4 v = part[min(own_line(n), k_lines - 1) * k_fours + from + term];
            held[n] += v.x * a + v.y * b + v.z * c + v.w * d;
        }
    }
}

void store_held() {
    barrier();
    for (int n = 0; n < k_each; ++n)
        if (own_line(n) < k_lines)
            part[own_line(n) * k_fours + own_four()] = held[n];
    barrier();
}

// One value of a line.
float value_at(int line, int n) { return part[line * k_fours + n / 4][n % 4]; }
