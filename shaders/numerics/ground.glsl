// Ground memory: one texel of the plane xz, with the lean of its plants in the wind and the traces of walkers.
//
//   lean     vec2 [rad], the plants' bend as stems take it (stem.glsl): its direction and how far, pi / 2 pressed flat. A damped
//            spring (spring.glsl) whose target is (1 - trample) (lean of the wind) + trail, the fading within a step included
//   trail    vec2 [rad], the lean that stays behind a walker, trail' = -trail / tau: it fades as an exponential and has no end
//   trample  how hard plants are pressed now, 0 to 1, fading with a shorter tau
//
// A walker is a disc that moves along a segment in the step: plants within its radius are pushed radially away from the point
// where it came closest, by (1 - s^2)^2 (radial.glsl) with s the relative distance: no texel's centre outside is touched. Over
// the inmost texel the push falls to 0, r / sqrt(r^2 + 1), so that it stays radial where it is read between texels; there a
// walker on the move pushes forward. A contact holds plants: their lean away from the walker is at least its push. The trail is
// what is longest now of what all contacts so far have left, each faded since: one who leaves, weaker and behind, does not turn
// it, and one who stays holds it.
//
// Lengths are in texels and positions relative to the window's low corner, both rounded to 1/16384 texel by the host, so that
// differences are exact and a texel gets the same bits wherever the window lies. Texel (i, j) has its centre at (i, j) + 1/2 and
// lies in slot (i + corner) mod n: a window that moves copies nothing.
#ifndef WINDROW_GROUND_GLSL
#define WINDROW_GROUND_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

#include "radial.glsl"
#include "spring.glsl"

// [rad] A wind lean beyond, or one that is no number, is taken for none: a texel that has seen it would not forget it. No plant
// bends so far, and a texture of halves, which end at 65504, holds sixty times as much. A lean beyond is shown as this.
#define WINDROW_GROUND_MOST_LEAN 1e3f

// A contact renews a trail that it exceeds by more than this share: what differs by rounding alone is one trail, on every device.
#define WINDROW_GROUND_SAME_TRAIL 1e-5f

// Of a step. Usable in a std140 or std430 block.
struct WindrowGroundStep {
    ivec4 window; // x texels an axis; yz slot of the low corner; w walkers
    ivec4 moved;  // xy texels that the window has moved since the last step; z 1: each texel has a wind lean of its own
    // x [m] height of the feet at which they touch no more; y [rad] lean that a walker pushes to; z share of it that stays
    vec4 contact;
    vec4 fading; // x of the trail, y of trample: exp(-h / tau) - 1; z and w: -h / tau
    vec4 wind;   // xy [rad] lean of the wind everywhere, now
    WindrowSpringStep spring;
    // what the fading within the step adds to a spring's place: x to a unit trail, y to a unit of pressed wind, z to a unit of
    // its change over the step
    vec4 faded_place;
    vec4 faded_velocity; // [1/s] and to its velocity
};

// Who walked in the step.
struct WindrowWalker {
    vec4 from; // xy place before [texels from the low corner], z [m] height of the feet above the ground, w radius [texels]
    vec4 to;   // xy place now, z height of the feet, w weight, 0 to 1
};

// A texel's memory.
struct WindrowGround {
    vec2 lean, velocity; // [rad], [rad/s]
    vec2 trail;          // [rad]
    float trample;       // 0 to 1
};

// What a walker does to a texel.
struct WindrowContact {
    vec2 away;    // unit vector; 0 right under a walker who stands
    float weight; // how hard it presses, 0 to 1; 0: does not touch
    float lean;   // how far it pushes away, as a share of the most, up to the weight
    float left;   // share of the step that was left when it was closest
};

// The slot of a texel, from the slot of the low corner; n texels an axis.
WINDROW_FN ivec2 windrow_ground_slot(ivec2 texel, ivec2 corner, int n) {
    ivec2 slot = texel + corner;
    return ivec2(slot.x >= n ? slot.x - n : slot.x, slot.y >= n ? slot.y - n : slot.y);
}

// The texel that lies in a slot.
WINDROW_FN ivec2 windrow_ground_in_slot(ivec2 slot, ivec2 corner, int n) {
    ivec2 texel = slot - corner;
    return ivec2(texel.x < 0 ? texel.x + n : texel.x, texel.y < 0 ? texel.y + n : texel.y);
}

// True where the window did not reach before it moved.
WINDROW_FN bool windrow_ground_is_new(ivec2 texel, ivec2 moved, int n) {
    ivec2 before = texel + moved;
    return before.x < 0 || before.y < 0 || before.x >= n || before.y >= n;
}

