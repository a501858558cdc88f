// Looks at each visible blade once a frame: where it stands, how it leans in the wind now and how it did. Its vertices, in the
// picture and in the shadows, only read that. The work goes with the blades that are seen, not with those that stand. With
// FIELD_SWINGS their bends are those of their springs.
#define WINDROW_SET 1
#include "shaders/coupling/windrow_plants.glsl"
#include "air.glsl"
#include "canopy_lean.glsl"
#include "field_lists.glsl"

#ifdef FIELD_SWINGS
// States of this frame and the last beside field_blades, in their order: [2 (base + n) + parity of the frame]. A place finds its
// state of the last frame by where that was listed. A blade that picture and shadow both list has it twice, alike. Its slot may
// have been another chunk's, and its place not listed for long: what goes on has the tag of this blade in the last frame.
struct KeptSwing {
    WindrowSwingBits bits;
    uint tag;
};
layout(std430, set = 2, binding = 3) buffer Swings { KeptSwing swings[]; };
layout(std430, set = 2, binding = 4) buffer Listed { uint listed[]; }; // [2 place + parity]
layout(std430, set = 2, binding = 5) readonly buffer SwingFrame {
    WindrowSwingStep swing_steps[4]; // of the bands of its class
    uvec4 swing_frame;               // x its number, from 1 on
};

// Another in each frame and of each blade, except for one in 2^32.
uint swing_tag(uint frame, GrassBlade blade) { return frame ^ windrow_plant_hash(blade.key).x; }

// The bend of a blade now and a frame ago.
vec4 swung(GrassBlade blade, uint at) {
    uint frame = swing_frame.x, parity = frame & 1u;
    KeptSwing last = swings[2u * listed[2u * blade.place + (1u - parity)] + (1u - parity)];
    bool goes_on = frame > 1u && last.tag == swing_tag(frame - 1u, blade);
    WindrowSwing swing = windrow_swing_unpacked(last.bits);
    vec2 bend = swing.bend;
    WindrowSwingStep own = swing_steps[windrow_spring_band(windrow_blade_quickness(blade.kind, blade.hash))];
    swing = windrow_blade_swing(own, blade.kind, blade.root, vec3(0.0, 1.0, 0.0), blade.hash, vec3(0.0), goes_on, swing);
    swings[2u * at + parity] = KeptSwing(windrow_swing_packed(swing), swing_tag(frame, blade));
    listed[2u * blade.place + parity] = at;
    return vec4(swing.bend, goes_on ? bend : swing.bend);
}
#endif

shared uint sums[gl_WorkGroupSize.x];

FieldBlade blade_of(uvec2 told, int instance, uint at) {
    GrassBlade now = grass_blade(told, instance);
    GrassBlade before = grass_blade_previous(told, instance);
    const vec3 up = vec3(0.0, 1.0, 0.0);
    vec3 middle = now.root + 0.5 * windrow_blade_length(now.kind, now.hash) * up;
#ifdef FIELD_SWINGS
    vec4 bend = swung(now, at);
#else
    vec4 bend = vec4(windrow_blade_load(now.kind, up, now.hash, windrow_wind_on(middle, vec3(0.0))).xz,
                     windrow_blade_load(before.kind, up, now.hash, windrow_wind_on_previous(middle, vec3(0.0))).xz);
#endif
    FieldBlade blade;
    blade.root = vec4(now.root, windrow_dryness(now.root.xz - grass.corner.xz));
    blade.bend = bend;
    blade.size = vec4(now.kind.size.xz, before.kind.size.xz);
    blade.traits = uvec4(now.hash, floatBitsToUint(vec2(now.morph, before.morph)));
    blade.looks = vec4(now.clump, now.looks.x, now.size);
    blade.fog = air_before(middle);
    float afar = smoothstep(0.3, 1.0, length(now.root - frame.eye.xyz) / look.size.y);
    blade.canopy = vec4(0.0);
    if (afar > 0.0 && look.size.w > 0.0)
        blade.canopy = vec4(canopy_lean(grass.blade, now.root, 1.0), afar, 0.0);
    return blade;
}

void main() {
    uint list = gl_WorkGroupID.x, lane = gl_LocalInvocationIndex;
    uint sum = 0u;
    for (uint before = lane; before < list; before += gl_WorkGroupSize.x)
        sum += counts_of(before).x + counts_of(before).y;
    sums[lane] = sum;
    barrier();
    uint base = 0u;
    for (uint n = 0u; n < gl_WorkGroupSize.x; ++n)
        base += sums[n];
    uvec2 counts = counts_of(list);
    uint slot = slot_of(list), view = list % 2u;
    if (gl_WorkGroupID.y == 0u && lane == 0u) {
        field_bases[4u * slot + 2u * view] = base;
        field_bases[4u * slot + 2u * view + 1u] = base + counts.x;
    }
    uint end = room_of(base, counts.x + counts.y);
    for (uint n = gl_WorkGroupID.y * gl_WorkGroupSize.x + lane; n < end; n += gl_NumWorkGroups.y * gl_WorkGroupSize.x) {
        uint level = n < counts.x ? 0u : 1u;
        field_blades[base + n] = blade_of(uvec2(slot, level + 2u * view), int(n - level * counts.x), base + n);
    }
}
