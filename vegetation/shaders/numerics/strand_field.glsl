// Strands of a shell: is there one at this point of the skin, at this height?
//
//   length   R = mix(low, high, chance)                  of each strand; h and R are shares of the whole length
//   cone     d < T/2 (R - h)                             d the distance from the strand's middle
//   centre   d^2 < mix(min, max, (h/R)^e)                min > max: narrows to the tip; min = max: a cylinder
//   edge     edge > mix(min, max, (h/R)^e)               Voronoi's cells; min < max: narrows to the tip
//   shapes   round; oval |x| < d(h) (1 - (y/l)^2); strip |x| < d(h), |y| < l, for feathers and paper: y along v
//   lift     a feather that lies: at y it reaches R ((1 - lift) + lift (y + l) / 2l)
//   bow      the middle moves by A h (cos, sin) 2 pi (turns h + chance)
//   tufts    x(h) = c + (1 - amount h^2)(x(0) - c)       c the nearest of coarser scattered middles: tips gather there
//
// Two ways to find strands. `uv`: the cells of the plane of uv. `surface`: for meshes whose uv are poor: the points of a lattice
// in the rest space of the mesh that lie within 0.6 cells of the tangent plane, seen along the normal; each is longest in the
// plane and has no length left at 0.6, so that none appears at once or is cut where the skin bends. About one strand a cell's
// area, whatever the skin's direction: the points fill space evenly. Only cells that the disc of a strand can reach from are
// hashed.
//
// `inside` counts in cells, above 0 within the strand, so that a host can smooth it over a pixel: coverage = clamp(1/2 + inside /
// pixel). Beyond 0.1 cells outside it may be any number down to -1. h is over the length that a map gives there: h / map. Where a
// strand of the other ways crosses its cell it is drawn whole, up to 1 cell from its middle; the grid alone (no jitter, bow,
// shape) cuts it at the cell as the sources do. Of strands that cross, the one whose middle is deepest shows. Forms of
// the sources: cone on the grid (a thesis on shell fur in Unity, 2024; there r = 2d < T (R - h)); cone and cylinder (a furry
// bunny, 2024); centre, edge, wriggle (Bloodelic's stylised fur).
// Based on: Lengyel, Praun, Finkelstein & Hoppe 2001, Real-time fur over arbitrary surfaces (shells); Worley 1996 (cells).
#ifndef WINDROW_STRAND_FIELD_GLSL
#define WINDROW_STRAND_FIELD_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

#include "../../../shaders/numerics/plant_masks.glsl"
#include "strand_cells.glsl"

// A field of strands. fur::StrandFieldSettings (vegetation/fur/strand_field.h) says more of each value. Usable in std140.
struct WindrowStrandField {
    vec4 cells;  // x [1/uv or 1/m] cells across; y their length along v over their width; z shift of every other row; w seed
    vec4 points; // x jitter; y wriggle; z [turns] its phase; w profile: 0 cone, 1 centre, 2 edge
    vec4 reach;  // x y low and high of the lengths; z lift; w shape: 0 round, 1 oval, 2 strip
    vec4 cut;    // cone: x T. Others: x min, y max, z e. w [cells] half length l of shapes
    vec4 bow;    // x [cells] A; y turns; z amount of tufts; w [1/cells] tufts across a cell
    vec4 shaft;  // x [cells] half width of the shaft line; yzw 0
};

struct WindrowStrandHit {
    float inside; // [cells] above 0: within the strand
    float reach;  // R; on a surface with what the slab leaves of it
    float radius; // [cells] of the strand at h
    float shaft;  // [cells] above 0: on the shaft line
    uvec2 key;    // the strand's own hash: windrow_strand_chance and others
    vec3 root;    // where it stands: uv, or metres in the rest space
    vec3 outward; // [cells] from its middle to the point, across the normal; uv: along u and v, z 0
    vec3 facet;   // unit vector to its nearest side, likewise
};

WINDROW_FN WindrowStrandHit windrow_strand_none() {
    WindrowStrandHit hit;
    hit.inside = -1.0f;
    hit.reach = 0.0f;
    hit.radius = 0.0f;
    hit.shaft = -1.0f;
    hit.key = uvec2(0u);
    hit.root = vec3(0.0f);
    hit.outward = vec3(0.0f);
    hit.facet = vec3(0.0f);
    return hit;
}

WINDROW_FN WindrowStrandLattice windrow_strand_lattice(WindrowStrandField field) {
    WindrowStrandLattice lattice;
    lattice.jitter = field.points.x;
    lattice.wriggle = field.points.y;
    lattice.phase = field.points.z;
    lattice.shift = field.cells.z;
    lattice.seed = uint(int(field.cells.w));
    return lattice;
}