// The contact of a walker with the texel whose centre is `at`; `clearance` [m] as WindrowGroundStep::contact.x.
WINDROW_FN WindrowContact windrow_ground_contact(WindrowWalker walker, vec2 at, float clearance) {
    WindrowContact contact;
    contact.away = vec2(0.0f, 0.0f);
    contact.weight = 0.0f;
    contact.lean = 0.0f;
    contact.left = 0.0f;
    vec2 from = at - vec2(walker.from);
    vec2 way = vec2(walker.to) - vec2(walker.from);
    float squared = dot(way, way);
    float passed = squared > 0.0f ? clamp(dot(from, way) / squared, 0.0f, 1.0f) : 1.0f;
    vec2 off = from - passed * way;
    float off_squared = dot(off, off);
    float feet = walker.from.z + passed * (walker.to.z - walker.from.z);
    float touch = clamp(min(1.0f - feet / clearance, 2.0f + feet / clearance), 0.0f, 1.0f); // a cellar is no meadow
    contact.weight = walker.to.w * touch * windrow_radial_weight(off_squared, walker.from.w);
    if (!(contact.weight > 0.0f))
        return contact;
    contact.left = 1.0f - passed;
    vec2 push = off;
    if (squared > 0.0f)
        push += way / (sqrt(squared) * (1.0f + off_squared));
    float push_squared = dot(push, push);
    if (push_squared > 1e-12f) {
        contact.away = push / sqrt(push_squared);
        contact.lean = contact.weight * sqrt(push_squared / (push_squared + 1.0f));
    }
    return contact;
}

// 0 for what is too short to be seen by many digits: an exponential that goes on would end in denormal numbers, which some
// processors take a hundred times as long to multiply.
WINDROW_FN vec2 windrow_ground_settled(vec2 value) { return dot(value, value) < 1e-24f ? vec2(0.0f, 0.0f) : value; }

// Where a texel's plants would stand after long.
WINDROW_FN vec2 windrow_ground_target(WindrowGround ground, vec2 wind_lean) {
    return (1.0f - ground.trample) * wind_lean + ground.trail;
}

// A wind lean that a host's pass has written, or 0.
WINDROW_FN float windrow_ground_sound(float lean) {
    bool finite = (floatBitsToUint(lean) & 0x7f800000u) != 0x7f800000u; // by the bits: a compiler may assume away a comparison
    return finite && abs(lean) <= WINDROW_GROUND_MOST_LEAN ? lean : 0.0f;
}

// A texel without a past, under a wind that has blown for long.
WINDROW_FN WindrowGround windrow_ground_new(vec2 wind_lean) {
    WindrowGround ground;
    ground.lean = wind_lean;
    ground.velocity = vec2(0.0f, 0.0f);
    ground.trail = vec2(0.0f, 0.0f);
    ground.trample = 0.0f;
    return ground;
}

// A step without walkers.
WINDROW_FN WindrowGround windrow_ground_advanced(WindrowGround ground, WindrowGroundStep s, vec2 lean_before, vec2 lean_now) {
    // The spring's linear target is that of what is remembered now, as if it stayed; then what its fading adds.
    vec2 before = windrow_ground_target(ground, lean_before);
    vec2 now = windrow_ground_target(ground, lean_now);
    vec2 change = lean_now - lean_before;
    vec2 place = windrow_spring_place(s.spring, ground.lean, ground.velocity, before, now) + s.faded_place.x * ground.trail -
                 ground.trample * (s.faded_place.y * lean_before + s.faded_place.z * change);
    vec2 velocity = windrow_spring_velocity(s.spring, ground.lean, ground.velocity, before, now) +
                    s.faded_velocity.x * ground.trail -
                    ground.trample * (s.faded_velocity.y * lean_before + s.faded_velocity.z * change);
    WindrowGround next = ground;
    next.trail = windrow_ground_settled(ground.trail + s.fading.x * ground.trail);
    next.trample += s.fading.y * ground.trample;
    next.trample = next.trample < 1e-12f ? 0.0f : next.trample;
    next.lean = windrow_ground_settled(ground.lean + place);
    next.velocity = windrow_ground_settled(ground.velocity + velocity);
    return next;
}

// The same texel after a contact in this step.
WINDROW_FN WindrowGround windrow_ground_touched(WindrowGround ground, WindrowGroundStep s, WindrowContact contact) {
    if (!(contact.weight > 0.0f))
        return ground;
    WindrowGround next = ground;
    next.trample = max(ground.trample, contact.weight * exp(contact.left * s.fading.w));
    float left = s.contact.y * s.contact.z * contact.weight * exp(contact.left * s.fading.z);
    float trail = length(ground.trail);
    if (left > (1.0f + WINDROW_GROUND_SAME_TRAIL) * trail) { // by the weight, which is largest where the walker is closest
        if (dot(contact.away, contact.away) > 0.0f)
            next.trail = left * contact.away;
        else if (trail > 0.0f) // right under who stands: held as it was
            next.trail = (left / trail) * ground.trail;
    }
    float lacking = s.contact.y * contact.lean - dot(ground.lean, contact.away);
    if (lacking > 0.0f)
        next.lean += lacking * contact.away;
    float inward = dot(ground.velocity, contact.away);
    if (lacking > 0.0f && inward < 0.0f)
        next.velocity -= inward * contact.away;
    return next;
}

// What is sampled of a texel: lean x and z, trample, length of the trail.
WINDROW_FN vec4 windrow_ground_shown(WindrowGround ground) {
    vec2 most = vec2(WINDROW_GROUND_MOST_LEAN, WINDROW_GROUND_MOST_LEAN);
    return vec4(clamp(ground.lean, -most, most), ground.trample, length(ground.trail));
}

#endif
