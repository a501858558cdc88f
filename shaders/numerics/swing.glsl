// A plant's spring over a frame: it follows the bend that the wind holds, in n equal parts of the frame.
//
//   g_k = load(u(t_k)) + r_k,  t_k = t - (1 - k / n) h,  k = 1 ... n                  targets at the ends of the parts
//   r'' + 2 xi w r' + w^2 (r - (load(u + d) - load(u))) = 0                            what the detail d adds, smoothed
//
// u is the wind, linear between the frame before and this one; d its detail, which the mean wind carries on from part to part
// (ambient.glsl), taken at the middle of each part. Between two targets the spring is exact (spring.glsl). Ripples of the detail
// pass a blade at 5 Hz and more: a frame of 24 a second that took them at its own end alone would meet them at random, and a
// lightly damped spring would ring with them. So they pass a Butterworth filter first, xi = sqrt(1/2), which is a spring too.
#ifndef WINDROW_SWING_GLSL
#define WINDROW_SWING_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

#include "spring.glsl"

// The same layout as windrow::SwingBlock (coupling/motion_blocks.h). Usable in a std140 block.
struct WindrowSwingStep {
    WindrowSpringStep spring;    // of a part
    WindrowSpringStep smoothing; // of a part, for what the detail adds
    vec4 parts;                  // x their number, y [s] length of one, zw 0
};

struct WindrowSwing {
    vec2 bend;         // [rad] x and z
    vec2 velocity;     // [rad/s]
    vec2 ripple;       // [rad] r
    vec2 ripple_speed; // [rad/s] r'
};

// A plant that begins: at rest where the wind holds it [rad].
WINDROW_FN WindrowSwing windrow_swing_begin(vec2 held) {
    WindrowSwing swing;
    swing.bend = held;
    swing.velocity = vec2(0.0f);
    swing.ripple = vec2(0.0f);
    swing.ripple_speed = vec2(0.0f);
    return swing;
}

// One part. [rad] what the wind without detail holds at its beginning and end, and what the detail adds at its middle.
WINDROW_FN WindrowSwing windrow_swing_part(WindrowSwingStep step, WindrowSwing swing, vec2 before, vec2 now, vec2 ripple) {
    WindrowSwing next;
    next.ripple = swing.ripple + windrow_spring_place(step.smoothing, swing.ripple, swing.ripple_speed, ripple, ripple);
    next.ripple_speed =
        swing.ripple_speed + windrow_spring_velocity(step.smoothing, swing.ripple, swing.ripple_speed, ripple, ripple);
    before = before + swing.ripple;
    now = now + next.ripple;
    next.bend = swing.bend + windrow_spring_place(step.spring, swing.bend, swing.velocity, before, now);
    next.velocity = swing.velocity + windrow_spring_velocity(step.spring, swing.bend, swing.velocity, before, now);
    return next;
}

// A state in 20 bytes: the bend as floats, since a frame at 144 Hz moves it by a thousandth of itself; the others as halves, off
// by 5e-4 of themselves.
struct WindrowSwingBits {
    uint bend_x, bend_z, velocity, ripple, ripple_speed;
};
WINDROW_FN WindrowSwingBits windrow_swing_packed(WindrowSwing swing) {
    return WindrowSwingBits(floatBitsToUint(swing.bend.x), floatBitsToUint(swing.bend.y), packHalf2x16(swing.velocity),
                            packHalf2x16(swing.ripple), packHalf2x16(swing.ripple_speed));
}
WINDROW_FN WindrowSwing windrow_swing_unpacked(WindrowSwingBits bits) {
    WindrowSwing swing;
    swing.bend = vec2(uintBitsToFloat(bits.bend_x), uintBitsToFloat(bits.bend_z));
    swing.velocity = unpackHalf2x16(bits.velocity);
    swing.ripple = unpackHalf2x16(bits.ripple);
    swing.ripple_speed = unpackHalf2x16(bits.ripple_speed);
    return swing;
}

#endif
