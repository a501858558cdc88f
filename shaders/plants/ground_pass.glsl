// A step of the ground memory, an invocation a texel: shaders/numerics/ground.glsl over the texels of the window, and what is
// sampled of it. WINDROW_TEXEL: format of the texture.
layout(local_size_x = 8, local_size_y = 8) in;

#include "numerics/ground.glsl"

layout(std430, set = 0, binding = 0) readonly buffer Step { WindrowGroundStep ground_step; };
layout(std430, set = 0, binding = 1) readonly buffer Walkers { WindrowWalker walkers[]; };
layout(std430, set = 0, binding = 2) buffer Motion { vec4 motion[]; };            // lean, velocity
layout(std430, set = 0, binding = 3) buffer Memory { vec4 memory[]; };            // trail, trample, 0
layout(std430, set = 0, binding = 4) buffer LeansBefore { vec2 leans_before[]; }; // of the wind, a step ago
layout(std430, set = 0, binding = 5) readonly buffer Leans { vec2 leans[]; };     // of the wind now, where each texel has its own
layout(WINDROW_TEXEL, set = 0, binding = 6) writeonly uniform image3D shown;

void main() {
    const ivec2 slot = ivec2(gl_GlobalInvocationID.xy);
    const int n = ground_step.window.x;
    if (slot.x >= n || slot.y >= n)
        return;
    const int at = slot.y * n + slot.x;
    const ivec2 texel = windrow_ground_in_slot(slot, ground_step.window.yz, n);
    vec2 lean = ground_step.wind.xy;
    if (ground_step.moved.z != 0)
        lean = vec2(windrow_ground_sound(leans[at].x), windrow_ground_sound(leans[at].y));
    WindrowGround ground;
    if (windrow_ground_is_new(texel, ground_step.moved.xy, n)) {
        ground = windrow_ground_new(lean);
    } else {
        ground = windrow_ground_new(vec2(0.0f));
        ground.lean = motion[at].xy;
        ground.velocity = motion[at].zw;
        ground.trail = memory[at].xy;
        ground.trample = memory[at].z;
        ground = windrow_ground_advanced(ground, ground_step, leans_before[at], lean);
    }
    const vec2 centre = vec2(texel) + 0.5f;
    for (int w = 0; w < ground_step.window.w; ++w)
        ground = windrow_ground_touched(ground, ground_step, windrow_ground_contact(walkers[w], centre, ground_step.contact.x));
    motion[at] = vec4(ground.lean, ground.velocity);
    memory[at] = vec4(ground.trail, ground.trample, 0.0f);
    leans_before[at] = lean;
    imageStore(shown, ivec3(slot, 0), windrow_ground_shown(ground));
}