// Place in cells of a uv, and back.
WINDROW_FN vec2 windrow_strand_place(WindrowStrandField field, vec2 uv) {
    return vec2(uv.x, uv.y / field.cells.y) * field.cells.x;
}
WINDROW_FN vec2 windrow_strand_uv_of(WindrowStrandField field, vec2 q) { return vec2(q.x, q.y * field.cells.y) / field.cells.x; }

WINDROW_FN float windrow_strand_reach(WindrowStrandField field, uvec2 key) {
    return mix(field.reach.x, field.reach.y, windrow_strand_chance(key));
}

// min to max at h of R.
WINDROW_FN float windrow_strand_cut(WindrowStrandField field, float h, float reach) {
    return mix(field.cut.x, field.cut.y, windrow_mask_power(min(h / max(reach, 1e-6f), 1.0f), field.cut.z));
}

// [cells] Radius of a strand at h, 0 or less beyond its tip. On a surface, which has no edges, the edge form is a disc in their
// place.
WINDROW_FN float windrow_strand_radius(WindrowStrandField field, float h, float reach) {
    if (h > reach)
        return -1.0f;
    if (field.points.w < 0.5f)
        return 0.5f * field.cut.x * (reach - h);
    float cut = windrow_strand_cut(field, h, reach);
    return field.points.w < 1.5f ? sqrt(max(cut, 0.0f)) : max(0.5f - cut, 0.0f);
}

// [cells] No strand is wider at h, whatever its length.
WINDROW_FN float windrow_strand_widest(WindrowStrandField field, float h) {
    float longest = windrow_strand_radius(field, h, field.reach.y);
    if (field.points.w < 0.5f || h > field.reach.y)
        return max(longest, 0.0f);
    return max(longest, field.points.w < 1.5f ? sqrt(max(field.cut.y, 0.0f)) : 0.5f - field.cut.y);
}

// The largest h at which anything is drawn; 0: nothing but the skin. No Voronoi cell has a place farther than 1/2 + jitter / 4
// from its edges.
WINDROW_FN float windrow_strand_top(WindrowStrandField field) {
    if (field.points.w < 0.5f)
        return field.cut.x > 0.0f ? field.reach.y : 0.0f;
    if (field.points.w < 1.5f)
        return field.cut.x > 0.0f || field.cut.y > 0.0f ? field.reach.y : 0.0f;
    bool grid = !(field.points.x > 0.0f) && !(field.cells.z > 0.0f);
    float widest = grid ? 0.5f : 0.55f + 0.25f * field.points.x;
    if (field.cut.y < widest)
        return field.reach.y;
    if (field.cut.x >= widest)
        return 0.0f;
    return field.reach.y * pow((widest - field.cut.x) / (field.cut.y - field.cut.x), 1.0f / field.cut.z);
}

WINDROW_FN bool windrow_layer_empty(WindrowStrandField field, float h) { return h > windrow_strand_top(field); }

// [cells] How deep `d` from the middle lies within the strand's section.
WINDROW_FN float windrow_strand_inside(WindrowStrandField field, vec2 d, float radius, float h, float reach) {
    if (field.reach.w < 0.5f)
        return radius - sqrt(dot(d, d));
    float half_length = field.cut.w;
    float y = d.y / half_length;
    float inside = min((field.reach.w < 1.5f ? radius * (1.0f - y * y) : radius) - abs(d.x), half_length - abs(d.y));
    float lift = field.reach.z;
    if (lift > 0.0f)
        inside = min(inside, d.y - half_length * (2.0f * (h / max(reach, 1e-6f) - 1.0f + lift) / lift - 1.0f));
    return inside;
}

// What a hit says of its section, once its `outward` is known.
WINDROW_FN WindrowStrandHit windrow_strand_told(WindrowStrandField field, WindrowStrandHit hit) {
    vec3 d = hit.outward;
    float half_length = max(field.cut.w, 1e-6f);
    hit.shaft = field.shaft.x * clamp(0.5f - 0.5f * d.y / half_length, 0.0f, 1.0f) - abs(d.x);
    if (field.reach.w < 0.5f)
        hit.facet = d / max(sqrt(dot(d, d)), 1e-9f);
    else if (field.reach.w > 1.5f && half_length - abs(d.y) < hit.radius - abs(d.x))
        hit.facet = vec3(0.0f, d.y < 0.0f ? -1.0f : 1.0f, 0.0f);
    else
        hit.facet = vec3(d.x < 0.0f ? -1.0f : 1.0f, 0.0f, 0.0f);
    return hit;
}

