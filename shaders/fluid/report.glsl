// Report of a tick, written where the host reads it, by one work group.
//
// The sums of the work groups are added with what each addition rounds away, so that the totals are those of exact additions,
// rounded once (6e-8 of them).
// Based on: Knuth 1997, The Art of Computer Programming 2, section 4.2.2 (the error of a sum).
//
// Before this text: Sums as `sums`, solids.glsl, k_group invocations, and WINDROW_AROUND and WINDROW_SLOT, the bindings.
layout(std430, set = 0, binding = WINDROW_AROUND) readonly buffer Around {
    WindrowAround around;
    float around_words[];
};
layout(std430, set = 0, binding = WINDROW_SLOT) writeonly buffer Slot {
    WindrowReport report;
    float behind[];
};

shared vec2 parts[k_group], lost[k_group];

// total += value; what that rounds away is added to `rounded`.
void add(inout vec2 total, inout vec2 rounded, vec2 value) {
    precise const vec2 sum = total + value;
    precise const vec2 added = sum - total;
    precise const vec2 error = (total - (sum - added)) + (value - added);
    total = sum;
    rounded += error;
}

// Sums that overflow have no error to add.
float whole(float total, float rounded) { return abs(total) < 3e38f ? total + rounded : total; }

// What acted on each body in the last tick.
void write_forces(int local, int forces, int forces_at) {
    for (int n = local; n < WINDROW_PUSHED * min(solids.body_count, forces); n += k_group) {
        const int sum = solids.loads + WINDROW_LOAD * (n / WINDROW_PUSHED) + 2 * WINDROW_PUSHED + n % WINDROW_PUSHED;
        behind[forces_at + n] = around_words[sum] + around_words[sum + WINDROW_PUSHED];
    }
}

// `count`: entries of `sums`. `forces`: bodies that there is room for, `forces_at` words behind the report.
void write_report(int count, int forces, int forces_at) {
    const int local = int(gl_LocalInvocationIndex);
    if (has_obstacles())
        write_forces(local, forces, forces_at);
    vec2 total = vec2(0.0f), rounded = vec2(0.0f);
    for (int n = local; n < count; n += k_group)
        add(total, rounded, sums[n]);
    parts[local] = total;
    lost[local] = rounded;
    barrier();
    for (int left = k_group; left > 1;) {
        const int half_count = (left + 1) / 2;
        if (local + half_count < left) {
            add(total, rounded, parts[local + half_count]);
            rounded += lost[local + half_count];
            parts[local] = total;
            lost[local] = rounded;
        }
        left = half_count;
        barrier();
    }
    if (local != 0)
        return;
    report.largest_component = uintBitsToFloat(atomicMax(control.largest_speed, 0u));
    report.apart = uintBitsToFloat(atomicMax(control.farthest_from_ambient, 0u));
    report.cfl = WINDROW_OF_PLAN.cfl;
    const uint carried = uint(min(ceil(1e6f * WINDROW_OF_PLAN.carried_time), 8388607.0f));
    report.substeps = uint(WINDROW_OF_PLAN.substeps) | uint(WINDROW_OF_PLAN.capped) << 8 | carried << 9;
    report.repaired_cells = control.repaired_cells;
    report.limited_cells = control.limited_cells;
    report.squares = whole(total.x, rounded.x);
    report.divergence_squares = whole(total.y, rounded.y);
    const bool any = has_obstacles();
    report.pressure_residual = any && around.wanted > 0.0f ? around.left / around.wanted : 0.0f;
    report.pressure_solves = any ? uint(around.solved) : 0u;
    report.still = still_ticks();
    for (int n = 0; n < 4; ++n)
        report.largest_before[n] = uintBitsToFloat(control.left_before[n]);
}
