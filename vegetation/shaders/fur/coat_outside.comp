// Takes from a vertex's strand as much of its lean, and of its length where that is not enough, as keeps it out of the body's skin:
// coat_room.glsl.
#version 460
#extension GL_GOOGLE_include_directive : require
#define COAT_SKIN_WRITTEN
#include "coat.glsl"
#include "coat_patches.glsl"

layout(local_size_x = 64) in;

const int k_heights = 4;     // looked at, evenly up to the tip
const int k_looks = 3;       // at the lean, each after what the one before has taken
const float k_margin = 0.06; // of the length of the strand up to there, which a triangle between vertices may take

void main() {
    uint n = gl_GlobalInvocationID.x;
    if (n >= narrow_count)
        return;
    uint vertex = narrow[n];
    CoatSkin skin = skins[coat.counts.y + vertex];
    vec3 root = skin.position.xyz, up = skin.normal.xyz;
    float length_of = coat.shells.form.x;
    // Between this vertex and a neighbour with longer strands it is theirs that are seen.
    float top = min(skin.position.w + 0.25, 1.0) * max(coat.field.reach.x, coat.field.reach.y);
    ivec3 cell = cell_at(root);
    float lean = 1.0, reach = 1.0;
    for (int look = 0; look <= k_looks; ++look) {
        bool at_length = look == k_looks;
        WindrowCoatStrand strand = windrow_coat_strand_leaning(coat.shells, up, skin.position.w, skin.load.xyz, skin.own.xyz,
                                                               skin.lag.xyz, skin.lag_more.xyz, lean);
        vec3 upright[k_heights], place[k_heights];
        for (int k = 0; k < k_heights; ++k) {
            float h = top * float(k + 1) / float(k_heights);
            upright[k] = root + (strand.stem.reach * h + coat.shells.form.x * coat.shells.form.z) * up;
            place[k] = upright[k] + windrow_coat_shift(strand, h);
        }
        float kept = 1.0;
        for (int near = 0; near < 27; ++near) {
            ivec3 there = cell + ivec3(near % 3, near / 3 % 3, near / 9) - 1;
            for (uint number = cells[list_of(there)]; number != 0u;) {
                CoatPatch disc = patches[number - 1u];
                number = floatBitsToUint(disc.normal.w);
                WindrowSkinPatch skin_patch = WindrowSkinPatch(disc.place.xyz, disc.place.w, disc.normal.xyz);
                vec3 off = disc.place.xyz - root;
                // Too far, facing away from the root, or under a strand that stays over its own tangent plane.
                if (dot(off, off) > 1.96 * length_of * length_of || dot(off, disc.normal.xyz) > 0.15 * length_of ||
                    dot(off, up) < -1.5 * disc.place.w)
                    continue;
                for (int k = 0; k < k_heights; ++k) {
                    float margin = at_length ? 0.0 : k_margin * length_of * top * float(k + 1) / float(k_heights);
                    vec3 free = at_length ? root : upright[k];
                    kept = min(kept, windrow_room_kept(skin_patch, root, free, place[k], margin, length_of));
                }
            }
        }
        if (kept >= 1.0)
            break;
        if (at_length)
            reach = kept;
        else
            lean *= kept;
    }
    // A strand that meets the skin takes some frames to rise before it, and more to lie down again.
    CoatSkin before = skins[coat.counts.z + vertex];
    float had_lean = 1.0 - before.own.w, had_reach = 1.0 - before.load.w;
    lean = mix(had_lean, lean, lean < had_lean ? takes : gives);
    reach = mix(had_reach, reach, reach < had_reach ? takes : gives);
    if (lean >= 1.0 && reach >= 1.0)
        return;
    skin.own.xyz = windrow_coat_own_leaning(coat.shells, up, skin.position.w, skin.own.xyz, lean);
    skin.load.xyz *= lean;
    skin.lag.xyz *= lean;
    skin.lag_more.xyz *= lean;
    skin.own.w = 1.0 - lean;
    skin.load.w = 1.0 - reach;
    skins[coat.counts.y + vertex] = skin;
    if (is_first == 1)
        skins[coat.counts.z + vertex] = skin;
}