// [cells] How far the middle has moved at h, in turns of its own.
WINDROW_FN vec2 windrow_strand_bow(WindrowStrandField field, uvec2 key, float h) {
    if (!(field.bow.x > 0.0f))
        return vec2(0.0f);
    float turn = field.bow.y * h + windrow_strand_other_chance(key);
    return (field.bow.x * h) * vec2(windrow_turn_cosine(turn), windrow_turn_sine(turn));
}

// Voronoi's edge form at q.
WINDROW_FN WindrowStrandHit windrow_strand_edge_hit(WindrowStrandField field, vec2 q, float h) {
    WindrowStrandHit hit = windrow_strand_none();
    WindrowStrandCell cell = windrow_strand_nearest(windrow_strand_lattice(field), q, true);
    hit.key = cell.key;
    hit.reach = windrow_strand_reach(field, cell.key);
    hit.radius = 0.5f - windrow_strand_cut(field, h, hit.reach);
    hit.inside = h > hit.reach ? -1.0f : cell.edge - windrow_strand_cut(field, h, hit.reach);
    hit.root = vec3(q - cell.offset, 0.0f);
    hit.outward = vec3(cell.offset, 0.0f);
    hit.facet = vec3(cell.facet, 0.0f);
    hit.shaft = field.shaft.x - abs(cell.offset.x);
    return hit;
}

// Cones and centre forms at q, `wider` times as wide; `root` in cells.
WINDROW_FN WindrowStrandHit windrow_strand_centre_hit(WindrowStrandField field, vec2 q, float h, float wider) {
    WindrowStrandHit hit = windrow_strand_none();
    WindrowStrandLattice lattice = windrow_strand_lattice(field);
    bool round_ones = field.reach.w < 0.5f;
    bool grid = round_ones && !(lattice.jitter > 0.0f) && !(field.bow.x > 0.0f);
    int rings = grid ? 0 : 1;
    float most = grid ? 1e9f : 1.0f - field.bow.x * h;
    float bound =
        (round_ones ? min(windrow_strand_widest(field, h) * wider, most) : 1.5f) + 0.5f * lattice.jitter + field.bow.x * h + 0.1f;
    for (int row = -rings; row <= rings; ++row)
        for (int across = -rings; across <= rings; ++across) {
            ivec2 cell = windrow_strand_home(lattice, q, row) + ivec2(across, 0);
            vec2 away = q - windrow_strand_centre(lattice, cell);
            if (dot(away, away) > bound * bound)
                continue;
            uvec2 key = windrow_strand_key(lattice.seed, cell);
            float reach = windrow_strand_reach(field, key);
            float radius = min(windrow_strand_radius(field, h, reach) * wider, most);
            if (radius < 0.0f)
                continue;
            vec2 d = away - windrow_strand_jitter(lattice, key);
            vec2 root = q - d;
            d = d - windrow_strand_bow(field, key, h);
            float inside = windrow_strand_inside(field, d, radius, h, reach);
            if (inside > hit.inside) {
                hit.inside = inside;
                hit.reach = reach;
                hit.radius = radius;
                hit.key = key;
                hit.root = vec3(root, 0.0f);
                hit.outward = vec3(d, 0.0f);
            }
        }
    return windrow_strand_told(field, hit);
}

// How much tufts have shrunk at h.
WINDROW_FN float windrow_tuft_shrink(WindrowStrandField field, float h) { return 1.0f - field.bow.z * h * h; }

// In the cells of uv.
WINDROW_FN WindrowStrandHit windrow_strand_uv(WindrowStrandField field, vec2 uv, float h) {
    vec2 q = windrow_strand_place(field, uv);
    WindrowStrandLattice coarse;
    WindrowStrandCell tuft;
    float shrink = 1.0f;
    bool tufts = field.bow.z > 0.0f && h > 0.0f;
    if (tufts) {
        coarse.jitter = 1.0f;
        coarse.wriggle = 0.0f;
        coarse.phase = 0.0f;
        coarse.shift = 0.0f;
        coarse.seed = uint(int(field.cells.w)) + 0x51ed270bu;
        tuft = windrow_strand_nearest(coarse, q * field.bow.w, false);
        shrink = windrow_tuft_shrink(field, h);
        q = q + tuft.offset * ((1.0f / shrink - 1.0f) / field.bow.w); // where it stood before the tips gathered
    }
    WindrowStrandHit hit; // by `if`: browsers select no structs by ?:
    if (field.points.w < 1.5f)
        hit = windrow_strand_centre_hit(field, q, h, 1.0f / shrink);
    else
        hit = windrow_strand_edge_hit(field, q, h);
    if (tufts) {
        // A strand whose root belongs to another tuft is drawn there.
        if (hit.inside > 0.0f && windrow_strand_nearest(coarse, vec2(hit.root) * field.bow.w, false).key != tuft.key)
            hit.inside = -1.0f;
        hit.inside = hit.inside * shrink;
        hit.radius = hit.radius * shrink;
        hit.outward = hit.outward * shrink;
    }
    hit.root = vec3(windrow_strand_uv_of(field, vec2(hit.root)), 0.0f);
    return hit;
}

