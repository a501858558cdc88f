// Direction memory: a vector D that is pushed at a fixed rate and kept within the unit ball.
//
//   |D| < 1, or pushed inward     D' = r t                       a straight line
//   |D| = 1, pushed outward       D' = r (t - (t.D) D)           a slide along the sphere
//
// t is a unit vector, r [1/s] the rate. This is the limit, for steps that go to 0, of "add r t dt, then shorten to 1", whose own
// result depends on the step. Both parts have closed forms: the angle a between D and t obeys a' = -r sin a on the sphere, so
// tan(a/2) falls as exp(-r time), which as a map of the sphere is the one below. Exact for an input that is constant over the
// step.
#ifndef WINDROW_DIRECTION_MEMORY_GLSL
#define WINDROW_DIRECTION_MEMORY_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

// A point of the unit sphere, not behind `toward` (their product >= 0), after a slide for `turn` = rate times time.
WINDROW_FN vec3 windrow_direction_slide(vec3 on_sphere, vec3 toward, float turn) {
    float limited = min(turn, 20.0f); // cosh of more is beyond what a float tells apart, and soon beyond what it holds
    float t = tanh(limited);
    float s = 1.0f / cosh(limited);
    float c = clamp(dot(on_sphere, toward), 0.0f, 1.0f);
    vec3 slid = (s * on_sphere + (c * (1.0f - s) + t) * toward) / (1.0f + c * t);
    return slid / max(length(slid), 1.0f); // rounding leads out of the ball, never in
}

// D after `duration` [s] of a push toward `toward` (a unit vector; 0: nothing pushes) at `rate` [1/s].
WINDROW_FN vec3 windrow_direction_memory(vec3 memory, vec3 toward, float rate, float duration) {
    float path = rate * duration;
    if (!(path > 0.0f) || !(dot(toward, toward) > 0.0f))
        return memory;
    // Where the straight line leaves the ball: |D + s t| = 1.
    float along = dot(memory, toward);
    float inside = max(1.0f - dot(memory, memory), 0.0f);
    float root = sqrt(along * along + inside);
    float straight = along < 0.0f ? root - along : inside / max(root + along, 1e-30f);
    if (path <= straight)
        return memory + path * toward;
    vec3 met = memory + straight * toward;
    return windrow_direction_slide(met / max(length(met), 1e-30f), toward, path - straight);
}

#endif
