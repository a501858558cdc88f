// A damped oscillator that follows a target, over a step of any length, exactly:
//
//   x'' + 2 zeta omega x' + omega^2 (x - g(t)) = 0,     g linear from `before` to `now` over the step
//
// With e = x - before and d = now - before, its solution after the step h is linear in e, x' and d:
//
//   x  +=  (A - 1) e +  B        x' + (1 + E)     d          A(t), B(t): what is left of a unit place and of a unit speed,
//   x' += -omega^2 B e + (D - 1) x' + (1 - A) / h d          D = A - 2 zeta omega B,  1 + E the mean of 1 - A over the step
//
// The six numbers are the same for all springs of a class: the CPU computes them once a step, in double (coupling/spring.h).
// Increments, not new values: at 1000 Hz A differs from 1 by some 1e-5, of which a float would keep two digits.
// Plants of one class differ in frequency, or a gust would make a meadow swing in unison. A class has four bands of springs, a
// quarter of an octave apart. Each plant uses the band nearest to its own frequency.
// Exact for targets that are constant or linear over each step, so the same motion at any frame rate. A resting spring on a
// resting target stays as it is, to the bit.
// Based on: the variation of constants; the free solution as in Den Hartog 1956, Mechanical Vibrations, chapter 2.
#ifndef WINDROW_SPRING_GLSL
#define WINDROW_SPRING_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

// The six numbers of a step. Usable in a std140 block.
struct WindrowSpringStep {
    vec4 place;    // x A - 1, y [s] B, z 1 + E
    vec4 velocity; // x [1/s^2] -omega^2 B, y D - 1, z [1/s] (1 - A) / h
};

// The band of a plant whose frequency is `quickness` times its class's: 0 to 3, windrow::spring_bands.
WINDROW_FN int windrow_spring_band(float quickness) {
    return quickness < 0.840896415f ? 0 : quickness < 1.0f ? 1 : quickness < 1.18920712f ? 2 : 3;
}

// What the place grows by in a step. `velocity` is the one before the step.
WINDROW_FN float windrow_spring_place(WindrowSpringStep s, float place, float velocity, float before, float now) {
    return s.place.x * (place - before) + s.place.y * velocity + s.place.z * (now - before);
}
WINDROW_FN vec2 windrow_spring_place(WindrowSpringStep s, vec2 place, vec2 velocity, vec2 before, vec2 now) {
    return s.place.x * (place - before) + s.place.y * velocity + s.place.z * (now - before);
}
WINDROW_FN vec3 windrow_spring_place(WindrowSpringStep s, vec3 place, vec3 velocity, vec3 before, vec3 now) {
    return s.place.x * (place - before) + s.place.y * velocity + s.place.z * (now - before);
}

// What the velocity grows by in a step. `place` is the one before the step.
WINDROW_FN float windrow_spring_velocity(WindrowSpringStep s, float place, float velocity, float before, float now) {
    return s.velocity.x * (place - before) + s.velocity.y * velocity + s.velocity.z * (now - before);
}
WINDROW_FN vec2 windrow_spring_velocity(WindrowSpringStep s, vec2 place, vec2 velocity, vec2 before, vec2 now) {
    return s.velocity.x * (place - before) + s.velocity.y * velocity + s.velocity.z * (now - before);
}
WINDROW_FN vec3 windrow_spring_velocity(WindrowSpringStep s, vec3 place, vec3 velocity, vec3 before, vec3 now) {
    return s.velocity.x * (place - before) + s.velocity.y * velocity + s.velocity.z * (now - before);
}

#endif