// What the slab leaves of a strand whose point lies `off` cells off the tangent plane: all within 0.4, nothing from 0.6.
WINDROW_FN float windrow_strand_slab(float off) {
    float s = clamp((off - 0.4f) * 5.0f, 0.0f, 1.0f);
    return 1.0f - s * s * (3.0f - 2.0f * s);
}

// Of a skin through q [cells] across the unit vector n, near which strands stand.
WINDROW_FN WindrowStrandHit windrow_strand_space_hit(WindrowStrandField field, vec3 q, vec3 n, float h, float wider) {
    WindrowStrandHit hit = windrow_strand_none();
    uint seed = uint(int(field.cells.w));
    float moved = field.bow.x * h;
    float most = 0.9f - moved;
    float bound = min(windrow_strand_widest(field, h) * wider, most) + moved + 0.05f;
    // How far the strand's section and the slab reach along each axis, together.
    vec3 side = sqrt(max(1.0f - n * n, 0.0f)) * bound + 0.6f * abs(n);
    float slab = 0.6f + 0.5f * (abs(n.x) + abs(n.y) + abs(n.z));
    ivec3 low = ivec3(floor(q - side));
    ivec3 high = ivec3(floor(q + side));
    for (int z = low.z; z <= high.z; ++z)
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x) {
                ivec3 cell = ivec3(x, y, z);
                vec3 away = q - vec3(cell) - 0.5f;
                // A cell holds points within sqrt(3)/2 of its middle: those that reach neither the slab nor the section are
                // passed by.
                float above = dot(away, n);
                float aside = sqrt(max(dot(away, away) - above * above, 0.0f)) - bound;
                float beyond = max(abs(above) - 0.6f, 0.0f);
                if (abs(above) > slab || (aside > 0.0f && aside * aside + beyond * beyond > 0.75f))
                    continue;
                uvec2 key = windrow_space_hash(seed, cell);
                vec3 jitter = vec3(windrow_fraction(key.x), windrow_fraction(key.y), windrow_strand_other_chance(key)) - 0.5f;
                vec3 d = away - jitter;
                float off = dot(d, n);
                float reach = windrow_strand_reach(field, key) * windrow_strand_slab(abs(off));
                float radius = min(windrow_strand_radius(field, h, reach) * wider, most);
                if (radius < 0.0f || !(reach > 0.0f))
                    continue;
                d = d - off * n;
                vec3 root = q - d;
                if (moved > 0.0f) {
                    vec3 lean = jitter - dot(jitter, n) * n;
                    lean = lean / max(sqrt(dot(lean, lean)), 0.05f);
                    vec3 turned = cross(n, lean);
                    float turn = field.bow.y * h;
                    d = d - moved * (windrow_turn_cosine(turn) * lean + windrow_turn_sine(turn) * turned);
                }
                float inside = radius - sqrt(dot(d, d));
                if (inside > hit.inside) {
                    hit.inside = inside;
                    hit.reach = reach;
                    hit.radius = radius;
                    hit.key = key;
                    hit.root = root;
                    hit.outward = d;
                }
            }
    hit.facet = hit.outward / max(sqrt(dot(hit.outward, hit.outward)), 1e-9f);
    return hit;
}

// On a mesh: x [m] in its rest space, on the skin, and the unit normal n there. All round; no stretch, no wriggle.
WINDROW_FN WindrowStrandHit windrow_strand_surface(WindrowStrandField field, vec3 x, vec3 n, float h) {
    vec3 q = x * field.cells.x;
    WindrowTuft tuft;
    float shrink = 1.0f;
    uint coarse = uint(int(field.cells.w)) + 0x51ed270bu;
    bool tufts = field.bow.z > 0.0f && h > 0.0f;
    if (tufts) {
        tuft = windrow_space_tuft(coarse, q * field.bow.w);
        vec3 offset = tuft.offset - dot(tuft.offset, n) * n;
        shrink = windrow_tuft_shrink(field, h);
        q = q + offset * ((1.0f / shrink - 1.0f) / field.bow.w);
    }
    WindrowStrandHit hit = windrow_strand_space_hit(field, q, n, h, 1.0f / shrink);
    if (tufts) {
        if (hit.inside > 0.0f && windrow_space_tuft(coarse, hit.root * field.bow.w).key != tuft.key)
            hit.inside = -1.0f;
        hit.inside = hit.inside * shrink;
        hit.radius = hit.radius * shrink;
        hit.outward = hit.outward * shrink;
    }
    hit.root = hit.root / field.cells.x;
    return hit;
}

#endif
