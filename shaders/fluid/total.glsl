// Sum over the invocations of a work group, of two at once.
layout(constant_id = 3) const int k_group = 256; // invocations
shared vec2 parts[k_group];

vec2 total(vec2 part) {
    const int local = int(gl_LocalInvocationIndex);
    parts[local] = part;
    barrier();
    for (int half_size = k_group / 2; half_size > 0; half_size /= 2) {
        if (local < half_size)
            parts[local] += parts[local + half_size];
        barrier();
    }
    const vec2 sum = parts[0];
    barrier();
    return sum;
}
